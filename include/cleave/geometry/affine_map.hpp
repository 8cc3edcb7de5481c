// SPDX-License-Identifier: Apache-2.0
/// Exact affine maps x -> (A x + t) / w of points and oriented planes, in any dimension.
#ifndef CLEAVE_GEOMETRY_AFFINE_MAP_HPP
#define CLEAVE_GEOMETRY_AFFINE_MAP_HPP

#include <cleave/algebra/solve.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/geometry/coordinates.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// An affine map over a ring: the homogeneous matrix with rows (A | t) and (0 | w), w > 0, which acts on (X, W).
/// Like points and planes it is fixed up to a positive factor, and `==` compares maps.
template <int D, ExactRing N>
requires(D >= 1) class AffineMap {
public:
    static constexpr int dimension = D;
    using number_type = N;
    using Homogeneous = Matrix<D + 1, D + 1, N>;

    /// The identity.
    AffineMap() : matrix_(identity_matrix<D + 1, N>()) {}

    /// Requires: the last row is (0, ..., 0, w) with w != 0. A negative w is made positive by changing all signs.
    explicit AffineMap(Homogeneous matrix) : matrix_(std::move(matrix)) {
        for (int j = 0; j < D; ++j) CLEAVE_REQUIRES(number_traits<N>::sign(matrix_(D, j)) == Sign::zero);
        const Sign weight_sign = number_traits<N>::sign(weight());
        CLEAVE_REQUIRES(weight_sign != Sign::zero);
        if (weight_sign == Sign::minus) {
            for (Vector<D + 1, N>& row : matrix_.row) negate_in_place(row);
        }
    }

    [[nodiscard]] const Homogeneous& homogeneous() const noexcept { return matrix_; }
    /// w > 0.
    [[nodiscard]] const N& weight() const { return matrix_(D, D); }

    /// The sign of the determinant. Returns: plus where orientation is kept, minus for a reflection (facets then need
    /// their vertices in reverse order), zero where the map is singular.
    [[nodiscard]] Sign orientation() const {
        const N d(determinant(matrix_));
        return number_traits<N>::sign(d);
    }

    /// The image of a point.
    [[nodiscard]] Point<D, N> operator()(const Point<D, N>& p) const {
        return Point<D, N>(multiply(matrix_, p.homogeneous()));
    }

    friend bool operator==(const AffineMap& a, const AffineMap& b) {
        for (int i = 0; i < D; ++i) {
            for (int j = 0; j <= D; ++j) {
                const N left(a.matrix_(i, j) * b.weight());
                const N right(b.matrix_(i, j) * a.weight());
                if (!(left == right)) return false;
            }
        }
        return true;
    }

private:
    Homogeneous matrix_;
};

/// The map x -> a(b(x)).
template <int D, ExactRing N>
[[nodiscard]] AffineMap<D, N> compose(const AffineMap<D, N>& a, const AffineMap<D, N>& b) {
    return AffineMap<D, N>(multiply(a.homogeneous(), b.homogeneous()));
}

/// The inverse map. Returns: nullopt where the map is singular.
template <int D, ExactRing N>
[[nodiscard]] std::optional<AffineMap<D, N>> inverse(const AffineMap<D, N>& map) {
    // The adjugate of the homogeneous matrix has det A as its weight, and is the inverse up to that factor.
    if (map.orientation() == Sign::zero) return std::nullopt;
    return AffineMap<D, N>(adjugate(map.homogeneous()));
}

/// How a map acts on oriented planes: the image of h has the images of h's minus side on its minus side, for
/// reflections too. Made once for many planes.
template <int D, ExactRing N>
class PlaneMap {
public:
    /// Requires: the map is not singular.
    explicit PlaneMap(const AffineMap<D, N>& map) : matrix_(adjugate(transpose(map.homogeneous()))) {
        // (h o map^-1) as a row vector is h adj(M) / det M; det M decides whether the division turns the plane round.
        const Sign orientation = map.orientation();
        CLEAVE_REQUIRES(orientation != Sign::zero);
        if (orientation == Sign::minus) {
            for (Vector<D + 1, N>& row : matrix_.row) negate_in_place(row);
        }
    }

    [[nodiscard]] Plane<D, N> operator()(const Plane<D, N>& h) const {
        return Plane<D, N>(multiply(matrix_, h.coefficients()));
    }

private:
    Matrix<D + 1, D + 1, N> matrix_;
};

/// The image of one oriented plane. Requires: the map is not singular.
template <int D, ExactRing N>
[[nodiscard]] Plane<D, N> image(const AffineMap<D, N>& map, const Plane<D, N>& h) {
    return PlaneMap<D, N>(map)(h);
}

/// x -> x + t, for t of any exact kind.
template <ExactRing N, Coordinate... X>
[[nodiscard]] AffineMap<static_cast<int>(sizeof...(X)), N> translation(const X&... t) {
    constexpr int D = static_cast<int>(sizeof...(X));
    const CommonDenominator<N, sizeof...(X)> c = over_common_denominator<N>(t...);
    Matrix<D + 1, D + 1, N> m = identity_matrix<D + 1, N>();
    for (int i = 0; i < D; ++i) {
        m(i, i) = c.denominator;
        m(i, D) = c.numerators[std::size_t(i)];
    }
    m(D, D) = c.denominator;
    return AffineMap<D, N>(std::move(m));
}

/// x_i -> s_i x_i; a negative factor mirrors, and factors of zero make the map singular.
template <ExactRing N, Coordinate... X>
[[nodiscard]] AffineMap<static_cast<int>(sizeof...(X)), N> scaling(const X&... s) {
    constexpr int D = static_cast<int>(sizeof...(X));
    const CommonDenominator<N, sizeof...(X)> c = over_common_denominator<N>(s...);
    Matrix<D + 1, D + 1, N> m = identity_matrix<D + 1, N>();
    for (int i = 0; i < D; ++i) m(i, i) = c.numerators[std::size_t(i)];
    m(D, D) = c.denominator;
    return AffineMap<D, N>(std::move(m));
}

/// The rotation of the coordinate plane (x_i, x_j), from axis i towards axis j, by twice the angle of the vector (p,
/// q):
///
///     cos = (p^2 - q^2) / (p^2 + q^2),   sin = 2 p q / (p^2 + q^2)
///
/// Every rational rotation of a plane is one of these; p = 2, q = 1 is the 3-4-5 rotation (about 53.13 degrees) and
/// p = q = 1 a quarter turn. Requires: i != j, both below D, and not p = q = 0.
template <int D, ExactRing N>
[[nodiscard]] AffineMap<D, N> rational_rotation(int i, int j, int p, int q) {
    CLEAVE_REQUIRES(0 <= i && i < D && 0 <= j && j < D && i != j && (p != 0 || q != 0));
    const N x(p);
    const N y(q);
    const N cosine(determinant_of_two<N>(x, y, y, x));
    N sine(x * y);
    sine += N(sine);
    N radius(x * x);
    add_product(radius, y, y);
    Matrix<D + 1, D + 1, N> m = identity_matrix<D + 1, N>();
    for (int k = 0; k <= D; ++k) m(k, k) = radius;
    m(i, i) = cosine;
    m(i, j) = -sine;
    m(j, i) = sine;
    m(j, j) = cosine;
    return AffineMap<D, N>(std::move(m));
}

CLEAVE_END_NAMESPACE

#endif

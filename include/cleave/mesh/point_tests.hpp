// SPDX-License-Identifier: Apache-2.0
/// `PointTests`: exact tests on the points of a mesh: collinear, coplanar, turns seen along an axis.
///
/// Floating point with a proven bound decides first, integers of whatever length are needed decide the rest.
#ifndef CLEAVE_MESH_POINT_TESTS_HPP
#define CLEAVE_MESH_POINT_TESTS_HPP

#include <cleave/geometry/double_predicates.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The same for exact coordinates: every component over the product of the distinct denominators.
template <class T>
[[nodiscard]] IntegerVector integer_difference(const std::array<T, 3>& p, const std::array<T, 3>& origin) {
    std::array<Fraction, 6> f;
    for (std::size_t i = 0; i < 6; ++i) f[i] = number_traits<T>::to_fraction(i < 3 ? p[i] : origin[i - 3]);
    WideInteger common(f[0].den);
    for (std::size_t i = 1; i < 6; ++i) {
        if (f[i].den.is_one() || f[i].den == common) continue;
        common *= exact_divide(WideInteger(f[i].den), gcd(common, f[i].den));
    }
    IntegerVector result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = exact_divide(common, f[i].den) * f[i].num;
        result[i] -= exact_divide(common, f[i + 3].den) * f[i + 3].num;
    }
    return result;
}

/// The vector product of two edges of a triangle of doubles, as computed.
struct TriangleNormal {
    std::array<double, 3> n;
    bool is_nonzero;  ///< proven: the corners are not on one line
};

/// Proof: each component is the turn of the corners along an axis, with the bound of `approximate_turn`.
[[nodiscard]] inline TriangleNormal triangle_normal(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                                    const std::array<double, 3>& r) noexcept {
    const double qx = q[0] - p[0], qy = q[1] - p[1], qz = q[2] - p[2];
    const double rx = r[0] - p[0], ry = r[1] - p[1], rz = r[2] - p[2];
    const double x1 = qy * rz, x2 = qz * ry;
    const double y1 = qz * rx, y2 = qx * rz;
    const double z1 = qx * ry, z2 = qy * rx;
    const double x = x1 - x2, y = y1 - y2, z = z1 - z2;
    const auto is_sure = [](double det, double left, double right) {
        return std::fabs(det) > 6 * 0x1p-53 * (std::fabs(left) + std::fabs(right)) + 0x1p-1060;
    };
    const bool sure = is_sure(x, x1, x2) || is_sure(y, y1, y2) || is_sure(z, z1, z2);
    return {{x, y, z}, sure && !filtering::always_fails};
}

/// Exact tests on points given by index. `T` is double or an exact field. The points must outlive this object and be
/// finite; const member functions may run in several threads.
template <class T>
class PointTests {
public:
    using point_type = std::array<T, 3>;

    /// Cost: for exact coordinates, a pass that rounds them; none for doubles.
    explicit PointTests(std::span<const point_type> points) : points_(points) {
        if constexpr (!is_double) {
            rounded_.reserve(points.size());
            for (const point_type& p : points) rounded_.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
        }
    }

    /// The coordinates, correctly rounded where they are not doubles.
    [[nodiscard]] const std::array<double, 3>& rounded(std::uint32_t i) const {
        if constexpr (is_double) {
            return points_[i];
        } else {
            return rounded_[i];
        }
    }

    /// True where i, j, k lie on one line (any two being equal included).
    [[nodiscard]] bool collinear(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (!filtering::always_fails && approximate_turn(i, j, k, Projection::along(axis))) return false;
        }
        const IntegerVector a = integer_difference(points_[j], points_[i]);
        const IntegerVector b = integer_difference(points_[k], points_[i]);
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (exact_turn(a, b, Projection::along(axis)) != Sign::zero) return false;
        }
        return true;
    }

    /// The turn i, j, k in a projection: plus where it is counter-clockwise.
    [[nodiscard]] Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k, Projection projection) const {
        return filtered_sign([&] { return approximate_turn(i, j, k, projection); },
                             [&] {
                                 return exact_turn(integer_difference(points_[j], points_[i]),
                                                   integer_difference(points_[k], points_[i]), projection);
                             });
    }

    /// The order of two points in a projection: by the first coordinate, ties by the second.
    [[nodiscard]] bool less(std::uint32_t i, std::uint32_t j, Projection projection) const {
        const point_type& p = points_[i];
        const point_type& q = points_[j];
        if (p[projection.u] != q[projection.u]) return p[projection.u] < q[projection.u];
        return p[projection.v] < q[projection.v];
    }

    /// The side of l of the plane through i, j, k: plus where i, j, k are counter-clockwise seen from l; zero where the
    /// four lie on one plane. Exact coordinates are not filtered: corners of one face are coplanar as a rule, where no
    /// approximation can decide.
    [[nodiscard]] Sign side(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const {
        if constexpr (is_double) {
            return plane_side(points_[i], points_[j], points_[k], points_[l]);
        } else {
            return filtered_sign([] { return std::optional<Sign>(); }, [&] { return exact_side(i, j, k, l); });
        }
    }

    /// An axis along which i, j, k do not look collinear, or nothing where they are collinear.
    [[nodiscard]] std::optional<unsigned> projectable_axis(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (turn(i, j, k, Projection::along(axis)) != Sign::zero) return axis;
        }
        return std::nullopt;
    }

private:
    static constexpr bool is_double = std::is_same_v<T, double>;
    static constexpr double unit = 0x1p-53;  // half the gap between 1 and the next double

    /// The larger a point's coordinates, the larger the rounding errors of exact coordinates; zero for doubles.
    [[nodiscard]] double coordinate_error(std::uint32_t i) const {
        if constexpr (is_double) {
            return 0;
        } else {
            const auto& p = rounded_[i];
            return unit * std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}) + 0x1p-1074;
        }
    }

    [[nodiscard]] std::optional<Sign> approximate_turn(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                                       Projection projection) const {
        const double error = is_double ? 0 : std::max({coordinate_error(i), coordinate_error(j), coordinate_error(k)});
        return cleave::approximate_turn(rounded(i), rounded(j), rounded(k), projection, error);
    }

    [[nodiscard]] Sign exact_side(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const {
        const auto &p = points_[i], &q = points_[j], &r = points_[k], &s = points_[l];
        for (std::size_t x = 0; x < 3; ++x) {
            if (p[x] == q[x] && p[x] == r[x] && p[x] == s[x]) return Sign::zero;  // an axis-parallel face
        }
        const IntegerVector a = integer_difference(q, p);
        const IntegerVector b = integer_difference(r, p);
        const IntegerVector c = integer_difference(s, p);
        WideInteger det, minor;
        for (std::size_t x = 0; x < 3; ++x) {
            minor = WideInteger();
            add_product(minor, a[(x + 1) % 3], b[(x + 2) % 3]);
            sub_product(minor, a[(x + 2) % 3], b[(x + 1) % 3]);
            add_product(det, minor, c[x]);
        }
        return det.sign();
    }

    std::span<const point_type> points_;
    std::vector<std::array<double, 3>> rounded_;
};

CLEAVE_END_NAMESPACE

#endif

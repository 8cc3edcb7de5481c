// SPDX-License-Identifier: Apache-2.0
/// Oriented hyperplanes: h(x) = n.x + c, plus = outside, minus = inside.
#ifndef CLEAVE_GEOMETRY_PLANE_HPP
#define CLEAVE_GEOMETRY_PLANE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/coordinates.hpp>

#include <array>
#include <cstddef>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// The plane n.x + c = 0 together with its orientation: the half-space n.x + c <= 0 is its inside, so that the normal n
/// points out. Coefficients are ring elements, fixed up to a positive factor; `==` compares oriented planes, not
/// coefficients. The normal is never the zero vector: what has no normal is no plane (see `join`).
///
/// In D = 1 a plane is an oriented point of the line, in D = 2 an oriented line.
template <int D, ExactRing N>
requires(D >= 1) class Plane {
public:
    static constexpr int dimension = D;
    using number_type = N;
    using Coefficients = Vector<D + 1, N>;

    /// The plane x_0 = 0 with its outside at x_0 > 0.
    Plane() {
        for (N& x : coefficients_) x = N(0);
        coefficients_[0] = N(1);
    }

    /// The plane (n_0, ..., n_{D-1}, c). Requires: n is not the zero vector.
    explicit Plane(Coefficients coefficients) : coefficients_(std::move(coefficients)) {
        CLEAVE_REQUIRES(first_nonzero(coefficients_) < std::size_t(D));
    }

    /// (n_0, ..., n_{D-1}, c).
    [[nodiscard]] const Coefficients& coefficients() const noexcept { return coefficients_; }
    /// n_i for i < D, c for i = D.
    [[nodiscard]] const N& operator[](std::size_t i) const { return coefficients_[i]; }
    /// c = h(0).
    [[nodiscard]] const N& offset() const noexcept { return coefficients_[D]; }

    /// n: it points to the plus side, which is outside. Its length means nothing.
    [[nodiscard]] Vector<D, N> normal() const {
        Vector<D, N> n;
        for (std::size_t i = 0; i < std::size_t(D); ++i) n[i] = coefficients_[i];
        return n;
    }

    /// The same set with the same orientation. Cost: up to 2 D products.
    friend bool operator==(const Plane& a, const Plane& b) {
        return proportionality(a.coefficients_, b.coefficients_) == Sign::plus;
    }

private:
    Coefficients coefficients_;
};

/// The same plane with inside and outside exchanged.
template <int D, ExactRing N>
[[nodiscard]] Plane<D, N> flip(const Plane<D, N>& h) {
    typename Plane<D, N>::Coefficients c = h.coefficients();
    negate_in_place(c);
    return Plane<D, N>(std::move(c));
}

/// The plane with coefficients n_0, ..., n_{D-1}, c of any exact kind: `make_plane<Integer>(1, 0, -0.5)` is x = 1/2.
/// For a ring they are multiplied by their least common denominator. Requires: the normal is not zero.
/// Throws: NumberError where a coefficient is not finite or does not fit N.
template <ExactRing N, Coordinate... X>
requires(sizeof...(X) >= 2)
    [[nodiscard]] Plane<static_cast<int>(sizeof...(X)) - 1, N> make_plane(const X&... coefficients) {
    return Plane<static_cast<int>(sizeof...(X)) - 1, N>(over_common_denominator<N>(coefficients...).numerators);
}

/// The same from an array of coefficients.
template <ExactRing N, Coordinate X, std::size_t K>
[[nodiscard]] Plane<static_cast<int>(K) - 1, N> make_plane(const std::array<X, K>& coefficients) {
    return Plane<static_cast<int>(K) - 1, N>(over_common_denominator<N>(coefficients).numerators);
}

CLEAVE_END_NAMESPACE

#endif

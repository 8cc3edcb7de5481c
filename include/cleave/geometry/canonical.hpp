// SPDX-License-Identifier: Apache-2.0
/// Primitive and canonical coefficients: the one description among all that differ by a factor.
///
/// A vector of integers is *primitive* if the gcd of its entries is 1. A plane has exactly one primitive vector for
/// each orientation, a point exactly one with positive weight; over a field denominators are cleared first. A plane's
/// vector is *canonical* if besides its first non-zero normal entry is positive: then it names the set, and orientation
/// is one more bit. Hashes must be taken of these, since equal planes otherwise hash differently.
#ifndef CLEAVE_GEOMETRY_CANONICAL_HPP
#define CLEAVE_GEOMETRY_CANONICAL_HPP

#include <cleave/algebra/primitive.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

template <ExactRing N, std::size_t K>
[[nodiscard]] std::array<N, K> numbers_of(const std::array<Integer, K>& v) {
    std::array<N, K> result;
    for (std::size_t i = 0; i < K; ++i) result[i] = number_traits<N>::from_integer(v[i]);
    return result;
}

}  // namespace detail

/// The same oriented plane with primitive integer coefficients.
template <int D, ExactRing N>
[[nodiscard]] Plane<D, N> primitive(const Plane<D, N>& h) {
    return Plane<D, N>(detail::numbers_of<N>(primitive_integers(h.coefficients())));
}

/// The same point with primitive integer homogeneous coordinates.
template <int D, ExactRing N>
[[nodiscard]] Point<D, N> primitive(const Point<D, N>& p) {
    return Point<D, N>(detail::numbers_of<N>(primitive_integers(p.homogeneous())));
}

/// An unoriented plane's name and an orientation.
template <int D>
struct CanonicalPlane {
    Vector<D + 1, Integer> coefficients;  ///< primitive, the first non-zero normal entry positive
    bool is_flipped = false;              ///< whether the plane faces the other way

    friend bool operator==(const CanonicalPlane&, const CanonicalPlane&) = default;
};

/// The canonical form: coincident planes of any scale and number type have equal `coefficients`.
template <int D, ExactRing N>
[[nodiscard]] CanonicalPlane<D> canonical(const Plane<D, N>& h) {
    CanonicalPlane<D> result{primitive_integers(h.coefficients()), false};
    if (result.coefficients[first_nonzero(result.coefficients)].sign() == Sign::minus) {
        for (Integer& x : result.coefficients) x.negate();
        result.is_flipped = true;
    }
    return result;
}

/// The largest bit length among the entries of the primitive vector: what "this number has grown" is measured in.
template <ExactRing N, std::size_t K>
[[nodiscard]] std::size_t primitive_bits(const std::array<N, K>& v) {
    std::size_t bits = 0;
    for (const Integer& x : primitive_integers(v)) bits = std::max(bits, x.bit_length());
    return bits;
}

CLEAVE_END_NAMESPACE

#endif

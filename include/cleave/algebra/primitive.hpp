// SPDX-License-Identifier: Apache-2.0
/// Primitive vectors: the shortest integer vector in a direction, the canonical form of homogeneous coordinates.
///
/// Of all positive multiples of a non-zero rational vector exactly one has integer entries without a common factor. Two
/// oriented planes are the same, and two homogeneous points of positive weight too, exactly if these are equal.
#ifndef CLEAVE_ALGEBRA_PRIMITIVE_HPP
#define CLEAVE_ALGEBRA_PRIMITIVE_HPP

#include <cleave/algebra/vector.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/traits.hpp>

#include <array>
#include <cstddef>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Divides `v` by the positive number that makes it primitive. The zero vector stays as it is.
/// Cost: D gcds and D exact divisions; for integers that have no common factor, often two gcds and nothing else.
template <ExactRing N, std::size_t D>
void make_primitive(std::array<N, D>& v) {
    using T = number_traits<N>;
    N common(0);
    for (const N& x : v) {
        common = T::gcd(common, x);
        // In a ring of integers 1 has no further divisors; in a field it has (1/2 divides 1).
        if constexpr (!T::is_field) {
            if (common == N(1)) return;
        }
    }
    if (T::sign(common) == Sign::zero) return;
    for (N& x : v) x = T::exact_divide(x, common);
}

/// The primitive integer vector with the direction of `v`; zero for the zero vector. For any exact number.
template <ExactRing N, std::size_t D>
[[nodiscard]] std::array<Integer, D> primitive_integers(const std::array<N, D>& v) {
    std::array<Fraction, D> fractions;
    Integer multiple(1);  // of all denominators
    for (std::size_t i = 0; i < D; ++i) {
        fractions[i] = number_traits<N>::to_fraction(v[i]);
        const Integer& den = fractions[i].den;
        if (!den.is_one()) multiple *= exact_divide(den, gcd(multiple, den));
    }
    std::array<Integer, D> r;
    for (std::size_t i = 0; i < D; ++i) {
        const Fraction& x = fractions[i];
        if (multiple.is_one()) {
            r[i] = std::move(fractions[i].num);
        } else {
            r[i] = x.num * exact_divide(multiple, x.den);
        }
    }
    make_primitive(r);
    return r;
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Sums of products: the one inner step of every determinant, minor and dot product.
///
/// `R` is the number that accumulates and may be wider than the factors (`AccumulatesInto<R, N>`). A number type with a
/// fused operation, or one whose product needs more room than its factors' type has, says so in its `number_traits`.
#ifndef CLEAVE_ALGEBRA_PRODUCT_HPP
#define CLEAVE_ALGEBRA_PRODUCT_HPP

#include <cleave/number/concepts.hpp>

CLEAVE_BEGIN_NAMESPACE

/// a * b in R, also where the type of a and b would not hold it.
template <ExactRing R, class A, class B>
[[nodiscard]] R product(const A& a, const B& b) {
    if constexpr (requires { number_traits<R>::product(a, b); }) {
        return number_traits<R>::product(a, b);
    } else {
        return R(a * b);
    }
}

/// r += a * b.
template <ExactRing R, class A, class B>
void add_product(R& r, const A& a, const B& b) {
    if constexpr (requires { number_traits<R>::add_product(r, a, b); }) {
        number_traits<R>::add_product(r, a, b);
    } else {
        r += product<R>(a, b);
    }
}

/// r -= a * b.
template <ExactRing R, class A, class B>
void sub_product(R& r, const A& a, const B& b) {
    if constexpr (requires { number_traits<R>::sub_product(r, a, b); }) {
        number_traits<R>::sub_product(r, a, b);
    } else {
        r -= product<R>(a, b);
    }
}

/// a * d - b * c: the determinant of the rows (a, b) and (c, d).
template <ExactRing R, class N>
[[nodiscard]] R determinant_of_two(const N& a, const N& b, const N& c, const N& d) {
    R r = product<R>(a, d);
    sub_product(r, b, c);
    return r;
}

/// a * x - b * y + c * z: a 3 x 3 determinant from a row and the minors of the other two rows.
template <ExactRing R, class N>
[[nodiscard]] R alternating_sum(const N& a, const R& x, const N& b, const R& y, const N& c, const R& z) {
    R r = product<R>(x, a);
    sub_product(r, y, b);
    add_product(r, z, c);
    return r;
}

/// -a * x + b * y - c * z.
template <ExactRing R, class N>
[[nodiscard]] R negated_alternating_sum(const N& a, const R& x, const N& b, const R& y, const N& c, const R& z) {
    R r = product<R>(y, b);
    sub_product(r, x, a);
    sub_product(r, z, c);
    return r;
}

/// a * x - b * y + c * z - d * w: a 4 x 4 determinant from a row and the minors of the other three rows.
template <ExactRing R, class N>
[[nodiscard]] R alternating_sum(const N& a, const R& x, const N& b, const R& y, const N& c, const R& z, const N& d,
                                const R& w) {
    R r = product<R>(x, a);
    sub_product(r, y, b);
    add_product(r, z, c);
    sub_product(r, w, d);
    return r;
}

/// -a * x + b * y - c * z + d * w.
template <ExactRing R, class N>
[[nodiscard]] R negated_alternating_sum(const N& a, const R& x, const N& b, const R& y, const N& c, const R& z,
                                        const N& d, const R& w) {
    return alternating_sum(b, y, a, x, d, w, c, z);
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Vectors of exact numbers: plain `std::array`s and the few operations on them that exactness allows.
#ifndef CLEAVE_ALGEBRA_VECTOR_HPP
#define CLEAVE_ALGEBRA_VECTOR_HPP

#include <cleave/algebra/product.hpp>

#include <array>
#include <cstddef>
#include <type_traits>

CLEAVE_BEGIN_NAMESPACE

/// D numbers. A plain array, so that literals, structured access and comparison need nothing of ours.
template <int D, class N>
using Vector = std::array<N, static_cast<std::size_t>(D)>;

/// The type that a computation on entries N is carried out in: `R` where the caller named one, else N.
template <class R, class N>
using SumType = std::conditional_t<std::is_void_v<R>, N, R>;

/// The sum of a_i * b_i, in R (by default the type of `a`'s entries). The entries' types may differ.
/// Cost: D products and D - 1 sums.
template <class R = void, class A, class B, std::size_t D>
[[nodiscard]] SumType<R, A> dot(const std::array<A, D>& a, const std::array<B, D>& b) {
    static_assert(D > 0);
    SumType<R, A> r = product<SumType<R, A>>(a[0], b[0]);
    for (std::size_t i = 1; i < D; ++i) add_product(r, a[i], b[i]);
    return r;
}

/// a + b, entry by entry.
template <ExactRing N, std::size_t D>
[[nodiscard]] std::array<N, D> add(const std::array<N, D>& a, const std::array<N, D>& b) {
    std::array<N, D> r(a);
    for (std::size_t i = 0; i < D; ++i) r[i] += b[i];
    return r;
}

/// a - b, entry by entry: the vector from b to a.
template <ExactRing N, std::size_t D>
[[nodiscard]] std::array<N, D> subtract(const std::array<N, D>& a, const std::array<N, D>& b) {
    std::array<N, D> r(a);
    for (std::size_t i = 0; i < D; ++i) r[i] -= b[i];
    return r;
}

/// factor * v.
template <ExactRing N, std::size_t D>
[[nodiscard]] std::array<N, D> scale(const N& factor, const std::array<N, D>& v) {
    std::array<N, D> r;
    for (std::size_t i = 0; i < D; ++i) r[i] = factor * v[i];
    return r;
}

/// Every entry times -1, in place. For a plane in homogeneous coordinates this is the flipped plane.
template <ExactRing N, std::size_t D>
void negate_in_place(std::array<N, D>& v) {
    for (N& x : v) x = -x;
}

/// Whether every entry is zero.
template <ExactRing N, std::size_t D>
[[nodiscard]] bool is_zero(const std::array<N, D>& v) {
    for (const N& x : v) {
        if (number_traits<N>::sign(x) != Sign::zero) return false;
    }
    return true;
}

/// The index of the first entry that is not zero; D where there is none.
template <ExactRing N, std::size_t D>
[[nodiscard]] std::size_t first_nonzero(const std::array<N, D>& v) {
    std::size_t i = 0;
    while (i < D && number_traits<N>::sign(v[i]) == Sign::zero) ++i;
    return i;
}

/// How two non-zero vectors are proportional.
/// Returns: plus if `b` is a positive multiple of `a`; minus if a negative one; zero if they are not proportional, that
/// is, if some 2 x 2 minor is not zero.
/// Requires: neither is the zero vector.
/// Cost: up to 2 D products, in R; the signs alone decide most pairs that are not proportional.
template <class R = void, ExactRing N, std::size_t D>
[[nodiscard]] Sign proportionality(const std::array<N, D>& a, const std::array<N, D>& b) {
    using T = number_traits<N>;
    using Wide = SumType<R, N>;
    const std::size_t k = first_nonzero(a);
    if (k == D || first_nonzero(b) != k) return Sign::zero;
    const Sign direction = T::sign(a[k]) * T::sign(b[k]);
    for (std::size_t i = k + 1; i < D; ++i) {
        if (T::sign(b[i]) != T::sign(a[i]) * direction) return Sign::zero;
    }
    for (std::size_t i = k + 1; i < D; ++i) {
        if (T::sign(a[i]) == Sign::zero) continue;
        const Wide left = product<Wide>(a[k], b[i]);
        const Wide right = product<Wide>(a[i], b[k]);
        if (!(left == right)) return Sign::zero;
    }
    return direction;
}

CLEAVE_END_NAMESPACE

#endif

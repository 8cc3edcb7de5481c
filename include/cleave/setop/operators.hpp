// SPDX-License-Identifier: Apache-2.0
/// The operations under their names and as operators: `|` `&` `-` `^` `~`.
#ifndef CLEAVE_SETOP_OPERATORS_HPP
#define CLEAVE_SETOP_OPERATORS_HPP

#include <cleave/setop/apply.hpp>

CLEAVE_BEGIN_NAMESPACE

/// Points of a or b.
template <int D, class N>
[[nodiscard]] Region<D, N> union_(const Region<D, N>& a, const Region<D, N>& b, const OperationOptions& options = {}) {
    return apply(Operation::union_, a, b, options);
}

/// Points of both a and b.
template <int D, class N>
[[nodiscard]] Region<D, N> intersection(const Region<D, N>& a, const Region<D, N>& b,
                                        const OperationOptions& options = {}) {
    return apply(Operation::intersection, a, b, options);
}

/// Points of a that are not in b.
template <int D, class N>
[[nodiscard]] Region<D, N> difference(const Region<D, N>& a, const Region<D, N>& b,
                                      const OperationOptions& options = {}) {
    return apply(Operation::difference, a, b, options);
}

/// Points of exactly one of a and b.
template <int D, class N>
[[nodiscard]] Region<D, N> symmetric_difference(const Region<D, N>& a, const Region<D, N>& b,
                                                const OperationOptions& options = {}) {
    return apply(Operation::symmetric_difference, a, b, options);
}

template <int D, class N>
[[nodiscard]] Region<D, N> operator|(const Region<D, N>& a, const Region<D, N>& b) {
    return union_(a, b);
}
template <int D, class N>
[[nodiscard]] Region<D, N> operator&(const Region<D, N>& a, const Region<D, N>& b) {
    return intersection(a, b);
}
template <int D, class N>
[[nodiscard]] Region<D, N> operator-(const Region<D, N>& a, const Region<D, N>& b) {
    return difference(a, b);
}
template <int D, class N>
[[nodiscard]] Region<D, N> operator^(const Region<D, N>& a, const Region<D, N>& b) {
    return symmetric_difference(a, b);
}
template <int D, class N>
[[nodiscard]] Region<D, N> operator~(const Region<D, N>& a) {
    return complement(a);
}
template <int D, class N>
Region<D, N>& operator|=(Region<D, N>& a, const Region<D, N>& b) {
    return a = a | b;
}
template <int D, class N>
Region<D, N>& operator&=(Region<D, N>& a, const Region<D, N>& b) {
    return a = a & b;
}
template <int D, class N>
Region<D, N>& operator-=(Region<D, N>& a, const Region<D, N>& b) {
    return a = a - b;
}
template <int D, class N>
Region<D, N>& operator^=(Region<D, N>& a, const Region<D, N>& b) {
    return a = a ^ b;
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Comparison of regions as sets.
#ifndef CLEAVE_SETOP_COMPARE_HPP
#define CLEAVE_SETOP_COMPARE_HPP

#include <cleave/region/canonical.hpp>
#include <cleave/region/region.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// Whether two regions are the same set, however each was made and whatever its faces are cut into. The answer is that
/// of an empty symmetric difference, without an operation: canonical forms are compared.
/// Cost: nothing for copies and where a look at the bounds tells; otherwise that of two canonical forms.
template <int D, class N>
[[nodiscard]] bool equal(const Region<D, N>& a, const Region<D, N>& b) {
    if (a.shared_boundary() == b.shared_boundary()) return true;
    const Boundary<D>& x = a.boundary();
    const Boundary<D>& y = b.boundary();
    if (x.value_at_infinity != y.value_at_infinity || x.is_finite != y.is_finite) return false;
    // Bounds contain what they bound, no more: boxes apart are boundaries apart.
    if (x.faces.faces.empty() != y.faces.faces.empty()) return false;
    if (!x.faces.faces.empty() && x.bounds.disjoint(y.bounds)) return false;
    return canonical(a) == canonical(b);
}

CLEAVE_END_NAMESPACE

#endif

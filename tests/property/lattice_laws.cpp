// SPDX-License-Identifier: Apache-2.0
// The laws of a Boolean algebra, exactly, for random solids in 1, 2 and 3 dimensions. Two sides are equal if their
// symmetric difference is empty; every operation on the way is checked.
#include <cleave/setop/operators.hpp>

#include "support/region_generators.hpp"

#include <type_traits>

using namespace cleave;
using namespace support;

namespace {

template <int D>
Region<D> unite(const Region<D>& a, const Region<D>& b) {
    return checked(Operation::union_, a, b);
}
template <int D>
Region<D> meet_of(const Region<D>& a, const Region<D>& b) {
    return checked(Operation::intersection, a, b);
}
template <int D>
Region<D> minus(const Region<D>& a, const Region<D>& b) {
    return checked(Operation::difference, a, b);
}
template <int D>
Region<D> exclusive(const Region<D>& a, const Region<D>& b) {
    return checked(Operation::symmetric_difference, a, b);
}

template <int D>
using Dimension = std::integral_constant<int, D>;

/// Fewer cases in higher dimensions, where each takes longer.
template <int D>
std::size_t cases(std::size_t n) {
    return D == 1 ? 4 * n : (D == 2 ? 2 * n : n);
}

}  // namespace

TEMPLATE_TEST_CASE("laws: one and two operands", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    using R = Region<D>;

    law("a set with itself, its complement, empty and full", cases<D>(30), [](const Solid<D>& solid) {
        const R a = verified(solid.region());
        const R c = verified(~a);
        RC_ASSERT(dump((~c).boundary()) == dump(a.boundary()));
        RC_ASSERT(equal_sets(unite(a, a), a));
        RC_ASSERT(equal_sets(meet_of(a, a), a));
        RC_ASSERT(minus(a, a).is_empty());
        RC_ASSERT(exclusive(a, a).is_empty());
        RC_ASSERT(unite(a, c).is_full());
        RC_ASSERT(meet_of(a, c).is_empty());
        RC_ASSERT(equal_sets(minus(a, c), a));
        RC_ASSERT(exclusive(a, c).is_full());
        RC_ASSERT(equal_sets(unite(a, R::empty()), a));
        RC_ASSERT(unite(a, R::full()).is_full());
        RC_ASSERT(meet_of(a, R::empty()).is_empty());
        RC_ASSERT(equal_sets(meet_of(a, R::full()), a));
        RC_ASSERT(equal_sets(minus(R::full(), a), c));
        RC_ASSERT(equal_sets(exclusive(a, R::full()), c));
    });

    law("order of operands and absorption", cases<D>(15), [](const Solid<D>& first, const Solid<D>& second) {
        const R a = first.region();
        const R b = second.region();
        const R join = unite(a, b);
        const R common = meet_of(a, b);
        const R odd = exclusive(a, b);
        RC_ASSERT(equal_sets(join, unite(b, a)));
        RC_ASSERT(equal_sets(common, meet_of(b, a)));
        RC_ASSERT(equal_sets(odd, exclusive(b, a)));
        RC_ASSERT(equal_sets(unite(a, common), a));
        RC_ASSERT(equal_sets(meet_of(a, join), a));
        RC_ASSERT(equal_sets(minus(join, common), odd));
        RC_ASSERT(equal_sets(unite(minus(a, b), minus(b, a)), odd));
        RC_ASSERT(equal_sets(exclusive(odd, b), a));
        RC_ASSERT(equal_sets(unite(odd, common), join));
    });

    law("complements", cases<D>(15), [](const Solid<D>& first, const Solid<D>& second) {
        const R a = first.region();
        const R b = second.region();
        RC_ASSERT(equal_sets(R(~unite(a, b)), meet_of(R(~a), R(~b))));
        RC_ASSERT(equal_sets(R(~meet_of(a, b)), unite(R(~a), R(~b))));
        RC_ASSERT(equal_sets(minus(a, b), meet_of(a, R(~b))));
        RC_ASSERT(equal_sets(exclusive(a, R(~b)), R(~exclusive(a, b))));
    });
}

TEMPLATE_TEST_CASE("laws: three operands", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    using R = Region<D>;

    law("grouping and distribution", cases<D>(10),
        [](const Solid<D>& first, const Solid<D>& second, const Solid<D>& third) {
            const R a = first.region();
            const R b = second.region();
            const R c = third.region();
            RC_ASSERT(equal_sets(unite(unite(a, b), c), unite(a, unite(b, c))));
            RC_ASSERT(equal_sets(meet_of(meet_of(a, b), c), meet_of(a, meet_of(b, c))));
            RC_ASSERT(equal_sets(exclusive(exclusive(a, b), c), exclusive(a, exclusive(b, c))));
            RC_ASSERT(equal_sets(meet_of(a, unite(b, c)), unite(meet_of(a, b), meet_of(a, c))));
            RC_ASSERT(equal_sets(unite(a, meet_of(b, c)), meet_of(unite(a, b), unite(a, c))));
            RC_ASSERT(equal_sets(meet_of(a, exclusive(b, c)), exclusive(meet_of(a, b), meet_of(a, c))));
            RC_ASSERT(equal_sets(minus(minus(a, b), c), minus(a, unite(b, c))));
        });
}

// SPDX-License-Identifier: Apache-2.0
// The laws of a Boolean algebra and of measures, exactly, for random solids in 1, 2 and 3 dimensions. Two sides are
// equal if their symmetric difference is empty; every operation on the way is checked.
#include <cleave/setop/operators.hpp>

#include "support/region_generators.hpp"

#include <cleave/query/measure.hpp>

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

TEMPLATE_TEST_CASE("laws: measures", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    using R = Region<D>;

    law("|A| + |B| = |A or B| + |A and B|, and what follows", cases<D>(60),
        [](const BoundedSolid<D>& first, const BoundedSolid<D>& second) {
            const R a = first.region();
            const R b = second.region();
            const R join = checked(Operation::union_, a, b);
            const R common = checked(Operation::intersection, a, b);
            const R left = checked(Operation::difference, a, b);
            const R right = checked(Operation::difference, b, a);
            const R odd = checked(Operation::symmetric_difference, a, b);
            const Rational ma = ExactRegion<D>(a).measure();
            const Rational mb = ExactRegion<D>(b).measure();
            const Rational mj = ExactRegion<D>(join).measure();
            const Rational mc = ExactRegion<D>(common).measure();
            RC_ASSERT(Rational(ma + mb) == Rational(mj + mc));
            RC_ASSERT(ExactRegion<D>(left).measure() == Rational(ma - mc));
            RC_ASSERT(ExactRegion<D>(right).measure() == Rational(mb - mc));
            RC_ASSERT(ExactRegion<D>(odd).measure() == Rational(mj - mc));
            // The library's own measure is the independent one.
            for (const R* r : {&a, &b, &join, &common, &left, &right, &odd})
                RC_ASSERT(measure(*r).value() == ExactRegion<D>(*r).measure());
            RC_ASSERT(!measure(R(~join)).has_value());
            // First moments add up like measures.
            for (std::size_t i = 0; i < std::size_t(D); ++i)
                RC_ASSERT(Rational(ExactRegion<D>(a).first_moment()[i] + ExactRegion<D>(b).first_moment()[i]) ==
                          Rational(ExactRegion<D>(join).first_moment()[i] + ExactRegion<D>(common).first_moment()[i]));
        });
}

TEMPLATE_TEST_CASE("laws: membership", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    using R = Region<D>;

    law("a point belongs to a result as it belongs to the operands", cases<D>(60), [] {
        const auto first = draw<Solid<D>>();
        const auto second = draw<Solid<D>>();
        const auto probes = draw_vector<ProbePoint<D>>(12);
        const R a = first.region();
        const R b = second.region();
        for (const Operation operation : all_operations) {
            const ExactRegion<D> result(checked(operation, a, b));
            for (const ProbePoint<D>& probe : probes) {
                const Where in_first = first.locate(probe.x);
                const Where in_second = second.locate(probe.x);
                if (in_first == Where::boundary || in_second == Where::boundary) continue;
                const bool expected = apply(operation, in_first == Where::inside, in_second == Where::inside);
                RC_ASSERT(result.locate(probe.x) == (expected ? Where::inside : Where::outside));
            }
        }
    });
}

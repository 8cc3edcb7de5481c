// SPDX-License-Identifier: Apache-2.0
// What operations do to measures and to points, for random solids in 1, 2 and 3 dimensions.
#include <cleave/query/measure.hpp>

#include "support/region_generators.hpp"

#include <type_traits>

using namespace cleave;
using namespace support;

namespace {

template <int D>
using Dimension = std::integral_constant<int, D>;

template <int D>
std::size_t cases(std::size_t n) {
    return D == 1 ? 4 * n : (D == 2 ? 2 * n : n);
}

}  // namespace

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
        const auto first = *rc::gen::arbitrary<Solid<D>>();
        const auto second = *rc::gen::arbitrary<Solid<D>>();
        const auto probes = *rc::gen::container<std::vector<ProbePoint<D>>>(12, rc::gen::arbitrary<ProbePoint<D>>());
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

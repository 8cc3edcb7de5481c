// SPDX-License-Identifier: Apache-2.0
// Both classical engines on unions of convex sets, bounded or not, in D = 1 to 5: equal canonical forms, and the laws
// of set algebra by canonical form.
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The operation by both engines, which must agree; the filter's result.
template <int D>
Region<D> both(Operation operation, const Region<D>& a, const Region<D>& b) {
    Region<D> by_filter = apply(operation, a, b);
    const Region<D> by_merge = apply(Engine::tree_merge, operation, a, b);
    INFO(to_text(operation));
    REQUIRE(canonical(by_filter) == canonical(by_merge));
    REQUIRE(by_filter.is_bounded() == by_merge.is_bounded());
    return by_filter;
}

template <int D>
Region<D> random_region(Dice& dice) {
    const bool bounded = dice.below(2) == 0;
    Region<D> r = region_of<D>(random_convex<D>(dice, bounded).planes);
    for (int n = dice.below(3); n > 0; --n) {
        const Operation operation = all_operations[std::size_t(dice.below(4))];
        r = both(operation, r, region_of<D>(random_convex<D>(dice, bounded).planes));
    }
    return dice.below(4) == 0 ? ~r : r;
}

template <int D>
void check_laws(unsigned seed) {
    Dice dice(seed);
    const Region<D> a = random_region<D>(dice);
    const Region<D> b = random_region<D>(dice);
    const std::string text_a = canonical(a);
    const std::string empty = canonical(Region<D>::empty());
    INFO("seed " << seed);
    const Region<D> sum = both(Operation::union_, a, b);
    const Region<D> common = both(Operation::intersection, a, b);
    const Region<D> a_only = both(Operation::difference, a, b);
    const Region<D> odd = both(Operation::symmetric_difference, a, b);
    CHECK(canonical(both(Operation::union_, b, a)) == canonical(sum));
    CHECK(canonical(both(Operation::union_, a_only, b)) == canonical(sum));
    CHECK(canonical(both(Operation::union_, a_only, common)) == text_a);
    CHECK(canonical(both(Operation::symmetric_difference, sum, common)) == canonical(odd));
    CHECK(canonical(both(Operation::symmetric_difference, odd, b)) == text_a);
    CHECK(canonical(both(Operation::union_, a, common)) == text_a);
    CHECK(canonical(both(Operation::intersection, a, sum)) == text_a);
    CHECK(canonical(~both(Operation::union_, ~a, ~b)) == canonical(common));
    CHECK(canonical(~~a) == text_a);
    CHECK(canonical(both(Operation::symmetric_difference, a, a)) == empty);
    CHECK(canonical(both(Operation::union_, a, ~a)) == canonical(Region<D>::full()));
    CHECK((canonical(a) == canonical(b)) == odd.is_empty());
    CHECK((a.is_bounded() && b.is_bounded()) == sum.is_bounded());
}

}  // namespace

TEST_CASE("engines: they agree and obey the laws in D = 1") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_laws<1>(seed);
}
TEST_CASE("engines: they agree and obey the laws in D = 2") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_laws<2>(seed);
}
TEST_CASE("engines: they agree and obey the laws in D = 3") {
    for (unsigned seed = 0; seed < scaled(30); ++seed) check_laws<3>(seed);
}
TEST_CASE("engines: they agree and obey the laws in D = 4") {
    for (unsigned seed = 0; seed < scaled(6); ++seed) check_laws<4>(seed);
}
TEST_CASE("engines: they agree and obey the laws in D = 5") {
    for (unsigned seed = 0; seed < scaled(2); ++seed) check_laws<5>(seed);
}

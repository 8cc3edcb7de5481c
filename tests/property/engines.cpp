// SPDX-License-Identifier: Apache-2.0
// The engines on unions of convex sets, bounded or not, in D = 1 to 5: equal canonical forms, and the laws
// of set algebra by canonical form. Where CLEAVE_LONG_TESTS is set, on 100,000 operations in D = 1, 2, 3 and on 5,000
// in D = 4, 5; an optimised build does them in minutes.
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Whether a face of one and a face of the other lie in the same plane, whichever way they face.
template <int D>
bool share_a_plane(const Region<D>& a, const Region<D>& b) {
    PlaneTable<D> table;
    std::vector<std::uint32_t> planes;
    for (const Region<D>* r : {&a, &b}) {
        std::vector<std::uint32_t> own;
        for (const auto& face : r->boundary().faces.faces)
            own.push_back(table.intern_from(r->boundary().planes, unoriented(face.plane)));
        std::sort(own.begin(), own.end());
        planes.insert(planes.end(), own.begin(), std::unique(own.begin(), own.end()));
    }
    std::sort(planes.begin(), planes.end());
    return std::adjacent_find(planes.begin(), planes.end()) != planes.end();
}

/// Draws sets, operates on them by the engines and counts what was compared.
template <int D>
class Laws {
public:
    std::size_t compared = 0;    ///< operations whose results by all engines have equal canonical forms
    std::size_t pairs = 0;       ///< pairs of random sets with a boundary
    std::size_t coincident = 0;  ///< those of them with faces in a common plane

    void check(unsigned seed) {
        Dice dice(seed);
        drawn_.clear();
        const Set a = random_set(dice);
        const Set b = random_set(dice);
        const Set not_a = complement(a);
        INFO("seed " << seed);
        count_pair(a, b);
        const Set sum = both(Operation::union_, a, b);
        const Set common = both(Operation::intersection, a, b);
        const Set a_only = both(Operation::difference, a, b);
        const Set odd = both(Operation::symmetric_difference, a, b);
        CHECK(both(Operation::union_, b, a).text == sum.text);
        CHECK(both(Operation::union_, a_only, b).text == sum.text);
        CHECK(both(Operation::union_, a_only, common).text == a.text);
        CHECK(both(Operation::symmetric_difference, sum, common).text == odd.text);
        CHECK(both(Operation::symmetric_difference, odd, b).text == a.text);
        CHECK(both(Operation::union_, a, common).text == a.text);
        CHECK(both(Operation::intersection, a, sum).text == a.text);
        CHECK(complement(both(Operation::union_, not_a, complement(b))).text == common.text);
        CHECK(complement(not_a).text == a.text);
        CHECK(both(Operation::symmetric_difference, a, a).text == canonical(Region<D>::empty()));
        CHECK(both(Operation::union_, a, not_a).text == canonical(Region<D>::full()));
        CHECK((a.text == b.text) == odd.region.is_empty());
        const Set c = random_part(dice, dice.below(2) == 0);
        const Set b_or_c = both(Operation::union_, b, c);
        CHECK(both(Operation::union_, sum, c).text == both(Operation::union_, a, b_or_c).text);
        CHECK(both(Operation::intersection, a, b_or_c).text ==
              both(Operation::union_, common, both(Operation::intersection, a, c)).text);
        CHECK((a.region.is_bounded() && b.region.is_bounded()) == sum.region.is_bounded());
    }

private:
    struct Set {
        Region<D> region;
        std::string text;  ///< its canonical form
    };

    static Set set(Region<D> region) {
        std::string text = canonical(region);
        return {std::move(region), std::move(text)};
    }
    /// Whether it is empty or full.
    static bool is_constant(const Set& a) { return a.region.is_empty() || a.region.is_full(); }
    static Set complement(const Set& a) { return set(~a.region); }

    /// The operation by the engines, which must agree; the filter's result.
    Set both(Operation operation, const Set& a, const Set& b) {
        Set by_filter = set(apply(Engine::boundary_filter, operation, a.region, b.region));
        const Region<D> by_merge = apply(Engine::tree_merge, operation, a.region, b.region);
        INFO(to_text(operation));
        REQUIRE(by_filter.text == canonical(by_merge));
        if constexpr (D == 2 || D == 3)
            REQUIRE(by_filter.text == canonical(apply(Engine::localised, operation, a.region, b.region)));
        REQUIRE(by_filter.region.is_bounded() == by_merge.is_bounded());
        ++compared;
        return by_filter;
    }

    /// A convex set with a boundary. One in two is cut by a plane of an earlier one, whichever way that faces.
    Set random_part(Dice& dice, bool bounded) {
        for (;;) {
            HalfSpaces<D> part = random_convex<D>(dice, bounded);
            if (!drawn_.empty() && dice.below(2) == 0) {
                IntegerPlane<D> known = drawn_[std::size_t(dice.below(int(drawn_.size())))];
                if (dice.below(2) == 0)
                    for (int& x : known) x = -x;
                part.planes.push_back(known);
            }
            Set s = set(region_of<D>(part.planes));
            if (is_constant(s)) continue;
            drawn_.insert(drawn_.end(), part.planes.begin(), part.planes.end());
            return s;
        }
    }

    /// Up to three convex sets joined by any operations, two in D = 5 where that takes seconds; or the complement.
    Set random_set(Dice& dice) {
        const bool bounded = dice.below(2) == 0;
        Set r = random_part(dice, bounded);
        for (int n = dice.below(D < 5 ? 3 : 2); n > 0; --n) {
            const Operation operation = all_operations[std::size_t(dice.below(4))];
            const Set more = random_part(dice, bounded);
            count_pair(r, more);
            r = both(operation, r, more);
        }
        return dice.below(4) == 0 ? complement(r) : r;
    }

    void count_pair(const Set& a, const Set& b) {
        if (is_constant(a) || is_constant(b)) return;
        ++pairs;
        coincident += share_a_plane(a.region, b.region) ? 1 : 0;
    }

    std::vector<IntegerPlane<D>> drawn_;  // the planes of this seed's sets
};

/// Checks the laws with as many seeds, or with as many as it takes to compare `operations` where long tests are wanted.
template <int D>
void check_laws(std::size_t seeds, std::size_t operations) {
    const char* text = std::getenv("CLEAVE_LONG_TESTS");
    const bool is_long = text != nullptr && *text != '\0';
    Laws<D> laws;
    unsigned seed = 0;
    for (; is_long ? laws.compared < operations : seed < scaled(seeds); ++seed) laws.check(seed);
    std::printf("engines compared in D = %d: %zu operations of %u seeds, %zu of %zu random pairs with a common plane\n",
                D, laws.compared, seed, laws.coincident, laws.pairs);
    CHECK(laws.compared >= (is_long ? operations : 17 * scaled(seeds)));
    // Coincidences are what engines differ in first: they must be frequent.
    if (laws.pairs >= 50) CHECK(3 * laws.coincident > laws.pairs);
}

}  // namespace

TEST_CASE("engines: they agree and obey the laws in D = 1") {
    check_laws<1>(100, 100'000);
}
TEST_CASE("engines: they agree and obey the laws in D = 2") {
    check_laws<2>(100, 100'000);
}
TEST_CASE("engines: they agree and obey the laws in D = 3") {
    check_laws<3>(30, 100'000);
}
TEST_CASE("engines: they agree and obey the laws in D = 4") {
    check_laws<4>(6, 5'000);
}
TEST_CASE("engines: they agree and obey the laws in D = 5") {
    check_laws<5>(2, 5'000);
}

// SPDX-License-Identifier: Apache-2.0
// Every number type in D = 4 and 5: the same sets given over each give the same canonical bytes by both engines, as
// regions and as trees, before and after operations.
#include <cleave/region/canonical.hpp>
#include <cleave/region/tree.hpp>
#include <cleave/setop/engines.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <cleave/number/fixed_int.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

using Numbers = backends::Join<std::tuple<Integer, FixedInt<512>>, backends::GmpRings, backends::BoostRings,
                               backends::GmpFields, backends::BoostFields>;

namespace {

/// The sets of one case, in plain integers, and the canonical forms that every number must give.
template <int D>
struct Case {
    std::array<HalfSpaces<D>, 2> sets;
    std::array<std::string, 2> texts;
    std::string sum;
    std::string difference;

    explicit Case(unsigned seed) {
        Dice dice(seed);
        std::vector<Region<D>> regions;
        while (regions.size() < 2) {
            // One in two has a plane of the other one.
            HalfSpaces<D> set = random_convex<D>(dice, regions.empty());
            if (!regions.empty() && dice.below(2) == 0) set.planes.push_back(sets[0].planes.front());
            Region<D> r = region_of<D>(set.planes);
            if (r.is_empty() || r.is_full()) continue;
            sets[regions.size()] = set;
            texts[regions.size()] = canonical(r);
            regions.push_back(std::move(r));
        }
        sum = canonical(apply(Operation::union_, regions[0], regions[1]));
        difference = canonical(apply(Operation::difference, regions[0], regions[1]));
    }
};

/// The cases are the same for every number: made once.
template <int D>
const std::vector<Case<D>>& cases() {
    static const std::vector<Case<D>> list = [] {
        std::vector<Case<D>> made;
        for (unsigned seed = 0; seed < scaled(D == 4 ? 8 : 2); ++seed) made.emplace_back(seed);
        return made;
    }();
    return list;
}

/// The half-spaces as planes of N, in sixths where N has fractions.
template <int D, class N>
Region<D, N> region_over(const HalfSpaces<D>& set) {
    std::vector<Plane<D, N>> planes;
    for (const IntegerPlane<D>& p : set.planes) {
        typename Plane<D, N>::Coefficients c;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) {
            if constexpr (number_traits<N>::is_field)
                c[i] = number_traits<N>::from_fraction(Integer(p[i]), Integer(6));
            else
                c[i] = number_traits<N>::from_integer(Integer(p[i]));
        }
        planes.push_back(Plane<D, N>(c));
    }
    return Region<D, N>(half_spaces<D, N>(planes));
}

template <int D, class N>
std::string through_tree(const Region<D, N>& r) {
    return canonical(to_region<D, N>(to_tree<D, N>(r)));
}

template <int D, class N>
void check_number() {
    for (std::size_t i = 0; i < cases<D>().size(); ++i) {
        INFO("D = " << D << ", case " << i);
        const Case<D>& one = cases<D>()[i];
        const Region<D, N> a = region_over<D, N>(one.sets[0]);
        const Region<D, N> b = region_over<D, N>(one.sets[1]);
        CHECK(canonical(a) == one.texts[0]);
        CHECK(canonical(b) == one.texts[1]);
        CHECK(through_tree(a) == one.texts[0]);
        CHECK(through_tree(b) == one.texts[1]);
        for (const Engine engine : all_engines) {
            const Region<D, N> sum = apply(engine, Operation::union_, a, b);
            const Region<D, N> difference = apply(engine, Operation::difference, a, b);
            CHECK(canonical(sum) == one.sum);
            CHECK(canonical(difference) == one.difference);
            if (engine != Engine::boundary_filter) continue;
            CHECK(through_tree(sum) == one.sum);
            CHECK(through_tree(difference) == one.difference);
        }
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("agreement: every number gives the same sets in D = 4 and 5", "", Numbers) {
    check_number<4, TestType>();
    check_number<5, TestType>();
}

TEST_CASE("agreement: the sets of D = 4 and 5 differ, and so do results from operands") {
    // What would let every number agree for nothing.
    for (const auto& one : cases<4>()) {
        CHECK(one.texts[0] != one.texts[1]);
        CHECK((one.sum != one.texts[0] || one.difference != one.texts[0]));
    }
    for (const auto& one : cases<5>()) {
        CHECK(one.texts[0] != one.texts[1]);
        CHECK((one.sum != one.texts[0] || one.difference != one.texts[0]));
    }
}

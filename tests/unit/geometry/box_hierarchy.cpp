// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/box_hierarchy.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

using namespace cleave;
using support::property;

namespace {

/// Small integers, some boxes flat, some empty (drawn the wrong way round), some long and thin.
template <int D>
std::vector<Box<D>> draw_boxes() {
    return support::draw_list([] {
        Box<D> b;
        for (std::size_t i = 0; i < b.size; ++i) {
            const int lo = support::draw_int(0, 40);
            const std::size_t kind = support::draw_choice({8, 1, 1});
            b.lo[i] = lo;
            b.hi[i] = lo + (kind == 0 ? support::draw_int(0, 6) : kind == 1 ? support::draw_int(20, 40) : -1);
        }
        return b;
    });
}

template <int D>
std::vector<std::pair<std::size_t, std::size_t>> meeting_pairs(const BoxHierarchy<D>& a, const BoxHierarchy<D>& b) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    BoxHierarchy<D>::for_each_meeting_pair(a, b, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
    return pairs;
}

template <int D>
void check_against_brute_force() {
    property("a box against all, each once", [] {
        const std::vector<Box<D>> all = draw_boxes<D>();
        const BoxHierarchy<D> hierarchy(all);
        for (const Box<D>& query : draw_boxes<D>()) {
            std::vector<std::size_t> expected;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (!disjoint(query, all[i])) expected.push_back(i);
            }
            std::vector<std::size_t> found;
            hierarchy.for_each_meeting(query, [&](std::size_t i) { found.push_back(i); });
            std::sort(found.begin(), found.end());
            RC_ASSERT(found == expected);
        }
        Box<D> bounds;
        std::size_t count = 0;
        for (const Box<D>& b : all) {
            if (b.is_empty()) continue;
            bounds.extend(b);
            ++count;
        }
        RC_ASSERT(hierarchy.bounds() == bounds);
        RC_ASSERT(hierarchy.size() == count);
    });
    property("all pairs, each once", [] {
        const std::vector<Box<D>> a = draw_boxes<D>();
        const std::vector<Box<D>> b = draw_boxes<D>();
        std::vector<std::pair<std::size_t, std::size_t>> expected;
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t j = 0; j < b.size(); ++j) {
                if (!disjoint(a[i], b[j])) expected.emplace_back(i, j);
            }
        }
        auto found = meeting_pairs(BoxHierarchy<D>(a), BoxHierarchy<D>(b));
        std::sort(found.begin(), found.end());
        RC_ASSERT(found == expected);
    });
}

}  // namespace

TEST_CASE("box hierarchy: agrees with brute force in D = 1") {
    check_against_brute_force<1>();
}
TEST_CASE("box hierarchy: agrees with brute force in D = 2") {
    check_against_brute_force<2>();
}
TEST_CASE("box hierarchy: agrees with brute force in D = 3") {
    check_against_brute_force<3>();
}
TEST_CASE("box hierarchy: agrees with brute force in D = 5") {
    check_against_brute_force<5>();
}

TEST_CASE("box hierarchy: nothing in, nothing out") {
    const BoxHierarchy<3> none;
    const BoxHierarchy<3> empties(std::vector<Box<3>>(7));
    const BoxHierarchy<3> one(std::vector<Box<3>>{Box<3>({0, 0, 0}, {1, 1, 1})});
    CHECK(none.size() == 0);
    CHECK(empties.size() == 0);
    CHECK(empties.bounds().is_empty());
    CHECK(meeting_pairs(none, one).empty());
    CHECK(meeting_pairs(one, empties).empty());
    CHECK(meeting_pairs(one, one) == std::vector<std::pair<std::size_t, std::size_t>>{{0, 0}});
}

TEST_CASE("box hierarchy: balanced whatever the boxes are") {
    // All equal, all on one point of an axis, a geometric progression, unbounded ones.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t n = 4096;
    std::vector<std::vector<Box<2>>> inputs(4);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i);
        inputs[0].emplace_back(Box<2>({1, 1}, {2, 2}));
        inputs[1].emplace_back(Box<2>({0, x}, {0, x}));
        inputs[2].emplace_back(Box<2>({1 / (x + 1), 0}, {1 / (x + 1), 1}));
        inputs[3].emplace_back(i % 2 == 0 ? Box<2>({-infinity, x}, {infinity, infinity}) : Box<2>({x, x}, {x, x}));
    }
    for (const std::vector<Box<2>>& boxes : inputs) {
        const BoxHierarchy<2> hierarchy(boxes);
        CHECK(hierarchy.size() == n);
        CHECK(hierarchy.depth() <= std::size_t(std::bit_width(n)));
    }
}

TEST_CASE("box hierarchy: the order of answers depends on the boxes alone") {
    std::vector<Box<1>> equal(100, Box<1>({0.0}, {1.0}));
    std::vector<std::size_t> found;
    BoxHierarchy<1>(equal).for_each_meeting(Box<1>({0.5}, {0.5}), [&](std::size_t i) { found.push_back(i); });
    CHECK(std::is_sorted(found.begin(), found.end()));
    CHECK(found.size() == 100);
}

TEST_CASE("box hierarchy: a general query descends only where it must") {
    std::vector<Box<1>> grid;
    for (int i = 0; i < 1024; ++i) grid.emplace_back(Box<1>({double(i)}, {i + 0.5}));
    std::size_t asked = 0;
    std::vector<std::size_t> found;
    BoxHierarchy<1>(grid).visit_if(
        [&](const Box<1>& b) {
            ++asked;
            return b.lo[0] <= 700 && 700 <= b.hi[0];
        },
        [&](std::size_t i) { found.push_back(i); });
    CHECK(found == std::vector<std::size_t>{700});
    CHECK(asked < 40);
}

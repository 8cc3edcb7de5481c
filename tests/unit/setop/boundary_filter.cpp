// SPDX-License-Identifier: Apache-2.0
// Over the toy space, where every unit of every facet can be looked up in a grid.
#include <cleave/setop/boundary_filter.hpp>
//
#include "support/catch.hpp"
#include "support/toy_space.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

template <std::size_t D>
using Cell = std::array<toy::Integer, D>;

/// A unit of a facet: its axis, its lowest corner, whether the outside is up.
template <std::size_t D>
using Unit = std::tuple<std::size_t, Cell<D>, bool>;

template <std::size_t D, class Look>
void for_each_cell(const Cell<D>& low, const Cell<D>& high, Look&& look) {
    Cell<D> c = low;
    for (;;) {
        look(c);
        std::size_t i = 0;
        for (; i < D && ++c[i] >= high[i]; ++i) c[i] = low[i];
        if (i == D) return;
    }
}

template <std::size_t D>
std::vector<Unit<D>> units(const toy::Facet<D>& f, bool flip = false) {
    std::vector<Unit<D>> list;
    for_each_cell<D>(f.low, f.high, [&](const Cell<D>& c) {
        list.push_back({f.plane.axis, c, (f.plane.outside == Sign::plus) != flip});
    });
    return list;
}

template <std::size_t D>
std::set<Unit<D>> boundary_units(const toy::Grid<D>& grid) {
    std::set<Unit<D>> all;
    for (const toy::Facet<D>& f : grid.boundary())
        for (const Unit<D>& u : units(f)) all.insert(u);
    return all;
}

template <std::size_t D>
std::vector<FilterOperand<toy::Facet<D>>> operands_of(const std::vector<toy::Grid<D>>& grids) {
    std::vector<FilterOperand<toy::Facet<D>>> operands;
    for (const toy::Grid<D>& g : grids) operands.push_back({g.boundary(), g.around()});
    return operands;
}

/// Filters, and compares with the grid whose cells have the function's values.
template <std::size_t D>
void check(const std::vector<toy::Grid<D>>& grids, const BooleanFunction& function) {
    const auto operands = operands_of(grids);
    toy::Space<D> space;
    BoundaryFilter<toy::Space<D>> filter(space, operands, function);
    const auto value = [&](auto&& bit) {
        BooleanFunction::Bits bits = 0;
        for (std::size_t i = 0; i < grids.size(); ++i) bits |= BooleanFunction::Bits(bit(grids[i]) ? 1 : 0) << i;
        return function(bits);
    };
    toy::Grid<D> result(grids[0].size(), value([](const toy::Grid<D>& g) { return g.around(); }));
    CHECK(filter.value_at_infinity() == result.around());
    Cell<D> end{};
    end.fill(grids[0].size());
    for_each_cell<D>({}, end, [&](const Cell<D>& c) {
        Cell<D> next = c;
        for (toy::Integer& x : next) ++x;
        result.fill(c, next, value([&](const toy::Grid<D>& g) { return g.cell(c); }));
    });
    std::vector<std::set<Unit<D>>> own;
    for (const toy::Grid<D>& g : grids) own.push_back(boundary_units(g));

    std::set<Unit<D>> found;
    struct Fate {
        std::size_t pieces = 0;
        std::size_t kept = 0;
        std::size_t flipped = 0;
    };
    std::map<std::pair<std::size_t, std::size_t>, Fate> fates;
    std::pair<std::size_t, std::size_t> last{0, 0};
    bool in_order = true;
    bool once = true;
    bool by_lowest = true;
    bool whole_is_whole = true;
    filter.run([&](std::size_t operand, std::size_t facet, Action action, const toy::Facet<D>& piece, bool whole) {
        in_order = in_order && last <= std::pair(operand, facet);
        last = {operand, facet};
        CHECK(action != Action::drop);
        whole_is_whole = whole_is_whole && whole == (piece == operands[operand].facets[facet]);
        Fate& fate = fates[last];
        ++fate.pieces;
        (action == Action::keep ? fate.kept : fate.flipped) += units(piece).size();
        for (const Unit<D>& u : units(piece, action == Action::flip)) {
            once = found.insert(u).second && once;
            Unit<D> turned = u;
            std::get<2>(turned) = !std::get<2>(u);
            for (std::size_t j = 0; j < operand; ++j)
                by_lowest = by_lowest && own[j].count(u) == 0 && own[j].count(turned) == 0;
        }
    });
    CHECK(in_order);
    CHECK(once);
    CHECK(by_lowest);
    CHECK(whole_is_whole);
    CHECK(found == boundary_units(result));
    // A facet of one fate comes back in one piece, whatever planes it went through.
    for (const auto& [of, fate] : fates) {
        const std::size_t all = units(operands[of.first].facets[of.second]).size();
        if (fate.kept == all || fate.flipped == all) CHECK(fate.pieces == 1);
    }
}

template <std::size_t D>
void check_random(unsigned seed, std::size_t rounds) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return unsigned(random() % n); };
    constexpr toy::Integer size = D == 2 ? 6 : 4;
    for (std::size_t round = 0; round < rounds; ++round) {
        const unsigned n = 2 + below(3);
        std::vector<toy::Grid<D>> grids;
        for (unsigned i = 0; i < n; ++i) {
            toy::Grid<D> g(size, below(4) == 0);
            for (unsigned boxes = below(4); boxes > 0; --boxes) {
                Cell<D> low{};
                Cell<D> high{};
                for (std::size_t k = 0; k < D; ++k) {
                    const auto [a, b] = std::minmax({below(size + 1), below(size + 1)});
                    low[k] = a;
                    high[k] = b;
                }
                g.fill(low, high, boxes % 2 == 1);
            }
            if (i > 0 && below(5) == 0) g = below(2) == 0 ? grids[0] : grids[0].complement();
            grids.push_back(g);
        }
        check(grids, BooleanFunction::from(all_operations[below(4)], n));
        check(grids, BooleanFunction::at_least(below(n + 2), n));
        check(grids,
              (BooleanFunction::operand(0, n) ^ ~BooleanFunction::operand(n - 1, n)) | BooleanFunction::operand(1, n));
    }
}

toy::Grid<2> square(toy::Integer low, toy::Integer high) {
    return toy::Grid<2>(8).fill({low, low}, {high, high});
}

}  // namespace

TEST_CASE("boundary filter: the boundary of any function's value, each part once, in the plane") {
    check_random<2>(1, scaled(150));
}

TEST_CASE("boundary filter: the boundary of any function's value, each part once, in space") {
    check_random<3>(2, scaled(60));
}

TEST_CASE("boundary filter: coincident and constant operands") {
    const toy::Grid<2> a = square(2, 6);
    const toy::Grid<2> none(8);
    for (const Operation operation : all_operations) {
        for (const toy::Grid<2>& b : {a, a.complement(), none, none.complement(), square(2, 4), square(0, 8)}) {
            check<2>({a, b}, BooleanFunction::from(operation, 2));
            check<2>({b, a}, BooleanFunction::from(operation, 2));
            check<2>({b, b, a, b}, BooleanFunction::from(operation, 4));
        }
    }
    check<2>({a}, BooleanFunction::operand(0, 1));
    check<2>({a}, ~BooleanFunction::operand(0, 1));
    check<2>({a, a}, BooleanFunction::constant(true, 2));
    check<2>({a, a}, BooleanFunction::constant(false, 2));
}

TEST_CASE("boundary filter: untouched facets are whole, crossed ones come in two pieces") {
    // A square in the corner of an L: within its box, but not touched.
    toy::Grid<2> corner(8);
    corner.fill({0, 0}, {8, 3}).fill({0, 0}, {3, 8});
    const auto operands = operands_of<2>({square(4, 7), corner});
    toy::Space<2> space;
    const BooleanFunction function = BooleanFunction::symmetric_difference(2);
    BoundaryFilter<toy::Space<2>> filter(space, operands, function);
    std::size_t pieces = 0;
    filter.run([&](std::size_t operand, std::size_t facet, Action action, const toy::Facet<2>& piece, bool whole) {
        ++pieces;
        CHECK(whole);
        CHECK(action == Action::keep);
        CHECK(piece == operands[operand].facets[facet]);
    });
    CHECK(pieces == operands[0].facets.size() + operands[1].facets.size());
    CHECK(filter.counts().nodes > 0);

    // Half of a facet inside, half outside: two pieces of one facet, one kept and one flipped.
    const auto crossing = operands_of<2>({square(0, 4), square(2, 6)});
    BoundaryFilter<toy::Space<2>> parity(space, crossing, function);
    std::vector<std::pair<std::size_t, Action>> fates;
    parity.run([&](std::size_t operand, std::size_t facet, Action action, const toy::Facet<2>& piece, bool whole) {
        if (operand != 0 || crossing[0].facets[facet].plane.at != 4) return;
        CHECK(!whole);
        CHECK(units(piece).size() == 2);
        fates.push_back({facet, action});
    });
    REQUIRE(fates.size() == 4);
    for (std::size_t i = 0; i < 4; i += 2) {
        CHECK(fates[i].first == fates[i + 1].first);
        CHECK(fates[i].second != fates[i + 1].second);
    }
    CHECK(parity.counts().piece_splits >= 4);
}

TEST_CASE("boundary filter: nothing to filter") {
    toy::Space<2> space;
    const std::vector<FilterOperand<toy::Facet<2>>> operands;
    for (const bool value : {false, true}) {
        const BooleanFunction function = BooleanFunction::constant(value, 0);
        BoundaryFilter<toy::Space<2>> filter(space, operands, function);
        CHECK(filter.value_at_infinity() == value);
        filter.run([](std::size_t, std::size_t, Action, const toy::Facet<2>&, bool) { FAIL("there is no facet"); });
    }
}

TEST_CASE("boundary filter: progress counts facets, a stop ends the work") {
    const auto operands = operands_of<2>({square(0, 4), square(2, 6)});
    toy::Space<2> space;
    const BooleanFunction function = BooleanFunction::union_(2);
    std::vector<double> shares;
    std::stop_source stop;
    ProgressReporter reporter(
        [&](std::string_view stage, double share) {
            CHECK(stage == "filter");
            shares.push_back(share);
            if (share >= 0.5) stop.request_stop();
        },
        stop.get_token(), ProgressReporter::Clock::duration::zero());
    BoundaryFilter<toy::Space<2>> filter(space, operands, function);
    std::size_t last = 0;
    const auto sink = [&](std::size_t operand, std::size_t, Action, const toy::Facet<2>&, bool) { last = operand; };
    CHECK_THROWS_AS(filter.run(sink, &reporter), Cancelled);
    CHECK(shares == std::vector<double>{0, 0.125, 0.25, 0.375, 0.5});
    CHECK(last == 0);  // the second operand was never reached
    filter.run(sink);  // and the filter can run again
    CHECK(last == 1);
}

#if CLEAVE_CONTRACTS >= 1
TEST_CASE("boundary filter: as many operands as the function takes") {
    toy::Space<2> space;
    const auto operands = operands_of<2>({square(0, 4), square(2, 6)});
    const BooleanFunction function = BooleanFunction::union_(3);
    CHECK_THROWS_AS(BoundaryFilter<toy::Space<2>>(space, operands, function), ContractViolation);
}
#endif

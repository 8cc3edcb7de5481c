// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/pivot.hpp>

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_space.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

using support::property;

namespace {

using cleave::Balanced;
using cleave::FacetSide;
using cleave::FewestSplits;
using cleave::FirstFacet;
using cleave::Sign;
using cleave::Structural;
using Sides = cleave::FacetSides;

static_assert(cleave::PivotFor<FirstFacet, toy::Space<2>>);
static_assert(cleave::PivotFor<FewestSplits, toy::Space<2>>);
static_assert(cleave::PivotFor<Balanced, toy::Space<2>>);
static_assert(cleave::PivotFor<Structural<>, toy::Space<2>>);
static_assert(cleave::PivotFor<const Structural<Balanced>, toy::Space<2>>);

/// A model that proposes nothing.
struct Quiet : toy::Space<1> {
    void propose(std::span<const facet_type>) const = delete;
};
static_assert(cleave::Clip<Quiet> && !cleave::ProposingClip<Quiet>);
static_assert(cleave::PivotFor<FirstFacet, Quiet>);
static_assert(!cleave::PivotFor<Structural<>, Quiet>);

toy::Facet<2> vertical(toy::Integer x, toy::Integer low, toy::Integer high) {
    return {{0, x, Sign::plus}, {x, low}, {x, high}};
}
toy::Facet<2> horizontal(toy::Integer y, toy::Integer low, toy::Integer high) {
    return {{1, y, Sign::plus}, {low, y}, {high, y}};
}

template <std::size_t D, class Pivot>
toy::Plane ask(const Pivot& pivot, const std::vector<toy::Facet<D>>& facets, Sides& sides) {
    toy::Space<D> space;
    sides.clear();
    return pivot(space, std::span<const toy::Facet<D>>(facets), sides);
}

template <std::size_t D, class Pivot>
toy::Plane ask(const Pivot& pivot, const std::vector<toy::Facet<D>>& facets) {
    Sides sides;
    return ask(pivot, facets, sides);
}

/// Whether the sides that a pivot left behind are those of its plane.
template <std::size_t D, class Pivot>
bool sides_belong(const Pivot& pivot, const std::vector<toy::Facet<D>>& facets) {
    Sides sides;
    const toy::Plane h = ask(pivot, facets, sides);
    if (sides.list.empty()) return true;
    toy::Space<D> space;
    Sides again;
    cleave::find_sides(space, h, std::span<const toy::Facet<D>>(facets), again);
    return sides.list == again.list && sides.counts == again.counts;
}

}  // namespace

TEST_CASE("pivot: the sides of a list are found and counted") {
    toy::Space<2> space;
    const std::vector<toy::Facet<2>> facets{vertical(1, 0, 2),   vertical(2, 0, 2),   space.flip(vertical(2, 2, 3)),
                                            vertical(3, 0, 2),   horizontal(0, 1, 3), horizontal(0, 0, 2),
                                            horizontal(1, 2, 4), horizontal(1, 0, 4)};
    Sides sides;
    sides.list = {FacetSide::crossing};
    sides.counts.add(FacetSide::crossing);
    cleave::find_sides(space, {0, 2, Sign::plus}, std::span(facets), sides);
    const cleave::SideCounts& c = sides.counts;
    CHECK(sides.list == std::vector<FacetSide>{FacetSide::minus, FacetSide::on_same, FacetSide::on_opposite,
                                               FacetSide::plus, FacetSide::crossing, FacetSide::minus, FacetSide::plus,
                                               FacetSide::crossing});
    CHECK(c[FacetSide::minus] == 2);
    CHECK(c[FacetSide::plus] == 2);
    CHECK(c[FacetSide::on_same] == 1);
    CHECK(c[FacetSide::on_opposite] == 1);
    CHECK(c.on() == 2);
    CHECK(c.crossing() == 2);
    CHECK(c.to_minus() == 4);
    CHECK(c.to_plus() == 4);
    CHECK(space.counts.sides == facets.size());
}

TEST_CASE("pivot: the first facet's plane, at no cost") {
    const std::vector<toy::Facet<2>> facets{vertical(3, 0, 1), vertical(1, 0, 2)};
    toy::Space<2> space;
    Sides sides;
    CHECK(FirstFacet{}(space, std::span(facets), sides) == facets[0].plane);
    CHECK(space.counts.sides == 0);
    CHECK(sides.list.empty());
}

TEST_CASE("pivot: fewest splits prefers the plane that splits least, then the earliest") {
    // The line y = 1 splits both uprights; each upright splits only the line.
    const std::vector<toy::Facet<2>> facets{horizontal(1, 0, 4), vertical(1, 0, 2), vertical(2, 0, 2)};
    CHECK(ask(FewestSplits{3}, facets) == facets[1].plane);
    CHECK(ask(FewestSplits{1}, facets) == facets[0].plane);
    CHECK(ask(FewestSplits{0}, facets) == facets[0].plane);
    const std::vector<toy::Facet<2>> free{vertical(1, 0, 2), vertical(2, 0, 2), horizontal(3, 0, 4)};
    toy::Space<2> space;
    Sides sides;
    CHECK(FewestSplits{3}(space, std::span(free), sides) == free[2].plane);
    // With a plane that splits nothing found, the rest is not looked at.
    const std::vector<toy::Facet<2>> early{vertical(9, 0, 2), vertical(1, 0, 2), vertical(2, 0, 2)};
    space.counts = {};
    CHECK(FewestSplits{3}(space, std::span(early), sides) == early[0].plane);
    CHECK(space.counts.sides == 3);
}

TEST_CASE("pivot: candidates are spread over the whole list") {
    const std::vector<toy::Facet<1>> facets = toy::comb(50);
    toy::Space<1> space;
    Sides sides;
    const toy::Plane h = Balanced{4}(space, std::span(facets), sides);
    CHECK(h == facets[50].plane);  // of 0, 25, 50, 75
    CHECK(space.counts.sides == 4 * facets.size());
}

TEST_CASE("pivot: balance weighs splits against unequal halves") {
    const std::vector<toy::Facet<1>> facets = toy::comb(4);
    CHECK(ask(Balanced{8}, facets).at == 3);  // of 3 | 4 and 4 | 3 the earlier
    // x = 2 halves the uprights but splits the line; x = 5 splits nothing and leaves all on one side.
    const std::vector<toy::Facet<2>> row{vertical(1, 0, 2), vertical(2, 0, 2), vertical(3, 0, 2), horizontal(3, 1, 4),
                                         vertical(5, 0, 2)};
    CHECK(ask(Balanced{5, 1}, row) == row[1].plane);
    CHECK(ask(Balanced{5, 100}, row) == row[0].plane);
}

TEST_CASE("pivot: structural takes the model's proposal while it divides") {
    const std::vector<toy::Facet<1>> facets = toy::comb(50);
    toy::Space<1> space;
    Sides sides;
    const toy::Plane h = Structural<>{}(space, std::span(facets), sides);
    CHECK(h == toy::Plane{0, 50, Sign::plus});
    CHECK(sides.list.size() == facets.size());
    CHECK(space.counts.sides == facets.size());
}

TEST_CASE("pivot: structural leaves small lists and useless proposals to its fall-back") {
    const std::vector<toy::Facet<1>> facets = toy::comb(6);
    CHECK(ask(Structural<FirstFacet>{12, {}}, facets) == facets[0].plane);
    CHECK(ask(Structural<FirstFacet>{11, {}}, facets) == toy::Plane{0, 6, Sign::plus});

    // Long parallel slivers: the longest axis runs along them, its median splits them all.
    std::vector<toy::Facet<2>> slivers;
    for (toy::Integer y = 0; y < 20; ++y) slivers.push_back(horizontal(y, 0, 100));
    toy::Space<2> space;
    REQUIRE(space.propose(std::span<const toy::Facet<2>>(slivers)) == toy::Plane{0, 50, Sign::plus});
    Sides sides;
    CHECK(ask(Structural<FirstFacet>{}, slivers, sides) == slivers[0].plane);
    CHECK(sides.list.empty());

    // All in one plane: there is no proposal.
    const std::vector<toy::Facet<1>> same(20, facets[0]);
    CHECK(ask(Structural<FirstFacet>{}, same) == facets[0].plane);
}

TEST_CASE(
    "pivot: a proposal is taken if the squares of its sides are at most seven eighths of the square of the whole") {
    // n = 20 facets, all but `aside` of them crossing the proposal x = 50.
    const auto bundle = [](std::size_t aside) {
        std::vector<toy::Facet<2>> facets;
        for (toy::Integer y = 0; y < 20; ++y) facets.push_back(horizontal(y, 0, 100));
        for (std::size_t i = 0; i < aside; ++i) {
            facets[i].low[0] = i % 2 == 0 ? 0 : 50;
            facets[i].high[0] = i % 2 == 0 ? 50 : 100;
        }
        return facets;
    };
    toy::Space<2> space;
    for (const std::size_t aside : {0U, 2U, 10U, 12U, 14U, 20U}) {
        const std::vector<toy::Facet<2>> facets = bundle(aside);
        Sides sides;
        const std::optional<toy::Plane> proposal = space.propose(std::span<const toy::Facet<2>>(facets));
        REQUIRE(proposal);
        const std::size_t half = 20 - aside / 2;
        if (proposal->at != 50) continue;
        const bool taken = ask(Structural<FirstFacet>{}, facets) == *proposal;
        CHECK(taken == (8 * 2 * half * half <= 7 * 400));
    }
    CHECK(ask(Structural<FirstFacet>{}, bundle(12)) == toy::Plane{1, 0, Sign::plus});   // 14^2 + 14^2 = 392 > 350
    CHECK(ask(Structural<FirstFacet>{}, bundle(14)) == toy::Plane{0, 50, Sign::plus});  // 13^2 + 13^2 = 338
}

TEST_CASE("pivot: where no proposal divides, structural looks for a plane through a ridge") {
    // Proposes nothing; names the line across each end of a segment.
    struct Turning : toy::Space<2> {
        std::size_t asked = 0;
        std::optional<toy::Plane> propose(std::span<const facet_type>) const { return std::nullopt; }
        std::vector<toy::Plane> planes_through(const toy::Plane& g, const toy::Plane& h) {
            ++asked;
            CHECK(g.axis != h.axis);
            return {flip_plane(h)};
        }
    };
    static_assert(cleave::TurningClip<Turning>);
    static_assert(!cleave::TurningClip<toy::Space<2>>);

    // Twenty steps of a stair, one above and behind the other: the first facet with an end that divides
    // them well ends the search, and the better of its ends is taken.
    std::vector<toy::Facet<2>> stairs;
    for (toy::Integer i = 0; i < 20; ++i) stairs.push_back(horizontal(i, 2 * i, 2 * i + 2));
    Turning model;
    Sides sides;
    const toy::Plane h = Structural<FirstFacet>{12, {}, 4}(model, std::span(stairs), sides);
    CHECK(h == toy::Plane{0, 12, Sign::minus});  // facet 5 of 0, 5, 10, 15 ends there
    CHECK(sides.counts.to_minus() == 14);
    CHECK(sides.counts.to_plus() == 6);
    CHECK(model.asked == 4);  // two ends each of facets 0 and 5

    // Slivers beside each other have their ends in two lines only: nothing divides them.
    std::vector<toy::Facet<2>> slivers;
    for (toy::Integer y = 0; y < 20; ++y) slivers.push_back(horizontal(y, 0, 100));
    sides.clear();
    model.asked = 0;
    CHECK(Structural<FirstFacet>{}(model, std::span(slivers), sides) == slivers[0].plane);
    CHECK(sides.list.empty());
    CHECK(model.asked == 16);

    // Of a long list only a sample is looked at.
    for (toy::Integer y = 20; y < 5000; ++y) slivers.push_back(horizontal(y, 0, 100));
    model.counts = {};
    CHECK(Structural<FirstFacet>{}(model, std::span(slivers), sides) == slivers[0].plane);
    CHECK(model.counts.sides <= 16 * 256);
    for (toy::Integer i = 20; i < 5000; ++i) stairs.push_back(horizontal(i, 2 * i, 2 * i + 2));
    model.counts = {};
    (void)Structural<FirstFacet>{}(model, std::span(stairs), sides);
    CHECK(sides.list.size() == 5000);
    CHECK(sides.counts.to_minus() * 4 >= 5000);
    CHECK(sides.counts.to_plus() * 4 >= 5000);
    CHECK(model.counts.sides <= 16 * 256 + 5000);

    // Small lists are left to the fall-back at once.
    stairs.resize(12);
    model.asked = 0;
    CHECK(Structural<FirstFacet>{}(model, std::span(stairs), sides) == stairs[0].plane);
    CHECK(model.asked == 0);
}

TEST_CASE("pivot: the sides left behind are those of the chosen plane, and the choice is repeatable") {
    property("in one, two and three dimensions",
             [](const toy::Grid<1>& a, const toy::Grid<2>& b, const toy::Grid<3>& c) {
                 const auto holds = [](const auto& facets) {
                     if (facets.empty()) return true;
                     const auto one = [&](const auto& pivot) {
                         return sides_belong(pivot, facets) && ask(pivot, facets) == ask(pivot, facets);
                     };
                     return one(FirstFacet{}) && one(FewestSplits{}) && one(FewestSplits{1000}) && one(Balanced{}) &&
                            one(Balanced{3, 0}) && one(Structural<>{}) && one(Structural<Balanced>{2, {}});
                 };
                 RC_ASSERT(holds(a.boundary()));
                 RC_ASSERT(holds(b.boundary()));
                 RC_ASSERT(holds(c.boundary()));
             });
}

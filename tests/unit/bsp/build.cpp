// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/build.hpp>

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_space.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/complement.hpp>
#include <cleave/bsp/invariant.hpp>
#include <cleave/bsp/statistics.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

using support::property;

namespace {

using cleave::Balanced;
using cleave::Branch;
using cleave::FacetSide;
using cleave::FacetSides;
using cleave::FewestSplits;
using cleave::FirstFacet;
using cleave::Location;
using cleave::Sign;
using cleave::Structural;

/// The first facet's plane the wrong way round: every facet in it is anti-oriented.
struct FlippedFirst {
    template <class M>
    auto operator()(M& m, std::span<const typename M::facet_type> facets, FacetSides&) const {
        return m.flip_plane(m.plane_of(facets.front()));
    }
};

/// Always the same plane, whether it helps or not.
struct Stubborn {
    toy::Plane plane;
    template <class M>
    toy::Plane operator()(M&, std::span<const typename M::facet_type>, FacetSides&) const {
        return plane;
    }
};

/// The last facet's plane, with its sides worked out.
struct LastWithSides {
    template <class M>
    auto operator()(M& m, std::span<const typename M::facet_type> facets, FacetSides& sides) const {
        const auto h = m.plane_of(facets.back());
        cleave::find_sides(m, h, facets, sides);
        return h;
    }
};

/// The measure of each plane's facets, counted by orientation: splitting does not change it.
template <std::size_t D>
std::map<std::pair<std::size_t, toy::Integer>, toy::Integer> areas(std::span<const toy::Facet<D>> facets) {
    std::map<std::pair<std::size_t, toy::Integer>, toy::Integer> sums;
    for (const toy::Facet<D>& f : facets) {
        toy::Integer a = f.plane.outside == Sign::plus ? 1 : 1000;
        for (std::size_t i = 0; i < D; ++i) a *= i == f.plane.axis ? 1 : f.high[i] - f.low[i];
        sums[{f.plane.axis, f.plane.at}] += a;
    }
    return sums;
}

/// Everything that must hold of a tree built from the boundary of `grid`, whatever the pivot.
template <std::size_t D, class Pivot>
void check_build(const toy::Grid<D>& grid, const Pivot& pivot) {
    toy::Space<D> space;
    const std::vector<toy::Facet<D>> facets = grid.boundary();
    const auto built = cleave::build_with_facets(space, facets, pivot, grid.around());
    RC_ASSERT(cleave::check_structure(built.tree).empty());
    RC_ASSERT(cleave::check_facets(space, built).empty());
    RC_ASSERT(toy::agrees(built.tree, grid));
    RC_ASSERT(built.facets.node_count() == built.tree.node_count());
    RC_ASSERT(areas<D>(built.facets.all()) == areas<D>(facets));
    RC_ASSERT(cleave::build(space, facets, pivot, grid.around()) == built.tree);
    RC_ASSERT((built.tree.is_single_leaf()) == facets.empty());
}

template <std::size_t D>
void check_all_pivots(const toy::Grid<D>& grid) {
    check_build(grid, FirstFacet{});
    check_build(grid, FlippedFirst{});
    check_build(grid, LastWithSides{});
    check_build(grid, FewestSplits{});
    check_build(grid, FewestSplits{3});
    check_build(grid, Balanced{});
    check_build(grid, Balanced{1000, 0});
    check_build(grid, Structural<>{});
    check_build(grid, Structural<FirstFacet>{1, {}});
    check_build(grid, Structural<Balanced>{4, {}});
    // Any plane at all gives the right set: where it does not divide, the first facet's is taken.
    check_build(grid, Stubborn{{0, 2, Sign::plus}});
    check_build(grid, Stubborn{{D - 1, 1, Sign::minus}});
    check_build(grid, Stubborn{{0, 1000, Sign::plus}});
}

}  // namespace

TEST_CASE("build: without facets the tree is what the caller says space is") {
    toy::Space<2> space;
    CHECK(cleave::build(space, {}) == toy::Tree<>(false));
    CHECK(cleave::build(space, {}, FirstFacet{}, true) == toy::Tree<>(true));
    CHECK(cleave::build_with_facets(space, {}, FirstFacet{}, true).facets.node_count() == 0);
}

TEST_CASE("build: one facet is a half-space with inside below it") {
    toy::Space<1> space;
    const toy::Facet<1> end{{0, 5, Sign::plus}, {5}, {5}};
    const toy::Plane h = end.plane;
    CHECK(cleave::build(space, {end}) == toy::Tree<>(h, toy::Tree<>(true), toy::Tree<>(false)));
    // By the flipped plane the facet is anti-oriented, and the labels change places with the sides.
    CHECK(cleave::build(space, {end}, FlippedFirst{}) ==
          toy::Tree<>(space.flip_plane(h), toy::Tree<>(false), toy::Tree<>(true)));
    const auto kept = cleave::build_with_facets(space, {end}, FlippedFirst{});
    CHECK(kept.facets.same(kept.tree.root()).empty());
    REQUIRE(kept.facets.opposite(kept.tree.root()).size() == 1);
    CHECK(kept.facets.opposite(kept.tree.root()).front() == end);
}

TEST_CASE("build: a square is four cuts in a row, in the order of its facets") {
    toy::Space<2> space;
    toy::Grid<2> grid(4);
    grid.fill({1, 1}, {3, 3});
    const std::vector<toy::Facet<2>> f = grid.boundary();
    const toy::Tree<> out(false);
    const toy::Tree<> expected(
        f[0].plane,
        toy::Tree<>(f[1].plane, toy::Tree<>(f[2].plane, toy::Tree<>(f[3].plane, toy::Tree<>(true), out), out), out),
        out);
    CHECK(cleave::build(space, f) == expected);
    CHECK(space.counts.sides == 4 + 3 + 2 + 1);
    CHECK(space.counts.splits == 0);
}

TEST_CASE("build: nodes are numbered parents first, minus before plus") {
    toy::Space<1> space;
    const toy::Tree<> t = cleave::build(space, toy::comb(8), Balanced{16});
    std::uint32_t next_node = 0;
    std::vector<Branch> open{t.root()};
    while (!open.empty()) {
        const Branch b = open.back();
        open.pop_back();
        if (b.is_leaf()) continue;
        CHECK(b.index() == next_node++);
        open.push_back(t.plus(b));
        open.push_back(t.minus(b));
    }
    CHECK(next_node == 16);
}

TEST_CASE("build: every pivot gives the oracle's set in one, two and three dimensions") {
    property("on a line", [](const toy::Grid<1>& grid) { check_all_pivots(grid); });
    property("in the plane", [](const toy::Grid<2>& grid) { check_all_pivots(grid); });
    property("in space", [](const toy::Grid<3>& grid) { check_all_pivots(grid); });
}

TEST_CASE("build: the flipped boundary gives the complement") {
    property("in the plane", [](const toy::Grid<2>& grid) {
        toy::Space<2> space;
        std::vector<toy::Facet<2>> flipped;
        for (const toy::Facet<2>& f : grid.boundary()) flipped.push_back(space.flip(f));
        const auto t = cleave::build_with_facets(space, std::move(flipped), FewestSplits{}, !grid.around());
        RC_ASSERT(cleave::check_facets(space, t).empty());
        RC_ASSERT(toy::agrees(t.tree, grid.complement()));
        RC_ASSERT(toy::agrees(cleave::complement(t.tree), grid));
    });
}

TEST_CASE("build: the order of the facets changes the tree, not the set") {
    property("in the plane", [](const toy::Grid<2>& grid) {
        std::vector<toy::Facet<2>> facets = grid.boundary();
        for (std::size_t i = facets.size(); i > 1; --i) {
            std::swap(facets[i - 1], facets[support::draw_index(i)]);
        }
        toy::Space<2> space;
        RC_ASSERT(toy::agrees(cleave::build(space, facets, FirstFacet{}, grid.around()), grid));
        RC_ASSERT(toy::agrees(cleave::build(space, facets, Structural<>{}, grid.around()), grid));
    });
}

TEST_CASE("build: a structural cut that facets lie in is a facet cut") {
    // Two squares that meet in the point (1,1), and the cut y = 1 that carries a side of each, facing both ways.
    toy::Grid<2> grid(2);
    grid.fill({0, 0}, {1, 1}).fill({1, 1}, {2, 2});
    toy::Space<2> space;
    const toy::Plane y1{1, 1, Sign::plus};
    const auto t = cleave::build_with_facets(space, grid.boundary(), Stubborn{y1});
    CHECK(t.tree.cut(t.tree.root()) == y1);
    CHECK(t.facets.same(t.tree.root()).size() == 1);
    CHECK(t.facets.opposite(t.tree.root()).size() == 1);
    CHECK(cleave::check_facets(space, t).empty());
    CHECK(toy::agrees(t.tree, grid));
}

TEST_CASE("build: an anti-oriented facet on a structural cut swaps the labels of empty children") {
    toy::Grid<2> grid(3);
    grid.fill({0, 0}, {1, 1});
    toy::Space<2> space;
    const toy::Plane against{0, 1, Sign::minus};  // the plane of the side x = 1, with its outside at x < 1
    const auto t = cleave::build_with_facets(space, grid.boundary(), Stubborn{against});
    REQUIRE(t.tree.cut(t.tree.root()) == against);
    CHECK(t.facets.same(t.tree.root()).empty());
    CHECK(t.facets.opposite(t.tree.root()).size() == 1);
    const Branch beyond = t.tree.minus(t.tree.root());
    REQUIRE(beyond.is_leaf());
    CHECK_FALSE(t.tree.label(beyond));
    CHECK(toy::agrees(t.tree, grid));
}

TEST_CASE("build: a cut without facets needs facets on both sides") {
    toy::Space<1> space;
    const std::vector<toy::Facet<1>> facets = toy::comb(2);  // [0,1] and [2,3]
    // Between 1 and 2 there is no integer, so look at [0,1] and [4,5].
    std::vector<toy::Facet<1>> apart = facets;
    for (std::size_t i = 2; i < 4; ++i) {
        apart[i].plane.at += 2;
        apart[i].low[0] += 2;
        apart[i].high[0] += 2;
    }
    const toy::Plane between{0, 2, Sign::plus};
    const auto t = cleave::build_with_facets(space, apart, Stubborn{between});
    CHECK(t.tree.cut(t.tree.root()) == between);
    CHECK(t.facets.same(t.tree.root()).empty());
    CHECK(t.facets.opposite(t.tree.root()).empty());
    CHECK(t.tree.minus(t.tree.root()).is_node());
    CHECK(t.tree.plus(t.tree.root()).is_node());
    CHECK(t.tree.node_count() == 5);
    // Once more below it, the same plane divides nothing and is not taken.
    CHECK(t.tree.cut(t.tree.minus(t.tree.root())) == apart[0].plane);
    CHECK(cleave::build(space, apart, Stubborn{{0, 9, Sign::plus}}) == cleave::build(space, apart, FirstFacet{}));
}

TEST_CASE("build: sides that the pivot has worked out are not asked for again") {
    toy::Space<1> space;
    const std::vector<toy::Facet<1>> facets = toy::comb(20);
    const std::size_t n = facets.size();
    (void)cleave::build(space, facets, FirstFacet{});
    CHECK(space.counts.sides == n * (n + 1) / 2);
    space.counts = {};
    (void)cleave::build(space, facets, LastWithSides{});
    CHECK(space.counts.sides == n * (n + 1) / 2);
}

TEST_CASE("build: what is kept in place survives a split behind it") {
    // In the list of the root the first facet stays, the second is split, so that the first is where it belongs.
    toy::Grid<2> grid(4);
    grid.fill({0, 0}, {4, 1}).fill({2, 1}, {4, 4});
    struct Heavy : toy::Space<2> {
        struct facet_type : toy::Facet<2> {
            std::vector<toy::Integer> load;  // a vector loses its contents if it is moved to itself
        };
        toy::Plane plane_of(const facet_type& f) const { return f.plane; }
        FacetSide side(const toy::Plane& h, const facet_type& f) { return toy::Space<2>::side(h, f); }
        cleave::Split<facet_type> split(const toy::Plane& h, const facet_type& f) {
            const cleave::Split<toy::Facet<2>> s = toy::Space<2>::split(h, f);
            cleave::Split<facet_type> loaded;
            loaded.side = s.side;
            if (s.minus) loaded.minus = facet_type{*s.minus, f.load};
            if (s.plus) loaded.plus = facet_type{*s.plus, f.load};
            if (s.on) loaded.on = facet_type{*s.on, f.load};
            return loaded;
        }
        facet_type flip(const facet_type& f) const { return {toy::Space<2>::flip(f), f.load}; }
        std::vector<toy::Plane> ridges(const facet_type& f) const { return toy::Space<2>::ridges(f); }
    };
    std::vector<Heavy::facet_type> facets;
    for (const toy::Facet<2>& f : grid.boundary()) facets.push_back({f, {f.low[0], f.low[1]}});
    Heavy model;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const auto t = cleave::build_with_facets(model, facets, FirstFacet{});
        CHECK(toy::agrees(t.tree, grid));
        for (const Heavy::facet_type& f : t.facets.all()) CHECK(f.load.size() == 2);
        std::rotate(facets.begin(), facets.begin() + 1, facets.end());
    }
}

TEST_CASE("build: children and nodes receive their facets in the order of the input") {
    toy::Space<1> line;
    std::vector<toy::Facet<1>> ends = toy::comb(5);  // 0, 1, ..., 9
    for (const std::size_t root : {2U, 3U, 6U, 7U}) {
        std::vector<toy::Facet<1>> facets = ends;
        std::rotate(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(root), facets.begin() + 8);
        const toy::Tree<> t = cleave::build(line, facets);
        CHECK(t.cut(t.root()) == ends[root].plane);
        for (const cleave::ChildSide side : {cleave::ChildSide::minus, cleave::ChildSide::plus}) {
            // The first facet of the input on this side is the child's cut.
            const FacetSide wanted = side == cleave::ChildSide::minus ? FacetSide::minus : FacetSide::plus;
            const auto first = std::find_if(facets.begin(), facets.end(), [&](const toy::Facet<1>& f) {
                return line.side(ends[root].plane, f) == wanted;
            });
            REQUIRE(first != facets.end());
            CHECK(t.cut(t.child(t.root(), side)) == first->plane);
        }
    }

    // Four squares in a row: their upper sides lie in one plane, which is the first cut.
    toy::Grid<2> row(8);
    for (toy::Integer x = 0; x < 8; x += 2) row.fill({x, 3}, {x + 1, 4}).fill({x, 4}, {x + 1, 5}, false);
    row.fill({1, 4}, {2, 5}).fill({3, 4}, {4, 5});
    toy::Space<2> plane;
    const std::vector<toy::Facet<2>> facets = row.boundary();
    const auto t = cleave::build_with_facets(plane, facets, Stubborn{{1, 4, Sign::plus}});
    const auto in_order = [&](std::span<const toy::Facet<2>> kept) {
        CHECK(kept.size() > 1);
        CHECK(std::is_sorted(kept.begin(), kept.end(), [&](const toy::Facet<2>& a, const toy::Facet<2>& b) {
            return std::find(facets.begin(), facets.end(), a) < std::find(facets.begin(), facets.end(), b);
        }));
    };
    in_order(t.facets.same(t.tree.root()));
    in_order(t.facets.opposite(t.tree.root()));
}

TEST_CASE("build: a facet that is split is split once a cut") {
    // A wall from 0 to 8 and three posts whose planes cross it.
    toy::Grid<2> grid(9);
    grid.fill({0, 0}, {8, 1}).fill({2, 3}, {3, 4}).fill({5, 3}, {6, 4});
    toy::Space<2> space;
    const std::vector<toy::Facet<2>> facets = grid.boundary();
    const toy::Tree<> posts_first = cleave::build(space, {facets.rbegin(), facets.rend()}, FirstFacet{});
    CHECK(toy::agrees(posts_first, grid));
    const std::size_t splits = space.counts.splits;
    space.counts = {};
    (void)cleave::build(space, facets, FewestSplits{100});
    CHECK(space.counts.splits <= splits);
}

TEST_CASE("build: facets are moved, never copied, but for the first list") {
    static std::size_t copies = 0;
    struct Counted : toy::Facet<1> {
        Counted() = default;
        explicit Counted(const toy::Facet<1>& f) : toy::Facet<1>(f) {}
        Counted(const Counted& other) : toy::Facet<1>(other) { ++copies; }
        Counted(Counted&&) = default;
        Counted& operator=(const Counted& other) {
            ++copies;
            toy::Facet<1>::operator=(other);
            return *this;
        }
        Counted& operator=(Counted&&) = default;
        ~Counted() = default;
    };
    struct Model {
        using plane_type = toy::Plane;
        using facet_type = Counted;
        toy::Space<1> base;
        toy::Plane plane_of(const Counted& f) const { return f.plane; }
        cleave::PlaneRelation relation(const toy::Plane& h, const toy::Plane& g) const { return base.relation(h, g); }
        FacetSide side(const toy::Plane& h, const Counted& f) { return base.side(h, f); }
        cleave::Split<Counted> split(const toy::Plane&, const Counted&) { return {}; }  // points are never split
        Counted flip(const Counted& f) const { return Counted(base.flip(f)); }
        toy::Plane flip_plane(const toy::Plane& h) const { return base.flip_plane(h); }
        std::vector<toy::Plane> ridges(const Counted&) const { return {}; }
    };
    static_assert(cleave::Clip<Model>);
    Model model;
    for (const bool balanced : {false, true}) {
        std::vector<Counted> facets;
        for (const toy::Facet<1>& f : toy::comb(32)) facets.emplace_back(f);
        copies = 0;
        const auto t = balanced ? cleave::build_with_facets(model, std::move(facets), Balanced{64})
                                : cleave::build_with_facets(model, std::move(facets), FirstFacet{});
        CHECK(copies == 0);
        CHECK(t.facets.all().size() == 64);
        CHECK(cleave::statistics(t.tree).depth == (balanced ? 7 : 64));
    }
}

TEST_CASE("build: a facet that is not in its own plane is refused, not cut for ever") {
    struct Broken : toy::Space<1> {
        toy::Plane plane_of(const facet_type& f) const { return {0, f.plane.at + 100, f.plane.outside}; }
    };
    Broken model;
    CHECK_THROWS_AS(cleave::build(model, toy::comb(3)), cleave::ContractViolation);
}

TEST_CASE("build: a structural tree of 20,000 facets has logarithmic depth") {
    toy::Space<1> line;
    const cleave::TreeStatistics s = cleave::statistics(cleave::build(line, toy::comb(10'000), Structural<>{}));
    CHECK(s.nodes == 20'000);
    CHECK(s.depth < 32);

    // In the plane: the staircase x + y < n, whose steps are all in convex position to a pivot that only sees them.
    constexpr toy::Integer n = 10'000;
    std::vector<toy::Facet<2>> stairs;
    for (toy::Integer i = 0; i < n; ++i) {
        stairs.push_back({{0, n - i, Sign::plus}, {n - i, i}, {n - i, i + 1}});
        stairs.push_back({{1, i + 1, Sign::plus}, {n - i - 1, i + 1}, {n - i, i + 1}});
    }
    stairs.push_back({{0, 0, Sign::minus}, {0, 0}, {0, n}});
    stairs.push_back({{1, 0, Sign::minus}, {0, 0}, {n, 0}});
    toy::Space<2> plane;
    const toy::Tree<> t = cleave::build(plane, stairs, Structural<>{});
    CHECK(cleave::statistics(t).depth < 64);
    for (toy::Integer i = 0; i < n; i += 97) {
        CHECK(cleave::classify(plane, t, {2 * i + 1, 2 * (n - i - 1) + 1}) == Location::inside);
        CHECK(cleave::classify(plane, t, {2 * i + 1, 2 * (n - i) + 1}) == Location::outside);
        CHECK(cleave::classify(plane, t, {2 * i + 1, 2 * (n - i)}) == Location::boundary);
    }
}

TEST_CASE("build: depth 100,000 is reached, checked and asked without recursion") {
    // The even numbers are lower ends of intervals, the odd ones upper ends. A depth of n means n^2 / 2 sides.
    struct Ruler {
        using plane_type = std::int32_t;
        using facet_type = std::int32_t;
        using point_type = toy::Point<1>;
        std::int32_t plane_of(std::int32_t f) const { return f; }
        FacetSide side(std::int32_t h, std::int32_t f) const {
            if (f == h) return FacetSide::on_same;
            return (f > h) == (h % 2 == 0) ? FacetSide::minus : FacetSide::plus;
        }
        Sign side(std::int32_t h, const point_type& p) const {
            const Sign s = cleave::sign_of_value(p[0] - 2 * h);
            return h % 2 == 0 ? -s : s;
        }
        cleave::PlaneRelation relation(std::int32_t, std::int32_t) const { return cleave::PlaneRelation::parallel; }
        cleave::Split<std::int32_t> split(std::int32_t h, std::int32_t f) const {
            cleave::Split<std::int32_t> s;
            s.side = side(h, f);
            (s.side == FacetSide::minus ? s.minus : s.side == FacetSide::plus ? s.plus : s.on) = f;
            return s;
        }
        std::int32_t flip(std::int32_t f) const { return f; }
        std::int32_t flip_plane(std::int32_t h) const { return h; }
        std::span<const std::int32_t> ridges(std::int32_t) const { return {}; }
        point_type witness(std::int32_t f) const { return {2 * f}; }
    };
    static_assert(cleave::LocatingClip<Ruler>);
    // The first facet's plane with its sides, which are known without a test: all others lie below or all above.
    const auto first_with_sides = [](Ruler&, std::span<const std::int32_t> list, FacetSides& sides) {
        const FacetSide others = list.front() % 2 == 0 ? FacetSide::minus : FacetSide::plus;
        sides.list.assign(list.size(), others);
        sides.list.front() = FacetSide::on_same;
        sides.counts.add(others, list.size() - 1);
        sides.counts.add(FacetSide::on_same);
        return list.front();
    };
    const std::size_t n = scaled(50'000) * 2;
    std::vector<std::int32_t> facets(n);
    for (std::size_t i = 0; i < n; ++i) facets[i] = static_cast<std::int32_t>(i);
    Ruler model;
    const auto t = cleave::build_with_facets(model, std::move(facets), first_with_sides);
    CHECK(cleave::statistics(t.tree) == cleave::TreeStatistics{n, n + 1, n, n * (n + 1) / 2 + n});
    CHECK(cleave::check_structure(t.tree).empty());
    CHECK(t.facets.all().size() == n);
    const auto last = static_cast<toy::Integer>(n - 1);
    CHECK(cleave::classify(model, t.tree, {-1}) == Location::outside);
    CHECK(cleave::classify(model, t.tree, {2 * last - 1}) == Location::inside);
    CHECK(cleave::classify(model, t.tree, {2 * last}) == Location::boundary);
    CHECK(cleave::classify(model, t.tree, {2 * last + 1}) == Location::outside);
}

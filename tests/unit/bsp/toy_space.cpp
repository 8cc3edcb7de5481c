// SPDX-License-Identifier: Apache-2.0
#include "support/toy_space.hpp"

#include "support/catch.hpp"
#include "support/clip_laws.hpp"
#include "support/toy_generators.hpp"

#include <array>
#include <cstddef>
#include <vector>

using support::property;

namespace {

using cleave::FacetSide;
using cleave::Location;
using cleave::Sign;

template <std::size_t D>
std::vector<toy::Plane> all_planes(toy::Integer size) {
    std::vector<toy::Plane> planes;
    for (std::size_t axis = 0; axis < D; ++axis) {
        for (toy::Integer at = -1; at <= size + 1; ++at) {
            planes.push_back({axis, at, Sign::plus});
            planes.push_back({axis, at, Sign::minus});
        }
    }
    return planes;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("toy space: it obeys the laws of Clip in one, two and three dimensions", "",
                       ((std::size_t D), D), 1, 2, 3) {
    toy::Grid<D> grid(3);
    std::array<toy::Integer, D> low{};
    std::array<toy::Integer, D> high{};
    low.fill(0);
    high.fill(2);
    grid.fill(low, high);
    low.fill(1);
    high.fill(3);
    grid.fill(low, high);
    toy::Space<D> space;
    check_clip_laws(space, grid.boundary(), all_planes<D>(3));
}

TEST_CASE("toy space: sides and parts of a segment, one by one") {
    toy::Space<2> space;
    const toy::Facet<2> f{{0, 1, Sign::plus}, {1, 0}, {1, 2}};
    CHECK(space.side({0, 2, Sign::plus}, f) == FacetSide::minus);
    CHECK(space.side({0, 2, Sign::minus}, f) == FacetSide::plus);
    CHECK(space.side({0, 0, Sign::plus}, f) == FacetSide::plus);
    CHECK(space.side({0, 1, Sign::plus}, f) == FacetSide::on_same);
    CHECK(space.side({0, 1, Sign::minus}, f) == FacetSide::on_opposite);
    CHECK(space.side({1, 1, Sign::plus}, f) == FacetSide::crossing);
    CHECK(space.side({1, 0, Sign::plus}, f) == FacetSide::plus);
    CHECK(space.side({1, 2, Sign::plus}, f) == FacetSide::minus);
    const cleave::Split<toy::Facet<2>> s = space.split({1, 1, Sign::minus}, f);
    CHECK(*s.minus == toy::Facet<2>{{0, 1, Sign::plus}, {1, 1}, {1, 2}});
    CHECK(*s.plus == toy::Facet<2>{{0, 1, Sign::plus}, {1, 0}, {1, 1}});
}

TEST_CASE("toy grid: a square has four sides that face outward") {
    toy::Grid<2> grid(4);
    grid.fill({1, 1}, {3, 3});
    const std::vector<toy::Facet<2>> expected{{{0, 1, Sign::minus}, {1, 1}, {1, 3}},
                                              {{0, 3, Sign::plus}, {3, 1}, {3, 3}},
                                              {{1, 1, Sign::minus}, {1, 1}, {3, 1}},
                                              {{1, 3, Sign::plus}, {1, 3}, {3, 3}}};
    CHECK(grid.boundary() == expected);
    CHECK(grid.locate({4, 4}) == Location::inside);
    CHECK(grid.locate({3, 3}) == Location::inside);
    CHECK(grid.locate({2, 4}) == Location::boundary);
    CHECK(grid.locate({2, 2}) == Location::boundary);
    CHECK(grid.locate({1, 4}) == Location::outside);
    CHECK(grid.locate({0, 0}) == Location::outside);
    CHECK(grid.locate({-3, 9}) == Location::outside);
    CHECK(grid.complement().locate({-3, 9}) == Location::inside);
    CHECK(grid.complement().locate({0, 0}) == Location::inside);
}

TEST_CASE("toy grid: the unit facets of a boundary are those between cells of different colour") {
    property("the area of the boundary is the number of differing neighbours", [](const toy::Grid<3>& grid) {
        toy::Integer area = 0;
        for (const toy::Facet<3>& f : grid.boundary()) {
            toy::Integer a = 1;
            for (std::size_t i = 0; i < 3; ++i) a *= i == f.plane.axis ? 1 : f.high[i] - f.low[i];
            area += a;
        }
        toy::Integer differing = 0;
        const toy::Integer n = grid.size();
        for (toy::Integer x = -1; x <= n; ++x) {
            for (toy::Integer y = -1; y <= n; ++y) {
                for (toy::Integer z = -1; z <= n; ++z) {
                    const bool c = grid.cell({x, y, z});
                    differing += (c != grid.cell({x + 1, y, z})) + (c != grid.cell({x, y + 1, z})) +
                                 (c != grid.cell({x, y, z + 1}));
                }
            }
        }
        RC_ASSERT(area == differing);
    });
}

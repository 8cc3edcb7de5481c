// SPDX-License-Identifier: Apache-2.0
// A convex body of many facets with the real Clip models: the case that facet planes alone turn into a list.
#include <cleave/bsp.hpp>

#include "support/catch.hpp"
#include "support/convex_body.hpp"

#include <cleave/clip/clip_model.hpp>
#include <cleave/number/integer.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

using cleave::Integer;
using cleave::Location;
using cleave::PlaneId;
using cleave::PointId;

}  // namespace

TEST_CASE("convex body: 20,000 facets in a structural tree of depth below 64") {
    const ConvexBody body = sphere_body(static_cast<std::int64_t>(scaled(50)));
    cleave::Kernel<3> kernel;
    TurningKernelClip clip(kernel);
    std::vector<cleave::KernelFacet<3>> facets = body_facets(body, clip);
    const std::size_t n = facets.size();
    REQUIRE(n == body.faces.size());
    const auto t = cleave::build_with_facets(clip, std::move(facets), cleave::Structural<>{});
    const cleave::TreeStatistics s = cleave::statistics(t.tree);
    CHECK(s.depth < 64);
    CHECK(s.nodes < 4 * n);
    CHECK(cleave::check_structure(t.tree).empty());
    CHECK(cleave::check_facets(clip, t).empty());

    const auto at = [&](const std::array<std::int64_t, 4>& x) {
        return cleave::classify(clip, t.tree,
                                kernel.add_point({Integer(x[0]), Integer(x[1]), Integer(x[2]), Integer(x[3])}));
    };
    CHECK(at({0, 0, 0, 1}) == Location::inside);
    for (std::size_t i = 0; i < body.points.size(); i += 37) {
        const std::array<std::int64_t, 4>& x = body.points[i];
        CHECK(at(x) == Location::boundary);
        CHECK(at({1001 * x[0], 1001 * x[1], 1001 * x[2], 1000 * x[3]}) == Location::outside);
        CHECK(at({999 * x[0], 999 * x[1], 999 * x[2], 1000 * x[3]}) == Location::inside);
    }
}

TEST_CASE("convex body: facet planes alone give a list") {
    cleave::Kernel<3> kernel;
    cleave::KernelClip<3> clip(kernel);
    const std::vector<cleave::KernelFacet<3>> facets = body_facets(sphere_body(5), clip);
    const std::size_t n = facets.size();
    CHECK(cleave::statistics(cleave::build(clip, facets, cleave::FirstFacet{})).depth == n);
    CHECK(cleave::statistics(cleave::build(clip, facets, cleave::FewestSplits{})).depth == n);
    CHECK(cleave::statistics(cleave::build(clip, facets, cleave::Balanced{})).depth == n);
    CHECK(cleave::statistics(cleave::build(clip, facets, cleave::Structural<>{})).depth < n / 2);
}

TEST_CASE("convex body: every pivot and both models put every point in the same place") {
    const ConvexBody body = sphere_body(3);
    cleave::Kernel<3> kernel;
    TurningKernelClip indexed(kernel);
    cleave::ClipModel<3, Integer> plain;
    const std::vector<cleave::KernelFacet<3>> facets = body_facets(body, indexed);
    const std::vector<cleave::Facet<3, Integer>> plain_facets = body_facets<Integer>(body);
    const std::vector<cleave::PlaneTree<PlaneId>> trees{cleave::build(indexed, facets, cleave::FirstFacet{}),
                                                        cleave::build(indexed, facets, cleave::FewestSplits{}),
                                                        cleave::build(indexed, facets, cleave::Balanced{}),
                                                        cleave::build(indexed, facets, cleave::Structural<>{4, {}})};
    const std::vector<cleave::PlaneTree<cleave::Plane<3, Integer>>> plain_trees{
        cleave::build(plain, plain_facets, cleave::FirstFacet{}),
        cleave::build(plain, plain_facets, cleave::Structural<>{4, {}})};
    std::array<std::size_t, 3> seen{};
    const auto check = [&](const std::array<std::int64_t, 4>& x) {
        const PointId p = kernel.add_point({Integer(x[0]), Integer(x[1]), Integer(x[2]), Integer(x[3])});
        const cleave::Point<3, Integer> q({Integer(x[0]), Integer(x[1]), Integer(x[2]), Integer(x[3])});
        // The oracle: a point of a convex body is below all of its planes.
        bool below = true;
        bool touching = false;
        for (const cleave::Facet<3, Integer>& f : plain_facets) {
            const cleave::Sign s = cleave::side(f.plane, q);
            below = below && s != cleave::Sign::plus;
            touching = touching || s == cleave::Sign::zero;
        }
        const Location expected = !below ? Location::outside : (touching ? Location::boundary : Location::inside);
        ++seen[static_cast<std::size_t>(expected)];
        for (const auto& t : trees) CHECK(cleave::classify(indexed, t, p) == expected);
        for (const auto& t : plain_trees) CHECK(cleave::classify(plain, t, q) == expected);
    };
    for (std::int64_t x = -4; x <= 4; ++x) {
        for (std::int64_t y = -4; y <= 4; ++y) {
            for (std::int64_t z = -4; z <= 4; ++z) check({x, y, z, 4});
        }
    }
    for (const std::array<std::int64_t, 4>& v : body.points) check(v);
    for (const std::size_t count : seen) CHECK(count > 50);
}

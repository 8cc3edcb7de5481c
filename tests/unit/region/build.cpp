// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/build.hpp>
//
#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Faces over points with small integer coordinates, with the plane of their first three corners.
struct Solid3 {
    Kernel<3> kernel;
    std::vector<PointId> points;
    PolyhedronBuilder builder{kernel};
    std::uint32_t faces = 0;

    explicit Solid3(const std::vector<std::array<double, 3>>& x) {
        for (const auto& p : x) points.push_back(kernel.add_point(p));
    }
    PlaneId add(const std::vector<std::size_t>& face) {
        std::vector<PointId> polygon;
        for (const std::size_t i : face) polygon.push_back(points[i]);
        const PlaneId plane = kernel.join(std::array{polygon[0], polygon[1], polygon[2]}).value();
        builder.add(plane, polygon, {0, faces++});
        return plane;
    }
    /// With all promises of a stored boundary verified, edge planes among them.
    Region<3> region(const FaceList& list) {
        return verified(Region<3>(freeze(kernel, list, false, [](PointId p) { return p; })));
    }
};

/// The vertices of the box [0, a] x [0, b] x [0, c]; bit i of the index says which end of axis i.
std::vector<std::array<double, 3>> box_points(double a, double b, double c) {
    std::vector<std::array<double, 3>> p;
    for (unsigned i = 0; i < 8; ++i) p.push_back({a * (i & 1U), b * ((i >> 1U) & 1U), c * ((i >> 2U) & 1U)});
    return p;
}

bool contains_axis(const Kernel<3>& kernel, PlaneId h, std::size_t axis) {
    return kernel.planes.exact(unoriented(h))[axis].is_zero();
}

}  // namespace

TEST_CASE("build: the axis of the longest normal entry, which is not zero") {
    Kernel<3> kernel;
    const auto axis = [&](int a, int b, int c) {
        return dominant_axis(kernel,
                             unoriented(kernel.planes.intern({Integer(a), Integer(b), Integer(c), Integer(9)})));
    };
    CHECK(axis(1, 0, 0) == 0);
    CHECK(axis(0, 0, -1) == 2);
    CHECK(axis(1, -3, 2) == 1);
    CHECK(axis(2, -2, 1) == 0);
    // Beyond the range of doubles approximations are NaN: any axis will do whose entry is not zero.
    const Integer huge = Integer::scaled(1, 3000);
    const PlaneId h = kernel.planes.intern({Integer(0), Integer(1), huge, Integer(0)});
    CHECK(dominant_axis(kernel, unoriented(h)) >= 1);
    CHECK(axis_direction<3>(1) == Homogeneous<3>{Integer(0), Integer(1), Integer(0), Integer(0)});
}

TEST_CASE("polyhedron builder: an edge plane is the neighbour's, the face on its minus side") {
    Solid3 s(box_points(2, 3, 4));
    const PlaneId planes[] = {s.add({0, 4, 6, 2}), s.add({1, 3, 7, 5}), s.add({0, 1, 5, 4}),
                              s.add({2, 6, 7, 3}), s.add({0, 2, 3, 1}), s.add({4, 5, 7, 6})};
    const FaceList list = s.builder.finish();
    REQUIRE(list.faces.size() == 6);
    for (std::uint32_t f = 0; f < 6; ++f) {
        CHECK(list.faces[f].plane == planes[f]);
        CHECK(list.faces[f].source == Source{0, f});
        CHECK(list.faces[f].loop_count == 1);
        CHECK(list.loop(f).size() == 4);
        // Outward planes of a convex body have everything on their minus side: each edge plane is one of them.
        for (const Corner& c : list.loop(f)) CHECK(std::count(planes, planes + 6, c.edge) == 1);
    }
    CHECK(list.loop(0)[0] == Corner{s.points[0], planes[2]});  // corners in the order given
    CHECK(list.loop(0)[1] == Corner{s.points[4], planes[5]});
    CHECK(ExactRegion<3>(s.region(list)).measure() == 24);
    // Corners know planes through them: side tests need no arithmetic.
    const std::uint64_t before = s.kernel.counts().by_identity;
    CHECK(s.kernel.side(planes[0], s.points[0]) == Sign::zero);
    CHECK(s.kernel.counts().by_identity == before + 1);
}

TEST_CASE("polyhedron builder: a coplanar neighbour's plane is never an edge plane") {
    // The top in two triangles. Their common edge gets a plane across the face: along the z axis.
    Solid3 s(box_points(2, 2, 2));
    for (const auto& face : std::vector<std::vector<std::size_t>>{
             {4, 5, 7}, {4, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}})
        s.add(face);
    const FaceList list = s.builder.finish();
    const Corner up = list.loop(0)[2];    // from 7 to 4
    const Corner down = list.loop(1)[0];  // from 4 to 7
    CHECK(up.point == s.points[7]);
    CHECK(down.point == s.points[4]);
    CHECK(up.edge == flipped(down.edge));
    CHECK(contains_axis(s.kernel, up.edge, 2));
    for (std::size_t f = 0; f < list.faces.size(); ++f)
        for (const Corner& c : list.loop(f)) CHECK(unoriented(c.edge) != unoriented(list.faces[f].plane));
    const Region<3> region = s.region(list);
    CHECK(region.face_count() == 7);
    CHECK(ExactRegion<3>(region).measure() == 8);
}

TEST_CASE("polyhedron builder: all neighbours coplanar, on a slanted plane") {
    // The face x + 2y + 4z = 8 of a tetrahedron in four triangles; the middle one has coplanar neighbours only.
    Solid3 s({{0, 0, 0}, {8, 0, 0}, {0, 4, 0}, {0, 0, 2}, {4, 2, 0}, {0, 2, 1}, {4, 0, 1}});
    const PlaneId slope = s.add({4, 5, 6});
    for (const auto& face : std::vector<std::vector<std::size_t>>{
             {1, 4, 6}, {4, 2, 5}, {6, 5, 3}, {0, 2, 4, 1}, {0, 1, 6, 3}, {0, 3, 5, 2}})
        s.add(face);
    const FaceList list = s.builder.finish();
    for (const Corner& c : list.loop(0)) {
        CHECK(contains_axis(s.kernel, c.edge, 2));  // z is most across the slope
        CHECK(unoriented(c.edge) != unoriented(slope));
    }
    const Region<3> region = s.region(list);
    CHECK(ExactRegion<3>(region).measure() == Rational(32, 3));
    CHECK(ExactRegion<3>(region).plane_count() == 4);
}

TEST_CASE("polyhedron builder: an edge of four faces, two and two of them coplanar") {
    // Two boxes that share the edge x = y = 1: x = 1 and y = 1 carry two faces each at this edge.
    std::vector<std::array<double, 3>> points = box_points(1, 1, 1);
    for (const std::array<double, 3>& p : box_points(1, 1, 1))
        if (p[0] + p[1] > 0) points.push_back({p[0] + 1, p[1] + 1, p[2]});  // 8: 211, 9: 121, 10: 221, then upper
    Solid3 s(points);
    for (const auto& face : std::vector<std::vector<std::size_t>>{
             {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
        s.add(face);
    const std::size_t second[] = {3, 8, 9, 10, 7, 11, 12, 13};
    for (const auto& face : std::vector<std::vector<std::size_t>>{
             {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
        std::vector<std::size_t> moved;
        for (const std::size_t i : face) moved.push_back(second[i]);
        s.add(moved);
    }
    CHECK(ExactRegion<3>(s.region(s.builder.finish())).measure() == 2);
}

TEST_CASE("polyhedron builder: an edge without a neighbour, and nothing at all") {
    // Not closed, so no region; yet each edge has a plane with the face below it.
    Solid3 s({{0, 0, 1}, {3, 0, 1}, {0, 3, 1}});
    const PlaneId plane = s.add({0, 1, 2});
    const FaceList list = s.builder.finish();
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& c = list.loop(0)[i];
        CHECK(unoriented(c.edge) != unoriented(plane));
        CHECK(s.kernel.side(c.edge, s.points[i]) == Sign::zero);
        CHECK(s.kernel.side(c.edge, s.points[(i + 1) % 3]) == Sign::zero);
        CHECK(s.kernel.side(c.edge, s.points[(i + 2) % 3]) == Sign::minus);
    }
    Solid3 none({});
    CHECK(none.builder.finish().faces.empty());
    CHECK(none.region(none.builder.finish()).is_empty());
}

TEST_CASE("polygon builder: an end's line is a neighbour's, or across the segment where all are collinear") {
    Kernel<2> kernel;
    std::vector<PointId> p;
    for (const std::array<double, 2>& x : std::vector<std::array<double, 2>>{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})
        p.push_back(kernel.add_point(x));
    PolygonBuilder builder(kernel);
    for (std::uint32_t i = 0; i < 5; ++i) builder.add(p[i], p[(i + 1) % 5], {0, i});
    const FaceList list = builder.finish();
    REQUIRE(list.faces.size() == 5);
    for (std::uint32_t i = 0; i < 5; ++i) {
        CHECK(list.faces[i].source == Source{0, i});
        const std::span<const Corner> s = list.loop(i);
        CHECK(s[0].point == p[i]);
        CHECK(s[1].point == p[(i + 1) % 5]);
        for (std::size_t end = 0; end < 2; ++end) {
            CHECK(unoriented(s[end].edge) != unoriented(list.faces[i].plane));
            CHECK(kernel.side(s[end].edge, s[end].point) == Sign::zero);
            CHECK(kernel.side(s[end].edge, s[1 - end].point) == Sign::minus);
        }
    }
    // The corner (2, 0) lies within a straight side: x = 2 from both sides.
    CHECK(list.loop(0)[1].edge == flipped(list.loop(1)[0].edge));
    CHECK(list.loop(0)[1].edge == kernel.planes.intern_axis_plane(0, 2));
    CHECK(list.loop(1)[1].edge == list.faces[2].plane);
    verified(Region<2>(freeze(kernel, list, false, [](PointId q) { return q; })));
}

#if CLEAVE_CONTRACTS >= 1
TEST_CASE("polygon builder: a segment needs two different ends") {
    Kernel<2> kernel;
    const PointId p = kernel.add_point(std::array{1.0, 2.0});
    const PointId q = kernel.add_point(std::array{1.0, 2.0});
    PolygonBuilder builder(kernel);
    CHECK_THROWS_AS(builder.add(p, p, {}), ContractViolation);
    CHECK_THROWS_AS(builder.add(p, q, {}), ContractViolation);
    CHECK(builder.finish().faces.empty());
}
#endif

TEST_CASE("build: the plane across an edge contains it, is parallel to an axis and has the face on its minus side") {
    support::Dice dice(51);
    for (int n = 0; n < 2000; ++n) {
        Kernel<3> kernel;
        const double scale = std::array{1.0, 0x1p-60, 0.1}[std::size_t(n % 3)];
        std::array<std::array<double, 3>, 3> x{};
        for (auto& p : x)
            for (double& c : p) c = scale * dice.between(-5, 5);
        std::array<PointId, 3> p{};
        for (std::size_t i = 0; i < 3; ++i) p[i] = kernel.add_point(x[i]);
        std::optional<PlaneId> plane = kernel.join(p);
        if (!plane) continue;
        // Seen from the other side, the same edge has the face on its right.
        for (const bool other_side : {false, true}) {
            const PlaneId f = other_side ? flipped(*plane) : *plane;
            const PointId u = other_side ? p[1] : p[0];
            const PointId v = other_side ? p[0] : p[1];
            const PlaneId h = plane_across(kernel, f, u, v);
            CHECK(kernel.side(h, u) == Sign::zero);
            CHECK(kernel.side(h, v) == Sign::zero);
            CHECK(kernel.side(h, p[2]) == Sign::minus);
            CHECK(contains_axis(kernel, h, std::size_t(dominant_axis(kernel, unoriented(f)))));
        }
        // The general way: of points that are not known to be doubles.
        const auto integers = [&](std::size_t i) { return kernel.add_point(kernel.coordinates(p[i])); };
        CHECK(plane_across(kernel, *plane, integers(0), integers(1)) == plane_across(kernel, *plane, p[0], p[1]));
    }
}

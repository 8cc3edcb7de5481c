// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/face_merge.hpp>
//
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

using Place = std::array<int, 2>;
using Outline = std::vector<Place>;
using Outlines = std::vector<Outline>;

/// Pieces of a face on the plane z = x + 2y, by their places over the plane of x and y.
struct Sheet {
    Kernel<3> kernel;
    PointInterner<3> points{kernel};
    FaceMerger<3> merger{kernel, points};
    PlaneId plane = kernel.planes.intern({Integer(-1), Integer(-2), Integer(1), Integer(0)});
    int tilt = 0;

    PointId point(const Place& p) {
        return kernel.add_point(std::array<double, 3>{double(p[0]), double(p[1]), double(p[0] + 2 * p[1])});
    }
    /// Each edge has a plane of its own through its line, as pieces of different operands would.
    std::vector<Corner> piece(const Outline& places, PlaneId f) {
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const PointId a = point(places[i]);
            const PointId b = point(places[(i + 1) % places.size()]);
            tilt = (tilt + 1) % 7;
            const Homogeneous<3> direction{Integer(tilt % 3), Integer(-tilt), Integer(5), Integer(0)};
            const PlaneId e = *kernel.join(std::array{kernel.coordinates(a), kernel.coordinates(b), direction});
            corners.push_back({a, orient_edge(kernel, f, e, a, b)});
        }
        return corners;
    }
    /// The outlines in the list's first face, each from its least corner, in order. Also checks the edge planes.
    Outlines outlines(const FaceList& list) {
        Outlines result;
        for (std::size_t l = 0; l + 1 < list.loop_first.size(); ++l) {
            const std::span<const Corner> loop = list.loop(l);
            Outline outline;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Corner& next = loop[(i + 1) % loop.size()];
                CHECK(points(loop[i].point) == loop[i].point);
                CHECK(kernel.side(loop[i].edge, loop[i].point) == Sign::zero);
                CHECK(kernel.side(loop[i].edge, next.point) == Sign::zero);
                const PlaneId f = list.faces.front().plane;
                CHECK(orient_edge(kernel, f, loop[i].edge, loop[i].point, next.point) == loop[i].edge);
                const auto& x = kernel.point(loop[i].point).approximation;
                outline.push_back({int(x[0]), int(x[1])});
            }
            std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end()), outline.end());
            result.push_back(outline);
        }
        std::sort(result.begin(), result.end());
        return result;
    }
};

Outlines merged(const Outlines& pieces) {
    Sheet s;
    s.merger.begin(s.plane);
    for (const Outline& p : pieces) s.merger.add(s.piece(p, s.plane));
    FaceList out;
    s.merger.finish(out, {3, 4});
    REQUIRE(out.faces.size() == 1);
    CHECK(out.faces[0].plane == s.plane);
    CHECK(out.faces[0].source == Source{3, 4});
    CHECK(out.faces[0].loop_count + 1 == out.loop_first.size());
    return s.outlines(out);
}

Outline rectangle(int x0, int y0, int x1, int y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace

TEST_CASE("line sweep: what is covered once more one way than the other remains") {
    Kernel<2> kernel;
    std::vector<PointId> p;
    for (int i = 0; i < 12; ++i) p.push_back(kernel.add_point(std::array<double, 2>{double(i), 0}));
    using Edges = std::vector<std::tuple<int, int, bool>>;
    const auto swept = [&](const std::vector<std::pair<int, int>>& edges, Sign direction) {
        LineSweep<2> sweep(kernel, {0, direction});
        for (const auto& [a, b] : edges) sweep.add(p[std::size_t(a)], p[std::size_t(b)]);
        Edges out;
        sweep.run([&](PointId a, PointId b, bool forward) { out.push_back({int(a), int(b), forward}); });
        for (std::size_t i = 1; i < sweep.points().size(); ++i)
            CHECK((sweep.points()[i - 1] < sweep.points()[i]) == (direction == Sign::plus));
        return out;
    };
    CHECK(swept({}, Sign::plus).empty());
    CHECK(swept({{0, 2}, {2, 5}}, Sign::plus) == Edges{{0, 5, true}});
    CHECK(swept({{0, 2}, {2, 5}}, Sign::minus) == Edges{{0, 5, false}});
    CHECK(swept({{0, 5}, {3, 1}}, Sign::plus) == Edges{{0, 1, true}, {3, 5, true}});
    CHECK(swept({{0, 2}, {3, 1}}, Sign::plus) == Edges{{0, 1, true}, {3, 2, false}});
    CHECK(swept({{0, 5}, {5, 3}, {1, 0}, {3, 1}}, Sign::plus).empty());
    // Twice the same way gives two edges; each stretch ends where the count changes.
    CHECK(swept({{0, 4}, {1, 3}}, Sign::plus) == Edges{{0, 1, true}, {1, 3, true}, {1, 3, true}, {3, 4, true}});
    // More than eight points are found by bisection.
    std::vector<std::pair<int, int>> many;
    for (int i = 0; i < 11; ++i) many.push_back({(i * 7 + 3) % 11, (i * 7 + 3) % 11 + 1});
    CHECK(swept(many, Sign::plus) == Edges{{0, 11, true}});
    CHECK(swept(many, Sign::minus) == Edges{{0, 11, false}});
    many.push_back({8, 2});
    CHECK(swept(many, Sign::minus) == Edges{{8, 11, false}, {0, 2, false}});
}

TEST_CASE("face merge: two triangles are a square again, in either order") {
    const Outline lower{{0, 0}, {4, 0}, {4, 4}};
    const Outline upper{{0, 0}, {4, 4}, {0, 4}};
    CHECK(merged({lower, upper}) == Outlines{rectangle(0, 0, 4, 4)});
    CHECK(merged({upper, lower}) == Outlines{rectangle(0, 0, 4, 4)});
    CHECK(merged({lower}) == Outlines{lower});
}

TEST_CASE("face merge: junctions within edges leave no corner, inside or outside") {
    const Outlines square{rectangle(0, 0, 4, 4)};
    CHECK(merged({rectangle(0, 0, 2, 4), rectangle(2, 0, 4, 1), rectangle(2, 1, 4, 4)}) == square);
    CHECK(merged({rectangle(0, 0, 1, 3), rectangle(1, 0, 4, 1), rectangle(3, 1, 4, 4), rectangle(0, 3, 3, 4),
                  rectangle(1, 1, 3, 3)}) == square);
    // Straight corners of the pieces themselves go as well.
    CHECK(merged({{{0, 0}, {1, 0}, {2, 0}, {2, 4}, {0, 4}, {0, 1}}, {{2, 0}, {4, 0}, {4, 4}, {2, 4}}}) == square);
}

TEST_CASE("face merge: one outline, however the face was cut") {
    const Outlines whole{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}};
    CHECK(merged({rectangle(0, 0, 4, 2), rectangle(0, 2, 2, 4)}) == whole);
    CHECK(merged({rectangle(0, 0, 2, 4), rectangle(2, 0, 4, 2)}) == whole);
    CHECK(merged({{{0, 0}, {4, 0}, {4, 2}, {2, 2}}, {{0, 0}, {2, 2}, {2, 4}, {0, 4}}}) == whole);
    Outlines cells;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < (x < 2 ? 4 : 2); ++y) cells.push_back(rectangle(x, y, x + 1, y + 1));
    CHECK(merged(cells) == whole);
    std::reverse(cells.begin(), cells.end());
    CHECK(merged(cells) == whole);
}

TEST_CASE("face merge: holes, separate parts, and parts that touch in a corner") {
    const Outline hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}};
    CHECK(merged({rectangle(0, 0, 1, 3), rectangle(1, 0, 4, 1), rectangle(3, 1, 4, 4), rectangle(0, 3, 3, 4)}) ==
          Outlines{rectangle(0, 0, 4, 4), hole});
    CHECK(merged({rectangle(0, 0, 1, 1), rectangle(5, 0, 6, 1)}) ==
          Outlines{rectangle(0, 0, 1, 1), rectangle(5, 0, 6, 1)});
    // A chessboard: in each corner a loop turns so that its interior stays in one sector.
    Outlines board;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            if ((x + y) % 2 == 0) board.push_back(rectangle(x, y, x + 1, y + 1));
    CHECK(merged(board) == board);
    // A hole with its tip in the corner of the outline is a part of that loop: inside on both sides of the corner.
    CHECK(
        merged(
            {{{0, 3}, {0, 0}, {1, 2}}, {{0, 0}, {3, 0}, {2, 1}}, {{1, 2}, {3, 0}, {3, 3}}, {{0, 3}, {1, 2}, {3, 3}}}) ==
        Outlines{Outline{{0, 0}, {1, 2}, {2, 1}, {0, 0}, {3, 0}, {3, 3}, {0, 3}}});
    // With its tip on a side it is a loop of its own, and the side keeps no corner.
    CHECK(merged({{{0, 0}, {4, 0}, {2, 2}},
                  {{4, 0}, {4, 4}, {2, 2}},
                  {{4, 4}, {1, 4}, {2, 2}},
                  {{1, 4}, {0, 4}, {0, 2}},
                  {{0, 2}, {0, 0}, {1, 1}, {1, 2}}}) ==
          Outlines{Outline{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, Outline{{0, 2}, {1, 4}, {2, 2}, {1, 1}, {1, 2}}});
}

TEST_CASE("face merge: more edges than are compared in pairs") {
    // Points of a parabola and their chord, which is divided; a fan of triangles.
    Outline curve;
    for (int i = 0; i <= 30; ++i) curve.push_back({i, i * i});
    Outline around = curve;
    around.insert(around.end(), {{20, 600}, {10, 300}});
    const Place apex = curve[15];
    Outlines fan;
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Place& a = around[i];
        const Place& b = around[(i + 1) % around.size()];
        if (a != apex && b != apex) fan.push_back({apex, a, b});
    }
    CHECK(merged(fan) == Outlines{curve});
    // 30 teeth above stairs, all of them on one line: 120 edges that are not cancelled at sight.
    Outlines teeth;
    for (int x = 87; x >= 0; x -= 3) {
        for (const int i : {0, 1, 2}) teeth.push_back(rectangle(x + i, -i, x + i + 1, 1));
        teeth.push_back(rectangle(x + 1, 1, x + 2, 2));
    }
    const Outlines comb = merged(teeth);
    REQUIRE(comb.size() == 1);
    CHECK(comb[0].size() == 30 * 10 + 2);
}

TEST_CASE("face merge: single edges in any order, a flipped face, and a merger used again") {
    Sheet s;
    FaceList out;
    s.merger.begin(s.plane);
    s.merger.finish(out, {});
    CHECK(out.faces.empty());  // no pieces
    // What cancels altogether gives no face.
    s.merger.add(s.piece(rectangle(0, 0, 1, 1), s.plane));
    s.merger.add(s.piece({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, s.plane));
    s.merger.finish(out, {});
    CHECK(out.faces.empty());
    const std::vector<Corner> lower = s.piece({{0, 0}, {4, 0}, {4, 4}}, flipped(s.plane));
    s.merger.begin(s.plane);
    s.merger.add(lower);
    s.merger.begin(flipped(s.plane));  // forgets it
    for (const Outline& piece : {Outline{{0, 0}, {4, 4}, {4, 0}}, Outline{{0, 0}, {0, 4}, {4, 4}}}) {
        const std::vector<Corner> corners = s.piece(piece, flipped(s.plane));
        for (std::size_t i = corners.size(); i-- > 0;)
            s.merger.add_edge(corners[i].point, corners[(i + 1) % corners.size()].point, corners[i].edge);
    }
    s.merger.finish(out, {0, 7});
    REQUIRE(out.faces.size() == 1);
    CHECK(out.faces[0].plane == flipped(s.plane));
    CHECK(s.outlines(out) == Outlines{Outline{{0, 0}, {0, 4}, {4, 4}, {4, 0}}});
}

TEST_CASE("face merge: ends and segments") {
    Kernel<1> line;
    PointInterner<1> ends(line);
    const PointId a = line.add_point(std::array{1.0});
    const PlaneId at = *line.join(std::span<const PointId, 1>(&a, 1));
    FaceMerger<1> merger(line, ends);
    merger.begin(at);
    const Corner corner{a, no_id};
    merger.add({&corner, 1});
    FaceList out;
    merger.finish(out, {1, 2});
    REQUIRE(out.faces.size() == 1);
    CHECK(out.loop(0).size() == 1);
    CHECK(out.loop(0)[0] == corner);

    // Segments of y = 0 with the set above: [0, 1], [1, 2] and [3, 4], each end with its line x = k.
    Kernel<2> plane;
    PointInterner<2> points(plane);
    const PlaneId below = flipped(plane.planes.intern_axis_plane(1, 0));
    FaceMerger<2> segments(plane, points);
    segments.begin(below);
    const auto end = [&](int x) { return plane.planes.intern_axis_plane(0, x); };
    const auto at_x = [&](int x) { return plane.add_point(std::array<double, 2>{double(x), 0}); };
    for (const int x : {3, 1, 0})
        segments.add(std::array{Corner{at_x(x), flipped(end(x))}, Corner{at_x(x + 1), end(x + 1)}});
    FaceList list;
    segments.finish(list, {5, 6});
    REQUIRE(list.faces.size() == 1);
    CHECK(list.faces[0].source == Source{5, 6});
    REQUIRE(list.faces[0].loop_count == 2);
    const int expected[2][2] = {{0, 2}, {3, 4}};
    for (std::size_t l = 0; l < 2; ++l) {
        CHECK(list.loop(l)[0].edge == flipped(end(expected[l][0])));
        CHECK(list.loop(l)[1].edge == end(expected[l][1]));
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(plane.point(list.loop(l)[i].point).approximation[0] == expected[l][i]);
    }

    // There and back again: nothing remains, and no face without loops.
    segments.begin(below);
    const Corner zero{at_x(0), end(0)}, one{at_x(1), end(1)};
    segments.add(std::array{zero, one});
    segments.add(std::array{one, zero});
    segments.finish(list, {5, 7});
    CHECK(list.faces.size() == 1);
}

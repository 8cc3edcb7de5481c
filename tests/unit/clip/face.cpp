// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/face.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/facet_measure.hpp"
#include "support/property.hpp"

#include <cleave/geometry/affine_map.hpp>
#include <cleave/geometry/relation.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

using namespace cleave;
using support::property;

namespace {

using Loop = std::vector<std::pair<int, int>>;

/// Loops in the plane z = 0, carried to where a map takes them. Faces of a reflected plane have their loops reversed.
template <class N>
Face<3, N> face_of(const std::vector<Loop>& loops, const AffineMap<3, N>& map = {}) {
    std::vector<std::vector<Point<3, N>>> points;
    for (const Loop& loop : loops) {
        std::vector<Point<3, N>>& to = points.emplace_back();
        for (const auto& [x, y] : loop) to.push_back(map(make_point<N>(x, y, 0)));
        if (map.orientation() == Sign::minus) std::reverse(to.begin(), to.end());
    }
    return make_face(image(map, make_plane<N>(0, 0, 1, 0)), std::span<const std::vector<Point<3, N>>>(points));
}

/// A map that leaves no plane axis-parallel.
template <class N>
AffineMap<3, N> tilted() {
    return compose(rational_rotation<3, N>(0, 2, 3, 1), rational_rotation<3, N>(1, 2, 2, -1));
}

/// All that cutting a face promises, but for the number of facets.
template <class N>
void check_facets(const Face<3, N>& face, const std::vector<Facet<3, N>>& facets) {
    CHECK(projected_measure(facets) == projected_measure(face));
    for (const Facet<3, N>& f : facets) {
        CHECK(is_valid(f));
        CHECK(f.plane == face.plane);
        for (const FacetCorner<N>& c : f.corners) {
            // Edges lie on lines of the face's own edges, so vertices are meets with two of them.
            std::set<std::size_t> lines;
            bool edge_is_given = false;
            std::size_t i = 0;
            std::vector<Plane<3, N>> through;
            for (const auto& loop : face.loops) {
                for (const FacetCorner<N>& given : loop) {
                    if (is_coincident(relation(given.edge, c.edge))) edge_is_given = true;
                    if (side(given.edge, c.point) == Sign::zero) through.push_back(given.edge);
                    ++i;
                }
            }
            CHECK(edge_is_given);
            const bool is_meet = std::any_of(through.begin(), through.end(), [&](const Plane<3, N>& g) {
                return std::any_of(through.begin(), through.end(),
                                   [&](const Plane<3, N>& h) { return meet(face.plane, g, h).has_value(); });
            });
            CHECK(is_meet);
        }
    }
}

template <class N>
std::size_t count_facets(const std::vector<Loop>& loops) {
    std::size_t count = 0;
    for (const AffineMap<3, N>& map : {AffineMap<3, N>(), tilted<N>(), scaling<N>(1, -1, 1)}) {
        const Face<3, N> face = face_of<N>(loops, map);
        const auto facets = to_facets(face);
        check_facets(face, facets);
        // The face seen from the other side is cut into as much.
        const auto flipped = to_facets(flip(face));
        check_facets(flip(face), flipped);
        count = facets.size();
    }
    return count;
}

const Loop square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

}  // namespace

TEMPLATE_LIST_TEST_CASE("face: a convex polygon comes back as it is, straight vertices and all", "", RingAndField) {
    using N = TestType;
    const Face<3, N> face = face_of<N>({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}, tilted<N>());
    const auto facets = to_facets(face);
    REQUIRE(facets.size() == 1);
    CHECK(facets[0].corners == face.loops[0]);
    CHECK(facets[0].plane == face.plane);
}

TEMPLATE_LIST_TEST_CASE("face: non-convex polygons and holes", "", RingAndField) {
    using N = TestType;
    CHECK(count_facets<N>({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}}) == 2);                  // an L
    CHECK(count_facets<N>({{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}}) <= 3);  // a U
    CHECK(count_facets<N>({square, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}) == 4);                          // a frame
    CHECK(count_facets<N>({square, {{1, 2}, {2, 3}, {3, 2}, {2, 1}}}) == 4);                          // a diamond hole
    CHECK(count_facets<N>({square, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{3, 3}, {2, 3}, {3, 2}}}) >= 4);  // two holes
    CHECK(count_facets<N>({square, {{6, 0}, {8, 0}, {7, 2}}}) == 2);                                    // two polygons
    CHECK(count_facets<N>({{{0, 0}, {9, 0}, {9, 9}, {0, 9}},                                            // an island
                           {{1, 1}, {1, 8}, {8, 8}, {8, 1}},
                           {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}) >= 5);
    // A spiral: every cut has to be found.
    CHECK(count_facets<N>({{{0, 0},
                            {9, 0},
                            {9, 9},
                            {2, 9},
                            {2, 4},
                            {5, 4},
                            {5, 6},
                            {4, 6},
                            {4, 5},
                            {3, 5},
                            {3, 8},
                            {8, 8},
                            {8, 1},
                            {1, 1},
                            {1, 9},
                            {0, 9}}}) >= 7);
}

TEMPLATE_LIST_TEST_CASE("face: touching loops", "", RingAndField) {
    using N = TestType;
    // Two squares at one corner, as two loops and as one loop that passes the corner twice.
    CHECK(count_facets<N>({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}) == 2);
    CHECK(count_facets<N>({{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}}) == 2);
    // A hole with a corner in the middle of an outer edge, in an outer corner, and two holes that touch.
    CHECK(count_facets<N>({square, {{2, 0}, {1, 2}, {3, 2}}}) >= 3);
    CHECK(count_facets<N>({square, {{0, 0}, {1, 3}, {3, 1}}}) >= 3);
    CHECK(count_facets<N>({square, {{1, 1}, {1, 2}, {2, 2}}, {{2, 2}, {3, 3}, {3, 2}}}) >= 4);
    // A hole along part of an outer edge: what is left is a U.
    CHECK(count_facets<N>({square, {{1, 0}, {1, 2}, {3, 2}, {3, 0}}}) <= 3);
    // A hole as large as its outer loop.
    CHECK(count_facets<N>({square, {{0, 0}, {0, 4}, {4, 4}, {4, 0}}}) == 0);
    // Polygons that share a whole edge.
    CHECK(count_facets<N>({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 0}, {4, 0}, {4, 2}, {2, 2}}}) <= 2);
}

TEMPLATE_LIST_TEST_CASE("face: edges there and back, and edges of length zero", "", RingAndField) {
    using N = TestType;
    // A keyhole: the frame as one loop with a bridge.
    CHECK(count_facets<N>({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}}) == 4);
    // An antenna inwards, outwards and along an edge.
    CHECK(count_facets<N>({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}}}) <= 2);
    CHECK(count_facets<N>({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}}}) == 1);
    CHECK(count_facets<N>({{{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}}) == 1);
    CHECK(count_facets<N>({{{0, 0}, {3, 0}, {1, 0}, {4, 0}, {4, 4}, {0, 4}}}) == 1);
    // Repeated vertices.
    CHECK(count_facets<N>({{{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}) == 1);
    // Nothing at all.
    CHECK(count_facets<N>({{{0, 0}, {4, 0}}}) == 0);
    CHECK(count_facets<N>({{{0, 0}, {4, 0}, {2, 0}}}) == 0);
    CHECK(count_facets<N>({{{1, 1}, {1, 1}, {1, 1}}}) == 0);
    CHECK(count_facets<N>({}) == 0);
}

TEMPLATE_LIST_TEST_CASE("face: the plane of loops of any shape", "", RingAndField) {
    using N = TestType;
    // The arrow runs counter-clockwise, but its first three vertices turn right: their plane faces the wrong way.
    const Loop arrow{{4, 0}, {1, 1}, {0, 4}, {0, 0}};
    for (const auto& [map, outside] : {std::pair(AffineMap<3, N>(), make_plane<N>(0, 0, 1, 0)),
                                       std::pair(tilted<N>(), image(tilted<N>(), make_plane<N>(0, 0, 1, 0)))}) {
        std::vector<std::vector<Point<3, N>>> points(1);
        for (const auto& [x, y] : arrow) points[0].push_back(map(make_point<N>(x, y, 0)));
        const auto face = make_face(std::span<const std::vector<Point<3, N>>>(points));
        REQUIRE(face);
        CHECK(face->plane == outside);
        std::reverse(points[0].begin(), points[0].end());
        const auto other = make_face(std::span<const std::vector<Point<3, N>>>(points));
        REQUIRE(other);
        CHECK(other->plane == flip(outside));
    }
    const std::vector<std::vector<Point<3, N>>> line{
        {make_point<N>(0, 0, 0), make_point<N>(1, 1, 1), make_point<N>(3, 3, 3)}};
    CHECK_FALSE(make_face(std::span<const std::vector<Point<3, N>>>(line)));
    CHECK_FALSE(make_face(std::span<const std::vector<Point<3, N>>>()));
    // A bow-tie has no area altogether.
    const std::vector<std::vector<Point<3, N>>> bow{
        {make_point<N>(0, 0, 0), make_point<N>(2, 2, 0), make_point<N>(2, 0, 0), make_point<N>(0, 2, 0)}};
    CHECK_FALSE(make_face(std::span<const std::vector<Point<3, N>>>(bow)));
}

TEST_CASE("face: segments and points of lower dimensions") {
    const Facet<1, Integer> end{make_plane<Integer>(1, -2)};
    CHECK(to_facets(Face<1, Integer>{end.plane}) == std::vector<Facet<1, Integer>>{end});
    CHECK(to_facets(flip(Face<1, Integer>{end.plane})) == std::vector<Facet<1, Integer>>{flip(end)});
    const auto p = [](int x) { return make_point<Integer>(x, 0); };
    const Face<2, Integer> face{make_plane<Integer>(0, -1, 0), {{p(0), p(1)}, {p(2), p(2)}, {p(3), p(7)}}};
    const auto facets = to_facets(face);
    REQUIRE(facets.size() == 2);
    CHECK(projected_measure(facets) == rational(5));
    for (const auto& f : facets) CHECK(is_valid(f));
    CHECK(projected_measure(to_facets(flip(face))) == rational(5));
    for (const auto& f : to_facets(flip(face))) CHECK(is_valid(f));
}

namespace {

constexpr int grid_size = 4;
using Mask = std::array<bool, std::size_t(2 * grid_size * grid_size)>;

/// The corners of triangle t of a grid of squares cut along their diagonals, counter-clockwise.
Loop triangle(std::size_t t) {
    const int cell = static_cast<int>(t / 2);
    const int x = cell % grid_size;
    const int y = cell / grid_size;
    return t % 2 == 0 ? Loop{{x, y}, {x + 1, y}, {x + 1, y + 1}} : Loop{{x, y}, {x + 1, y + 1}, {x, y + 1}};
}

/// The boundary of the chosen triangles as closed walks. Where walks meet they are joined in any way: outer loops and
/// holes touch and even cross over each other's corners, which is for the cutter to sort out.
std::vector<Loop> boundary_walks(const Mask& mask) {
    using Corner = std::pair<int, int>;
    std::set<std::pair<Corner, Corner>> edges;
    for (std::size_t t = 0; t < mask.size(); ++t) {
        if (!mask[t]) continue;
        const Loop corners = triangle(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner a = corners[i];
            const Corner b = corners[(i + 1) % 3];
            if (edges.erase({b, a}) == 0) edges.insert({a, b});
        }
    }
    std::map<Corner, std::vector<Corner>> next;
    for (const auto& [a, b] : edges) next[a].push_back(b);
    std::vector<Loop> walks;
    for (auto& [start, targets] : next) {
        while (!targets.empty()) {
            Loop& walk = walks.emplace_back();
            Corner at = start;
            do {
                walk.push_back(at);
                const Corner to = next[at].back();
                next[at].pop_back();
                at = to;
            } while (at != start);
        }
    }
    return walks;
}

}  // namespace

TEST_CASE("face: random sets of triangles of a grid, point by point") {
    property("each chosen triangle is in exactly one facet, the others in none", [](const Mask& mask) {
        const bool tilt = support::draw_bool();
        const AffineMap<3, Rational> map = tilt ? tilted<Rational>() : AffineMap<3, Rational>();
        const Face<3, Rational> face = face_of<Rational>(boundary_walks(mask), map);
        const auto facets = to_facets(face);
        for (const Facet<3, Rational>& f : facets) RC_ASSERT(is_valid(f));
        RC_ASSERT(projected_measure(facets) == projected_measure(face));
        for (std::size_t t = 0; t < mask.size(); ++t) {
            const Loop c = triangle(t);
            const Point<3, Rational> centre =
                map(make_point<Rational>(rational(c[0].first + c[1].first + c[2].first, 3),
                                         rational(c[0].second + c[1].second + c[2].second, 3), 0));
            int covered = 0;
            for (const Facet<3, Rational>& f : facets) {
                bool inside = true;
                bool on_edge = false;
                for (const FacetCorner<Rational>& corner : f.corners) {
                    inside = inside && side(corner.edge, centre) != Sign::plus;
                    on_edge = on_edge || side(corner.edge, centre) == Sign::zero;
                }
                // A cut may go through the centre of a triangle; then two facets share it, or four.
                if (inside) covered += on_edge ? 0 : 1;
                if (inside && on_edge) covered += 1000;
            }
            if (mask[t])
                RC_ASSERT(covered == 1 || covered >= 1000);
            else
                RC_ASSERT(covered == 0);
        }
    });
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/surface_evaluation.hpp>
//
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

using namespace cleave;
using support::Dice;
using support::verified;

namespace {

using Corners = std::array<std::array<Rational, 3>, 4>;

/// The triangles of a region's boundary as a mesh of doubles read anew: no plane is known. Requires: doubles will do.
Region<3> as_mesh(const Region<3>& region) {
    const Mesh mesh = to_mesh(region);
    Region<3> read = to_region(mesh);
    REQUIRE(read.surface().is_conforming);
    REQUIRE_FALSE(read.surface().is_complete);
    REQUIRE(canonical(read) == canonical(region));
    return read;
}

/// By every operation: the evaluation under test is what ran, its result is that of boundary filtering, and sound.
OperationCounts check_operations(const Region<3>& a, const Region<3>& b) {
    const std::array<const Boundary<3>*, 2> operands{&a.surface(), &b.surface()};
    REQUIRE(SurfaceEvaluation::is_for(operands));
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    for (const Operation operation : all_operations) {
        const Region<3> r(SurfaceEvaluation(operands, BooleanFunction::from(operation, 2), options).finish());
        CHECK(r.surface().is_conforming);
        CHECK(canonical(r) == canonical(apply(Engine::boundary_filter, operation, a, b)));
        verified(r);
    }
    return counts;
}

/// A union put together by the evaluation under test, where it touches itself as it comes.
Region<3> united(const std::vector<Region<3>>& parts) {
    Region<3> all = parts.front();
    for (std::size_t n = 1; n < parts.size(); ++n) all = all | parts[n];
    return all;
}

Region<3> tetrahedron(const Corners& corners) {
    return simplex<3>(corners);
}

}  // namespace

TEST_CASE("surface evaluation: two boxes in every relative position") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    // Along each axis: apart, touching, overlapping, with a common side inside, the same, and beyond on both sides.
    const std::array<std::array<int, 2>, 7> ends = {{{3, 4}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {-1, 3}}};
    for (std::size_t x = 0; x < ends.size(); ++x)
        for (std::size_t y = 0; y <= x; ++y)  // the axes are alike
            for (std::size_t z = 0; z <= y; ++z)
                check_operations(a, box<3>({ends[x][0], ends[y][0], ends[z][0]}, {ends[x][1], ends[y][1], ends[z][1]}));
}

TEST_CASE("surface evaluation: ridges, vertices and walls in contact") {
    const Region<3> block = box<3>({0, 0, 0}, {4, 4, 4});
    const Corners on_ridge = {{{1, 1, 4}, {3, 3, 4}, {1, 3, 6}, {3, 1, 6}}};
    const Corners through_ridge = {{{1, 1, 4}, {3, 3, 4}, {1, 3, 2}, {3, 1, 6}}};
    const Corners by_vertex = {{{2, 2, 4}, {1, 1, 6}, {3, 1, 6}, {2, 3, 6}}};
    const Corners vertex_within = {{{2, 2, 4}, {1, 1, 2}, {3, 1, 6}, {2, 3, 6}}};
    const Corners edge_on_edge = {{{4, 1, 4}, {4, 3, 4}, {6, 2, 5}, {6, 2, 3}}};
    const Corners edge_across_edge = {{{3, 2, 5}, {5, 2, 3}, {5, 1, 5}, {5, 3, 5}}};
    const Corners corner_to_corner = {{{4, 4, 4}, {6, 4, 5}, {4, 6, 5}, {5, 5, 6}}};
    for (const Corners& c :
         {on_ridge, through_ridge, by_vertex, vertex_within, edge_on_edge, edge_across_edge, corner_to_corner}) {
        check_operations(block, tetrahedron(c));
        check_operations(tetrahedron(c), as_mesh(block));
        check_operations(~block, tetrahedron(c));
    }
    // A room: what fills it touches all its walls from inside.
    const Region<3> room = block - box<3>({1, 1, 1}, {3, 3, 3});
    check_operations(room, box<3>({1, 1, 1}, {3, 3, 3}));
    check_operations(room, box<3>({1, 1, 1}, {3, 2, 3}));
    check_operations(room, box<3>({Rational(3, 2), Rational(3, 2), Rational(3, 2)}, {2, 2, 2}));
}

TEST_CASE("surface evaluation: operands that touch themselves where the other one meets them") {
    SECTION("a ridge on a face, crossed by a plane through both") {
        const Region<3> a =
            united({box<3>({0, 1, 1}, {4, 3, 2}), tetrahedron({{{1, 3, 2}, {5, 1, 2}, {4, 2, 3}, {4, 0, 5}}}),
                    tetrahedron({{{2, 4, 1}, {1, 5, 0}, {5, 2, 4}, {2, 2, 4}}})});
        const Region<3> b = tetrahedron({{{5, 5, 2}, {1, 4, 2}, {4, 1, 3}, {3, 0, 2}}});
        check_operations(a, b);
        check_operations(a | b, united({box<3>({0, 2, 0}, {5, 4, 2}), box<3>({4, 0, 3}, {5, 3, 5}),
                                        tetrahedron({{{0, 2, 5}, {3, 1, 3}, {0, 3, 5}, {2, 0, 1}}})}));
    }
    SECTION("an edge through the place where a face and a ridge of another sheet touch") {
        const Region<3> a = tetrahedron({{{2, 5, 0}, {0, 4, 1}, {4, 4, 5}, {4, 2, 4}}}) | box<3>({4, 1, 3}, {5, 2, 4}) |
                            tetrahedron({{{5, 0, 1}, {2, 4, 4}, {0, 5, 5}, {4, 3, 4}}});
        const Region<3> b =
            united({tetrahedron({{{3, 1, 4}, {4, 2, 3}, {5, 0, 5}, {3, 4, 4}}}), box<3>({2, 3, 2}, {3, 4, 5}),
                    tetrahedron({{{5, 3, 0}, {2, 1, 1}, {3, 0, 0}, {1, 3, 5}}}),
                    tetrahedron({{{1, 5, 1}, {0, 0, 1}, {0, 2, 1}, {4, 0, 3}}})});
        check_operations(a, b);
        check_operations(b, a);
    }
    SECTION("a ridge on a face, and a face of the other operand along it") {
        const Region<3> a = box<3>({0, 0, 0}, {4, 4, 4}) | tetrahedron({{{1, 1, 4}, {3, 3, 4}, {1, 3, 6}, {3, 1, 6}}});
        const Region<3> b = tetrahedron({{{-1, -1, 3}, {5, 5, 3}, {2, 2, 8}, {6, 0, 4}}});
        check_operations(a, b);
        check_operations(b, ~a);
    }
    SECTION("a vertex of a face in the middle of one of its edges") {
        const Region<3> a =
            united({box<3>({1, 4, 0}, {3, 5, 5}), tetrahedron({{{0, 5, 5}, {5, 0, 2}, {3, 2, 0}, {2, 0, 1}}}),
                    tetrahedron({{{5, 3, 3}, {0, 5, 5}, {0, 3, 4}, {1, 2, 3}}})});
        for (const int x : {0, 1, 2})
            check_operations(
                a, box<3>({x, 2, 4}, {5, 3, 5}) | tetrahedron({{{1, 4, 4}, {x, 3, 4}, {2, 3, 4}, {1, 3, 6}}}));
    }
}

TEST_CASE("surface evaluation: one face in several pieces, some inside the other operand and some not") {
    const Region<3> block = box<3>({0, 0, 0}, {9, 2, 2});
    const Region<3> trenched = block - box<3>({1, -1, 1}, {3, 3, 3}) - box<3>({5, -1, 1}, {6, 3, 3});
    // The top is three pieces of one face; the tool contains the middle one and touches nothing of it.
    const OperationCounts counts = check_operations(trenched, box<3>({2, -2, Rational(3, 2)}, {Rational(11, 2), 4, 5}));
    CHECK(counts.points_located == 0);
}

TEST_CASE("surface evaluation: grid solids, as they are and as meshes read anew") {
    Dice dice(5);
    const auto part = [&]() -> Region<3> {
        for (;;) {
            Corners c;
            for (auto& p : c)
                for (auto& x : p) x = dice.between(0, 4);
            Region<3> r;
            if (dice.below(2) == 0)
                r = box<3>(c[0], c[1]);
            else
                r = simplex<3>(c);
            if (!r.is_empty()) return r;
        }
    };
    for (std::size_t n = 0; n < scaled(60); ++n) {
        Region<3> a = united({part(), part()});
        Region<3> b = n % 3 == 0 ? a : united({part(), part(), part()});
        if (n % 4 == 0) b = ~b;
        if (n % 5 == 0) a = as_mesh(part());
        check_operations(a, b);
    }
}

TEST_CASE("surface evaluation: what nothing touches passes by index and gets no plane") {
    const Mesh ball = to_mesh(sphere<Rational>({0, 0, 0}, 4, {24, 12}));
    const Region<3> a = to_region(ball);
    const Region<3> b = as_mesh(box<3>({3, 3, 3}, {9, 9, 9}));
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    const Region<3> apart = apply(Operation::union_, a, b, options);
    CHECK(counts.kernel.sides == 0);
    CHECK(counts.faces_whole == ball.face_count() + 12);
    CHECK(apart.surface().planes.size() == 0);
    CHECK(apart.face_count() == ball.face_count() + 12);
    // One corner bitten off: only faces beside the bite have planes.
    const Region<3> bitten = apply(Operation::difference, a, as_mesh(box<3>({1, 1, 1}, {9, 9, 9})), options);
    const auto& faces = bitten.surface().faces.faces;
    const auto with_plane =
        std::count_if(faces.begin(), faces.end(), [](const FaceList::Face& f) { return f.plane != no_id; });
    CHECK(with_plane > 0);
    CHECK(std::size_t(with_plane) == counts.faces_merged);
    CHECK(std::size_t(with_plane) < faces.size() / 2);
    CHECK(*measure(bitten) + *measure(a & box<3>({1, 1, 1}, {9, 9, 9})) == *measure(a));
}

TEST_CASE("surface evaluation: results are operands again, and no plane grows") {
    Dice dice(11);
    const AffineMap<3, Integer> turn =
        compose(rational_rotation<3, Integer>(0, 1, 5, 2), rational_rotation<3, Integer>(1, 2, 7, 3));
    Region<3> part = as_mesh(box<3>({-4, -4, -4}, {4, 4, 4}));
    std::vector<Region<3>> tools;
    std::size_t bits = 4;
    for (std::size_t n = 0; n < scaled(30); ++n) {
        Region<3> tool = box<3>({-1, -1, -6}, {1, 1, 6});
        if (n % 3 != 0) tool = transform(turn, tool);
        tool = transform(translation<Integer>(dice.between(-3, 3), dice.between(-3, 3), dice.between(-2, 2)), tool);
        bits = std::max({bits, tool.boundary().planes.bits().first, tool.boundary().planes.bits().second});
        tools.push_back(tool);
        const Operation operation = n % 4 == 3 ? Operation::union_ : Operation::difference;
        const Region<3> next = apply(operation, part, tool);
        REQUIRE(next.surface().is_conforming);
        REQUIRE(canonical(next) == canonical(apply(Engine::boundary_filter, operation, part, tool)));
        part = next;
        const auto stored = part.surface().planes.bits();
        CHECK(std::max(stored.first, stored.second) <= bits);
    }
    verified(part);
    const Mesh mesh = to_mesh(part);
    CHECK(validate(mesh).is_valid(Strictness::tolerant));
}

TEST_CASE("surface evaluation: coordinates of all sizes at once") {
    const auto stretched = [](double x, double y, double z) {
        Mesh mesh = to_mesh(box<3>({0, 0, 0}, {1, 1, 1}));
        for (auto& p : mesh.points) p = {p[0] * x, p[1] * y, p[2] * z};
        return to_region(mesh);
    };
    for (const double e : {1e300, 1e-300, 0x1p-1070}) {
        const Region<3> flat = stretched(e, 1, 1 / std::max(e, 1e-300));
        check_operations(flat, stretched(e / 2, 2, 0.5));
        check_operations(flat, stretched(1, 0.5, 1));
        check_operations(flat, flat);
    }
}

TEST_CASE("a boundary without planes: completed once, whoever asks") {
    const Region<3> a = to_region(to_mesh(sphere<Rational>({0, 0, 0}, 4, {16, 8})));
    REQUIRE_FALSE(a.surface().is_complete);
    std::vector<const Boundary<3>*> seen(4, nullptr);
    {
        std::vector<std::jthread> threads;
        for (auto& s : seen) threads.emplace_back([&a, &s] { s = &a.boundary(); });
    }
    for (const auto* s : seen) CHECK(s == seen.front());
    CHECK(a.boundary().is_complete);
    CHECK(a.boundary().faces.faces.size() == a.face_count());
    // The complement of what has no planes yet has none either.
    const Region<3> outside = ~a;
    CHECK_FALSE(outside.surface().is_complete);
    CHECK(canonical(outside) == canonical(~Region<3>(a.boundary())));
}

// SPDX-License-Identifier: Apache-2.0
// Known solids given by meshes and boxes, and what is wrong with some of them, each by its number in the list that they
// come from.
#include <cleave/io/off.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/query/centroid.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/exact_region.hpp"
#include "support/meshes.hpp"
#include "support/tree_set.hpp"

#include <array>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The set goes through text and back unchanged, and is nothing but itself for both engines.
void check_text(const Region<3>& r) {
    const Region<3> back = to_region(read_off<Rational>(write_off(to_rational_mesh(r))));
    CHECK(canonical(back) == canonical(r));
    for (const Engine engine : all_engines) {
        CHECK(apply(engine, Operation::difference, r, back).is_empty());
        CHECK(apply(engine, Operation::symmetric_difference, r, back).is_empty());
        CHECK(canonical(apply(engine, Operation::intersection, r, back)) == canonical(r));
    }
}

}  // namespace

TEST_CASE("solid cases: D51, triangles of a cube and of a union") {
    const Region<3> cube = box<3>({0, 0, 0}, {1, 1, 1});
    const Mesh mesh = to_mesh(cube);
    CHECK(mesh.face_count() == 12);
    CHECK(mesh.point_count() == 8);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) CHECK(mesh.face(f).size() == 3);
    const Rational h(1, 2);
    const Region<3> other = box<3>({h, h, h}, {Rational(1 + h), Rational(1 + h), Rational(1 + h)});
    for (const Engine engine : all_engines) {
        const Region<3> sum = apply(engine, Operation::union_, cube, other);
        const Region<3> back = to_region(to_mesh(sum));
        CHECK(measure(back) == Rational(15, 8));
        CHECK(*centroid(back) == std::array<Rational, 3>{Rational(3, 4), Rational(3, 4), Rational(3, 4)});
        CHECK(canonical(back) == canonical(sum));
    }
    CHECK(to_mesh(Region<3>::empty()).face_count() == 0);
    CHECK(to_region(Mesh()).is_empty());
    // A set without end has no mesh, even the one without a boundary.
    CHECK_THROWS_AS(to_mesh(half_space(make_plane<Integer>(0, 1, 0, 0))), UnboundedError);
    CHECK_THROWS_AS(to_mesh(Region<3>::full()), UnboundedError);
}

TEST_CASE("solid cases: D52, a prism that is concave by a ten millionth") {
    const Rational dent(1, 10000000);
    std::vector<std::array<Rational, 3>> points;
    for (const int z : {0, 2})
        for (const auto& [x, y] : {std::array<Rational, 2>{0, 0}, {2, dent}, {4, 0}, {2, 2}})
            points.push_back({x, y, z});
    const Region<3> prism = to_region(meshes::mesh<Rational>(
        points, {{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}));
    CHECK(measure(prism) == 8 - 4 * dent);
    TreeSet<3> set(prism);
    CHECK(set.inside({2, 1, 1}));
    for (const auto& p : {std::array<Rational, 3>{2, 1, 3}, {2, 1, -3}, {2, -1, 1}, {2, 3, 1}, {-1, 1, 1}, {4, 1, 1}})
        CHECK(set.outside(p));
    // The dent itself: half as deep is outside, its bottom is boundary, as deep again is inside.
    CHECK(set.outside({2, Rational(dent / 2), 1}));
    CHECK(set.on({2, dent, 1}));
    CHECK(set.inside({2, Rational(2 * dent), 1}));
    check_text(prism);
}

TEST_CASE("solid cases: D54, a cube with a corner moved by a millionth") {
    const Rational e(999999, 1000000);
    const RationalMesh mesh = meshes::mesh<Rational>(
        {{1, -1, -1}, {1, -1, 1}, {-1, -1, 1}, {-1, -1, -1}, {1, 1, -1}, {e, 1, 1}, {-1, 1, 1}, {-1, 1, -1}},
        {{0, 1, 2},
         {0, 2, 3},
         {4, 7, 6},
         {4, 6, 5},
         {0, 4, 5},
         {0, 5, 1},
         {1, 5, 6},
         {1, 6, 2},
         {2, 6, 7},
         {2, 7, 3},
         {4, 0, 3},
         {4, 3, 7}});
    const Region<3> solid = to_region(mesh);
    CHECK(measure(solid) == Rational(5999999, 750000));
    // What it lacks of the cube lies at that corner.
    const Region<3> cube = box<3>({-1, -1, -1}, {1, 1, 1});
    for (const Engine engine : all_engines) {
        CHECK(apply(engine, Operation::difference, solid, cube).is_empty());
        CHECK(measure(apply(engine, Operation::difference, cube, solid)) == Rational(1, 750000));
    }
    check_text(solid);
}

TEST_CASE("solid cases: D55, a pentomino, and pentominoes that are refused") {
    const Mesh mesh = meshes::pentomino();
    const Region<3> solid = to_region(mesh);
    CHECK(measure(solid) == 5);
    CHECK(ExactRegion<3>(solid).boundary_measure() == 22);
    check_text(solid);
    // Without a wall, and with a face turned over.
    CHECK_THROWS_AS(to_region(meshes::without_face(mesh, 4)), MeshError);
    CHECK_THROWS_AS(to_region(meshes::with_reversed_face(mesh, 3)), MeshError);
    // A corner out of its face's plane, and a face of two corners: refused where strictness is asked for. Without it
    // the face that is not flat is taken as triangles, so there is a solid all the same.
    const ToRegionOptions strict{Strictness::strict, nullptr, nullptr, true};
    Mesh bent = mesh;
    bent.points[7][2] = 0.5;
    CHECK_THROWS_AS(to_region(bent, strict), MeshError);
    CHECK(measure(to_region(bent)) < 5);
    Mesh thin = mesh;
    thin.add_face({0, 1});
    CHECK_THROWS_AS(to_region(thin, strict), MeshError);
    // Points given twice are one point.
    const Mesh doubled = meshes::soup(mesh);
    CHECK(doubled.point_count() == 4 * 5 + 8 * 4);
    CHECK(weld(doubled).point_count() == mesh.point_count());
    CHECK(canonical(to_region(doubled)) == canonical(solid));
}

TEST_CASE("solid cases: D56, a cube of twelve triangles through text") {
    const Region<3> cube = to_region(meshes::triangle_cube());
    CHECK(measure(cube) == 8);
    CHECK(ExactRegion<3>(cube).boundary_measure() == 24);
    CHECK(canonical(cube) == canonical(box<3>({-1, -1, -1}, {1, 1, 1})));
    check_text(cube);
}

TEST_CASE("solid cases: D57, boxes without extent are empty") {
    const Region<3> cube = box<3>({-1, -1, -1}, {1, 1, 1});
    for (const auto& corner : {std::array<Rational, 3>{0, 1, 1}, {1, 0, 1}, {1, 1, 0}, {0, 0, 1}, {0, 0, 0}}) {
        const Region<3> flat = box<3>({0, 0, 0}, corner);
        CHECK(flat.is_empty());
        CHECK(measure(flat) == 0);
        CHECK_FALSE(centroid(flat));
        for (const Engine engine : all_engines) {
            CHECK(canonical(apply(engine, Operation::union_, cube, flat)) == canonical(cube));
            CHECK(canonical(apply(engine, Operation::difference, cube, flat)) == canonical(cube));
            CHECK(apply(engine, Operation::intersection, cube, flat).is_empty());
        }
    }
}

// SPDX-License-Identifier: Apache-2.0
/// Validation: good meshes in every odd form, and each kind of defect found where it is.
#include <cleave/mesh/validate.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/property.hpp"

#include <limits>

using namespace cleave;
using support::property;

namespace {

using Faces = std::vector<std::uint32_t>;

RationalMesh rational(const Mesh& mesh) {
    RationalMesh result;
    for (const auto& p : mesh.points) result.points.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
    result.corners = mesh.corners;
    result.first = mesh.first;
    return result;
}

/// The report, after asserting that exact coordinates and a soup of separate faces give the same kinds and faces.
MeshReport checked(const Mesh& mesh) {
    const MeshReport report = validate(mesh);
    const MeshReport exact = validate(rational(mesh));
    const MeshReport loose = validate(meshes::soup(mesh));
    for (const MeshDefect kind : all_mesh_defects) {
        REQUIRE(exact.count(kind) == report.count(kind));
        if (kind != MeshDefect::unused_point) REQUIRE(loose.count(kind) == report.count(kind));
    }
    REQUIRE(exact.open_edges == report.open_edges);
    REQUIRE(exact.zero_area_faces == report.zero_area_faces);
    REQUIRE(loose.non_planar_faces == report.non_planar_faces);
    REQUIRE(loose.is_closed() == report.is_closed());
    return report;
}

}  // namespace

TEST_CASE("validate: closed oriented meshes have nothing to report") {
    for (const Mesh& mesh : {meshes::cube(), meshes::tetrahedron(), meshes::triangle_cube(), meshes::pentomino()}) {
        const MeshReport report = checked(mesh);
        for (const MeshDefect kind : all_mesh_defects) REQUIRE(report.count(kind) == 0);
        REQUIRE(report.is_closed());
        REQUIRE(report.is_valid(Strictness::strict));
        REQUIRE(report.point_count == mesh.point_count());
        REQUIRE(report.face_count == mesh.face_count());
    }
}

TEST_CASE("validate: a mesh without faces bounds the empty set") {
    REQUIRE(validate(Mesh{}).is_valid(Strictness::strict));
    REQUIRE(validate(RationalMesh{}).is_closed());
    Mesh moved_from;
    moved_from.first.clear();
    REQUIRE(validate(moved_from).is_valid(Strictness::strict));
}

TEST_CASE("validate: a missing face leaves its edges open") {
    // The pentomino without the face {0, 1, 9, 8}: four edges have one face left.
    const MeshReport report = checked(meshes::without_face(meshes::pentomino(), 4));
    REQUIRE(report.open_edges ==
            std::vector<EdgeDefect>{{0, 8, 1, 0, 10}, {1, 0, 1, 0, 2}, {8, 9, 1, 0, 0}, {9, 1, 1, 0, 4}});
    REQUIRE_FALSE(report.is_closed());
    REQUIRE_FALSE(report.is_valid());
    REQUIRE(report.misoriented_edges.empty());
    REQUIRE(report.unbalanced_edges.empty());
    REQUIRE(report.complete);
}

TEST_CASE("validate: a reversed face runs the same way as its neighbours") {
    // Face {6, 5, 4, 3, 2} of the pentomino turned over.
    const MeshReport report = checked(meshes::with_reversed_face(meshes::pentomino(), 3));
    REQUIRE(report.open_edges.empty());
    REQUIRE(report.misoriented_edges.size() == 5);
    REQUIRE(report.misoriented_edges[0] == EdgeDefect{2, 3, 2, 0, 3});
    REQUIRE_FALSE(report.is_valid());
    // All faces turned over: the complement's boundary, as consistent as before.
    Mesh inside_out = meshes::pentomino();
    for (std::size_t f = 0; f < inside_out.face_count(); ++f) inside_out = meshes::with_reversed_face(inside_out, f);
    REQUIRE(checked(inside_out).is_valid(Strictness::strict));
}

TEST_CASE("validate: surplus faces unbalance their edges") {
    Mesh mesh = meshes::tetrahedron();
    mesh.points.push_back({1, 1, 1});
    mesh.add_face({0, 1, 4});
    const MeshReport report = checked(mesh);
    REQUIRE(report.unbalanced_edges == std::vector<EdgeDefect>{{0, 1, 2, 1, 0}});
    REQUIRE(report.open_edges.size() == 2);
}

TEST_CASE("validate: four faces at an edge and two solids at a vertex are closed") {
    // Two tetrahedra with a common edge, by index.
    const Mesh mesh =
        meshes::mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                     {{0, 3, 2}, {0, 2, 1}, {2, 3, 1}, {3, 0, 1}, {0, 5, 4}, {0, 4, 1}, {4, 5, 1}, {5, 0, 1}});
    REQUIRE(checked(mesh).is_valid(Strictness::strict));
    // Two cubes with a common corner, and with a common edge, as separate points.
    for (const auto& shift : {std::array<double, 3>{1, 1, 1}, std::array<double, 3>{1, 1, 0}}) {
        Mesh pair = meshes::cube();
        for (const auto& p : meshes::cube().points)
            pair.points.push_back({p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]});
        const Mesh cube = meshes::cube();
        for (std::size_t f = 0; f < cube.face_count(); ++f) {
            std::vector<std::uint32_t> face;
            for (const std::uint32_t corner : cube.face(f)) face.push_back(corner + 8);
            pair.add_face(face);
        }
        REQUIRE(checked(pair).is_valid(Strictness::strict));
        REQUIRE(validate(weld(pair)).is_valid(Strictness::strict));
    }
}

TEST_CASE("validate: points at equal coordinates are one point, minus zero included") {
    Mesh soup = meshes::soup(meshes::cube());
    REQUIRE(validate(soup).is_valid(Strictness::strict));
    for (auto& p : soup.points) {
        for (double& x : p) {
            if (x == 0 && (&p - soup.points.data()) % 2 == 0) x = -0.0;
        }
    }
    REQUIRE(validate(soup).is_valid(Strictness::strict));
    // The least possible gap is a gap. Along an edge's line it leaves the rest of that edge balanced.
    soup.points[0][2] = std::numeric_limits<double>::denorm_min();
    MeshReport report = validate(soup);
    REQUIRE_FALSE(report.is_closed());
    REQUIRE(report.open_edges.size() == 4);
    REQUIRE(report.t_junctions.empty());
    soup.points[0] = {std::numeric_limits<double>::denorm_min(), 0, 0};
    report = validate(soup);
    REQUIRE_FALSE(report.is_closed());
    REQUIRE(report.open_edges.size() == 3);
    REQUIRE(report.t_junctions.size() == 1);
}

TEST_CASE("validate: faces without area close the surface and are reported") {
    // The edge 0-1 of one face meets the edges 0-8 and 8-1 of its neighbour; the flat triangle between them closes it.
    Mesh mesh = meshes::cube();
    mesh.points.push_back({0.5, 0, 0});
    Mesh split = meshes::without_face(mesh, 2);
    split.add_face({0, 8, 1, 5, 4});
    split.add_face({0, 1, 8});
    const MeshReport report = checked(split);
    REQUIRE(report.is_closed());
    REQUIRE(report.t_junctions.empty());
    REQUIRE(report.zero_area_faces == Faces{6});
    REQUIRE(report.is_valid(Strictness::tolerant));
    REQUIRE_FALSE(report.is_valid(Strictness::strict));
}

TEST_CASE("validate: edges that cancel out along their line are closed without any face between them") {
    // The same without the flat triangle, as a T-junction; then with three vertices on one side and two on the other.
    Mesh mesh = meshes::cube();
    mesh.points.push_back({0.25, 0, 0});
    mesh.points.push_back({0.5, 0, 0});
    mesh.points.push_back({0.75, 0, 0});
    Mesh split = meshes::without_face(mesh, 2);
    split.add_face({0, 8, 10, 1, 5, 4});
    const MeshReport report = checked(split);
    REQUIRE(report.is_closed());
    REQUIRE(report.is_valid(Strictness::strict));
    REQUIRE(report.t_junctions ==
            std::vector<EdgeDefect>{{0, 8, 1, 0, 5}, {1, 0, 1, 0, 0}, {8, 10, 1, 0, 5}, {10, 1, 1, 0, 5}});
    split = meshes::without_face(split, 0);
    split.add_face({0, 2, 3, 1, 9});
    REQUIRE(checked(split).is_closed());
    REQUIRE(checked(split).t_junctions.size() == 5);
}

TEST_CASE("validate: edges that nearly lie on one line, or cover it in part, are open") {
    Mesh mesh = meshes::cube();
    mesh.points.push_back({0.5, 0, 0});
    Mesh split = meshes::without_face(mesh, 2);
    split.add_face({0, 8, 1, 5, 4});
    // Off the line by the least possible amount.
    split.points[8][1] = std::numeric_limits<double>::denorm_min();
    MeshReport report = checked(split);
    REQUIRE_FALSE(report.is_closed());
    REQUIRE(report.open_edges.size() == 3);
    REQUIRE(report.t_junctions.empty());
    // On the line, with one of the two short edges turned: the line is covered twice and not at all.
    const Mesh overlap = meshes::mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                                      {{0, 1, 3}, {2, 0, 4}, {2, 1, 5}});
    report = checked(overlap);
    REQUIRE(report.t_junctions == std::vector<EdgeDefect>{{2, 0, 1, 0, 1}});
    REQUIRE(report.open_edges.size() == 8);
}

TEST_CASE("validate: faces with repeated and with too few corners") {
    Mesh mesh = meshes::cube();
    Mesh odd = meshes::without_face(mesh, 0);
    odd.add_face({0, 2, 2, 3, 1});  // 5
    odd.add_face({4, 6, 4});        // 6: there and back
    odd.add_face({1});              // 7
    odd.add_face({});               // 8
    const MeshReport report = checked(odd);
    REQUIRE(report.repeated_corners == Faces{5});
    REQUIRE(report.too_few_corners == Faces{6, 7, 8});
    REQUIRE(report.is_closed());
    REQUIRE(report.is_valid(Strictness::tolerant));
    REQUIRE_FALSE(report.is_valid(Strictness::strict));
}

TEST_CASE("validate: non-planar faces, decided exactly") {
    // Corner 7 of the pentomino moved to z = 1/2 stays in the planes of its two walls and leaves that of the bottom.
    Mesh mesh = meshes::pentomino();
    mesh.points[7][2] = 0.5;
    MeshReport report = checked(mesh);
    REQUIRE(report.non_planar_faces == Faces{2});
    REQUIRE(report.is_closed());
    REQUIRE(report.is_valid(Strictness::tolerant));
    REQUIRE_FALSE(report.is_valid(Strictness::strict));
    mesh = meshes::cube();
    mesh.points[7][0] = std::numeric_limits<double>::epsilon() + 1;
    report = checked(mesh);
    REQUIRE(report.non_planar_faces == Faces{5});
}

TEST_CASE("validate: outlines that cross themselves are refused in every mode") {
    Mesh mesh = meshes::cube();
    Mesh crossed = meshes::without_face(mesh, 1);
    crossed.add_face({4, 5, 6, 7});
    const MeshReport report = checked(crossed);
    REQUIRE(report.crossing_outlines == Faces{5});
    REQUIRE_FALSE(report.is_valid(Strictness::tolerant));
}

TEST_CASE("validate: coordinates that are not finite, and indices out of range") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    Mesh mesh = meshes::cube();
    mesh.points[2][1] = nan;
    mesh.points[5][2] = -infinity;
    MeshReport report = validate(mesh);
    REQUIRE(report.points_not_finite == Faces{2, 5});
    REQUIRE_FALSE(report.complete);
    REQUIRE_FALSE(report.is_closed());
    REQUIRE_FALSE(report.is_valid());

    mesh = meshes::cube();
    mesh.corners[6] = 8;
    mesh.corners[22] = 0xffffffffU;
    report = validate(mesh);
    REQUIRE(report.indices_out_of_range == std::vector<CornerDefect>{{1, 2, 8}, {5, 2, 0xffffffffU}});
    REQUIRE_FALSE(report.is_valid());
}

TEST_CASE("validate: unused points are mentioned and harmless") {
    Mesh mesh = meshes::cube();
    mesh.points.push_back({9, 9, 9});
    const MeshReport report = validate(mesh);
    REQUIRE(report.unused_points == Faces{8});
    REQUIRE(report.is_valid(Strictness::strict));
}

TEST_CASE("validate: a broken face table is a broken contract") {
    Mesh mesh = meshes::cube();
    mesh.first[2] = 23;
    REQUIRE_THROWS_AS(validate(mesh), ContractViolation);
    mesh = meshes::cube();
    mesh.first.back() = 20;
    REQUIRE_THROWS_AS(validate(mesh), ContractViolation);
    mesh = meshes::cube();
    mesh.first.front() = 1;
    REQUIRE_THROWS_AS(validate(mesh), ContractViolation);
}

TEST_CASE("validate: require_valid passes good meshes and throws with the evidence") {
    REQUIRE(require_valid(meshes::cube()).is_closed());
    REQUIRE(require_valid(meshes::cube<Rational>(), Strictness::strict).is_closed());
    Mesh warped = meshes::cube();
    warped.points[7] = {2, 2, 1.5};
    REQUIRE(require_valid(warped).non_planar_faces.size() == 3);
    REQUIRE_THROWS_AS(require_valid(warped, Strictness::strict), MeshError);
    try {
        require_valid(meshes::without_face(meshes::cube(), 3));
        FAIL("an open mesh was accepted");
    } catch (const MeshError& error) {
        REQUIRE(error.report().open_edges.size() == 4);
    }
}

TEST_CASE("validate: a hole or a turned face is found wherever it is") {
    property("one changed face of a subdivided cube", [] {
        // A grid of n x n quadrilaterals on each side of a cube, as separate faces: 24 n^2 corners to weld.
        const int n = support::draw_int(1, 4);
        Mesh mesh;
        const Mesh cube = meshes::cube(0.0, double(n));
        for (std::size_t f = 0; f < 6; ++f) {
            const auto& o = cube.points[cube.face(f)[0]];
            const auto& u = cube.points[cube.face(f)[1]];
            const auto& v = cube.points[cube.face(f)[3]];
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    std::vector<std::uint32_t> face;
                    for (const auto& [s, t] :
                         {std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)}) {
                        face.push_back(static_cast<std::uint32_t>(mesh.points.size()));
                        auto& p = mesh.points.emplace_back();
                        for (std::size_t x = 0; x < 3; ++x) p[x] = o[x] + (u[x] - o[x]) * s / n + (v[x] - o[x]) * t / n;
                    }
                    mesh.add_face(face);
                }
            }
        }
        RC_ASSERT(validate(mesh).is_valid(Strictness::strict));
        const std::size_t f = support::draw_index(mesh.face_count());
        const MeshReport open = validate(meshes::without_face(mesh, f));
        RC_ASSERT(open.open_edges.size() == 4U);
        const MeshReport turned = validate(meshes::with_reversed_face(mesh, f));
        RC_ASSERT(turned.misoriented_edges.size() == 4U);
        RC_ASSERT(turned.open_edges.empty());
        Mesh doubled = mesh;
        doubled.add_face(std::vector<std::uint32_t>(mesh.face(f).begin(), mesh.face(f).end()));
        RC_ASSERT(validate(doubled).unbalanced_edges.size() == 4U);
    });
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/from_region.hpp>
// The operations that the tests need are compiled once for all tests.
#include <cleave/extern.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <set>

using namespace cleave;

namespace {

Region<3> cuboid(const Rational& x, const Rational& y, const Rational& z, const Rational& size) {
    return box<3, Rational>({x, y, z}, {x + size, y + size, z + size});
}

void check_both(const Region<3>& r) {
    const ExportedMesh<double> rounded = to_exported_mesh(r);
    const ExportedMesh<Rational> exact = to_exported_rational_mesh(r);
    CHECK(rounded.sources.size() == rounded.mesh.face_count());
    CHECK(exact.sources.size() == exact.mesh.face_count());
    const MeshReport a = validate(rounded.mesh);
    const MeshReport b = validate(exact.mesh);
    CHECK(a.is_closed());
    CHECK(b.is_valid(Strictness::strict));
    CHECK(b.t_junctions.empty());
    CHECK(*measure(to_region(exact.mesh)) == *measure(r));
}

}  // namespace

TEST_CASE("from_region: a cube is twelve triangles, eight points") {
    const Mesh m = to_mesh(cuboid(0, 0, 0, 2));
    CHECK(m.face_count() == 12);
    CHECK(m.point_count() == 8);
    CHECK(*measure(to_region(m)) == 8);
}

TEST_CASE("from_region: results of operations close without T-junctions") {
    const Region<3> a = cuboid(0, 0, 0, 2);
    const Region<3> b = cuboid(1, 1, 1, 2);
    const Region<3> c = cuboid(Rational(1) / 3, Rational(1) / 3, 2, 1);  // stands on a
    check_both(a | b);
    check_both(a & b);
    check_both(a - b);
    check_both(a ^ b);
    check_both(a | c);
    check_both((a | c) - b);
    check_both(a | cuboid(2, 1, 0, 2));  // shares part of a face; edges end in the middle of others
    check_both(a - cuboid(Rational(1) / 2, Rational(1) / 2, Rational(1) / 2, 1));  // a void
}

TEST_CASE("from_region: coordinates are correctly rounded") {
    const Region<3> r = cuboid(Rational(1) / 3, Rational(1) / 7, Rational(1) / 10, 1) & cuboid(0, 0, 0, 1);
    std::set<double> seen;
    const Mesh m = to_mesh(r);
    for (const auto& p : m.points)
        for (const double x : p) seen.insert(x);
    CHECK(seen == std::set<double>{1.0 / 3, 1.0 / 7, 0.1, 1.0});
}

TEST_CASE("from_region: what is thinner than doubles can tell vanishes, and the mesh stays closed") {
    const Rational tiny = Rational(1) / Rational("1000000000000000000000000000000");
    const Region<3> sheet = box<3, Rational>({1, 1, 1}, {2, 2, 1 + tiny});
    const ExportedMesh<double> none = to_exported_mesh(sheet);
    CHECK(none.mesh.face_count() == 0);
    CHECK(none.rounding.points_merged == 4);
    CHECK(none.rounding.faces_vanished == 12);
    const ExportedMesh<double> some = to_exported_mesh(sheet | cuboid(1, 1, 5, 1));
    CHECK(some.mesh.face_count() == 12);
    CHECK(validate(some.mesh).is_closed());
    CHECK(to_rational_mesh(sheet).face_count() == 12);
}

TEST_CASE("from_region: empty gives no faces, unbounded an error that says what to do") {
    CHECK(to_mesh(Region<3>()).face_count() == 0);
    CHECK_THROWS_AS(to_mesh(Region<3>::full()), UnboundedError);
    CHECK_THROWS_AS(to_mesh(~cuboid(0, 0, 0, 1)), UnboundedError);
}

TEST_CASE("from_region: a coordinate beyond doubles is an error, not an infinity") {
    Rational huge(1);
    for (int i = 0; i < 1100; ++i) huge *= 2;
    CHECK_THROWS_AS(to_mesh(box<3, Rational>({0, 0, 0}, {huge, huge, huge})), NumberError);
    CHECK(to_rational_mesh(box<3, Rational>({0, 0, 0}, {huge, huge, huge})).face_count() == 12);
}

TEST_CASE("from_region: sources name operand and face") {
    const Region<3> a = cuboid(0, 0, 0, 2);
    const Region<3> b = cuboid(1, 1, 1, 2);
    const ExportedMesh<double> m = to_exported_mesh(a - b);
    std::set<std::uint32_t> operands;
    for (const Source& s : m.sources) {
        operands.insert(s.operand);
        CHECK(s.face < 6);
    }
    CHECK(operands == std::set<std::uint32_t>{0, 1});
}

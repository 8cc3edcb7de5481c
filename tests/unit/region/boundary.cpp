// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/boundary.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

const auto itself = [](PointId p) { return p; };

template <int D>
void check_round_trip(const Region<D>& region) {
    Kernel<D> kernel;
    // Into an empty kernel everything keeps its number.
    const LoadedBoundary<D> first = load(region.boundary(), kernel);
    CHECK(first.first_point == 0);
    CHECK(dump(freeze(kernel, region.boundary().faces, region.boundary().value_at_infinity, itself)) ==
          dump(region.boundary()));
    // A second copy shares the planes and has points of its own.
    const std::size_t planes = kernel.planes.size();
    const LoadedBoundary<D> second = load(region.boundary(), kernel);
    CHECK(kernel.planes.size() == planes);
    CHECK(second.planes == first.planes);
    CHECK(second.first_point == region.boundary().points.size());
    CHECK(kernel.point_count() == 2 * region.boundary().points.size());
    // Into a kernel that knows other things, and out again from there.
    Kernel<D> other;
    for (int axis = 0; axis < D; ++axis) (void)other.planes.intern_axis_plane(axis, 77);
    const LoadedBoundary<D> moved = load(region.boundary(), other);
    FaceList list = region.boundary().faces;
    for (FaceList::Face& f : list.faces) f.plane = moved.plane(f.plane);
    for (Corner& c : list.corners) c = moved.corner(c);
    CHECK(dump(freeze(other, list, region.boundary().value_at_infinity, itself)) == dump(region.boundary()));
}

}  // namespace

TEST_CASE("boundary: faces and loops are runs of one list of corners") {
    FaceList list;
    CHECK(list.loop_first == LargeVector<std::uint32_t>{0});
    const Corner c[] = {{10, 0}, {11, 2}, {12, 4}, {13, 6}};
    list.begin_face(4, {0, 1});
    list.add_loop({c, 3});
    list.add_loop({c + 1, 3});
    list.begin_face(6, {0, 2});
    list.add_loop({c, 4});
    REQUIRE(list.faces.size() == 2);
    CHECK(list.faces[0].first_loop == 0);
    CHECK(list.faces[0].loop_count == 2);
    CHECK(list.faces[1].first_loop == 2);
    CHECK(list.faces[1].loop_count == 1);
    CHECK(list.faces[1].plane == 6);
    CHECK(list.faces[1].source == Source{0, 2});
    CHECK(list.loop_first == LargeVector<std::uint32_t>{0, 3, 6, 10});
    CHECK(list.loop(1).size() == 3);
    CHECK(list.loop(1)[0] == c[1]);
    CHECK(list.loop(2)[3] == c[3]);
}

TEST_CASE("boundary: freezing keeps what faces use, in order of first use") {
    Kernel<2> kernel;
    const auto plane = [&](int a, int b, int c) { return kernel.planes.intern({Integer(a), Integer(b), Integer(c)}); };
    (void)plane(1, 7, 3);  // used by nothing
    const PlaneId x = plane(1, 0, -1);
    const PlaneId unused = plane(1, 1, -2);
    const PlaneId y = plane(0, 1, -1);
    const PlaneId z = plane(3, 1, 0);
    const PointId p = kernel.add_point(std::array{1.0, 1.0});
    (void)kernel.add_point(std::array{9.0, 9.0});
    const PointId q = kernel.add_point(std::array{1.0, -3.0});
    const PointId q2 = kernel.add_point(std::array{1.0, -3.0});
    const PointId meet = kernel.add_meet({unoriented(z), unoriented(y)});
    kernel.note_incidence(p, unoriented(unused));
    kernel.note_incidence(p, unoriented(y));
    FaceList list;
    const auto face = [&](PlaneId h, Corner a, Corner b) {
        const Corner loop[2] = {a, b};
        list.begin_face(h, {1, 2});
        list.add_loop(loop);
    };
    face(y, {p, x}, {meet, flipped(z)});
    face(flipped(z), {meet, y}, {q, x});
    face(x, {q2, flipped(z)}, {p, y});
    const Boundary<2> b = freeze(kernel, list, false, [&](PointId r) { return r == q2 ? q : r; });
    CHECK(!b.value_at_infinity);
    REQUIRE(b.planes.size() == 3);
    CHECK(b.planes.exact(0) == kernel.planes.exact(unoriented(y)));
    CHECK(b.planes.exact(1) == kernel.planes.exact(unoriented(z)));
    CHECK(b.planes.exact(2) == kernel.planes.exact(unoriented(x)));
    CHECK(b.faces.faces[0].plane == 0);
    CHECK(b.faces.faces[1].plane == 3);  // orientations are kept
    CHECK(b.faces.faces[1].source == Source{1, 2});
    CHECK(b.faces.corners == LargeVector<Corner>{{0, 4}, {1, 3}, {1, 0}, {2, 4}, {2, 3}, {0, 0}});
    REQUIRE(b.points.size() == 3);
    // Of the planes that p is known to lie on only those of the boundary are kept.
    CHECK(b.points[0].planes == std::array<std::uint32_t, 2>{no_id, 0});
    CHECK(b.points[1].kind == PointRecord<2>::Kind::meet);
    CHECK(b.points[1].planes == std::array<std::uint32_t, 2>{1, 0});
    CHECK(b.points[1].error < std::numeric_limits<double>::infinity());  // worked out at the latest now
    REQUIRE(b.exact.size() == 1);
    CHECK(b.points[1].exact == 0);
    CHECK(rational(b.exact[0][0], b.exact[0][2]) == Rational(-1, 3));
    CHECK(b.bounds.hi[0] == 1);
    CHECK(b.bounds.lo[1] == -3);
    CHECK(b.bounds.lo[0] < -1.0 / 3);  // a bound of the exact place, not of its approximation
    CHECK(b.bounds.lo[0] > -0.34);
    CHECK(freeze(kernel, list, true, itself).value_at_infinity);
    verified(Region<2>(b));
}

TEST_CASE("boundary: a meet's planes come along although no face has them") {
    Kernel<1> kernel;
    const PlaneId at = kernel.planes.intern({Integer(3), Integer(-1)});
    const PointId p = kernel.add_meet({unoriented(at)});
    FaceList list;
    const Corner corner{p, no_id};
    list.begin_face(at, {});
    list.add_loop({&corner, 1});
    const Boundary<1> b = freeze(kernel, list, true, itself);
    CHECK(b.faces.corners[0].edge == no_id);
    CHECK(ExactRegion<1>(b).points()[0][0] == Rational(1, 3));
    Kernel<2> plane;
    const PlaneId x = plane.planes.intern_axis_plane(0, 1);
    const PlaneId y = plane.planes.intern_axis_plane(1, 2);
    const PlaneId diagonal = plane.planes.intern({Integer(2), Integer(-1), Integer(0)});
    const Corner ends[2] = {{plane.add_meet({unoriented(x), unoriented(diagonal)}), y},
                            {plane.add_point(std::array{1.0, 5.0}), flipped(y)}};
    FaceList segment;
    segment.begin_face(x, {});
    segment.add_loop(ends);
    CHECK(freeze(plane, segment, false, itself).planes.size() == 3);
}

TEST_CASE("boundary: loading and freezing again changes nothing") {
    check_round_trip<1>(intervals({{0, 1}, {Rational(7, 3), 4}}));
    check_round_trip<2>(box<2>({0, 0}, {3, 3}) ^ simplex<2>({{1, 1}, {5, 2}, {2, 7}}));
    const Region<3> a = simplex<3>({{0, 0, 0}, {4, 0, 1}, {1, 4, 0}, {0, 1, 4}});
    const Region<3> b = simplex<3>({{2, 2, 3}, {0, 0, 1}, {4, 0, 0}, {1, 4, 1}});
    check_round_trip<3>(a);
    check_round_trip<3>(a - b);
    check_round_trip<3>(Region<3>::full() - (a ^ b));
    check_round_trip<3>(a & b & box<3>({1, 1, 1}, {Rational(5, 3), Rational(5, 3), Rational(5, 3)}));
    check_round_trip<3>(Region<3>::empty());
    check_round_trip<3>(Region<3>::full());
}

TEST_CASE("boundary: a loaded boundary names its planes and corners, and no plane stays none") {
    Kernel<2> kernel;
    (void)kernel.planes.intern_axis_plane(0, 5);
    (void)kernel.add_point(std::array{5.0, 5.0});
    const Region<2> square = box<2>({0, 0}, {5, 5});
    const LoadedBoundary<2> loaded = load(square.boundary(), kernel);
    CHECK(kernel.planes.size() == 4);  // x = 5 was there
    CHECK(loaded.first_point == 1);
    for (std::uint32_t k = 0; k < 4; ++k) {
        CHECK(kernel.planes.exact(loaded.planes[k]) == square.boundary().planes.exact(k));
        CHECK(loaded.plane(2 * k) == 2 * loaded.planes[k]);
        CHECK(loaded.plane(2 * k + 1) == flipped(loaded.plane(2 * k)));
    }
    CHECK(loaded.plane(no_id) == no_id);
    CHECK(loaded.corner({2, no_id}) == Corner{3, no_id});
    CHECK(loaded.corner({2, 1}) == Corner{3, loaded.plane(1)});
}

// SPDX-License-Identifier: Apache-2.0
// The cube tables: volumes, areas, centroids and faces of two overlapping cubes; coincident operands in every way that
// their faces may be divided.
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/cuboids.hpp"
#include "support/region_checker.hpp"

#include <cleave/query/measure.hpp>
#include <cleave/shape/box.hpp>

using namespace cleave;
using namespace support;

namespace {

struct Expected {
    Operation operation;
    Rational volume;
    Rational area;
    Rational centroid;
    std::size_t faces;
    std::size_t whole;  // of them untouched
};

void check_size(const Region<3>& r, const Rational& volume, const Rational& area) {
    const ExactRegion<3> exact(r);
    CHECK(exact.measure() == volume);
    CHECK(exact.boundary_measure() == area);
    CHECK(exact.total_area_vector() == Coordinates<3>{0, 0, 0});
    CHECK(measure(r).value() == volume);
}

}  // namespace

TEST_CASE("cube table: two cubes that overlap in a corner") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> b = box<3>({1, 1, 1}, {3, 3, 3});
    // Each cube has three faces that the other does not touch and three that lose a square.
    const std::vector<Expected> table = {
        {Operation::union_, 15, 42, Rational(3) / 2, 12, 6},
        {Operation::intersection, 1, 6, Rational(3) / 2, 6, 0},
        {Operation::difference, 7, 24, Rational(13) / 14, 9, 3},
        {Operation::symmetric_difference, 14, 48, Rational(3) / 2, 18, 6},
    };
    for (const Expected& row : table) {
        INFO(to_text(row.operation));
        OperationCounts counts;
        OperationOptions options;
        options.counts = &counts;
        const Region<3> r = checked_evaluate<3, Rational>(BooleanFunction::from(row.operation, 2), {a, b}, options);
        check_size(r, row.volume, row.area);
        CHECK(ExactRegion<3>(r).centroid() == Coordinates<3>{row.centroid, row.centroid, row.centroid});
        CHECK(r.face_count() == row.faces);
        CHECK(ExactRegion<3>(r).plane_count() == row.faces);
        CHECK(counts.faces_whole == row.whole);
        CHECK(counts.faces_whole + counts.faces_merged == row.faces);
    }
}

TEST_CASE("cube table: the same whatever way the faces are divided") {
    for (const Surface& first : all_surfaces) {
        for (const Surface& second : all_surfaces) {
            const Region<3> a = cuboid({0, 0, 0}, {2, 2, 2}, first);
            const Region<3> b = cuboid({1, 1, 1}, {3, 3, 3}, second);
            check_size(checked(Operation::union_, a, b), 15, 42);
            check_size(checked(Operation::intersection, a, b), 1, 6);
            check_size(checked(Operation::difference, a, b), 7, 24);
            check_size(checked(Operation::symmetric_difference, a, b), 14, 48);
        }
    }
}

TEST_CASE("coincidence table: a cube with itself, a neighbour, a slab of itself, its complement") {
    for (const Surface& first : all_surfaces) {
        for (const Surface& second : all_surfaces) {
            INFO(first.pieces << (first.triangles ? " triangles, " : " quads, ") << second.pieces
                              << (second.triangles ? " triangles" : " quads"));
            const Region<3> a = cuboid({0, 0, 0}, {2, 2, 2}, first);
            const Region<3> same = cuboid({0, 0, 0}, {2, 2, 2}, second);
            const Region<3> t = cuboid({2, 0, 0}, {4, 2, 2}, second);
            const Region<3> s = cuboid({0, 0, 0}, {1, 2, 2}, second);

            check_size(checked(Operation::union_, a, same), 8, 24);
            check_size(checked(Operation::intersection, a, same), 8, 24);
            CHECK(checked(Operation::difference, a, same).is_empty());
            CHECK(checked(Operation::symmetric_difference, a, same).is_empty());
            CHECK(ExactRegion<3>(checked(Operation::union_, a, same)).plane_count() == 6);
            // Coincident pieces are kept from the first operand, which comes back as it went in.
            CHECK(checked(Operation::union_, a, same).face_count() == a.face_count());
            CHECK(checked(Operation::intersection, a, same).face_count() == a.face_count());

            check_size(checked(Operation::union_, a, t), 16, 40);
            CHECK(ExactRegion<3>(checked(Operation::union_, a, t)).plane_count() == 6);
            CHECK(checked(Operation::intersection, a, t).is_empty());
            check_size(checked(Operation::difference, a, t), 8, 24);
            CHECK(checked(Operation::difference, a, t).face_count() == a.face_count());
            check_size(checked(Operation::difference, t, a), 8, 24);
            check_size(checked(Operation::symmetric_difference, a, t), 16, 40);

            check_size(checked(Operation::union_, a, s), 8, 24);
            check_size(checked(Operation::intersection, a, s), 4, 16);
            check_size(checked(Operation::difference, a, s), 4, 16);
            CHECK(checked(Operation::difference, s, a).is_empty());
            check_size(checked(Operation::symmetric_difference, a, s), 4, 16);

            const Region<3> c = ~same;
            CHECK(checked(Operation::union_, a, c).is_full());
            CHECK(checked(Operation::intersection, a, c).is_empty());
            check_size(checked(Operation::difference, a, c), 8, 24);
            CHECK(checked(Operation::symmetric_difference, a, c).is_full());
        }
    }
}

TEST_CASE("coincidence table: empty and full are ordinary operands") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> none = Region<3>::empty();
    const Region<3> all = Region<3>::full();
    CHECK(equal_sets(a | none, a));
    CHECK((a & none).is_empty());
    CHECK(equal_sets(a - none, a));
    CHECK((none - a).is_empty());
    CHECK((a | all).is_full());
    CHECK(equal_sets(a & all, a));
    CHECK((a - all).is_empty());
    CHECK(equal_sets(all - a, Region<3>(~a)));
    CHECK(equal_sets(a ^ all, Region<3>(~a)));
    CHECK((none | none).is_empty());
    CHECK((all ^ all).is_empty());
    CHECK((none ^ all).is_full());
    CHECK((~none).is_full());
    CHECK((~all).is_empty());
}

TEST_CASE("cubes: disjoint, sharing a wall, an edge, a corner, a gap of 1e-7") {
    const Rational half = Rational(1) / 2;
    const Region<3> u = box<3>({-half, -half, -half}, {half, half, half});
    const auto moved = [&](const Rational& x, const Rational& y, const Rational& z) {
        return box<3>({Rational(x - half), Rational(y - half), Rational(z - half)},
                      {Rational(x + half), Rational(y + half), Rational(z + half)});
    };
    const Region<3> apart = checked(Operation::union_, u, moved(2, 0, 0));
    check_size(apart, 2, 12);
    CHECK(ExactRegion<3>(apart).centroid() == Coordinates<3>{1, 0, 0});
    const Region<3> wall = checked(Operation::union_, u, moved(1, 0, 0));
    check_size(wall, 2, 10);
    CHECK(ExactRegion<3>(wall).plane_count() == 6);
    CHECK(ExactRegion<3>(wall).locate({half, 0, 0}) == Where::inside);
    const Region<3> edge = checked(Operation::union_, u, moved(1, 1, 0));
    check_size(edge, 2, 12);
    CHECK(edge.face_count() == 12);
    check_size(checked(Operation::union_, u, moved(1, 1, 1)), 2, 12);
    for (const Region<3>& touching : {moved(1, 0, 0), moved(1, 1, 0), moved(1, 1, 1)}) {
        CHECK(checked(Operation::intersection, u, touching).is_empty());
        CHECK(equal_sets(checked(Operation::difference, u, touching), u));
    }
    const Rational gap = Rational(1) / 10000000;
    const Region<3> near = checked(Operation::union_, u, moved(Rational(1 + gap), 0, 0));
    check_size(near, 2, 12);
    CHECK(ExactRegion<3>(near).centroid() == Coordinates<3>{Rational(half + gap / 2), 0, 0});
    CHECK(ExactRegion<3>(near).locate({Rational(half + gap / 2), 0, 0}) == Where::outside);
}

TEST_CASE("cubes: a bar through a cube, beams that cross, a room in a block") {
    const Rational q = Rational(1) / 4;
    const Region<3> cube = box<3>({0, 0, 0}, {1, 1, 1});
    const Region<3> bar = box<3>({q, q, -1}, {Rational(3 * q), Rational(3 * q), 2});
    CHECK(ExactRegion<3>(checked(Operation::union_, cube, bar)).measure() == Rational(3) / 2);
    CHECK(ExactRegion<3>(checked(Operation::intersection, cube, bar)).measure() == q);
    const Region<3> pierced = checked(Operation::difference, cube, bar);
    check_size(pierced, Rational(3) / 4, Rational(15) / 2);
    CHECK(pierced.face_count() == 10);  // two of them with a hole
    CHECK(ExactRegion<3>(checked(Operation::difference, bar, cube)).measure() == Rational(1) / 2);

    // Three beams of half length 1 and half width 1/10 around (1, 2, 3).
    const Rational w = Rational(1) / 10;
    Region<3> cross = Region<3>::empty();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Coordinates<3> lo{Rational(1 - w), Rational(2 - w), Rational(3 - w)};
        Coordinates<3> hi{Rational(1 + w), Rational(2 + w), Rational(3 + w)};
        lo[axis] = int(axis);
        hi[axis] = int(axis) + 2;
        cross = checked(Operation::union_, cross, box<3>(lo, hi));
    }
    check_size(cross, Rational(224) / 1000, Rational(456) / 100);
    CHECK(ExactRegion<3>(cross).centroid() == Coordinates<3>{1, 2, 3});

    const Region<3> hollow = checked(Operation::difference, box<3>({0, 0, 0}, {4, 4, 4}), box<3>({1, 1, 1}, {2, 3, 2}));
    check_size(hollow, 62, 96 + 10);
    CHECK(hollow.face_count() == 12);
    CHECK(ExactRegion<3>(hollow).locate({Rational(3) / 2, 2, Rational(3) / 2}) == Where::outside);
}

TEST_CASE("cubes: positions of two unit cubes and of two blocks of eight") {
    struct Row {
        Coordinates<3> shift;
        Rational common;
    };
    const Rational h = Rational(1) / 2;
    const std::vector<Row> rows = {
        {{h, h, h}, Rational(1) / 8}, {{-1, h, 1}, 0}, {{h, h, 0}, Rational(1) / 4}, {{h, 0, 0}, h}, {{0, 0, 0}, 1},
        {{3 * h, 3 * h, 0}, 0}};
    for (const Row& row : rows) {
        const Region<3> a = box<3>({0, 0, 0}, {1, 1, 1});
        const Region<3> b =
            box<3>(row.shift, {Rational(row.shift[0] + 1), Rational(row.shift[1] + 1), Rational(row.shift[2] + 1)});
        CHECK(ExactRegion<3>(checked(Operation::intersection, a, b)).measure() == row.common);
        CHECK(ExactRegion<3>(checked(Operation::union_, a, b)).measure() == Rational(2 - row.common));
        CHECK(ExactRegion<3>(checked(Operation::symmetric_difference, a, b)).measure() == Rational(2 - 2 * row.common));
    }
    // Strictly inside: scaled by a half about (1/4, 1/4, 1/4).
    const Region<3> outer = box<3>({0, 0, 0}, {1, 1, 1});
    const Region<3> inner = box<3>({h / 4, h / 4, h / 4}, {Rational(5) / 8, Rational(5) / 8, Rational(5) / 8});
    CHECK(equal_sets(checked(Operation::union_, outer, inner), outer));
    CHECK(equal_sets(checked(Operation::intersection, outer, inner), inner));
    CHECK(checked(Operation::difference, inner, outer).is_empty());
    CHECK(ExactRegion<3>(checked(Operation::difference, outer, inner)).measure() == Rational(7) / 8);
}

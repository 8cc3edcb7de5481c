// SPDX-License-Identifier: Apache-2.0
// The localised engine on more than two operands: one arrangement of all of them.
#include <cleave/setop/surface_evaluation.hpp>
//
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/conforming.hpp>
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
#include <cstdint>
#include <vector>

using namespace cleave;
using support::Dice;
using support::verified;

namespace {

using Regions = std::vector<Region<3>>;

/// The value by the engine under test, which must not have given up.
Region<3> localised(const BooleanFunction& function, const Regions& operands, OperationCounts* counts = nullptr) {
    std::vector<const Boundary<3>*> boundaries;
    std::vector<Boundary<3>> conforming;
    conforming.reserve(operands.size());
    for (const Region<3>& r : operands) {
        const Boundary<3>* b = &r.surface();
        boundaries.push_back(b->is_conforming ? b : &conforming.emplace_back(make_conforming(r.boundary())));
    }
    REQUIRE(SurfaceEvaluation::is_for(boundaries));
    SurfaceEvaluation evaluation(boundaries, function, OperationOptions{nullptr, counts});
    REQUIRE(evaluation.is_sound());
    return Region<3>(evaluation.finish());
}

void check(const BooleanFunction& function, const Regions& operands, OperationCounts* counts = nullptr) {
    const Region<3> r = localised(function, operands, counts);
    CHECK(r.surface().is_conforming);
    CHECK(canonical(r) == canonical(evaluate<3, Rational>(Engine::boundary_filter, function, operands)));
    verified(r);
}

/// Every count and a few mixed functions.
void check_all(const Regions& operands) {
    const auto k = static_cast<unsigned>(operands.size());
    for (unsigned m = 1; m <= k; ++m) check(BooleanFunction::at_least(m, k), operands);
    check(BooleanFunction::symmetric_difference(k), operands);
    check(BooleanFunction::difference(k), operands);
    const auto a = BooleanFunction::operand(0, k);
    const auto z = BooleanFunction::operand(k - 1, k);
    check((a ^ z) | ~BooleanFunction::union_(k), operands);
}

Region<3> turned(const Region<3>& r, int axis = 0) {
    const auto turn = compose(rational_rotation<3, Integer>(axis, (axis + 1) % 3, 5, 2),
                              rational_rotation<3, Integer>((axis + 1) % 3, (axis + 2) % 3, 8, 3));
    return transform(turn, r);
}

Region<3> cube(int lo, int hi) {
    return box<3>({lo, lo, lo}, {hi, hi, hi});
}

}  // namespace

TEST_CASE("several operands: three planes through one point of a face") {
    // Walls of two boxes cross on the top of the third: a triple point inside a face, others on its edges.
    check_all({box<3>({0, 0, 0}, {6, 6, 2}), box<3>({1, 1, 1}, {3, 8, 3}), box<3>({2, -1, 1}, {4, 5, 4})});
    OperationCounts counts;
    check(BooleanFunction::union_(3), {cube(-2, 2), turned(cube(-2, 2)), turned(cube(-2, 2), 1)}, &counts);
    CHECK(counts.faces_crossed == 18);
    CHECK(counts.points_located == 0);
    check_all({turned(cube(-2, 2)), turned(cube(-3, 1), 1), turned(cube(-1, 3), 2), cube(0, 3)});
}

TEST_CASE("several operands: the same one several times, and complements") {
    const Region<3> a = cube(0, 2);
    const Region<3> b = turned(a);
    check_all({a, a, a});
    check_all({a, ~a, b});
    check_all({a, b, a, ~b});
    CHECK(localised(BooleanFunction::at_least(2, 3), {a, a, b}).face_count() == 6);
}

TEST_CASE("several operands: a common plane of three, overlapping, nested and side by side") {
    const Region<3> floor = box<3>({0, 0, -1}, {8, 8, 0});
    check_all({floor, box<3>({1, 1, 0}, {5, 5, 2}), box<3>({3, 3, 0}, {7, 7, 3})});
    check_all({floor, box<3>({1, 1, 0}, {7, 7, 2}), box<3>({2, 2, 0}, {3, 3, 3})});
    check_all({floor, box<3>({1, 1, -2}, {4, 4, 0}), box<3>({4, 1, -1}, {6, 4, 0}), box<3>({2, 2, 0}, {5, 3, 1})});
    // A segment of one runs through the middle of a coplanar face of another.
    check_all({floor, box<3>({1, 1, 0}, {7, 7, 1}), turned(box<3>({3, 3, -3}, {5, 5, 3}))});
}

TEST_CASE("several operands: a face in coplanar contact at its vertex only") {
    // Found by random search: a ridge of the second operand ends at a vertex of the first, one of its faces coplanar.
    const Region<3> a =
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{0, 3, 1}, {2, 0, 1}, {3, 4, 2}, {0, 4, 1}}});
    const Region<3> b =
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{0, 0, 1}, {0, 4, 1}, {1, 1, 1}, {3, 4, 3}}});
    const Region<3> c =
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{4, 4, 2}, {0, 4, 0}, {0, 1, 3}, {1, 4, 0}}});
    check_all({a, b, c});
    check_all({c, a, b});
}

TEST_CASE("several operands: a ridge on the operand's own face, which is coplanar with another's") {
    // Found by random search: a wedge stands on a plate by a ridge, along which a box on the plate has an edge.
    const auto wedge = [](const std::array<std::array<Rational, 3>, 4>& corners) {
        return box<3>({-1, -2, -1}, {4, 2, 0}) | simplex<3>(corners);
    };
    const Region<3> a = wedge({{{3, -2, 3}, {1, 1, 1}, {3, 0, 0}, {4, 0, 0}}});
    check_all({a, a, box<3>({3, -1, 0}, {4, 0, 3})});
    const Region<3> b =
        box<3>({1, -2, -1}, {4, 2, 0}) |
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{1, 0, 2}, {3, -2, 1}, {1, 0, 0}, {5, 0, 0}}});
    const Region<3> c =
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{3, 0, -1}, {3, -1, 0}, {3, 0, 0}, {4, 0, 0}}});
    check_all({a, b, c});
    check_all({a, c, b});
    check_all({c, a, b});
    check_all({a, c, box<3>({1, -2, -1}, {4, 2, 0})});
}

TEST_CASE(
    "several operands: an edge ends in the middle of a ridge on the operand's own face, coplanar with another's") {
    // Found by random search: the ridge tells that what leaves the edge's end is outside its wedge, not that it is
    // outside the plate that the wedge stands on, which has nothing there but its inside.
    const auto wedge = [](int from, int to) {
        return simplex<3>(std::array<std::array<Rational, 3>, 4>{{{from, 0, 0}, {to, 0, 0}, {3, 0, 3}, {1, 2, 2}}});
    };
    const Region<3> plate = box<3>({1, -2, -1}, {5, 2, 0});
    const Region<3> standing = plate | wedge(1, 4);
    const Region<3> block = box<3>({1, -1, 0}, {3, 0, 2});
    check_all({block, standing, plate});
    check_all({standing, block, plate});
    check_all({plate, block, ~standing});
    // The plates overlap, one is inside the other, and both have ridges.
    check_all({block, standing, box<3>({0, -2, -1}, {4, 2, 0})});
    check_all({block, standing, box<3>({2, -1, -1}, {5, 1, 0})});
    check_all({block, standing, plate | wedge(2, 5)});
    check_all({block, plate | wedge(0, 3), box<3>({1, -3, -2}, {4, 2, 0}), plate | wedge(2, 5)});
    // A wall of the block stands across the ridge instead, or its corner is inside the ridge.
    check_all({box<3>({2, -1, 0}, {3, 1, 2}), standing, plate});
    check_all({box<3>({2, 0, -1}, {3, 1, 2}), standing, plate});
    check_all({turned(block), turned(standing), turned(plate)});
}

TEST_CASE("several operands: shells of one operand that touch in ridges, cut nowhere") {
    // Ridges on the plate's top, along its edge and beyond, across its edge, and across another ridge; a cavity that
    // reaches the top from below; each as a mesh of separate shells, without a point where they touch.
    const auto wedge = [](std::array<Rational, 3> from, std::array<Rational, 3> to, int z) {
        const Rational x(from[0] + to[0]);
        const Rational y(from[1] + to[1]);
        return simplex<3>(
            std::array<std::array<Rational, 3>, 4>{{from,
                                                    to,
                                                    {Rational(x / 2 - y / 4 - 1), y, z},
                                                    {Rational(x / 2 + 1), Rational(y / 2 - 1), Rational(2 * z)}}});
    };
    const auto shells = [](const std::vector<Region<3>>& outer, const std::vector<Region<3>>& cavities) {
        Mesh all;
        const auto append = [&](const Region<3>& r, bool reverse) {
            const Mesh m = to_mesh(r);
            const auto base = static_cast<std::uint32_t>(all.points.size());
            all.points.insert(all.points.end(), m.points.begin(), m.points.end());
            for (std::size_t f = 0; f < m.face_count(); ++f) {
                std::vector<std::uint32_t> corners;
                for (const std::uint32_t c : m.face(f)) corners.push_back(base + c);
                if (reverse) std::reverse(corners.begin(), corners.end());
                all.add_face(corners);
            }
        };
        Region<3> set;
        for (const Region<3>& r : outer) {
            append(r, false);
            set = set | r;
        }
        for (const Region<3>& r : cavities) {
            append(r, true);
            set = set - r;
        }
        const Region<3> read = to_region(all);
        REQUIRE(read.surface().is_conforming);
        REQUIRE(canonical(read) == canonical(set));
        return read;
    };
    const Region<3> plate = box<3>({0, -2, -2}, {4, 2, 0});
    const Region<3> half = box<3>({0, 0, -2}, {3, 2, 0});
    const std::vector<Region<3>> solids = {
        shells({plate, wedge({1, 0, 0}, {3, 0, 0}, 2)}, {}),
        shells({half, wedge({1, 0, 0}, {4, 0, 0}, 2)}, {}),
        shells({half, wedge({2, -1, 0}, {2, 1, 0}, 2)}, {}),
        shells({wedge({1, 0, 0}, {3, 0, 0}, 2), wedge({2, -1, 0}, {2, 1, 0}, -2)}, {}),
        shells({plate}, {wedge({1, 0, 0}, {3, 0, 0}, -1)}),
        shells({plate, wedge({1, 0, 0}, {3, 0, 0}, 2)}, {wedge({2, -1, 0}, {2, 1, 0}, -1)}),
    };
    const std::vector<Region<3>> others = {
        plate,
        half,
        box<3>({1, -1, 0}, {2, 0, 2}),
        box<3>({0, 0, -1}, {2, 2, 1}),
        wedge({0, 0, 0}, {2, 0, 0}, 1),
        simplex<3>(std::array<std::array<Rational, 3>, 4>{{{2, 0, 0}, {3, 1, 2}, {3, -1, 2}, {4, 0, -1}}}),
    };
    for (const Region<3>& a : solids) {
        for (const Region<3>& b : solids) check_all({a, b});
        for (std::size_t n = 0; n < others.size(); ++n) {
            check_all({a, others[n]});
            check_all({a, others[n], others[(n + 1) % others.size()]});
            check_all({others[n], solids[n % solids.size()], a});
        }
    }
}

TEST_CASE("several operands: a vertex of a face on the face's own edge") {
    // Found by random search: the edge is cut there by a face that meets it in the vertex.
    const auto tetrahedron = [](const std::array<std::array<Rational, 3>, 4>& corners) { return simplex<3>(corners); };
    const Region<3> touching = box<3>({0, 3, 1}, {1, 5, 4}) |
                               tetrahedron({{{1, 2, 1}, {4, 3, 3}, {4, 1, 4}, {0, 5, 0}}}) |
                               tetrahedron({{{2, 5, 1}, {1, 2, 0}, {4, 5, 2}, {0, 4, 3}}});
    check_all({box<3>({1, 0, 1}, {2, 5, 5}), touching});
}

TEST_CASE("several operands: closed curves, nested shells and what touches nothing") {
    const Region<3> outer = sphere<Rational>({0, 0, 0}, 10, {16, 8});
    const Region<3> inner = turned(sphere<Rational>({0, 0, 0}, 4, {16, 8}));
    const Region<3> rod =
        transform(translation<Integer>(Rational(1, 3), Rational(1, 7), 0), box<3>({-1, -1, -12}, {1, 1, 12}));
    const Region<3> apart = sphere<Rational>({40, 0, 0}, 2, {16, 8});
    check_all({outer, inner, rod, apart});
    check_all({~outer, inner, ~rod, apart});
    // In closed curves inside one face: nothing on the face's edges tells where either rim is.
    const Region<3> block = cube(0, 10);
    const auto at = [](const Region<3>& r, int x, int y) { return transform(translation<Integer>(x, y, 10), r); };
    check_all({block, at(turned(cube(-1, 1)), 3, 3), at(turned(cube(-1, 1), 1), 7, 7)});
    // What touches neither of them is located in both.
    OperationCounts counts;
    check(BooleanFunction::difference(3), {cube(0, 10), sphere<Rational>({5, 5, 5}, 3, {8, 4}), cube(4, 6)}, &counts);
    CHECK(counts.faces_crossed == 0);
    CHECK(counts.points_located == 3);
    check_all({block, at(turned(cube(-1, 1)), 5, 5), at(turned(cube(-1, 1), 1), 5, 5)});
}

TEST_CASE("several operands: one, and as many as there may be") {
    const Region<3> a = turned(cube(0, 2));
    const Region<3> same = localised(BooleanFunction::union_(1), {a});
    CHECK(canonical(same) == canonical(a));
    const Region<3> other = localised(~BooleanFunction::union_(1), {a});
    CHECK(canonical(other) == canonical(~a));
    // A ring of 64 boxes, each overlapping the next one by half.
    Regions ring;
    for (int n = 0; n < 64; ++n) {
        const int side = n / 16;
        const int at = n % 16;
        const std::array<int, 2> corner = side == 0   ? std::array<int, 2>{at, 0}
                                          : side == 1 ? std::array<int, 2>{16, at}
                                          : side == 2 ? std::array<int, 2>{16 - at, 16}
                                                      : std::array<int, 2>{0, 16 - at};
        ring.push_back(box<3>({corner[0], corner[1], 0}, {corner[0] + 2, corner[1] + 2, 1 + n % 3}));
    }
    check(BooleanFunction::union_(64), ring);
    check(BooleanFunction::symmetric_difference(64), ring);
    check(BooleanFunction::at_least(3, 64), ring);
}

TEST_CASE("several operands: random boxes and tetrahedra on a small grid") {
    Dice dice(2026);
    const auto part = [&](int size) {
        if (dice.below(2) == 0) {
            std::array<Rational, 3> lo, hi;
            for (std::size_t x = 0; x < 3; ++x) {
                const int a = dice.below(size);
                lo[x] = a;
                hi[x] = a + dice.between(1, size - a);
            }
            return box<3>(lo, hi);
        }
        for (;;) {
            std::array<std::array<Rational, 3>, 4> corners;
            for (auto& p : corners)
                for (Rational& x : p) x = dice.between(0, size);
            const Region<3> r = simplex<3>(corners);
            if (!r.is_empty()) return r;
        }
    };
    for (int n = 0; n < 120; ++n) {
        Regions operands;
        const int k = dice.between(3, 6);
        for (int i = 0; i < k; ++i) {
            operands.push_back(part(dice.between(2, 4)));
            if (dice.below(6) == 0) operands.back() = ~operands.back();
            if (i > 0 && dice.below(6) == 0) operands.back() = operands.back() | operands[0];
            if (operands.back().face_count() == 0) operands.pop_back();
        }
        const auto arity = static_cast<unsigned>(operands.size());
        check(BooleanFunction::at_least(static_cast<unsigned>(dice.between(1, int(arity))), arity), operands);
        check(BooleanFunction::symmetric_difference(arity), operands);
    }
}

TEST_CASE("several operands: a union of spheres in one evaluation is the union one by one") {
    Dice dice(8);
    Regions balls;
    for (int n = 0; n < 12; ++n)
        balls.push_back(turned(sphere<Rational>({Rational(dice.between(-20, 20), 8), Rational(dice.between(-20, 20), 8),
                                                 Rational(dice.between(-20, 20), 8)},
                                                1, {8, 4}),
                               n % 3));
    Region<3> folded = balls.front();
    for (std::size_t n = 1; n < balls.size(); ++n) folded = folded | balls[n];
    const Region<3> all = localised(BooleanFunction::union_(12), balls);
    CHECK(canonical(all) == canonical(folded));
    verified(all);
}

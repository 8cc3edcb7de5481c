// SPDX-License-Identifier: Apache-2.0
/// Random solids and plane sets of the shapes that make operations difficult: they touch, share planes and lines, have
/// holes and cavities, and touch themselves.
#ifndef CLEAVE_TESTS_SOAK_SOLIDS_HPP
#define CLEAVE_TESTS_SOAK_SOLIDS_HPP

#include "soak/draw.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace soak {

// --- in the plane -----------------------------------------------------------------------------------------------

/// A polygon around a point of the grid: corners in all directions, at integers, so that it is star-shaped and cannot
/// cross itself.
[[nodiscard]] inline Region<2> star(Dice& dice) {
    static const std::vector<std::pair<int, int>> directions = {{1, 0},  {2, 1},  {1, 1},  {1, 2},   {0, 1},   {-1, 2},
                                                                {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2},
                                                                {0, -1}, {1, -2}, {1, -1}, {2, -1}};
    const int x = dice.between(2, 8);
    const int y = dice.between(2, 8);
    std::vector<Coordinates<2>> loop;
    for (std::size_t n = 0; n < directions.size(); ++n) {
        // The four axes stay, so that the point in the middle is inside.
        if (n % 4 != 0 && one_in(dice, 2)) continue;
        const int far = dice.between(1, 4);
        loop.push_back({Rational(x + far * directions[n].first), Rational(y + far * directions[n].second)});
    }
    return cleave::polygon<Rational>(loop);
}

/// A set with holes, some of which touch each other, the outside or the set's other pieces in points.
[[nodiscard]] inline Region<2> plane_set(Dice& dice) {
    Region<2> set;
    switch (dice.below(3)) {
        case 0:
            set = cleave::disc<Rational>(grid_point<2>(dice, 3, 6), dice.between(2, 5), 8);
            break;
        case 1:
            set = star(dice);
            break;
        default:
            set = grid_box<2>(dice, 0, 10);
    }
    for (int n = dice.below(3); n > 0; --n) set = set | grid_box<2>(dice, 0, 10);
    for (int n = dice.below(4); n > 0; --n) set = set - grid_box<2>(dice, 1, 9);
    if (one_in(dice, 2)) set = set ^ grid_hull<2>(dice, 4, 0, 10);
    return set;
}

/// The minus side of a line between points of the grid.
[[nodiscard]] inline Region<2> half_plane(Dice& dice) {
    const int a = dice.between(1, 3);
    const int b = dice.between(-3, 3);
    const int c = dice.between(-20, 20);
    return cleave::half_space(cleave::make_plane<Integer>(a, b, c));
}

// --- in space ---------------------------------------------------------------------------------------------------

[[nodiscard]] inline Region<3> small_sphere(Dice& dice) {
    static const std::vector<cleave::SphereOptions> fineness = {{4, 2}, {8, 4}, {12, 6}, {16, 8}};
    const Coordinates<3> centre = grid_point<3>(dice, -3, 3);
    const int radius = dice.between(1, 4);
    return cleave::sphere<Rational>(centre, radius, pick(dice, fineness));
}

/// A hull that shares vertices, or points of edges and faces, with `a`, and has others elsewhere.
[[nodiscard]] inline Region<3> touching_hull(Dice& dice, const Region<3>& a) {
    const std::vector<Coordinates<3>> corners = cleave::vertices(a);
    for (int attempt = 0; attempt < 50; ++attempt) {
        std::vector<Coordinates<3>> points;
        for (int n = dice.between(1, 4); n > 0; --n) {
            std::vector<Coordinates<3>> some;
            for (int k = dice.between(1, 3); k > 0; --k) some.push_back(pick(dice, corners));
            points.push_back(centroid_of<3>(some));
        }
        for (int n = dice.between(1, 4); n > 0; --n) points.push_back(grid_point<3>(dice, -6, 6));
        const Region<3> hull = cleave::convex_hull<3>(points);
        if (!hull.is_empty()) return hull;
    }
    return grid_box<3>(dice, 0, 5);
}

/// Something that touches `a` from outside, or shares vertices with it: a box at two of its vertices, a slab on its
/// highest point along an axis, a hull, or a copy of it that has been moved from one vertex to another.
[[nodiscard]] inline Region<3> touching(Dice& dice, const Region<3>& a) {
    const std::vector<Coordinates<3>> corners = cleave::vertices(a);
    switch (dice.below(4)) {
        case 0: {
            const Coordinates<3> p = pick(dice, corners);
            Coordinates<3> q = pick(dice, corners);
            for (std::size_t i = 0; i < 3; ++i)
                if (p[i] == q[i]) q[i] += one_in(dice, 2) ? -dice.between(1, 4) : dice.between(1, 4);
            return cleave::box<3>(p, q);
        }
        case 1: {
            const auto axis = std::size_t(dice.below(3));
            Coordinates<3> lo{-6, -6, -6};
            Coordinates<3> hi{6, 6, 6};
            lo[axis] = pick(dice, corners)[axis];
            if (one_in(dice, 2))
                for (const Coordinates<3>& p : corners) lo[axis] = std::max(lo[axis], p[axis]);
            hi[axis] = lo[axis] + dice.between(1, 5);
            return cleave::box<3>(lo, hi);
        }
        case 2:
            return touching_hull(dice, a);
        default: {
            const Coordinates<3> p = pick(dice, corners);
            const Coordinates<3> q = pick(dice, corners);
            return cleave::transform(shift_by<3>(support::subtract(q, p)), a);
        }
    }
}

/// A prism over a plane set: faces with holes, vertical edges where the set touches itself.
[[nodiscard]] inline Region<3> frame(Dice& dice) {
    Region<2> base = plane_set(dice);
    while (base.is_empty()) base = plane_set(dice);
    const int z = dice.between(-2, 3);
    Region<3> solid = cleave::prism(base, z, z + dice.between(1, 5));
    if (one_in(dice, 3)) solid = cleave::transform(cleave::rational_rotation<3, Integer>(0, 2, 1, 1), solid);
    if (one_in(dice, 4)) solid = cleave::transform(cleave::rational_rotation<3, Integer>(1, 2, 1, 1), solid);
    return solid;
}

/// Shells in the cavities of shells.
[[nodiscard]] inline Region<3> shells(Dice& dice) {
    Region<3> shape =
        one_in(dice, 2) ? cleave::box<3>({-6, -6, -6}, {6, 6, 6}) : cleave::sphere<Rational>({0, 0, 0}, 6, {8, 4});
    Region<3> solid = shape;
    const Rational half = support::rational(1, 2);
    const int depth = dice.between(1, 4);
    for (int k = 0; k < depth; ++k) {
        AffineMap<3, Integer> map = scale_by<3>({half, half, half});
        if (one_in(dice, 2)) map = cleave::compose(map, draw_rotation<3>(dice));
        shape = cleave::transform(map, shape);
        const Operation operation = k % 2 == 0 ? Operation::difference : Operation::union_;
        solid = cleave::apply(draw_engine(dice), operation, solid, shape);
    }
    return solid;
}

/// A block with slots: many faces on one plane, and faces in several pieces.
[[nodiscard]] inline Region<3> comb(Dice& dice) {
    std::vector<Region<3>> operands{cleave::box<3>({0, 0, 0}, {10, 10, 4})};
    const int slots = dice.between(1, 4);
    for (int k = 1; k <= slots; ++k) {
        Region<3> slot = cleave::box<3>({2 * k, -1, 1}, {2 * k + 1, 11, 5});
        if (one_in(dice, 2)) {
            const int from = dice.between(0, 7);
            const int floor = dice.between(1, 3);
            slot = cleave::box<3>({from, -1, floor}, {dice.between(8, 12), 11, 5});
        }
        if (one_in(dice, 3)) slot = cleave::transform(draw_rotation<3>(dice), slot);
        operands.push_back(slot);
    }
    const BooleanFunction difference = BooleanFunction::difference(unsigned(operands.size()));
    return cleave::evaluate<3, Rational>(draw_engine(dice), difference, operands);
}

/// Wedges with a ridge along the x axis, each from one integer to another: ridges overlap without being equal, and more
/// than two faces meet along them. Now and then they stand on a plate that has the axis inside its top.
[[nodiscard]] inline Region<3> wedges(Dice& dice) {
    Region<3> sum;
    const bool on_plate = one_in(dice, 3);
    if (on_plate) sum = cleave::box<3>({dice.between(-1, 2), -2, -1}, {dice.between(3, 6), 2, 0});
    for (int n = dice.between(1, 3); n > 0; --n) {
        const int from = dice.between(0, 4);
        const int to = dice.between(from + 1, 5);
        Region<3> wedge;
        if (!on_plate && one_in(dice, 3)) {
            const int y = one_in(dice, 2) ? -dice.between(1, 3) : dice.between(1, 3);
            const int z = one_in(dice, 2) ? -dice.between(1, 3) : dice.between(1, 3);
            wedge = cleave::box<3>({from, 0, 0}, {to, y, z});
        } else {
            std::vector<Coordinates<3>> points = grid_points<3>(dice, dice.between(2, 3), -3, 3);
            if (on_plate)
                for (Coordinates<3>& p : points) p[2] = abs(p[2]) + 1;
            points.push_back({from, 0, 0});
            points.push_back({to, 0, 0});
            wedge = cleave::convex_hull<3>(points);
        }
        const Operation operation = one_in(dice, 3) ? Operation::symmetric_difference : Operation::union_;
        sum = cleave::apply(draw_engine(dice), operation, sum, wedge);
    }
    return sum.is_empty() ? wedges(dice) : sum;
}

/// Boxes, wedges and cavities that may have points, edges and faces in the plane z = 2, as shells of one mesh: cut
/// nowhere, also where one touches another.
[[nodiscard]] inline Region<3> bundle(Dice& dice) {
    cleave::Mesh all;
    Region<3> set;
    for (int n = dice.between(2, 6); n > 0; --n) {
        Region<3> part;
        const int side = dice.below(4);  // 0: beneath the plane
        if (n > 1 && set.is_empty()) {
            part = cleave::box<3>({dice.between(0, 2), dice.between(0, 2), 0},
                                  {dice.between(3, 5), dice.between(3, 5), 2});
        } else {
            std::vector<Coordinates<3>> points = grid_points<3>(dice, dice.between(2, 4), 0, 5);
            const int level = dice.below(2);
            for (std::size_t k = 0; k < points.size(); ++k) {
                Rational& z = points[k][2];
                if (k < std::size_t(level))
                    z = 2;
                else
                    z = side == 0 ? dice.between(0, 1) : dice.between(3, 5);
            }
            points.push_back({dice.between(0, 5), dice.between(0, 5), 2});
            part = cleave::convex_hull<3>(points);
        }
        if (part.is_empty()) continue;
        const bool is_cavity = !cleave::apply(Operation::intersection, set, part).is_empty();
        if (is_cavity && !cleave::apply(Operation::difference, part, set).is_empty()) continue;
        const cleave::Mesh shell = cleave::to_mesh(part);
        cleave::Mesh more = all;
        const auto base = static_cast<std::uint32_t>(more.points.size());
        more.points.insert(more.points.end(), shell.points.begin(), shell.points.end());
        for (std::size_t f = 0; f < shell.face_count(); ++f) {
            std::vector<std::uint32_t> corners;
            for (const std::uint32_t c : shell.face(f)) corners.push_back(base + c);
            if (is_cavity) std::reverse(corners.begin(), corners.end());
            more.add_face(corners);
        }
        if (!cleave::find_self_intersections(more).empty()) continue;  // faces of the two are a wall without thickness
        all = more;
        set = cleave::apply(is_cavity ? Operation::difference : Operation::union_, set, part);
    }
    return set.is_empty() ? bundle(dice) : cleave::to_region(all);
}

/// A set that touches itself: along edges and in vertices where parts overlap, from inside where a cavity reaches the
/// surface, or in a corner that two copies have in common.
[[nodiscard]] inline Region<3> self_touching(Dice& dice) {
    const Region<3> a = grid_parts<3>(dice, 2);
    switch (dice.below(3)) {
        case 0:
            return grid_parts<3>(dice, 4, Operation::symmetric_difference);
        case 1:
            return cleave::apply(draw_engine(dice), Operation::difference, a, touching_hull(dice, a));
        default: {
            const Region<3> b = touching(dice, a);
            return cleave::apply(draw_engine(dice), Operation::symmetric_difference, a, b);
        }
    }
}

/// Any of the above; never empty.
[[nodiscard]] inline Region<3> anything(Dice& dice) {
    Region<3> solid;
    switch (dice.below(9)) {
        case 0:
            solid = grid_parts<3>(dice);
            break;
        case 1:
            solid = small_sphere(dice);
            break;
        case 2:
            solid = grid_hull<3>(dice, dice.between(4, 12), -4, 6);
            break;
        case 3:
            solid = frame(dice);
            break;
        case 4:
            solid = shells(dice);
            break;
        case 5:
            solid = comb(dice);
            break;
        case 6:
            solid = wedges(dice);
            break;
        case 7:
            solid = self_touching(dice);
            break;
        default: {
            solid = grid_parts<3>(dice);
            solid = cleave::transform(draw_maps<3>(dice, dice.between(1, 2)), solid);
        }
    }
    return solid.is_empty() ? anything(dice) : solid;
}

}  // namespace soak

#endif

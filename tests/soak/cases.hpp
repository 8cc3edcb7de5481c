// SPDX-License-Identifier: Apache-2.0
/// The kinds of cases: each draws operands in a way of its own and has them checked.
#ifndef CLEAVE_TESTS_SOAK_CASES_HPP
#define CLEAVE_TESTS_SOAK_CASES_HPP

#include "soak/checks.hpp"
#include "soak/solids.hpp"

#include <array>

namespace soak {

/// Planes, edges and vertices in common: everything is at small integers.
inline void grid_case(Dice& dice, Checker& checker) {
    const Region<3> a = grid_parts<3>(dice);
    const Region<3> b = grid_parts<3>(dice);
    checker.four_operations(a, b);
}

/// One operand on the grid, the other rotated, moved, scaled, sheared or mirrored.
inline void moved_case(Dice& dice, Checker& checker) {
    const Region<3> a = grid_parts<3>(dice);
    const Region<3> b = grid_parts<3>(dice);
    checker.four_operations(a, cleave::transform(draw_maps<3>(dice, dice.between(1, 3)), b));
}

/// A solid and the same a little beside itself.
inline void nearly_case(Dice& dice, Checker& checker) {
    const Region<3> a = one_in(dice, 2) ? grid_parts<3>(dice) : anything(dice);
    AffineMap<3, Integer> map = tiny_shift<3>(dice);
    if (one_in(dice, 3)) map = cleave::compose(cleave::rational_rotation<3, Integer>(0, 1, 1000000007, 1), map);
    checker.four_operations(a, cleave::transform(map, a));
}

/// Solids that are put against each other.
inline void touching_case(Dice& dice, Checker& checker) {
    const Region<3> a = one_in(dice, 2) ? small_sphere(dice) : grid_hull<3>(dice, dice.between(4, 14), -3, 3);
    const Region<3> b = touching(dice, a);
    checker.four_operations(a, b);
    if (one_in(dice, 2)) return;
    const Region<3> c = touching_hull(dice, b);
    checker.evaluate<3>(BooleanFunction::at_least(2, 3), {a, b, c});
    checker.evaluate<3>(BooleanFunction::symmetric_difference(3), {a, c, b});
}

/// Ridges on one line that overlap, and fans of faces along them.
inline void ridges_case(Dice& dice, Checker& checker) {
    const Region<3> a = wedges(dice);
    const Region<3> b = wedges(dice);
    checker.four_operations(a, b);
    if (one_in(dice, 3)) checker.many<3>({a, b, wedges(dice)});
}

/// The same set twice, whole or in pieces, as it is or as a mesh of triangles.
inline void identical_case(Dice& dice, Checker& checker) {
    const Region<3> a = anything(dice);
    Region<3> b = a;
    if (one_in(dice, 2)) {
        b = cleave::to_region<Rational>(cleave::to_rational_mesh(a));
    } else if (one_in(dice, 2)) {
        const Region<3> tool = grid_part<3>(dice);
        b = checker.evaluate<3>(BooleanFunction::union_(2), {a, tool});
        checker.four_operations(tool, b);
    }
    checker.four_operations(a, b);
    checker.four_operations(a, ~b);
    checker.evaluate<3>(BooleanFunction::at_least(2, 3), {a, grid_part<3>(dice), b});
}

/// Solids in cavities, plates with holes and slots.
inline void nested_case(Dice& dice, Checker& checker) {
    const auto draw = [&] {
        switch (dice.below(3)) {
            case 0:
                return shells(dice);
            case 1:
                return comb(dice);
            default:
                return frame(dice);
        }
    };
    const Region<3> a = draw();
    Region<3> b = draw();
    if (one_in(dice, 2)) b = cleave::transform(draw_maps<3>(dice, dice.between(1, 2)), b);
    checker.four_operations(a, b);
    if (!one_in(dice, 3)) return;
    const std::vector<Region<3>> three{a, b, anything(dice)};
    checker.evaluate<3>(draw_function(dice, 3), three);
    checker.evaluate<3>(BooleanFunction::at_least(2, 3), three);
}

/// Operands that touch themselves, and what touches them there.
inline void self_touching_case(Dice& dice, Checker& checker) {
    Region<3> a = self_touching(dice);
    if (a.is_empty()) a = grid_part<3>(dice);
    Region<3> b = one_in(dice, 2) ? self_touching(dice) : touching(dice, a);
    if (one_in(dice, 4)) b = cleave::transform(draw_map<3>(dice), b);
    checker.four_operations(a, b);
    if (one_in(dice, 3)) checker.many<3>({a, b, grid_part<3>(dice)});
}

/// Shells of one operand that touch each other uncut.
inline void bundles_case(Dice& dice, Checker& checker) {
    const Region<3> a = bundle(dice);
    Region<3> b = bundle(dice);
    if (one_in(dice, 4)) b = touching(dice, a);
    checker.four_operations(a, b);
    if (one_in(dice, 2)) checker.many<3>({a, b, one_in(dice, 2) ? bundle(dice) : grid_part<3>(dice)});
}

/// Each result is an operand of the next operation.
inline void chain_case(Dice& dice, Checker& checker) {
    Region<3> sum = anything(dice);
    const bool turning = one_in(dice, 2);
    for (int n = dice.between(4, 12); n > 0; --n) {
        Region<3> tool = grid_part<3>(dice);
        if (one_in(dice, 2)) tool = cleave::transform(draw_map<3>(dice), tool);
        if (one_in(dice, 8)) tool = frame(dice);
        if (turning && one_in(dice, 4)) sum = cleave::transform(draw_rotation<3>(dice), sum);
        Operation operation = one_in(dice, 3) ? Operation::difference : draw_operation(dice);
        if (operation == Operation::intersection && !one_in(dice, 3)) operation = Operation::union_;
        const BooleanFunction function = BooleanFunction::from(operation, 2);
        if (one_in(dice, 6)) checker.four_operations(sum, tool);
        sum = one_in(dice, 2) ? checker.evaluate<3>(function, {sum, tool}) : checker.evaluate<3>(function, {tool, sum});
        if (sum.face_count() == 0) sum = anything(dice);
        if (sum.surface().faces.corners.size() > 1000) return;
    }
}

/// Three to eight operands at once, some of them equal and some complements.
inline void many_case(Dice& dice, Checker& checker) {
    const int most = one_in(dice, 4) ? 8 : 5;
    std::vector<Region<3>> operands;
    const bool bounded = one_in(dice, 2);
    for (int n = dice.between(3, most); n > 0; --n) {
        Region<3> r = one_in(dice, 3) ? grid_parts<3>(dice, 3) : grid_part<3>(dice);
        if (one_in(dice, 2)) r = cleave::transform(draw_maps<3>(dice, dice.between(1, 2)), r);
        if (!operands.empty() && one_in(dice, 8)) r = pick(dice, operands);
        operands.push_back(!bounded && one_in(dice, 5) ? ~r : r);
    }
    checker.many<3>(operands);
}

/// Complements of all sorts of solids.
inline void complement_case(Dice& dice, Checker& checker) {
    Region<3> a = anything(dice);
    if (one_in(dice, 2)) a = ~a;
    const Region<3> b = ~anything(dice);
    checker.four_operations(a, b);
    Region<3> c = grid_part<3>(dice);
    if (one_in(dice, 5)) c = ~c;
    checker.evaluate<3>(draw_function(dice, 3), {a, b, c});
}

/// Coordinates near the ends of the range of doubles, along some of the axes.
inline void scale_case(Dice& dice, Checker& checker) {
    const Rational size = power_of_two(one_in(dice, 2) ? dice.between(900, 1018) : -dice.between(900, 1070));
    Coordinates<3> scales;
    for (Rational& s : scales) s = one_in(dice, 4) ? Rational(1) : size;
    const AffineMap<3, Integer> map = scale_by<3>(scales);
    const Region<3> a = grid_parts<3>(dice, 2);
    Region<3> b = grid_part<3>(dice);
    if (one_in(dice, 2)) b = cleave::transform(draw_map<3>(dice), b);
    checker.four_operations(cleave::transform(map, a), cleave::transform(map, b));
}

/// Sets in the plane, a few of them unbounded: two, moved or not; a chain; several at once.
inline void plane_case(Dice& dice, Checker& checker) {
    const auto draw = [&] {
        Region<2> r = one_in(dice, 2) ? plane_set(dice) : grid_parts<2>(dice, 5, Operation::symmetric_difference);
        if (one_in(dice, 10)) r = r ^ half_plane(dice);
        if (one_in(dice, 3)) r = cleave::transform(draw_maps<2>(dice, dice.between(1, 2)), r);
        return one_in(dice, 8) ? ~r : r;
    };
    Region<2> a = draw();
    const Region<2> b = draw();
    checker.four_operations(a, b);
    if (one_in(dice, 2)) {
        checker.many<2>({a, b, draw(), draw()});
        return;
    }
    for (int n = dice.between(1, 6); n > 0; --n) {
        const BooleanFunction function = BooleanFunction::from(draw_operation(dice), 2);
        a = checker.evaluate<2>(function, {a, draw()});
    }
}

struct Kind {
    const char* name;
    const char* about;
    void (*run)(Dice&, Checker&);
};

inline constexpr std::array<Kind, 14> all_kinds = {{
    {"grid", "boxes and simplices at small integers", grid_case},
    {"moved", "the same, one operand rotated, scaled, sheared, mirrored", moved_case},
    {"nearly", "a solid and itself, moved by next to nothing", nearly_case},
    {"touching", "vertices, edges and faces put against each other", touching_case},
    {"ridges", "ridges on one line that overlap", ridges_case},
    {"identical", "the same set twice, in whole or in part", identical_case},
    {"nested", "cavities, holes and slots", nested_case},
    {"self", "operands that touch themselves", self_touching_case},
    {"bundles", "shells of one operand that touch each other", bundles_case},
    {"chain", "each result is the next operand", chain_case},
    {"many", "functions of three to eight operands", many_case},
    {"outside", "complements", complement_case},
    {"scale", "coordinates near the ends of the range of doubles", scale_case},
    {"plane", "sets of dimension two", plane_case},
}};

}  // namespace soak

#endif

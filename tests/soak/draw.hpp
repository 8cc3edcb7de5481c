// SPDX-License-Identifier: Apache-2.0
/// What every random case draws: places on small grids, maps, functions of operands. Draws follow one another in the
/// order in which they are written, so that a case is the same on every machine.
#ifndef CLEAVE_TESTS_SOAK_DRAW_HPP
#define CLEAVE_TESTS_SOAK_DRAW_HPP

#include "support/dice.hpp"
#include "support/exact_region.hpp"

#include <cleave/extern.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soak {

using cleave::AffineMap;
using cleave::BooleanFunction;
using cleave::Integer;
using cleave::Operation;
using cleave::Rational;
using cleave::Region;
using support::Coordinates;
using support::Dice;

[[nodiscard]] inline bool one_in(Dice& dice, int n) {
    return dice.below(n) == 0;
}

template <class T>
[[nodiscard]] const T& pick(Dice& dice, const std::vector<T>& list) {
    return list[std::size_t(dice.below(int(list.size())))];
}

/// A point with integer coordinates in [lo, hi].
template <int D>
[[nodiscard]] Coordinates<D> grid_point(Dice& dice, int lo, int hi) {
    Coordinates<D> p;
    for (Rational& x : p) x = dice.between(lo, hi);
    return p;
}

template <int D>
[[nodiscard]] std::vector<Coordinates<D>> grid_points(Dice& dice, int count, int lo, int hi) {
    std::vector<Coordinates<D>> points;
    for (int i = 0; i < count; ++i) points.push_back(grid_point<D>(dice, lo, hi));
    return points;
}

/// A fraction with numerator in [lo, hi] and a denominator up to `most`.
[[nodiscard]] inline Rational fraction(Dice& dice, int lo, int hi, int most) {
    const int numerator = dice.between(lo, hi);
    return support::rational(numerator, dice.between(1, most));
}

template <int D>
[[nodiscard]] Coordinates<D> centroid_of(const std::vector<Coordinates<D>>& points) {
    Coordinates<D> sum;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        for (const Coordinates<D>& p : points) sum[i] += p[i];
        sum[i] /= int(points.size());
    }
    return sum;
}

// --- regions ----------------------------------------------------------------------------------------------------

/// A box with corners at integers of [lo, hi]; never empty.
template <int D>
[[nodiscard]] Region<D> grid_box(Dice& dice, int lo, int hi) {
    Coordinates<D> a;
    Coordinates<D> b;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        const int from = dice.between(lo, hi);
        const int to = dice.between(lo, hi - 1);
        a[i] = from;
        b[i] = to < from ? to : to + 1;
    }
    return cleave::box<D>(a, b);
}

/// The convex hull of `count` points at integers of [lo, hi]; never empty.
template <int D>
[[nodiscard]] Region<D> grid_hull(Dice& dice, int count, int lo, int hi) {
    for (;;) {
        const Region<D> hull = cleave::convex_hull<D>(grid_points<D>(dice, count, lo, hi));
        if (!hull.is_empty()) return hull;
    }
}

template <int D>
[[nodiscard]] Region<D> grid_part(Dice& dice, int lo = 0, int hi = 5) {
    if (one_in(dice, 2)) return grid_box<D>(dice, lo, hi);
    return grid_hull<D>(dice, D + 1, lo, hi);
}

[[nodiscard]] inline Operation draw_operation(Dice& dice) {
    return cleave::all_operations[std::size_t(dice.below(4))];
}

/// One of two engines, so that what one of them makes becomes the other's operand.
[[nodiscard]] inline cleave::Engine draw_engine(Dice& dice) {
    return one_in(dice, 2) ? cleave::Engine::localised : cleave::Engine::boundary_filter;
}

/// Up to `most` parts, joined by an operation.
template <int D>
[[nodiscard]] Region<D> grid_parts(Dice& dice, int most = 4, Operation operation = Operation::union_) {
    Region<D> sum = grid_part<D>(dice);
    for (int more = dice.below(most); more > 0; --more) {
        const cleave::Engine engine = draw_engine(dice);
        sum = cleave::apply(engine, operation, sum, grid_part<D>(dice));
    }
    return sum;
}

// --- maps -------------------------------------------------------------------------------------------------------

/// x -> x + t with t = `shift` along some of the axes.
template <int D>
[[nodiscard]] AffineMap<D, Integer> shift_by(const Coordinates<D>& t) {
    if constexpr (D == 2)
        return cleave::translation<Integer>(t[0], t[1]);
    else
        return cleave::translation<Integer>(t[0], t[1], t[2]);
}

template <int D>
[[nodiscard]] AffineMap<D, Integer> scale_by(const Coordinates<D>& s) {
    if constexpr (D == 2)
        return cleave::scaling<Integer>(s[0], s[1]);
    else
        return cleave::scaling<Integer>(s[0], s[1], s[2]);
}

[[nodiscard]] inline Rational power_of_two(int exponent) {
    return cleave::number_traits<Rational>::from_double(std::ldexp(1.0, exponent));
}

/// A shift so small that a floating-point computation would not notice it.
template <int D>
[[nodiscard]] AffineMap<D, Integer> tiny_shift(Dice& dice) {
    const Rational step = power_of_two(one_in(dice, 4) ? -dice.between(1000, 1073) : -dice.between(30, 60));
    Coordinates<D> t;
    for (Rational& x : t) x = step * dice.between(-1, 1);
    return shift_by<D>(t);
}

/// A rotation: by any angle, by nearly none or by a right angle.
template <int D>
[[nodiscard]] AffineMap<D, Integer> draw_rotation(Dice& dice) {
    const int i = dice.below(D);
    const int j = (i + dice.between(1, D - 1)) % D;
    const int kind = dice.below(4);
    if (kind == 0) return cleave::rational_rotation<D, Integer>(i, j, 1000000007, 1);
    if (kind == 1) return cleave::rational_rotation<D, Integer>(i, j, 1, 1);
    const int p = dice.between(1, 7);
    return cleave::rational_rotation<D, Integer>(i, j, p, dice.between(1, 7));
}

/// A rotation, shift, reflection, shear or change of scale.
template <int D>
[[nodiscard]] AffineMap<D, Integer> draw_map(Dice& dice) {
    Coordinates<D> x;
    switch (dice.below(8)) {
        case 0:
            for (Rational& c : x) c = one_in(dice, 2) ? -1 : 1;
            return scale_by<D>(x);
        case 1:
            for (Rational& c : x) c = fraction(dice, -5, 5, 4);
            return shift_by<D>(x);
        case 2:
            for (Rational& c : x) c = fraction(dice, 1, 5, 5);
            return scale_by<D>(x);
        case 3: {
            cleave::Matrix<D + 1, D + 1, Integer> m = cleave::identity_matrix<D + 1, Integer>();
            const int i = dice.below(D);
            const int j = (i + dice.between(1, D - 1)) % D;
            m(i, j) = Integer(dice.between(-2, 2));
            return AffineMap<D, Integer>(m);
        }
        case 4:
            return tiny_shift<D>(dice);
        default:
            return draw_rotation<D>(dice);
    }
}

template <int D>
[[nodiscard]] AffineMap<D, Integer> draw_maps(Dice& dice, int count) {
    AffineMap<D, Integer> map;
    for (; count > 0; --count) map = cleave::compose(map, draw_map<D>(dice));
    return map;
}

// --- functions --------------------------------------------------------------------------------------------------

/// Any function of k operands.
[[nodiscard]] inline BooleanFunction draw_function(Dice& dice, unsigned k, int depth = 3) {
    if (depth == 0 || one_in(dice, 4)) {
        switch (dice.below(5)) {
            case 0:
                return BooleanFunction::at_least(unsigned(dice.between(0, int(k) + 1)), k);
            case 1:
                return BooleanFunction::symmetric_difference(k);
            case 2:
                return BooleanFunction::difference(k);
            default:
                return BooleanFunction::operand(unsigned(dice.below(int(k))), k);
        }
    }
    const BooleanFunction a = draw_function(dice, k, depth - 1);
    if (one_in(dice, 5)) return ~a;
    const BooleanFunction b = draw_function(dice, k, depth - 1);
    switch (dice.below(4)) {
        case 0:
            return a | b;
        case 1:
            return a & b;
        case 2:
            return a ^ b;
        default:
            return a - b;
    }
}

}  // namespace soak

#endif

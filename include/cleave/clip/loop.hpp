// SPDX-License-Identifier: Apache-2.0
/// Splitting a convex loop by a plane: one walk, five cases, no vertex ever dropped.
///
/// A loop is a cycle of corners; corner i is a point p_i and the plane e_i of the edge from p_i to p_{i+1}, oriented
/// with the facet on its minus side. With s_i the sign of p_i against the cutting plane h, the minus part receives
///
/// | s_i | s_{i+1} | minus part                     | plus part                        |
/// |-----|---------|--------------------------------|----------------------------------|
/// |  -  |  -, 0   | (p_i, e_i)                     |                                  |
/// |  -  |  +      | (p_i, e_i), (x, h)             | (x, e_i)                         |
/// |  0  |  -      | (p_i, e_i)                     | (p_i, ~h)                        |
/// |  0  |  +      | (p_i, h)                       | (p_i, e_i)                       |
/// |  +  |  +, 0   |                                | (p_i, e_i)                       |
/// |  +  |  -      | (x, e_i)                       | (p_i, e_i), (x, ~h)              |
///
/// where x is the crossing point and ~h is h flipped. Two zeros in a row cannot occur in a convex loop that h crosses.
#ifndef CLEAVE_CLIP_LOOP_HPP
#define CLEAVE_CLIP_LOOP_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/sign.hpp>

#include <cstddef>
#include <span>

CLEAVE_BEGIN_NAMESPACE

/// Requires: `signs[i]` is the side of `loop[i]`'s point, both signs occur, and the loop is convex.
/// `Corner` is `{point, edge}`; `cross(i, j)` makes the point where the edge from corner i to corner j = i+1 meets h.
/// `minus` and `plus` are called with each corner of their part, in loop order.
template <class Corner, class Plane, class Cross, class Minus, class Plus>
void split_loop(std::span<const Corner> loop, std::span<const Sign> signs, const Plane& h, const Plane& h_flipped,
                Cross&& cross, Minus&& minus, Plus&& plus) {
    CLEAVE_REQUIRES(loop.size() == signs.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t j = i + 1 == loop.size() ? 0 : i + 1;
        const Corner& c = loop[i];
        switch (signs[i]) {
            case Sign::minus:
                minus(c);
                if (signs[j] == Sign::plus) {
                    const auto x = cross(i, j);
                    minus(Corner{x, h});
                    plus(Corner{x, c.edge});
                }
                break;
            case Sign::zero:
                CLEAVE_ASSERT(signs[j] != Sign::zero);
                minus(signs[j] == Sign::plus ? Corner{c.point, h} : c);
                plus(signs[j] == Sign::minus ? Corner{c.point, h_flipped} : c);
                break;
            case Sign::plus:
                plus(c);
                if (signs[j] == Sign::minus) {
                    const auto x = cross(i, j);
                    plus(Corner{x, h_flipped});
                    minus(Corner{x, c.edge});
                }
                break;
        }
    }
}

CLEAVE_END_NAMESPACE

#endif

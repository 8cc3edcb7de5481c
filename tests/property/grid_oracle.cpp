// SPDX-License-Identifier: Apache-2.0
// Operations on sets of grid cells against the same operations on words: every cell, the cells around, the measure.
#include <cleave/setop/operators.hpp>

#include "support/grid_oracle.hpp"
#include "support/region_generators.hpp"

#include <cstdint>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Random cells, each in the set with probability one half.
template <int D, int S>
Cells<D, S> draw_cells() {
    const std::vector<bool> drawn = draw_bools(Cells<D, S>::count);
    Cells<D, S> c;
    for (std::size_t i = 0; i < drawn.size(); ++i) c.bits[i] = drawn[i];
    return c;
}

GridStyle draw_style() {
    const std::vector<bool> drawn = draw_bools(4);
    return {drawn[0] ? Rational(1) / 3 : Rational(1), drawn[1], drawn[2], drawn[3]};
}

template <int D, int S>
typename Cells<D, S>::Bits expected(Operation operation, const Cells<D, S>& a, const Cells<D, S>& b) {
    typename Cells<D, S>::Bits out;
    for (std::size_t i = 0; i < Cells<D, S>::count; ++i) out[i] = apply(operation, bool(a.bits[i]), bool(b.bits[i]));
    return out;
}

template <int D, int S>
void check_pair(GridStyle first_style, GridStyle second_style, const Cells<D, S>& a, const Cells<D, S>& b) {
    second_style.unit = first_style.unit;
    const Region<D> ra = verified(a.region(first_style));
    const Region<D> rb = verified(b.region(second_style));
    a.verify(ra, first_style);
    for (const Operation operation : all_operations) {
        const Cells<D, S> truth{expected(operation, a, b)};
        const Region<D> result = checked(operation, ra, rb);
        truth.verify(result, first_style);
        RC_ASSERT(result.is_empty() == truth.bits.none());
        // With a complement as operand the result of an operation is that of another, or its complement.
        const Cells<D, S> without{expected(Operation::difference, b, a)};
        if (operation == Operation::intersection) without.verify(checked(operation, Region<D>(~ra), rb), first_style);
        if (operation == Operation::difference)
            truth.verify(checked(Operation::union_, Region<D>(~ra), rb), first_style, true);
    }
}

template <int D, int S>
void check_random_pair() {
    const GridStyle first_style = draw_style();
    const GridStyle second_style = draw_style();
    const auto a = draw_cells<D, S>();
    check_pair<D, S>(first_style, second_style, a, draw_cells<D, S>());
}

}  // namespace

TEST_CASE("grid oracle: intervals") {
    law("all operations on cells of the line", 200, [] { check_random_pair<1, 9>(); });
}

TEST_CASE("grid oracle: rectilinear polygons that touch themselves in vertices") {
    law("all operations on cells of the plane", 40, [] { check_random_pair<2, 5>(); });
}

TEST_CASE("grid oracle: rectilinear polyhedra that touch themselves in vertices and edges") {
    law("all operations on cells of space", 10, [] { check_random_pair<3, 3>(); });
}

TEST_CASE("grid oracle: results are operands") {
    law("a chain of operations in the plane", 10, [] {
        Cells<2, 5> truth = draw_cells<2, 5>();
        Region<2> region = truth.region();
        for (int step = 0; step < 20; ++step) {
            const Cells<2, 5> tool = draw_cells<2, 5>();
            const Operation operation = all_operations[draw_index(all_operations.size())];
            truth.bits = expected(operation, truth, tool);
            region = checked(operation, region, tool.region());
            truth.verify(region, {});
        }
    });
    law("a chain of operations in space", 3, [] {
        Cells<3, 3> truth = draw_cells<3, 3>();
        Region<3> region = truth.region();
        for (int step = 0; step < 10; ++step) {
            const Cells<3, 3> tool = draw_cells<3, 3>();
            const Operation operation = all_operations[draw_index(all_operations.size())];
            truth.bits = expected(operation, truth, tool);
            region = checked(operation, region, tool.region());
            truth.verify(region, {});
        }
    });
}

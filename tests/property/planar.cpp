// SPDX-License-Identifier: Apache-2.0
// The localised engine in the plane beside boundary filtering and tree merging, on sets with corners at small integers:
// common lines, vertices and edges, sets that touch themselves. Canonical forms, every check, and membership of points.
#include <cleave/region/canonical.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/shape/box.hpp>

#include "support/region_generators.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Counts how often the engine decided alone.
struct Total {
    std::size_t evaluations = 0;
    std::size_t crossed = 0;
    std::size_t located = 0;
};

/// The value of the function by the localised engine, which must not give up, and which the other two agree with.
Region<2> by_all(const BooleanFunction& function, const std::vector<Region<2>>& operands, Total& total) {
    std::vector<const Boundary<2>*> boundaries;
    for (const Region<2>& r : operands) boundaries.push_back(&r.boundary());
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    PlanarEvaluation evaluation(boundaries, function, options);
    RC_ASSERT(evaluation.is_sound());
    Region<2> result(evaluation.finish());
    const std::string form = canonical(result);
    RC_ASSERT(form == canonical(evaluate<2, Rational>(Engine::boundary_filter, function, operands)));
    RC_ASSERT(form == canonical(evaluate<2, Rational>(Engine::tree_merge, function, operands)));
    RC_ASSERT(form == canonical(evaluate<2, Rational>(Engine::localised, function, operands)));
    const RegionChecker<2> checker(result);
    checker.verify();
    checker.verify_names(boundaries);
    ++total.evaluations;
    total.crossed += counts.faces_crossed;
    total.located += counts.points_located;
    return result;
}

/// Some functions of k operands: the four operations, counts, and one that treats no two of them alike.
std::vector<BooleanFunction> functions(unsigned k) {
    std::vector<BooleanFunction> list;
    for (const Operation operation : all_operations) list.push_back(BooleanFunction::from(operation, k));
    list.push_back(BooleanFunction::at_least(2, k));
    BooleanFunction odd = ~BooleanFunction::operand(k - 1, k);
    for (unsigned i = 0; i + 1 < k; ++i)
        odd = i % 2 == 0 ? odd | BooleanFunction::operand(i, k) : odd - BooleanFunction::operand(i, k);
    list.push_back(odd);
    return list;
}

/// Whether the result contains the middles of the unit cells of the grid, and points between, as the operands say.
void check_members(const BooleanFunction& function, const std::vector<Solid<2>>& solids, const Region<2>& result) {
    const ExactRegion<2> exact(result);
    for (int x = -1; x < 6; ++x)
        for (int y = -1; y < 6; ++y)
            for (const int part : {2, 5}) {
                const Coordinates<2> p{Rational(x) + Rational(1) / part, Rational(y) + Rational(2) / 7};
                BooleanFunction::Bits bits = 0;
                bool is_on_boundary = false;
                for (std::size_t i = 0; i < solids.size(); ++i) {
                    const Where where = solids[i].locate(p);
                    is_on_boundary = is_on_boundary || where == Where::boundary;
                    if (where == Where::inside) bits |= BooleanFunction::Bits(1) << i;
                }
                if (!is_on_boundary) RC_ASSERT(exact.locate(p) == (function(bits) ? Where::inside : Where::outside));
            }
}

}  // namespace

TEST_CASE("planar: random sets with common lines, edges and vertices") {
    Total total;
    for (const unsigned k : {2U, 3U, 4U})
        law(std::to_string(k) + " operands", 60, [&] {
            const std::vector<Solid<2>> solids = draw_vector<Solid<2>>(k);
            std::vector<Region<2>> operands;
            for (const Solid<2>& s : solids) operands.push_back(s.region());
            for (const BooleanFunction& f : functions(k)) check_members(f, solids, by_all(f, operands, total));
        });
    CHECK(total.crossed > total.evaluations);
    // Random sets are hardly ever nested, where nothing but a ray tells.
    Total nested;
    by_all(BooleanFunction::difference(2), {box<2>({0, 0}, {9, 9}), box<2>({3, 3}, {4, 4})}, nested);
    CHECK(nested.located == 1);
    CHECK(nested.crossed == 0);
}

TEST_CASE("planar: sets that cross at points that are no doubles") {
    Total total;
    const AffineMap<2, Integer> turn = rational_rotation<2, Integer>(0, 1, 5, 2);
    const AffineMap<2, Integer> again = compose(turn, turn);
    law("three operands", 60, [&](const Solid<2>& x, const Solid<2>& y, const Solid<2>& z) {
        const std::vector<Region<2>> operands{x.region(), transform(turn, y.region()), transform(again, z.region())};
        for (const BooleanFunction& f : functions(3)) by_all(f, operands, total);
    });
    law("an operand, its images, and the operand again", 30, [&](const Solid<2>& x) {
        const Region<2> a = x.region();
        for (const BooleanFunction& f : functions(4)) by_all(f, {a, transform(turn, a), ~a, a}, total);
    });
    CHECK(total.crossed > total.evaluations);
}

TEST_CASE("planar: results are operands again") {
    Total total;
    const AffineMap<2, Integer> turn = rational_rotation<2, Integer>(0, 1, 7, 3);
    law("a chain of operations", 10, [&](const Solid<2>& start) {
        Region<2> region = start.region();
        for (int step = 0; step < 8; ++step) {
            const Region<2> part = draw<Part<2>>().region();
            const Region<2> tool = draw_bool() ? part : transform(turn, part);
            const Operation operation = all_operations[draw_index(all_operations.size())];
            region = by_all(BooleanFunction::from(operation, 2), {region, tool}, total);
        }
    });
}

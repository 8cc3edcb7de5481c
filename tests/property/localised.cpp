// SPDX-License-Identifier: Apache-2.0
// The localised engine beside boundary filtering: the same set, by canonical form, whether operands cross properly,
// share planes, edges and vertices, or do not meet; and results that stand every check.
#include <cleave/region/canonical.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/expression.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/convex_sets.hpp"
#include "support/region_generators.hpp"

#include <array>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The value of the function by both engines, which must agree; the localised one must not have given up, and its
/// result stands every check.
void both(const BooleanFunction& function, const std::vector<Region<3>>& operands, OperationCounts* counts) {
    const std::string filtered = canonical(evaluate<3, Rational>(Engine::boundary_filter, function, operands));
    OperationOptions options;
    options.counts = counts;
    const Region<3> localised = evaluate<3, Rational>(Engine::localised, function, operands, options);
    RC_ASSERT(filtered == canonical(localised));
    verified(localised);
    if (!localised.is_empty() && !localised.is_full()) RC_ASSERT(localised.surface().is_conforming);
}

/// A map without any symmetry: nothing stays in the planes that it was in, and no point where it was.
AffineMap<3, Integer> tilt() {
    const AffineMap<3, Integer> turn =
        compose(rational_rotation<3, Integer>(0, 1, 5, 2), rational_rotation<3, Integer>(1, 2, 7, 3));
    return compose(translation<Integer>(Rational(1, 3), Rational(1, 5), Rational(1, 7)), turn);
}

}  // namespace

TEST_CASE("localised: random solids with common planes, edges and vertices") {
    law("four operations", 100, [&](const Solid<3>& x, const Solid<3>& y) {
        const Region<3> a = x.region();
        const Region<3> b = y.region();
        for (const Operation operation : all_operations) both(BooleanFunction::from(operation, 2), {a, b}, nullptr);
    });
}

TEST_CASE("localised: random solids that cross properly") {
    std::size_t crossed = 0;
    const AffineMap<3, Integer> map = tilt();
    law("four operations", 60, [&](const Solid<3>& x, const Solid<3>& y) {
        const Region<3> a = x.region();
        const Region<3> b = transform(map, y.region());
        for (const Operation operation : all_operations) {
            OperationCounts counts;
            both(BooleanFunction::from(operation, 2), {a, b}, &counts);
            crossed += counts.faces_crossed;
        }
    });
    CHECK(crossed > 0);
}

TEST_CASE("localised: any function of several operands") {
    const AffineMap<3, Integer> once = tilt();
    const AffineMap<3, Integer> twice = compose(once, once);
    law("three operands", 30, [&](const Part<3>& x, const Solid<3>& y, const Part<3>& z) {
        const std::vector<Region<3>> operands{x.region(), transform(once, y.region()), transform(twice, z.region())};
        const BooleanFunction a = BooleanFunction::operand(0, 3);
        const BooleanFunction b = BooleanFunction::operand(1, 3);
        const BooleanFunction c = BooleanFunction::operand(2, 3);
        for (const BooleanFunction& f : {BooleanFunction::at_least(2, 3), BooleanFunction::symmetric_difference(3),
                                         a - (b | c), (a & b) | ~c, BooleanFunction::union_(3)})
            both(f, operands, nullptr);
    });
    law("one operand several times", 20, [&](const Part<3>& x) {
        const Region<3> a = x.region();
        both(BooleanFunction::at_least(2, 3), {a, a, transform(once, a)}, nullptr);
        both(BooleanFunction::symmetric_difference(3), {a, transform(once, a), a}, nullptr);
    });
}

TEST_CASE("localised: results are operands again") {
    Dice dice(1);
    const AffineMap<3, Integer> map = tilt();
    Region<3> part = sphere<Rational>({0, 0, 0}, 4, {16, 8});
    const Region<3> drill = box<3>({-1, -1, -6}, {1, 1, 6});
    for (unsigned n = 0; n < scaled(12); ++n) {
        AffineMap<3, Integer> turn = map;
        for (int k = dice.below(6); k > 0; --k)
            turn = compose(turn, rational_rotation<3, Integer>(k % 3, (k + 1) % 3, 4, 1));
        const Region<3> tool = transform(
            compose(translation<Integer>(dice.between(-3, 3), dice.between(-3, 3), dice.between(-3, 3)), turn), drill);
        const Operation operation = n % 3 == 2 ? Operation::union_ : Operation::difference;
        const Region<3> filtered = apply(Engine::boundary_filter, operation, part, tool);
        part = apply(Engine::localised, operation, part, tool);
        REQUIRE(canonical(filtered) == canonical(part));
    }
    verified(part);
}

TEST_CASE("localised: what no operand touches is told by what surrounds it") {
    const AffineMap<3, Integer> map = tilt();
    const Region<3> outer = sphere<Rational>({0, 0, 0}, 10, {16, 8});
    const Region<3> middle = transform(map, sphere<Rational>({0, 0, 0}, 6, {16, 8}));
    const Region<3> inner = sphere<Rational>({0, 0, 0}, 2, {16, 8});
    const Region<3> apart = sphere<Rational>({40, 0, 0}, 2, {16, 8});
    OperationCounts counts;
    const std::vector<Region<3>> nested{outer, middle, inner, apart};
    for (const Operation operation : all_operations) both(BooleanFunction::from(operation, 4), nested, &counts);
    CHECK(counts.faces_crossed == 0);
    // The two inner shells against what is around them; bounds tell the rest.
    CHECK(counts.points_located == 3);
    // Complements: far away is inside.
    both(BooleanFunction::intersection(3), {~inner, middle, ~apart}, nullptr);
    both(BooleanFunction::union_(2), {~outer, middle}, nullptr);
}

TEST_CASE("localised: a chain of 200 cuts is the one evaluation of all of them, on the operands' planes alone") {
    Dice dice(200);
    const AffineMap<3, Integer> map = tilt();
    const Region<3> block = box<3>({-6, -6, -6}, {6, 6, 6});
    const Region<3> bit = box<3>({-1, -1, -1}, {1, 1, 1});
    const Region<3> tilted = transform(map, bit);
    Region<3> part = block;
    Expression<3> all(block);
    PlaneTable<3> planes;
    const auto note = [&](const Region<3>& r) {
        const Boundary<3>& b = r.boundary();
        for (std::uint32_t k = 0; k < b.planes.size(); ++k) planes.intern_from(b.planes, k);
    };
    note(block);
    for (unsigned n = 0; n < scaled(200); ++n) {
        const AffineMap<3, Integer> at =
            translation<Integer>(dice.between(-6, 6), dice.between(-6, 6), dice.between(-6, 6));
        const Region<3> tool = transform(at, n % 2 == 0 ? tilted : bit);
        note(tool);
        part = apply(Engine::localised, Operation::difference, part, tool);
        all = all - Expression<3>(tool);
    }
    const Region<3> once = evaluate(Engine::localised, all);
    REQUIRE(canonical(once) == canonical(part));
    // No plane that no operand has, so none with more bits.
    const std::size_t given = planes.size();
    note(part);
    CHECK(planes.size() == given);
    verified(part);
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/conforming.hpp>
//
#include <cleave/region/canonical.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/surface_evaluation.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

/// Whether every edge has an opposite with the same ends, and no two points are at one place.
bool conforms(const Boundary<3>& b) {
    std::vector<std::pair<PointId, PointId>> edges, opposites;
    for (std::size_t l = 0; l + 1 < b.faces.loop_first.size(); ++l) {
        const auto loop = b.faces.loop(l);
        for (std::size_t n = 0; n < loop.size(); ++n) {
            const PointId p = loop[n].point;
            const PointId q = loop[n + 1 == loop.size() ? 0 : n + 1].point;
            edges.push_back({p, q});
            opposites.push_back({q, p});
        }
    }
    std::sort(edges.begin(), edges.end());
    std::sort(opposites.begin(), opposites.end());
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(b, kernel);
    for (PointId p = 0; p < b.points.size(); ++p)
        for (PointId q = 0; q < p; ++q)
            if (kernel.same(loaded.first_point + p, loaded.first_point + q)) return false;
    return edges == opposites;
}

}  // namespace

TEST_CASE("conforming: the corners of a step become corners of the edge that they lie on") {
    // Boundary filtering leaves the long edge of the block whole where the step's wall ends on it.
    const Region<3> step =
        apply(Engine::boundary_filter, Operation::union_, box<3>({0, 0, 0}, {4, 4, 4}), box<3>({1, 1, 4}, {4, 2, 5}));
    REQUIRE_FALSE(conforms(step.boundary()));
    const Boundary<3> made = make_conforming(step.boundary());
    CHECK(made.is_conforming);
    CHECK(conforms(made));
    CHECK(made.faces.faces.size() == step.boundary().faces.faces.size());
    CHECK(canonical(Region<3>(made)) == canonical(step));
    support::verified(Region<3>(made));
    // Twice is once.
    CHECK(make_conforming(made).faces.corners.size() == made.faces.corners.size());
}

TEST_CASE("conforming: what boundary filtering gives becomes an operand of the localised engine") {
    Dice dice(3);
    for (int n = 0; n < 40; ++n) {
        const auto part = [&] {
            std::array<Rational, 3> lo, hi;
            for (std::size_t x = 0; x < 3; ++x) {
                const int a = dice.below(4);
                lo[x] = a;
                hi[x] = a + dice.between(1, 3);
            }
            return box<3>(lo, hi);
        };
        const Region<3> a = apply(Engine::boundary_filter, Operation::symmetric_difference, part(), part());
        const Region<3> b = apply(Engine::boundary_filter, Operation::difference, part(), part());
        const Boundary<3> x = make_conforming(a.boundary());
        const Boundary<3> y = make_conforming(b.boundary());
        CHECK(conforms(x));
        const std::array<const Boundary<3>*, 2> operands{&x, &y};
        const OperationOptions options;
        SurfaceEvaluation evaluation(operands, BooleanFunction::union_(2), options);
        REQUIRE(evaluation.is_sound());
        const Region<3> r(evaluation.finish());
        CHECK(canonical(r) == canonical(apply(Engine::boundary_filter, Operation::union_, a, b)));
        CHECK(canonical(a | b) == canonical(r));
    }
}

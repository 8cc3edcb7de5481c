// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/conform.hpp>

#include "support/catch.hpp"

#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

using namespace cleave;

namespace {

struct Conformed {
    std::size_t inserted;
    std::size_t balanced;  // pieces of edges with as many faces in either direction
    std::size_t others;
};

Conformed conform(const Region<3>& region) {
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(region.boundary(), kernel);
    Conformer conformer(kernel, region.boundary(), loaded);
    std::map<std::pair<PointId, PointId>, int> uses;
    const FaceList& faces = region.boundary().faces;
    for (std::size_t l = 0; l + 1 < faces.loop_first.size(); ++l) {
        const std::span<const PointId> loop = conformer.loop(l);
        std::size_t i = 0;
        std::uint32_t corner = faces.loop_first[l];
        conformer.for_each_edge(l, [&](PointId from, PointId to, std::uint32_t c) {
            // The two ways to read a loop agree, and edges come from consecutive corners.
            CHECK(loop[i] == from);
            i = i + 1 == loop.size() ? 0 : i + 1;
            CHECK(loop[i] == to);
            CHECK((c == corner || c == corner + 1));
            corner = c;
            ++uses[{std::min(from, to), std::max(from, to)}];
            uses[{std::min(from, to), std::max(from, to)}] += from < to ? 1000 : -1000;
        });
    }
    Conformed result{conformer.inserted(), 0, 0};
    for (const auto& [ends, count] : uses) ++(count == 2 ? result.balanced : result.others);
    return result;
}

/// By boundary filtering, whose results need not conform.
Region<3> filtered(Operation operation, const Region<3>& a, const Region<3>& b) {
    return apply(Engine::boundary_filter, operation, a, b);
}

}  // namespace

TEST_CASE("conform: what conforms already stays as it is", "[conform]") {
    const Conformed c = conform(box<3>({0, 0, 0}, {1, 2, 3}));
    CHECK(c.inserted == 0);
    CHECK(c.balanced == 12);
    CHECK(c.others == 0);
    CHECK(conform(Region<3>::empty()).inserted == 0);
}

TEST_CASE("conform: a corner on a neighbour's edge is inserted there", "[conform]") {
    // A step: corners of the small box lie in the middle of the large one's edges.
    const Conformed c =
        conform(filtered(Operation::union_, box<3>({0, 0, 0}, {4, 4, 4}), box<3>({0, 0, 4}, {2, 4, 6})));
    CHECK(c.inserted == 2);  // on the large box's front and back: faces of two operands are not joined
    CHECK(c.others == 0);
    const Conformed d =
        conform(filtered(Operation::union_, box<3>({0, 0, 0}, {4, 4, 4}), box<3>({-1, 0, 1}, {0, 4, 2})));
    CHECK(d.others == 0);
    const Conformed e =
        conform(filtered(Operation::union_, box<3>({0, 0, 0}, {4, 4, 4}), box<3>({-1, 1, 1}, {1, 3, 4})));
    CHECK(e.others == 0);
}

TEST_CASE("conform: a face that touches the middle of its own edge is pinched there", "[conform]") {
    // The hole is a diamond whose corner lies on the plate's edge.
    const Region<3> plate = box<3>({0, 0, 0}, {4, 4, 1});
    const Region<3> hole = prism<Rational>({{4, 2}, {3, 3}, {2, 2}, {3, 1}}, -1, 2);
    const Region<3> pinched = filtered(Operation::difference, plate, hole);
    const Conformed c = conform(pinched);
    CHECK(c.inserted >= 4);  // top and bottom, and the side face twice
    // The edge along which the hole touches the side has four faces or two, and everything is balanced.
    const RationalMesh mesh = to_rational_mesh(pinched);
    const MeshReport report = validate(mesh);
    CHECK(report.is_closed());
    CHECK(report.t_junctions.empty());
}

TEST_CASE("conform: many touches, found by boxes", "[conform]") {
    Region<3> plate = box<3>({0, 0, 0}, {40, 4, 1});
    for (int i = 0; i < 20; ++i)
        plate = filtered(
            Operation::difference, plate,
            prism<Rational>({{2 * i + 1, 0}, {Rational(4 * i + 3, 2), 1}, {2 * i + 1, 2}, {Rational(4 * i + 1, 2), 1}},
                            -1, 2));
    const MeshReport report = validate(to_rational_mesh(plate));
    CHECK(report.is_closed());
    CHECK(report.t_junctions.empty());
}

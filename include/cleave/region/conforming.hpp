// SPDX-License-Identifier: Apache-2.0
/// A boundary whose edges match from end to end, made of one where they need not.
#ifndef CLEAVE_REGION_CONFORMING_HPP
#define CLEAVE_REGION_CONFORMING_HPP

#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/conform.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The same faces with every vertex that lies on an edge made a corner there, and points at one place made one.
/// Requires: complete and finite. Throws: Error where edges of a face cross. Cost: O(n log n).
[[nodiscard]] inline Boundary<3> make_conforming(const Boundary<3>& boundary) {
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    PointInterner<3> points(kernel);
    Conformer conformer(kernel, boundary, loaded);
    FaceList list;
    std::vector<Corner> loop;
    for (const FaceList::Face& face : boundary.faces.faces) {
        list.begin_face(loaded.plane(face.plane), face.source);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            loop.clear();
            conformer.for_each_edge(l, [&](PointId from, PointId, std::uint32_t corner) {
                loop.push_back({loaded.first_point + from, loaded.plane(boundary.faces.corners[corner].edge)});
            });
            list.add_loop(loop);
        }
    }
    Boundary<3> out = freeze(kernel, list, boundary.value_at_infinity, [&](PointId p) { return points(p); });
    out.is_conforming = true;
    return out;
}

CLEAVE_END_NAMESPACE

#endif

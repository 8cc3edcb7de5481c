// SPDX-License-Identifier: Apache-2.0
/// `resolve`: the solid that a mesh describes by a winding rule, even where it runs through itself.
#ifndef CLEAVE_MESH_RESOLVE_HPP
#define CLEAVE_MESH_RESOLVE_HPP

#include <cleave/base/winding_rule.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/region/resolve.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Options of `resolve`.
struct ResolveOptions {
    Strictness strictness = Strictness::tolerant;
    const MeshOrigin* origin = nullptr;    ///< for messages that name file and line
    MeshReport* report = nullptr;          ///< receives what validation found, errors or not
    ProgressReporter* progress = nullptr;  ///< told about stages; may cancel, which throws Cancelled
    ExecutorRef executor{};                ///< where independent work runs; the result is the same for every executor
};

/// The set of points whose winding number with respect to a mesh the rule takes for inside: how often the mesh runs
/// around them, 1 inside one solid that faces outward. The mesh has to be closed, but may cross, overlap and repeat
/// itself, be nested in any way and turned inside out. Coordinates are taken exactly as they are, sources count faces.
/// Faces without area are left out and non-planar ones split into triangles, unless strict; so are flat ones whose
/// outline crosses itself.
/// Throws: MeshError for a mesh that is not closed, with all defects; Cancelled.
/// Cost: O(n log n) and what crosses, see the `resolve` of boundaries; one exact plane per face.
template <class N = Rational, class T>
[[nodiscard]] Region<3, N> resolve(const PolygonMesh<T>& mesh, WindingRule rule, const ResolveOptions& options = {}) {
    MeshReport report = validate(mesh, options.executor);
    if (options.report != nullptr) *options.report = report;
    // The triangles of a fan run around a crossing outline's parts as often as the outline does.
    std::vector<std::uint32_t> split;
    std::merge(report.non_planar_faces.begin(), report.non_planar_faces.end(), report.crossing_outlines.begin(),
               report.crossing_outlines.end(), std::back_inserter(split));
    report.crossing_outlines.clear();
    if (!report.is_valid(options.strictness))
        throw make_mesh_error(std::move(report), mesh, options.strictness, options.origin);
    report.non_planar_faces = std::move(split);
    Boundary<3> surface = detail::MeshConverter<T>(mesh).convert(report);
    surface.is_conforming = report.t_junctions.empty() && report.zero_area_faces.empty() &&
                            report.too_few_corners.empty() && detail::has_simple_faces(surface);
    return Region<3, N>(resolve<3>(surface, rule, options.progress));
}

CLEAVE_END_NAMESPACE

#endif

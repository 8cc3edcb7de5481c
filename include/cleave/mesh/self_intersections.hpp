// SPDX-License-Identifier: Apache-2.0
/// `find_self_intersections`: which faces of a mesh cross or overlap each other. All decisions are exact.
#ifndef CLEAVE_MESH_SELF_INTERSECTIONS_HPP
#define CLEAVE_MESH_SELF_INTERSECTIONS_HPP

#include <cleave/execution/progress.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/region/facet_meeting.hpp>
#include <cleave/region/make.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// How two faces meet that have more in common than the corners and edges that both name.
///
/// `crossing`: the faces lie on different planes, and some point is inside both (on no edge of either).
/// `overlap`: they lie on one plane, and some point is inside both.
/// `touch`: no point is inside both, but a corner or edge of one lies on the other: inside it, or on an edge, or edges
/// cross. A solid may touch itself, so this is no defect; but where surfaces pass through each other exactly along
/// edges of both, touches are all there is.
enum class SelfContactKind : std::uint8_t { touch, crossing, overlap };

/// Two faces of a mesh, by their indices, and how they meet; `first == second` for a face that is not flat, or whose
/// outline crosses itself, and whose triangles meet.
struct SelfContact {
    std::uint32_t first;
    std::uint32_t second;
    SelfContactKind kind;

    friend bool operator==(const SelfContact&, const SelfContact&) = default;
};

/// Options of `find_self_intersections`.
struct SelfIntersectionOptions {
    bool touches = false;                  ///< whether to report touches as well
    ProgressReporter* progress = nullptr;  ///< told about the work; may cancel, which throws Cancelled
};

/// A mesh whose faces cross or overlap each other was refused. `what()` names the first few pairs and what to do;
/// `contacts()` has them all.
class SelfIntersectionError : public Error {
public:
    SelfIntersectionError(const std::string& message, std::vector<SelfContact> contacts)
        : Error(message), contacts_(std::make_shared<const std::vector<SelfContact>>(std::move(contacts))) {}

    [[nodiscard]] const std::vector<SelfContact>& contacts() const noexcept { return *contacts_; }

private:
    std::shared_ptr<const std::vector<SelfContact>> contacts_;  // shared, so that copying cannot throw
};

namespace detail {

/// The triangles of a mesh's faces, compared in pairs.
template <class T>
class SelfIntersections {
public:
    explicit SelfIntersections(const PolygonMesh<T>& mesh) : mesh_(&mesh), facets_(kernel_), meetings_(facets_) {
        const std::vector<std::uint32_t> first_equal = first_equal_points<T>(mesh.points);
        ids_.assign(mesh.points.size(), no_id);
        kernel_.reserve_points(mesh.points.size());
        for (std::size_t i = 0; i < ids_.size(); ++i)
            ids_[i] = first_equal[i] == i ? add_point<T, 3>(kernel_, mesh.points[i]) : ids_[first_equal[i]];
        facets_.reserve(mesh.face_count(), mesh.corners.size());
        add_faces();
    }

    std::vector<SelfContact> find(const SelfIntersectionOptions& options) {
        ProgressReporter silent;
        ProgressReporter& progress = options.progress != nullptr ? *options.progress : silent;
        std::vector<NamedBox<3>> boxes(facets_.size());
        for (std::uint32_t f = 0; f < boxes.size(); ++f) boxes[f] = {facets_.bounds(f), f};
        // Most boxes meet those of a dozen neighbours, each pair once.
        progress.begin("comparing faces", 6 * boxes.size());
        std::vector<SelfContact> found;
        for_each_meeting_pair<3>(boxes, [&](std::uint32_t a, std::uint32_t b) {
            progress.advance();
            const auto [first, second] = std::minmax(facets_[a].face, facets_[b].face);
            if (first == second && is_flat_[first]) return;  // parts of one flat face have edges in common
            const std::optional<MeetingKind> decided = meetings_.decide(a, b);
            const MeetingKind kind = decided ? *decided : meetings_.meet(a, b).kind;
            if (kind <= MeetingKind::shared || (kind == MeetingKind::touch && (!options.touches || first == second)))
                return;
            found.push_back({first, second,
                             kind == MeetingKind::touch      ? SelfContactKind::touch
                             : kind == MeetingKind::crossing ? SelfContactKind::crossing
                                                             : SelfContactKind::overlap});
        });
        progress.finish();
        // Of the ways in which the parts of two faces meet, the strongest.
        std::sort(found.begin(), found.end(), [](const SelfContact& x, const SelfContact& y) {
            return std::array<std::uint32_t, 3>{x.first, x.second, 3U - static_cast<std::uint32_t>(x.kind)} <
                   std::array<std::uint32_t, 3>{y.first, y.second, 3U - static_cast<std::uint32_t>(y.kind)};
        });
        found.erase(std::unique(found.begin(), found.end(),
                                [](const SelfContact& x, const SelfContact& y) {
                                    return x.first == y.first && x.second == y.second;
                                }),
                    found.end());
        return found;
    }

private:
    void add_faces() {
        FaceShapes<T> shapes(mesh_->points);
        std::vector<IndexTriangle> triangles;
        is_flat_.assign(mesh_->face_count(), true);
        for (std::uint32_t f = 0; f < mesh_->face_count(); ++f) {
            triangles.clear();
            const FaceShape shape = shapes.shape(mesh_->face(f), &triangles);
            if (shape == FaceShape::too_few_corners || shape == FaceShape::zero_area) continue;
            if (shape != FaceShape::flat) {
                is_flat_[f] = false;
                fan(mesh_->face(f), triangles);
            }
            if (triangles.size() > 1) collect_outline(f);
            for (const IndexTriangle& t : triangles)
                if (shape == FaceShape::flat || shapes.shape(t) == FaceShape::flat)
                    add_triangle(f, t, triangles.size());
        }
    }

    /// The edges of face f in both directions, sorted.
    void collect_outline(std::uint32_t f) {
        outline_.clear();
        const auto face = mesh_->face(f);
        for (std::size_t i = 0; i < face.size(); ++i)
            outline_.push_back({ids_[face[i]], ids_[face[i + 1 == face.size() ? 0 : i + 1]]});
        std::sort(outline_.begin(), outline_.end());
    }

    void add_triangle(std::uint32_t f, const IndexTriangle& t, std::size_t count) {
        std::array<Corner, 3> loop;
        for (std::size_t i = 0; i < 3; ++i) loop[i] = {ids_[t[i]], no_id};
        std::array<bool, 3> inner{};
        if (count > 1)
            for (std::size_t i = 0; i < 3; ++i)
                inner[i] = !std::binary_search(outline_.begin(), outline_.end(),
                                               std::pair(loop[i].point, loop[(i + 1) % 3].point));
        facets_.add(f, no_id, loop, inner);
    }

    const PolygonMesh<T>* mesh_;
    Kernel<3> kernel_;
    ConvexFacets facets_;
    FacetMeetings meetings_;
    std::vector<PointId> ids_;   // of the mesh's points, one for equal ones
    std::vector<bool> is_flat_;  // per face
    std::vector<std::pair<PointId, PointId>> outline_;
};

}  // namespace detail

/// Pairs of faces of a mesh that cross or overlap each other, ascending; on request also those that touch. Points at
/// equal coordinates are one point, so corners and edges count as common wherever they coincide from end to end. The
/// mesh may be open, and its faces neither flat nor convex: what is not flat stands for the triangles that `to_region`
/// makes of it, and faces without area meet nothing.
/// Throws: MeshError where a point is not finite or a corner refers to no point.
/// Cost: O(n log n + pairs of faces whose boxes meet), some 3 microseconds a triangle of doubles in a mesh that does
/// not cross itself.
template <class T>
[[nodiscard]] std::vector<SelfContact> find_self_intersections(const PolygonMesh<T>& mesh,
                                                               const SelfIntersectionOptions& options = {}) {
    MeshReport report;
    report.point_count = mesh.point_count();
    report.face_count = mesh.face_count();
    detail::check_points(mesh, report);
    detail::check_indices(mesh, report);
    if (!report.points_not_finite.empty() || !report.indices_out_of_range.empty())
        throw make_mesh_error(std::move(report), mesh, Strictness::tolerant);
    return detail::SelfIntersections<T>(mesh).find(options);
}

/// The pairs in words, a line each, the first few and how many more; `origin` adds lines of the file.
template <class T>
[[nodiscard]] std::string explain(std::span<const SelfContact> contacts, const PolygonMesh<T>& mesh,
                                  const MeshOrigin* origin = nullptr) {
    constexpr std::size_t examples = 3;
    const MeshReport unused;
    const detail::Explainer<T> explainer(mesh, unused, origin);
    std::string text;
    for (std::size_t i = 0; i < contacts.size() && i < examples; ++i) {
        const SelfContact& c = contacts[i];
        const char* how = c.kind == SelfContactKind::crossing  ? " crosses "
                          : c.kind == SelfContactKind::overlap ? " overlaps "
                                                               : " touches ";
        text += "\n    " + explainer.face(c.first) + how +
                (c.first == c.second ? std::string("itself") : explainer.face(c.second));
    }
    if (contacts.size() > examples) text += "\n    and " + std::to_string(contacts.size() - examples) + " more";
    return text;
}

/// Does nothing for a mesh without faces that cross or overlap each other.
/// Throws: SelfIntersectionError with all pairs for any other; `origin` lets its message name the file and lines.
template <class T>
void require_no_self_intersections(const PolygonMesh<T>& mesh, const MeshOrigin* origin = nullptr,
                                   ProgressReporter* progress = nullptr) {
    std::vector<SelfContact> contacts = find_self_intersections(mesh, {false, progress});
    if (contacts.empty()) return;
    const std::string file = origin == nullptr || origin->file.empty() ? std::string() : origin->file + ": ";
    const std::string message = file + "the mesh intersects itself\n  " + std::to_string(contacts.size()) +
                                (contacts.size() == 1 ? " pair" : " pairs") +
                                " of faces cross or overlap:" + explain<T>(contacts, mesh, origin) +
                                "\n    -> `resolve` the mesh by winding number, or move the parts apart";
    throw SelfIntersectionError(message, std::move(contacts));
}

CLEAVE_END_NAMESPACE

#endif

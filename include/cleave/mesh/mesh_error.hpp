// SPDX-License-Identifier: Apache-2.0
/// `MeshError`: a mesh that bounds no set, with the evidence; and `explain`, which puts a report into words.
#ifndef CLEAVE_MESH_MESH_ERROR_HPP
#define CLEAVE_MESH_MESH_ERROR_HPP

#include <cleave/base/error.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/number/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A mesh was refused. `what()` names the first few defects and what to do; `report()` has them all.
class MeshError : public Error {
public:
    MeshError(const std::string& message, MeshReport report)
        : Error(message), report_(std::make_shared<const MeshReport>(std::move(report))) {}

    [[nodiscard]] const MeshReport& report() const noexcept { return *report_; }

private:
    std::shared_ptr<const MeshReport> report_;  // shared, so that copying the exception cannot throw
};

namespace detail {

/// What a kind of defect is called, and what its owner can do about it.
struct DefectWords {
    const char* one;
    const char* many;
    const char* advice;
};

[[nodiscard]] inline DefectWords words_for(MeshDefect kind) {
    switch (kind) {
        case MeshDefect::point_not_finite:
            return {"point with an infinite or NaN coordinate", "points with an infinite or NaN coordinate",
                    "give it finite coordinates"};
        case MeshDefect::index_out_of_range:
            return {"corner that refers to no point", "corners that refer to no point", "correct the index"};
        case MeshDefect::open_edge:
            return {"open edge (one face only)", "open edges (one face only)",
                    "add the missing face, or make the points on both sides of the gap equal"};
        case MeshDefect::misoriented_edge:
            return {"edge whose two faces run the same way", "edges whose two faces run the same way",
                    "reverse one of the faces so that all are counter-clockwise seen from outside"};
        case MeshDefect::unbalanced_edge:
            return {"edge with three or more faces, not as many each way",
                    "edges with three or more faces, not as many each way",
                    "remove the surplus face or add the missing one"};
        case MeshDefect::crossing_outline:
            return {"flat face whose outline crosses itself", "flat faces whose outlines cross themselves",
                    "split the face where it crosses itself"};
        case MeshDefect::too_few_corners:
            return {"face with fewer than three distinct corners", "faces with fewer than three distinct corners",
                    "remove the face, or do without the strict mode"};
        case MeshDefect::repeated_corner:
            return {"face that repeats a corner", "faces that repeat a corner",
                    "remove the repetition, or do without the strict mode"};
        case MeshDefect::zero_area:
            return {"face without area", "faces without area", "remove the face, or do without the strict mode"};
        case MeshDefect::not_planar:
            return {"face whose corners lie on no common plane", "faces whose corners lie on no common plane",
                    "split the face into triangles, or do without the strict mode"};
        case MeshDefect::t_junction:
            return {"edge balanced by shorter edges on its line", "edges balanced by shorter edges on their lines",
                    "nothing needs to be done"};
        case MeshDefect::unused_point:
            return {"point that no face uses", "points that no face uses", "nothing needs to be done"};
    }
    return {"", "", ""};
}

[[nodiscard]] inline std::string coordinate_text(double x) {
    std::array<char, 32> buffer;
    const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return std::string(buffer.data(), end.ptr);
}

/// Long fractions are given as the nearest double: a message is read by people.
template <class T>
[[nodiscard]] std::string coordinate_text(const T& x) {
    const std::string exact = to_text(x);
    return exact.size() <= 40 ? exact : "about " + coordinate_text(to_double(x));
}

/// Writes the messages about one mesh.
template <class T>
class Explainer {
public:
    Explainer(const PolygonMesh<T>& mesh, const MeshReport& report, const MeshOrigin* origin)
        : mesh_(mesh), report_(report), origin_(origin) {}

    /// "point 3 (line 7) at (0, 0, 1)"
    [[nodiscard]] std::string point(std::uint32_t i) const {
        std::string text = std::to_string(i);
        if (origin_ != nullptr && i < origin_->point_lines.size()) {
            text += " (line " + std::to_string(origin_->point_lines[i]) + ')';
        }
        if (i >= mesh_.points.size()) return text;
        const auto& p = mesh_.points[i];
        return text + " at (" + coordinate_text(p[0]) + ", " + coordinate_text(p[1]) + ", " + coordinate_text(p[2]) +
               ')';
    }

    /// "face 5 (line 20)"
    [[nodiscard]] std::string face(std::uint32_t f) const {
        std::string text = "face " + std::to_string(f);
        if (origin_ != nullptr && f < origin_->face_lines.size()) {
            text += " (line " + std::to_string(origin_->face_lines[f]) + ')';
        }
        return text;
    }

    [[nodiscard]] std::string face_with_points(std::uint32_t f) const {
        constexpr std::size_t limit = 6;
        const auto corners = mesh_.face(f);
        std::string text = face(f) + " with points";
        for (std::size_t i = 0; i < corners.size() && i < limit; ++i) {
            text += (i == 0 ? " " : ", ") + (corners.size() <= 4 ? point(corners[i]) : std::to_string(corners[i]));
        }
        if (corners.size() > limit) text += ", ... (" + std::to_string(corners.size()) + " corners)";
        return corners.empty() ? face(f) + " without points" : text;
    }

    [[nodiscard]] std::string edge(const EdgeDefect& e) const {
        return "from point " + point(e.from) + " to point " + point(e.to) + ", used " + std::to_string(e.forward) +
               " time" + (e.forward == 1 ? "" : "s") + " this way and " + std::to_string(e.backward) +
               " the other, first by " + face(e.face);
    }

    /// The i-th defect of a kind.
    [[nodiscard]] std::string example(MeshDefect kind, std::size_t i) const {
        switch (kind) {
            case MeshDefect::point_not_finite:
                return "point " + point(report_.points_not_finite[i]);
            case MeshDefect::index_out_of_range: {
                const CornerDefect& c = report_.indices_out_of_range[i];
                return "corner " + std::to_string(c.corner) + " of " + face(c.face) + " is point " +
                       std::to_string(c.index) + " of " + std::to_string(report_.point_count);
            }
            case MeshDefect::open_edge:
                return edge(report_.open_edges[i]);
            case MeshDefect::misoriented_edge:
                return edge(report_.misoriented_edges[i]);
            case MeshDefect::unbalanced_edge:
                return edge(report_.unbalanced_edges[i]);
            case MeshDefect::crossing_outline:
                return face_with_points(report_.crossing_outlines[i]);
            case MeshDefect::too_few_corners:
                return face_with_points(report_.too_few_corners[i]);
            case MeshDefect::repeated_corner:
                return face_with_points(report_.repeated_corners[i]);
            case MeshDefect::zero_area:
                return face_with_points(report_.zero_area_faces[i]);
            case MeshDefect::not_planar:
                return face_with_points(report_.non_planar_faces[i]);
            case MeshDefect::t_junction:
                return edge(report_.t_junctions[i]);
            case MeshDefect::unused_point:
                return "point " + point(report_.unused_points[i]);
        }
        return {};
    }

    /// A count and up to three examples.
    [[nodiscard]] std::string kind(MeshDefect kind) const {
        constexpr std::size_t examples = 3;
        const std::size_t n = report_.count(kind);
        const DefectWords words = words_for(kind);
        std::string text = std::to_string(n) + ' ' + (n == 1 ? words.one : words.many) + ":";
        for (std::size_t i = 0; i < n && i < examples; ++i) text += "\n    " + example(kind, i);
        if (n > examples) text += "\n    and " + std::to_string(n - examples) + " more";
        return text;
    }

private:
    const PolygonMesh<T>& mesh_;
    const MeshReport& report_;
    const MeshOrigin* origin_;
};

template <class T, class Wanted>
[[nodiscard]] std::string explain_kinds(const MeshReport& report, const PolygonMesh<T>& mesh, const MeshOrigin* origin,
                                        bool advise, Wanted&& wanted) {
    const Explainer<T> explainer(mesh, report, origin);
    std::string text;
    for (const MeshDefect kind : all_mesh_defects) {
        if (report.count(kind) == 0 || !wanted(kind)) continue;
        if (!text.empty()) text += '\n';
        text += "  " + explainer.kind(kind);
        if (advise) text += std::string("\n    -> ") + words_for(kind).advice;
    }
    return text;
}

}  // namespace detail

/// Every kind of defect in the report with its count and the first few places, a line each; empty for a mesh without
/// any. `mesh` must be the one that the report is about; `origin` adds lines of the file.
template <class T>
[[nodiscard]] std::string explain(const MeshReport& report, const PolygonMesh<T>& mesh,
                                  const MeshOrigin* origin = nullptr) {
    return detail::explain_kinds(report, mesh, origin, false, [](MeshDefect) { return true; });
}

/// The error for a mesh that is not valid in this mode: file, what is wrong, where, and what to do.
template <class T>
[[nodiscard]] MeshError make_mesh_error(MeshReport report, const PolygonMesh<T>& mesh, Strictness strictness,
                                        const MeshOrigin* origin = nullptr) {
    const std::string defects =
        detail::explain_kinds(report, mesh, origin, true, [&](MeshDefect kind) { return is_error(kind, strictness); });
    const std::string file = origin == nullptr || origin->file.empty() ? std::string() : origin->file + ": ";
    const std::string message = file + "the mesh of " + std::to_string(report.point_count) + " points and " +
                                std::to_string(report.face_count) + " faces is refused\n" + defects;
    return MeshError(message, std::move(report));
}

CLEAVE_END_NAMESPACE

#endif

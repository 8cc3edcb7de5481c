// SPDX-License-Identifier: Apache-2.0
/// `MeshReport`: everything that is wrong with a mesh, or odd about it, by kind and with indices.
///
/// Indices of points and faces count from 0, whatever the file format counted from.
#ifndef CLEAVE_MESH_MESH_REPORT_HPP
#define CLEAVE_MESH_MESH_REPORT_HPP

#include <cleave/base/config.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Where a mesh came from, so that a message can name lines. Readers fill it on request.
struct MeshOrigin {
    std::string file;
    std::vector<std::uint32_t> point_lines;  ///< 1-based line of each point; empty where the format has no lines
    std::vector<std::uint32_t> face_lines;   ///< 1-based line of each face; empty where the format has no lines
};

/// What to do about faces that bound no volume or are not flat.
///
/// `tolerant`: faces without area are left out, non-planar ones are split into triangles; both are reported.
/// `strict`: both are errors.
enum class Strictness : std::uint8_t { tolerant, strict };

/// The kinds of defects.
enum class MeshDefect : std::uint8_t {
    point_not_finite,    ///< a coordinate is infinite or NaN
    index_out_of_range,  ///< a corner refers to no point
    open_edge,           ///< an edge with one face
    misoriented_edge,    ///< an edge that two faces, and no third, use in the same direction
    unbalanced_edge,     ///< an edge of three or more faces, not as many in one direction as in the other
    crossing_outline,    ///< the outline of a flat face crosses itself
    too_few_corners,     ///< fewer than three distinct corners; strict only
    repeated_corner,     ///< the same point twice in a row; strict only
    zero_area,           ///< all corners on one line; strict only
    not_planar,          ///< no plane holds all corners; strict only
    t_junction,          ///< an edge that is balanced by shorter edges on its line; never an error
    unused_point,        ///< no face has this corner; never an error
};

/// All kinds, worst first.
inline constexpr std::array<MeshDefect, 12> all_mesh_defects{
    MeshDefect::point_not_finite, MeshDefect::index_out_of_range, MeshDefect::open_edge,
    MeshDefect::misoriented_edge, MeshDefect::unbalanced_edge,    MeshDefect::crossing_outline,
    MeshDefect::too_few_corners,  MeshDefect::repeated_corner,    MeshDefect::zero_area,
    MeshDefect::not_planar,       MeshDefect::t_junction,         MeshDefect::unused_point};

/// True for the kinds that no mode accepts.
[[nodiscard]] constexpr bool is_always_error(MeshDefect kind) noexcept {
    return kind <= MeshDefect::crossing_outline;
}

/// True for the kinds that a mode refuses.
[[nodiscard]] constexpr bool is_error(MeshDefect kind, Strictness strictness) noexcept {
    return is_always_error(kind) || (strictness == Strictness::strict && kind <= MeshDefect::not_planar);
}

/// A corner that refers to no point.
struct CornerDefect {
    std::uint32_t face;
    std::uint32_t corner;  ///< its place in the face
    std::uint32_t index;   ///< the point it asks for

    friend bool operator==(const CornerDefect&, const CornerDefect&) = default;
};

/// An edge and how often faces use it in each direction. Points at equal coordinates count as one; an edge is named by
/// the least indices of its ends, in the direction of its prevailing use.
struct EdgeDefect {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t forward;   ///< uses in the direction from -> to
    std::uint32_t backward;  ///< uses in the direction to -> from
    std::uint32_t face;      ///< the first face that uses the edge

    friend bool operator==(const EdgeDefect&, const EdgeDefect&) = default;
};

/// The result of `validate`. Lists are sorted, by face, point, or (from, to).
struct MeshReport {
    std::size_t point_count = 0;
    std::size_t face_count = 0;

    std::vector<std::uint32_t> points_not_finite;
    std::vector<CornerDefect> indices_out_of_range;
    std::vector<EdgeDefect> open_edges;
    std::vector<EdgeDefect> misoriented_edges;
    std::vector<EdgeDefect> unbalanced_edges;
    std::vector<std::uint32_t> crossing_outlines;
    std::vector<std::uint32_t> too_few_corners;
    std::vector<std::uint32_t> repeated_corners;
    std::vector<std::uint32_t> zero_area_faces;
    std::vector<std::uint32_t> non_planar_faces;
    std::vector<EdgeDefect> t_junctions;
    std::vector<std::uint32_t> unused_points;

    /// False where bad points or indices kept edges, areas or planes from being looked at.
    bool complete = true;

    /// How many of a kind were found.
    [[nodiscard]] std::size_t count(MeshDefect kind) const noexcept {
        switch (kind) {
            case MeshDefect::point_not_finite:
                return points_not_finite.size();
            case MeshDefect::index_out_of_range:
                return indices_out_of_range.size();
            case MeshDefect::open_edge:
                return open_edges.size();
            case MeshDefect::misoriented_edge:
                return misoriented_edges.size();
            case MeshDefect::unbalanced_edge:
                return unbalanced_edges.size();
            case MeshDefect::crossing_outline:
                return crossing_outlines.size();
            case MeshDefect::too_few_corners:
                return too_few_corners.size();
            case MeshDefect::repeated_corner:
                return repeated_corners.size();
            case MeshDefect::zero_area:
                return zero_area_faces.size();
            case MeshDefect::not_planar:
                return non_planar_faces.size();
            case MeshDefect::t_junction:
                return t_junctions.size();
            case MeshDefect::unused_point:
                return unused_points.size();
        }
        return 0;
    }

    /// True where the faces, those without area included, bound a set: along every line their edges cancel out.
    [[nodiscard]] bool is_closed() const noexcept {
        return complete && open_edges.empty() && misoriented_edges.empty() && unbalanced_edges.empty();
    }

    /// True where no defect is an error in this mode.
    [[nodiscard]] bool is_valid(Strictness strictness = Strictness::tolerant) const noexcept {
        for (const MeshDefect kind : all_mesh_defects) {
            if (is_error(kind, strictness) && count(kind) != 0) return false;
        }
        return true;
    }
};

CLEAVE_END_NAMESPACE

#endif

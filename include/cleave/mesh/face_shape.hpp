// SPDX-License-Identifier: Apache-2.0
/// What a face of a mesh is: flat with an area, without area, not flat, or crossing itself; and its triangles.
#ifndef CLEAVE_MESH_FACE_SHAPE_HPP
#define CLEAVE_MESH_FACE_SHAPE_HPP

#include <cleave/mesh/point_tests.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/triangulate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The shapes a face can have.
enum class FaceShape : std::uint8_t {
    flat,             ///< on one plane, with area, its outline not crossing itself
    too_few_corners,  ///< fewer than three distinct points
    zero_area,        ///< three distinct points or more, and no area
    not_planar,       ///< no plane holds all corners
    crossing          ///< on one plane, and its outline crosses itself or runs around some part twice
};

/// Triangles from the corner with the least index to all edges: how faces are split that have no triangulation. Their
/// edges other than the face's own cancel out, whatever the shape.
inline void fan(std::span<const std::uint32_t> face, std::vector<IndexTriangle>& out) {
    const std::size_t n = face.size();
    if (n < 3) return;
    const auto s = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
    for (std::size_t i = 1; i + 1 < n; ++i) out.push_back({face[s], face[(s + i) % n], face[(s + i + 1) % n]});
}

/// Decides the shapes of the faces of one mesh. Keeps buffers: not for two threads at once, but each may have a copy;
/// what is known of the points is shared by copies.
template <class T>
class FaceShapes {
public:
    /// Requires: `points` outlives this object and is finite.
    explicit FaceShapes(std::span<const std::array<T, 3>> points)
        : points_(points), tests_(std::make_shared<const PointTests<T>>(points)) {}

    /// The shape of a face. A flat face's triangles are appended to `out` where it is given; nothing for other shapes.
    /// Requires: all corners refer to points.
    /// Cost: 10 ns for a triangle of doubles; an exact coplanarity test a corner and a triangulation for larger faces.
    [[nodiscard]] FaceShape shape(std::span<const std::uint32_t> face, std::vector<IndexTriangle>* out = nullptr) {
        if (face.size() == 3 && !tests_->collinear(face[0], face[1], face[2])) {
            if (out != nullptr) out->push_back({face[0], face[1], face[2]});
            return FaceShape::flat;
        }
        // Three corners not on a line, found greedily: the first corner, the first unlike it, the first off their line.
        if (face.empty()) return FaceShape::too_few_corners;
        const auto unlike = std::find_if(face.begin(), face.end(), [&](std::uint32_t c) { return !equal(c, face[0]); });
        if (unlike == face.end()) return FaceShape::too_few_corners;
        const auto off =
            std::find_if(unlike, face.end(), [&](std::uint32_t c) { return !tests_->collinear(face[0], *unlike, c); });
        if (off == face.end()) {
            const bool third = std::any_of(unlike, face.end(),
                                           [&](std::uint32_t c) { return !equal(c, face[0]) && !equal(c, *unlike); });
            return third ? FaceShape::zero_area : FaceShape::too_few_corners;
        }
        for (const std::uint32_t c : face) {
            if (c != face[0] && c != *unlike && c != *off && tests_->side(face[0], *unlike, *off, c) != Sign::zero) {
                return FaceShape::not_planar;
            }
        }
        return outline(face, *tests_->projectable_axis(face[0], *unlike, *off), out);
    }

    /// True where the same point stands twice in a row in a face.
    [[nodiscard]] bool repeats_a_corner(std::span<const std::uint32_t> face) const {
        for (std::size_t i = 0; i < face.size(); ++i) {
            if (face.size() > 1 && equal(face[i], face[i + 1 == face.size() ? 0 : i + 1])) return true;
        }
        return false;
    }

    [[nodiscard]] bool equal(std::uint32_t i, std::uint32_t j) const { return i == j || points_[i] == points_[j]; }

    [[nodiscard]] const PointTests<T>& tests() const noexcept { return *tests_; }

private:
    /// A planar face, seen along an axis that its plane does not contain: is its outline sound?
    [[nodiscard]] FaceShape outline(std::span<const std::uint32_t> face, unsigned axis,
                                    std::vector<IndexTriangle>* out) {
        // Rounded arithmetic guesses from which end of the axis the face is counter-clockwise; the triangulation knows.
        const Projection guess = Projection::along(axis);
        double area = 0;
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const auto &p = tests_->rounded(face[0]), &q = tests_->rounded(face[i]), &r = tests_->rounded(face[i + 1]);
            area += (q[guess.u] - p[guess.u]) * (r[guess.v] - p[guess.v]) -
                    (q[guess.v] - p[guess.v]) * (r[guess.u] - p[guess.u]);
        }
        triangles_.clear();
        for (const bool reversed : {area < 0, !(area < 0)}) {
            const Projection projection = Projection::along(axis, reversed);
            const std::array<std::uint32_t, 2> loop{0, static_cast<std::uint32_t>(face.size())};
            const bool sound = triangulator_.triangulate(
                face, loop,
                [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { return tests_->turn(i, j, k, projection); },
                [&](std::uint32_t i, std::uint32_t j) { return tests_->less(i, j, projection); }, triangles_);
            if (!sound) continue;
            if (triangles_.empty()) return FaceShape::zero_area;  // every edge runs both ways
            if (out != nullptr) out->insert(out->end(), triangles_.begin(), triangles_.end());
            return FaceShape::flat;
        }
        return FaceShape::crossing;
    }

    std::span<const std::array<T, 3>> points_;
    std::shared_ptr<const PointTests<T>> tests_;
    Triangulator triangulator_;
    std::vector<IndexTriangle> triangles_;
};

/// A mesh and, for each of its faces, the face of another mesh that it is a part of.
template <class T>
struct SplitMesh {
    PolygonMesh<T> mesh;
    std::vector<std::uint32_t> source;
};

/// The mesh in triangles, with the same points. Flat faces get a triangulation without flat triangles that uses all of
/// their corners; others are split by `fan`, so that edges stay balanced. Faces with fewer than three corners vanish.
/// Requires: finite points, and every corner refers to one.
template <class T>
[[nodiscard]] SplitMesh<T> triangulate_faces(const PolygonMesh<T>& mesh) {
    SplitMesh<T> result;
    result.mesh.points = mesh.points;
    FaceShapes<T> shapes(mesh.points);
    std::vector<IndexTriangle> triangles;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        triangles.clear();
        if (shapes.shape(mesh.face(f), &triangles) != FaceShape::flat) fan(mesh.face(f), triangles);
        for (const IndexTriangle& t : triangles) {
            result.mesh.add_face(t);
            result.source.push_back(static_cast<std::uint32_t>(f));
        }
    }
    return result;
}

/// The mesh with flat faces only, each with an area: non-planar and self-crossing faces become the triangles of their
/// `fan`, and what has no area is left out. The set that the mesh bounds is the same: a face without area bounds
/// nothing, and what its absence leaves unbalanced are stretches of one line, which still cancel out along it.
/// Requires: finite points, and every corner refers to one.
template <class T>
[[nodiscard]] SplitMesh<T> flat_faces(const PolygonMesh<T>& mesh) {
    SplitMesh<T> result;
    result.mesh.points = mesh.points;
    result.mesh.corners.reserve(mesh.corners.size());
    result.mesh.first.reserve(mesh.first.size());
    result.source.reserve(mesh.face_count());
    FaceShapes<T> shapes(mesh.points);
    std::vector<IndexTriangle> triangles;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const auto source = static_cast<std::uint32_t>(f);
        switch (shapes.shape(face)) {
            case FaceShape::flat:
                result.mesh.add_face(face);
                result.source.push_back(source);
                break;
            case FaceShape::too_few_corners:
            case FaceShape::zero_area:
                break;
            case FaceShape::not_planar:
            case FaceShape::crossing:
                triangles.clear();
                fan(face, triangles);
                for (const IndexTriangle& t : triangles) {
                    if (shapes.shape(t) != FaceShape::flat) continue;
                    result.mesh.add_face(t);
                    result.source.push_back(source);
                }
                break;
        }
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif

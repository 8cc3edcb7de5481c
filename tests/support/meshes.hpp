// SPDX-License-Identifier: Apache-2.0
/// Small meshes that tests read, write, validate and break.
#ifndef CLEAVE_TESTS_SUPPORT_MESHES_HPP
#define CLEAVE_TESTS_SUPPORT_MESHES_HPP

#include <cleave/mesh/polygon_mesh.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace meshes {

/// A mesh from points and faces written out.
template <class T = double>
cleave::PolygonMesh<T> mesh(std::vector<std::array<T, 3>> points,
                            std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
    cleave::PolygonMesh<T> result;
    result.points = std::move(points);
    for (const auto& face : faces) result.add_face(face);
    return result;
}

/// The corners of a box in binary order: bit 0 is x, bit 1 y, bit 2 z.
template <class T = double>
std::vector<std::array<T, 3>> box_points(T lower, T upper) {
    std::vector<std::array<T, 3>> points;
    for (unsigned i = 0; i < 8; ++i) {
        points.push_back({(i & 1) != 0 ? upper : lower, (i & 2) != 0 ? upper : lower, (i & 4) != 0 ? upper : lower});
    }
    return points;
}

/// A cube of six quadrilaterals.
template <class T = double>
cleave::PolygonMesh<T> cube(T lower = T(0), T upper = T(1)) {
    return mesh<T>(box_points<T>(lower, upper),
                   {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

template <class T = double>
cleave::PolygonMesh<T> tetrahedron() {
    return mesh<T>({{T(0), T(0), T(0)}, {T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// The cube [-1, 1]^3 in twelve triangles.
inline cleave::Mesh triangle_cube() {
    return mesh({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                {{3, 1, 0},
                 {1, 3, 2},
                 {5, 7, 4},
                 {7, 5, 6},
                 {2, 5, 1},
                 {5, 2, 6},
                 {4, 3, 0},
                 {3, 4, 7},
                 {4, 1, 5},
                 {1, 4, 0},
                 {3, 6, 2},
                 {6, 3, 7}});
}

/// The N pentomino prism: its top and bottom are two pentagons each, every other corner of which is on a straight edge.
inline cleave::Mesh pentomino() {
    const std::array<std::array<double, 2>, 8> outline{
        {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 4}, {1, 4}, {1, 2}, {0, 2}}};
    std::vector<std::array<double, 3>> points;
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : outline) points.push_back({x, y, z});
    }
    return mesh(std::move(points), {{8, 9, 10, 14, 15},
                                    {10, 11, 12, 13, 14},
                                    {7, 6, 2, 1, 0},
                                    {6, 5, 4, 3, 2},
                                    {0, 1, 9, 8},
                                    {1, 2, 10, 9},
                                    {2, 3, 11, 10},
                                    {3, 4, 12, 11},
                                    {4, 5, 13, 12},
                                    {5, 6, 14, 13},
                                    {6, 7, 15, 14},
                                    {7, 0, 8, 15}});
}

/// The mesh without one of its faces.
template <class T>
cleave::PolygonMesh<T> without_face(const cleave::PolygonMesh<T>& source, std::size_t face) {
    cleave::PolygonMesh<T> result;
    result.points = source.points;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
        if (f != face) result.add_face(source.face(f));
    }
    return result;
}

/// The mesh with one of its faces turned over.
template <class T>
cleave::PolygonMesh<T> with_reversed_face(const cleave::PolygonMesh<T>& source, std::size_t face) {
    cleave::PolygonMesh<T> result;
    result.points = source.points;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
        const auto corners = source.face(f);
        std::vector<std::uint32_t> copy(corners.begin(), corners.end());
        if (f == face) copy.assign(corners.rbegin(), corners.rend());
        result.add_face(copy);
    }
    return result;
}

/// The mesh with points of its own for every face: what STL files hold.
template <class T>
cleave::PolygonMesh<T> soup(const cleave::PolygonMesh<T>& source) {
    cleave::PolygonMesh<T> result;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (const std::uint32_t corner : source.face(f)) {
            face.push_back(static_cast<std::uint32_t>(result.points.size()));
            result.points.push_back(source.points[corner]);
        }
        result.add_face(face);
    }
    return result;
}

}  // namespace meshes

#endif

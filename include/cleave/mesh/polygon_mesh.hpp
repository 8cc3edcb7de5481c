// SPDX-License-Identifier: Apache-2.0
/// `PolygonMesh`: points and polygons that refer to them, the form in which solids enter and leave the library.
#ifndef CLEAVE_MESH_POLYGON_MESH_HPP
#define CLEAVE_MESH_POLYGON_MESH_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/rational.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// An indexed polygon mesh. Face i is the cycle of point indices `corners[first[i]] .. corners[first[i + 1] - 1]`,
/// counter-clockwise seen from outside. Members are public because any values are allowed here: `validate` decides
/// whether they describe a closed oriented surface.
///
/// Coordinates are `T`: `double` (each of which *is* a rational number, nothing is approximate about it) or `Rational`.
template <class T>
struct PolygonMesh {
    using coordinate_type = T;
    using point_type = std::array<T, 3>;

    std::vector<point_type> points;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first{0};

    [[nodiscard]] std::size_t point_count() const noexcept { return points.size(); }

    /// Also right for a moved-from mesh, whose `first` is empty.
    [[nodiscard]] std::size_t face_count() const noexcept { return first.empty() ? 0 : first.size() - 1; }

    /// The corners of face i. Requires: i < face_count(), and `first` ascending within `corners`.
    [[nodiscard]] std::span<const std::uint32_t> face(std::size_t i) const {
        CLEAVE_REQUIRES(i < face_count());
        return std::span<const std::uint32_t>(corners).subspan(first[i], first[i + 1] - first[i]);
    }

    /// Appends a face. Requires: fewer than 2^32 corners in all.
    void add_face(std::span<const std::uint32_t> face_corners) {
        CLEAVE_REQUIRES(corners.size() + face_corners.size() <= std::numeric_limits<std::uint32_t>::max());
        if (first.empty()) first.push_back(0);
        corners.insert(corners.end(), face_corners.begin(), face_corners.end());
        first.push_back(static_cast<std::uint32_t>(corners.size()));
    }

    /// The same for a face written out: `mesh.add_face({0, 1, 2})`.
    void add_face(std::initializer_list<std::uint32_t> face_corners) {
        add_face(std::span<const std::uint32_t>(face_corners.begin(), face_corners.size()));
    }

    friend bool operator==(const PolygonMesh&, const PolygonMesh&) = default;
};

/// Coordinates as doubles: what files usually hold.
using Mesh = PolygonMesh<double>;

/// Coordinates as exact rationals.
using RationalMesh = PolygonMesh<Rational>;

CLEAVE_END_NAMESPACE

#endif

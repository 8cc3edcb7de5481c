// SPDX-License-Identifier: Apache-2.0
/// The boundary of a mesh of triangles of doubles, as it is: planes are made when something asks for them.
#ifndef CLEAVE_MESH_TRIANGLE_BOUNDARY_HPP
#define CLEAVE_MESH_TRIANGLE_BOUNDARY_HPP

#include <cleave/execution/executor_ref.hpp>
#include <cleave/geometry/bounds.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/tabulate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The boundary whose point k is the mesh's point `order[k]`; `id` says the reverse of every corner's point.
[[nodiscard]] inline Boundary<3> number_triangles(const PolygonMesh<double>& mesh, std::span<const std::uint32_t> order,
                                                  std::span<const PointId> id, ExecutorRef executor) {
    Boundary<3> out;
    out.is_complete = false;
    out.is_conforming = true;
    const std::size_t faces = mesh.face_count();
    const auto fill_faces = [&] {
        out.faces.faces = tabulate<LargeVector>(faces, [](std::size_t f) {
            return FaceList::Face{no_id, static_cast<std::uint32_t>(f), 1, {0, static_cast<std::uint32_t>(f)}};
        });
        out.faces.loop_first =
            tabulate<LargeVector>(faces + 1, [](std::size_t f) { return static_cast<std::uint32_t>(3 * f); });
    };
    const auto fill_corners = [&] {
        out.faces.corners = tabulate<LargeVector>(executor, mesh.corners.size(), [&](std::size_t c) {
            return Corner{id[mesh.corners[c]], no_id};
        });
    };
    const auto fill_points = [&] {
        Bounds<3> bounds;
        out.points = tabulate<LargeVector>(order.size(), [&](std::size_t k) {
            PointRecord<3> r;
            for (std::size_t x = 0; x < 3; ++x) r.approximation[x] = mesh.points[order[k]][x] + 0.0;  // one zero
            bounds.include(r.approximation, 0);
            return r;
        });
        out.bounds = bounds;
    };
    executor.invoke(fill_corners, [&] { executor.invoke(fill_points, fill_faces); });
    return out;
}

/// The boundary of a mesh whose edges match from end to end. `used`: the points that faces use, in the order of their
/// first corners. Requires: no two of them are equal; every triangle has an area.
[[nodiscard]] inline Boundary<3> triangle_boundary(const PolygonMesh<double>& mesh, std::span<const std::uint32_t> used,
                                                   ExecutorRef executor) {
    std::vector<PointId> id(mesh.points.size(), no_id);
    for (std::size_t k = 0; k < used.size(); ++k) id[used[k]] = static_cast<PointId>(k);
    return number_triangles(mesh, used, id, executor);
}

/// The same where points may be equal.
[[nodiscard]] inline Boundary<3> welded_triangle_boundary(const PolygonMesh<double>& mesh, ExecutorRef executor) {
    std::vector<std::uint32_t> first_equal = first_equal_points<double>(mesh.points);
    std::vector<PointId> id(mesh.points.size(), no_id);
    std::vector<std::uint32_t> order;
    for (const std::uint32_t c : mesh.corners) {
        PointId& first = id[first_equal[c]];
        if (first == no_id) {
            first = static_cast<PointId>(order.size());
            order.push_back(c);
        }
        id[c] = first;
    }
    return number_triangles(mesh, order, id, executor);
}

/// The sign of the volume that a boundary encloses, by doubles with a bound, then exactly.
inline Sign enclosed_volume_sign(const Boundary<3>& boundary) {
    double sum = 0;
    double magnitude = 0;
    std::size_t terms = 0;
    const auto each = [&](auto&& term) {
        for (std::size_t l = 0; l + 1 < boundary.faces.loop_first.size(); ++l) {
            const std::span<const Corner> loop = boundary.faces.loop(l);
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) term(loop[0].point, loop[i].point, loop[i + 1].point);
        }
    };
    bool exact_points = true;
    each([&](PointId p, PointId q, PointId r) {
        const auto& a = boundary.points[p].approximation;
        const auto& b = boundary.points[q].approximation;
        const auto& c = boundary.points[r].approximation;
        exact_points = exact_points && boundary.points[p].error == 0 && boundary.points[q].error == 0 &&
                       boundary.points[r].error == 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = b[(i + 1) % 3] * c[(i + 2) % 3];
            const double y = b[(i + 2) % 3] * c[(i + 1) % 3];
            sum += a[i] * (x - y);
            magnitude += std::abs(a[i]) * (std::abs(x) + std::abs(y));
        }
        terms += 3;
    });
    // n additions and three operations a term: relative error below (n + 4) u of the magnitudes; twice that is safe.
    const double bound = magnitude * (double(terms) + 8) * 0x1p-52 + 0x1p-900;
    if (exact_points && sum > bound) return Sign::plus;
    if (exact_points && -sum > bound) return Sign::minus;
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    std::vector<Rational> parts;
    each([&](PointId p, PointId q, PointId r) {
        const Homogeneous<3> a = kernel.coordinates(loaded.first_point + p);
        const Homogeneous<3> b = kernel.coordinates(loaded.first_point + q);
        const Homogeneous<3> c = kernel.coordinates(loaded.first_point + r);
        WideInteger det;
        for (std::size_t i = 0; i < 3; ++i) {
            WideInteger minor(b[(i + 1) % 3] * WideInteger(c[(i + 2) % 3]));
            sub_product(minor, b[(i + 2) % 3], c[(i + 1) % 3]);
            add_product(det, a[i], minor);
        }
        parts.push_back(number_traits<Rational>::from_fraction(Integer(det), Integer(WideInteger(a[3]) * b[3] * c[3])));
    });
    for (std::size_t n = parts.size(); n > 1; n = (n + 1) / 2)  // in pairs, so that denominators grow late
        for (std::size_t i = 0; i < n / 2; ++i) {
            Rational s = parts[i] + parts[n - 1 - i];
            parts[i] = s;
        }
    return parts.empty() ? Sign::zero : number_traits<Rational>::sign(parts.front());
}

}  // namespace detail

CLEAVE_END_NAMESPACE

#endif

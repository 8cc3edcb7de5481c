// SPDX-License-Identifier: Apache-2.0
/// The simplices that the faces of a boundary span with the origin, each with its signed size: what integrals over a
/// region are sums over.
#ifndef CLEAVE_QUERY_CONE_SIMPLICES_HPP
#define CLEAVE_QUERY_CONE_SIMPLICES_HPP

#include <cleave/algebra/determinant.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/polytope_faces.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The determinant of the points' numerators: D! times the size of their simplex with the origin, times their weights.
template <int D>
[[nodiscard]] Integer cone_determinant(const std::array<Homogeneous<D>, D>& x) {
    Matrix<D, D, Integer> m;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) m(i, j) = x[std::size_t(i)][std::size_t(j)];
    return Integer(determinant<WideInteger>(m));
}

/// Cuts a polytope up from its first vertex: each of its faces without that vertex is cut up in the same way, down to
/// points. `chosen` holds the vertices chosen so far.
template <int D, class Emit>
void pull_vertices(const Polytope& body, std::vector<PointId>& chosen, Emit& emit) {
    chosen.push_back(body.points[0]);
    if (chosen.size() == std::size_t(D)) {
        emit(chosen);
    } else {
        for (const PolytopeFace& face : largest_faces(body))
            if (face.vertices.front() != 0) pull_vertices<D>(subpolytope(body, face.vertices), chosen, emit);
    }
    chosen.pop_back();
}

}  // namespace detail

/// Calls `emit(points, determinant)` for simplices (of D points and the origin) whose signed sum is the cone over the
/// face; points are homogeneous, the determinant is that of their numerators. Requires: the face is bounded.
template <int D, class Emit>
void cone_simplices(Kernel<D>& kernel, const Boundary<D>& boundary, const LoadedBoundary<D>& loaded,
                    const FaceList::Face& face, Emit&& emit) {
    const FaceList& list = boundary.faces;
    const auto at = [&](const Corner& corner) { return kernel.coordinates(loaded.first_point + corner.point); };
    const PlaneId plane = loaded.plane(face.plane);
    std::array<Homogeneous<D>, D> x;
    for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
        const std::span<const Corner> loop = list.loop(l);
        if constexpr (D == 1) {
            x[0] = at(loop[0]);
            emit(x, is_flipped(plane) ? -x[0][0] : x[0][0]);
        } else if constexpr (D == 2) {
            x = {at(loop[0]), at(loop[1])};
            emit(x, detail::cone_determinant<D>(x));
        } else if constexpr (D == 3) {
            // A fan from the first corner: where the polygon is not convex some triangles count negatively.
            x[0] = at(loop[0]);
            x[2] = at(loop[1]);
            for (std::size_t i = 2; i < loop.size(); ++i) {
                x[1] = std::move(x[2]);
                x[2] = at(loop[i]);
                emit(x, detail::cone_determinant<D>(x));
            }
        } else {
            // The origin is inside the plane where its offset is negative.
            Sign inside = -kernel.planes.exact(unoriented(plane))[D].sign();
            if (is_flipped(plane)) inside = -inside;
            if (inside == Sign::zero) return;
            PolytopeClip<D> clip(kernel);
            std::vector<PointId> chosen;
            const auto simplex = [&](const std::vector<PointId>& vertices) {
                for (std::size_t i = 0; i < std::size_t(D); ++i) x[i] = kernel.coordinates(vertices[i]);
                const Integer size = abs(detail::cone_determinant<D>(x));
                emit(x, inside == Sign::plus ? size : -size);
            };
            detail::pull_vertices<D>(polytope_of(clip, loop, loaded), chosen, simplex);
        }
    }
}

CLEAVE_END_NAMESPACE

#endif

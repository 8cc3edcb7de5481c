// SPDX-License-Identifier: Apache-2.0
/// A convex body with as many facets as wanted, exactly on a sphere: the worst case of every tree that uses facet
/// planes alone. Made of small integers, for the real Clip models.
#ifndef CLEAVE_TESTS_SUPPORT_CONVEX_BODY_HPP
#define CLEAVE_TESTS_SUPPORT_CONVEX_BODY_HPP

#include <cleave/clip/facet.hpp>
#include <cleave/clip/kernel_clip.hpp>
#include <cleave/clip/make_facet.hpp>
#include <cleave/clip/pencil.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

/// Points with homogeneous coordinates (X, Y, Z, W) and plane convex faces, counter-clockwise as seen from outside.
struct ConvexBody {
    std::vector<std::array<std::int64_t, 4>> points;
    std::vector<std::vector<std::uint32_t>> faces;

    /// The face on the other side of the edge from face[i] to the next vertex, for each face and i.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> neighbours() const {
        std::unordered_map<std::uint64_t, std::uint32_t> face_of;
        const auto edge = [](std::uint64_t a, std::uint64_t b) { return (a << 32U) | b; };
        const auto next = [](const std::vector<std::uint32_t>& face, std::size_t i) {
            return face[i + 1 == face.size() ? 0 : i + 1];
        };
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            for (std::size_t i = 0; i < faces[f].size(); ++i) face_of[edge(faces[f][i], next(faces[f], i))] = f;
        }
        std::vector<std::vector<std::uint32_t>> result(faces.size());
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            for (std::size_t i = 0; i < faces[f].size(); ++i) {
                result[f].push_back(face_of.at(edge(next(faces[f], i), faces[f][i])));
            }
        }
        return result;
    }
};

/// 8 m^2 faces between 4 m meridians and 2 m - 1 parallels of the unit sphere. The point at the parameter t = j / m of
/// a quarter turn is ((m^2 - j^2), 2 j m) / (m^2 + j^2). Quadrangles between two parallels are plane: their chords are
/// parallel.
[[nodiscard]] inline ConvexBody sphere_body(std::int64_t m) {
    struct OnCircle {
        std::int64_t x, y, w;
    };
    const auto quarter = [m](std::int64_t j) { return OnCircle{m * m - j * j, 2 * j * m, m * m + j * j}; };
    std::vector<OnCircle> round;
    for (std::int64_t turn = 0; turn < 4; ++turn) {
        for (std::int64_t j = 0; j < m; ++j) {
            const OnCircle p = quarter(j);
            const std::array<OnCircle, 4> turned{p, {-p.y, p.x, p.w}, {-p.x, -p.y, p.w}, {p.y, -p.x, p.w}};
            round.push_back(turned[static_cast<std::size_t>(turn)]);
        }
    }
    ConvexBody body;
    body.points.push_back({0, 0, -1, 1});
    for (std::int64_t j = 1 - m; j < m; ++j) {
        const OnCircle latitude = quarter(j < 0 ? -j : j);
        const std::int64_t z = j < 0 ? -latitude.y : latitude.y;
        for (const OnCircle& p : round) {
            body.points.push_back({latitude.x * p.x, latitude.x * p.y, z * p.w, latitude.w * p.w});
        }
    }
    body.points.push_back({0, 0, 1, 1});
    const auto columns = static_cast<std::uint32_t>(4 * m);
    const auto rows = static_cast<std::uint32_t>(2 * m - 1);
    const auto at = [&](std::uint32_t row, std::uint32_t column) { return 1 + row * columns + column % columns; };
    const auto top = static_cast<std::uint32_t>(body.points.size() - 1);
    for (std::uint32_t c = 0; c < columns; ++c) {
        body.faces.push_back({0, at(0, c + 1), at(0, c)});
        for (std::uint32_t r = 0; r + 1 < rows; ++r) {
            body.faces.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
        }
        body.faces.push_back({at(rows - 1, c), at(rows - 1, c + 1), top});
    }
    return body;
}

/// The indexed model, with planes turned about the edges of its facets.
struct TurningKernelClip : cleave::KernelClip<3> {
    using cleave::KernelClip<3>::KernelClip;

    std::vector<cleave::PlaneId> planes_through(cleave::PlaneId g, cleave::PlaneId h) {
        cleave::PlaneTable<3>& table = kernel().planes;
        const cleave::PlaneTable<3>::Coefficients a = table.exact(cleave::unoriented(g));
        const cleave::PlaneTable<3>::Coefficients b = table.exact(cleave::unoriented(h));
        return cleave::planes_through(
            a, b, [&](cleave::PlaneTable<3>::Coefficients c) { return table.intern(std::move(c)); });
    }
};

/// The faces as facets over N, with the planes of their neighbours as edge planes.
template <cleave::ExactRing N>
[[nodiscard]] std::vector<cleave::Facet<3, N>> body_facets(const ConvexBody& body) {
    using P = cleave::Point<3, N>;
    std::vector<std::vector<P>> loops;
    std::vector<cleave::Plane<3, N>> planes;
    for (const std::vector<std::uint32_t>& face : body.faces) {
        std::vector<P> loop;
        for (const std::uint32_t v : face) {
            typename P::Homogeneous x;
            for (std::size_t i = 0; i < 4; ++i) {
                x[i] = cleave::number_traits<N>::from_integer(cleave::Integer(body.points[v][i]));
            }
            loop.emplace_back(std::move(x));
        }
        planes.push_back(*cleave::plane_of_convex(std::span<const P>(loop)));
        loops.push_back(std::move(loop));
    }
    const std::vector<std::vector<std::uint32_t>> neighbours = body.neighbours();
    std::vector<cleave::Facet<3, N>> facets;
    for (std::size_t f = 0; f < loops.size(); ++f) {
        std::vector<std::optional<cleave::Plane<3, N>>> across;
        for (const std::uint32_t g : neighbours[f]) across.emplace_back(planes[g]);
        facets.push_back(*cleave::make_facet(planes[f], std::span<const P>(loops[f]),
                                             std::span<const std::optional<cleave::Plane<3, N>>>(across)));
    }
    return facets;
}

/// The faces as facets of the indexed kernel, which gets their planes and points.
[[nodiscard]] inline std::vector<cleave::KernelFacet<3>> body_facets(const ConvexBody& body,
                                                                     cleave::KernelClip<3>& clip) {
    using cleave::Integer;
    using P = cleave::Point<3, Integer>;
    cleave::Kernel<3>& kernel = clip.kernel();
    std::vector<cleave::PointId> points;
    for (const std::array<std::int64_t, 4>& x : body.points) {
        points.push_back(kernel.add_point({Integer(x[0]), Integer(x[1]), Integer(x[2]), Integer(x[3])}));
    }
    std::vector<cleave::PlaneId> planes;
    for (const std::vector<std::uint32_t>& face : body.faces) {
        std::vector<P> loop;
        for (const std::uint32_t v : face) {
            typename P::Homogeneous x;
            for (std::size_t i = 0; i < 4; ++i) x[i] = Integer(body.points[v][i]);
            loop.emplace_back(std::move(x));
        }
        const cleave::Plane<3, Integer> h = *cleave::plane_of_convex(std::span<const P>(loop));
        planes.push_back(kernel.planes.intern({h[0], h[1], h[2], h[3]}));
    }
    const std::vector<std::vector<std::uint32_t>> neighbours = body.neighbours();
    std::vector<cleave::KernelFacet<3>> facets;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        std::vector<cleave::Corner> corners;
        for (std::size_t i = 0; i < body.faces[f].size(); ++i) {
            corners.push_back({points[body.faces[f][i]], planes[neighbours[f][i]]});
        }
        facets.push_back(clip.make(planes[f], corners));
    }
    return facets;
}

#endif

// SPDX-License-Identifier: Apache-2.0
/// What a region is the convex hull of, and what half-spaces it is the intersection of, if it is convex.
#ifndef CLEAVE_QUERY_REPRESENTATION_HPP
#define CLEAVE_QUERY_REPRESENTATION_HPP

#include <cleave/geometry/plane.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The finite corners of a region's faces, each once, in lexicographic order. For a bounded convex region its
/// V-representation: `convex_hull<D, N>(vertices(r))` is r.
/// Requires: the coordinates fit N (`Region<D, Rational>(r)` costs nothing). Cost: exact coordinates of all corners.
template <int D, class N>
[[nodiscard]] std::vector<std::array<N, std::size_t(D)>> vertices(const Region<D, N>& region) {
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    std::vector<std::array<N, std::size_t(D)>> all;
    for (PointId p = 0; p < region.boundary().points.size(); ++p) {
        if (kernel.is_infinite(loaded.first_point + p)) continue;
        const Homogeneous<D> x = kernel.coordinates(loaded.first_point + p);
        std::array<N, std::size_t(D)> v;
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            const Fraction f = make_fraction(x[i], x[std::size_t(D)]);
            v[i] = number_traits<N>::from_fraction(f.num, f.den);
        }
        all.push_back(std::move(v));
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The planes of a region's faces, facing outward, primitive, each once, in lexicographic order. For a convex region,
/// bounded or not, its irredundant H-representation: `half_spaces<D, Integer>(facet_planes(r))` is r.
/// Cost: a sort.
template <int D, class N>
[[nodiscard]] std::vector<Plane<D, Integer>> facet_planes(const Region<D, N>& region) {
    const Boundary<D>& b = region.boundary();
    std::vector<PlaneId> planes;
    for (const FaceList::Face& face : b.faces.faces) planes.push_back(face.plane);
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    std::vector<typename Plane<D, Integer>::Coefficients> rows;
    for (const PlaneId h : planes) {
        rows.push_back(b.planes.exact(unoriented(h)));
        if (is_flipped(h))
            for (Integer& x : rows.back()) x.negate();
    }
    std::sort(rows.begin(), rows.end());
    std::vector<Plane<D, Integer>> result;
    for (auto& row : rows) result.emplace_back(std::move(row));
    return result;
}

CLEAVE_END_NAMESPACE

#endif

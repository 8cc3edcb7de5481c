// SPDX-License-Identifier: Apache-2.0
/// The centroid of a region, exactly.
#ifndef CLEAVE_QUERY_CENTROID_HPP
#define CLEAVE_QUERY_CENTROID_HPP

#include <cleave/number/rational.hpp>
#include <cleave/query/cone_simplices.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/region.hpp>

#include <array>
#include <cstddef>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

/// The mean of all points of the set, in any dimension: the sum over the boundary's simplices with the origin of their
/// signed sizes times their centroids, over the sum of the sizes.
/// Returns: nullopt where there is no mean: the set is empty or unbounded. Cost: as `measure`, D + 1 times.
template <int D, class N>
[[nodiscard]] std::optional<std::array<typename number_traits<N>::field_type, std::size_t(D)>> centroid(
    const Region<D, N>& region) {
    if (region.is_empty() || !region.is_bounded()) return std::nullopt;
    Kernel<D> kernel;
    const Boundary<D>& boundary = region.boundary();
    const LoadedBoundary<D> loaded = load(boundary, kernel);
    // Everything is left without the factor 1 / D!, which the quotient does not need.
    FractionSum size;
    std::array<FractionSum, D> moment;
    for (const FaceList::Face& face : boundary.faces.faces)
        cone_simplices(kernel, boundary, loaded, face,
                       [&](const std::array<Homogeneous<D>, D>& x, const Integer& determinant) {
                           if (determinant.is_zero()) return;
                           Integer weights(1);
                           for (const Homogeneous<D>& p : x) weights *= p[D];
                           size.add(determinant, weights);
                           for (std::size_t i = 0; i < std::size_t(D); ++i)
                               for (const Homogeneous<D>& p : x)
                                   if (!p[i].is_zero()) moment[i].add(determinant * p[i], weights * p[D]);
                       });
    const Rational scale = size.total() * (D + 1);
    std::array<typename number_traits<N>::field_type, std::size_t(D)> result;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        const Rational x = moment[i].total() / scale;
        if constexpr (std::is_same_v<typename number_traits<N>::field_type, Rational>)
            result[i] = x;
        else
            result[i] = convert_number<typename number_traits<N>::field_type>(x);
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Random points, planes and maps for rapidcheck, with small integers so that coincidences are common.
#ifndef CLEAVE_TESTS_SUPPORT_GEOMETRY_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_GEOMETRY_GENERATORS_HPP

#include "support/catch.hpp"

#include <cleave/geometry/affine_map.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <array>
#include <cstddef>

namespace rc {

template <int D, class N>
struct Arbitrary<cleave::Point<D, N>> {
    static Gen<cleave::Point<D, N>> arbitrary() {
        using Numerators = std::array<int, std::size_t(D)>;
        return gen::map(gen::pair(gen::container<Numerators>(gen::inRange(-4, 5)),
                                  gen::weightedElement<int>({{6, 1}, {1, 2}, {1, 3}})),
                        [](const std::pair<Numerators, int>& drawn) {
                            typename cleave::Point<D, N>::Homogeneous h;
                            for (std::size_t i = 0; i < std::size_t(D); ++i) h[i] = N(drawn.first[i]);
                            h[D] = N(drawn.second);
                            return cleave::Point<D, N>(h);
                        });
    }
};

template <int D, class N>
struct Arbitrary<cleave::Plane<D, N>> {
    static Gen<cleave::Plane<D, N>> arbitrary() {
        using Coefficients = std::array<int, std::size_t(D) + 1>;
        const auto has_normal = [](const Coefficients& c) {
            for (std::size_t i = 0; i < std::size_t(D); ++i) {
                if (c[i] != 0) return true;
            }
            return false;
        };
        // Not smaller for small sizes: all zeros is no plane.
        const auto entries = gen::resize(kNominalSize, gen::inRange(-2, 3));
        return gen::map(gen::suchThat(gen::container<Coefficients>(entries), has_normal),
                        [](const Coefficients& c) { return cleave::make_plane<N>(c); });
    }
};

template <int D, class N>
struct Arbitrary<cleave::AffineMap<D, N>> {
    static Gen<cleave::AffineMap<D, N>> arbitrary() {
        using Row = std::array<int, std::size_t(D) + 1>;
        using Rows = std::array<Row, std::size_t(D)>;
        // Not smaller for small sizes: all zeros has no inverse.
        const auto rows = gen::container<Rows>(gen::container<Row>(gen::resize(kNominalSize, gen::inRange(-2, 3))));
        return gen::map(gen::pair(rows, gen::inRange(1, 4)), [](const std::pair<Rows, int>& drawn) {
            auto m = cleave::identity_matrix<D + 1, N>();
            for (std::size_t i = 0; i < std::size_t(D); ++i) {
                for (std::size_t j = 0; j <= std::size_t(D); ++j) m(int(i), int(j)) = N(drawn.first[i][j]);
            }
            m(D, D) = N(drawn.second);
            return cleave::AffineMap<D, N>(m);
        });
    }
};

}  // namespace rc

#endif

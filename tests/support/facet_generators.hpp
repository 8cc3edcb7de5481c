// SPDX-License-Identifier: Apache-2.0
/// Random facets for rapidcheck, with small integers so that cuts often go through vertices and along edges.
#ifndef CLEAVE_TESTS_SUPPORT_FACET_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_FACET_GENERATORS_HPP

#include "support/catch.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/clip/clip_3d.hpp>
#include <cleave/clip/facet.hpp>
#include <cleave/clip/make_facet.hpp>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace rc {

template <class N>
struct Arbitrary<cleave::Facet<1, N>> {
    static Gen<cleave::Facet<1, N>> arbitrary() {
        return gen::map(gen::pair(gen::arbitrary<cleave::Point<1, N>>(), gen::arbitrary<bool>()),
                        [](const std::pair<cleave::Point<1, N>, bool>& drawn) {
                            return cleave::make_facet(drawn.first,
                                                      drawn.second ? cleave::Sign::plus : cleave::Sign::minus);
                        });
    }
};

template <class N>
struct Arbitrary<cleave::Facet<2, N>> {
    static Gen<cleave::Facet<2, N>> arbitrary() {
        using Ends = std::pair<cleave::Point<2, N>, cleave::Point<2, N>>;
        return gen::map(gen::suchThat(gen::arbitrary<Ends>(), [](const Ends& e) { return e.first != e.second; }),
                        [](const Ends& e) { return *cleave::make_facet(e.first, e.second); });
    }
};

/// A triangle, and what a few cuts leave of it: up to seven corners, edge planes of all kinds.
template <class N>
struct Arbitrary<cleave::Facet<3, N>> {
    static Gen<cleave::Facet<3, N>> arbitrary() {
        using Corners = std::array<cleave::Point<3, N>, 3>;
        using Cuts = std::vector<cleave::Plane<3, N>>;
        const auto span_a_plane = [](const Corners& p) { return cleave::join(p).has_value(); };
        const auto cuts = gen::mapcat(gen::inRange(0, 5), [](int n) {
            return gen::container<Cuts>(std::size_t(n), gen::arbitrary<cleave::Plane<3, N>>());
        });
        return gen::map(gen::pair(gen::suchThat(gen::arbitrary<Corners>(), span_a_plane), cuts),
                        [](const std::pair<Corners, Cuts>& drawn) {
                            const std::vector<cleave::Point<3, N>> corners(drawn.first.begin(), drawn.first.end());
                            cleave::Facet<3, N> f = *cleave::make_facet(corners);
                            for (const cleave::Plane<3, N>& h : drawn.second) {
                                cleave::Split<cleave::Facet<3, N>> s = cleave::split(h, f);
                                if (s.side == cleave::FacetSide::crossing) f = *s.minus;
                            }
                            return f;
                        });
    }
};

}  // namespace rc

#endif

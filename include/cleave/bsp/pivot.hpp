// SPDX-License-Identifier: Apache-2.0
/// Pivots: the choice of the plane that cuts a cell next. The choice never changes the set, only the tree.
///
/// A pivot is a small function object `pivot(model, facets, sides)` that returns an oriented plane for a cell whose
/// facets are `facets` (never empty). `sides` is scratch memory, empty on entry: a pivot that has worked out where each
/// facet lies with respect to its answer leaves those sides there, one a facet, and they are not computed again;
/// otherwise it leaves `sides` empty. All pivots here are deterministic: the same facets give the same plane.
///
/// | pivot                            | side tests a node | convex body of n facets | use                             |
/// |----------------------------------|-------------------|-------------------------|---------------------------------|
/// | `FirstFacet`                     | n                 | depth n                 | tests, tiny inputs              |
/// | `FewestSplits{k}`                | k n               | depth n                 | small trees for merging         |
/// | `Balanced{k, weight}`            | k n               | depth n                 | general input, point location   |
/// | `Structural{leaf_size, fallback}`| n, seldom more    | depth O(log n)          | many facets, convex pieces      |
///
/// No pivot that uses facet planes alone can balance a convex body: every facet lies inside every other's plane.
#ifndef CLEAVE_BSP_PIVOT_HPP
#define CLEAVE_BSP_PIVOT_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/concepts.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// How many facets go where if a cell is cut.
class SideCounts {
public:
    void add(FacetSide side, std::size_t facets = 1) noexcept { counts_[static_cast<std::size_t>(side)] += facets; }

    /// Facets on this side.
    [[nodiscard]] std::size_t operator[](FacetSide side) const noexcept {
        return counts_[static_cast<std::size_t>(side)];
    }
    /// Facets that the cut splits.
    [[nodiscard]] std::size_t crossing() const noexcept { return (*this)[FacetSide::crossing]; }
    /// Facets that lie in the cut.
    [[nodiscard]] std::size_t on() const noexcept {
        return (*this)[FacetSide::on_same] + (*this)[FacetSide::on_opposite];
    }
    /// Sizes of the two children's lists.
    [[nodiscard]] std::size_t to_minus() const noexcept { return (*this)[FacetSide::minus] + crossing(); }
    [[nodiscard]] std::size_t to_plus() const noexcept { return (*this)[FacetSide::plus] + crossing(); }

    friend bool operator==(const SideCounts&, const SideCounts&) = default;

private:
    std::array<std::size_t, 5> counts_{};  // by FacetSide
};

/// Where each facet of a list lies with respect to one plane, and how many lie where.
struct FacetSides {
    std::vector<FacetSide> list;  ///< one a facet, or empty: not known
    SideCounts counts;            ///< of `list`

    void clear() noexcept {
        list.clear();
        counts = {};
    }
};

/// Writes the side of each facet with respect to h into `sides`.
/// Cost: one side test a facet.
template <Clip M>
void find_sides(M& model, const typename M::plane_type& h, std::span<const typename M::facet_type> facets,
                FacetSides& sides) {
    sides.counts = {};
    sides.list.resize(facets.size());
    FacetSide* to = sides.list.data();
    for (const typename M::facet_type& f : facets) {
        const FacetSide side = model.side(h, f);
        *to++ = side;
        sides.counts.add(side);
    }
}

/// A pivot for the facets of the model M; see the head of this file.
/// Semantic demand: none for correctness. A plane that carries no facet and does not divide the facets is replaced by
/// the first facet's plane.
template <class P, class M>
concept PivotFor = Clip<M> &&
    requires(P& pivot, M& m, std::span<const typename M::facet_type> facets, FacetSides& sides) {
    { pivot(m, facets, sides) } -> std::convertible_to<typename M::plane_type>;
};

/// The plane of the first facet. The tree then follows the order of the input.
struct FirstFacet {
    template <Clip M>
    [[nodiscard]] typename M::plane_type operator()(M& model, std::span<const typename M::facet_type> facets,
                                                    FacetSides& /*sides*/) const {
        return model.plane_of(facets.front());
    }
};

namespace detail {

/// The best plane of at most `wanted` facets, spread evenly over the list. `cost(counts)` is compared by `<`, the
/// earliest of equals wins, and a cost of zero ends the search.
template <Clip M, class Cost>
typename M::plane_type best_facet_plane(M& model, std::span<const typename M::facet_type> facets, FacetSides& sides,
                                        std::size_t wanted, Cost&& cost) {
    const std::size_t n = facets.size();
    const std::size_t tries = std::clamp<std::size_t>(wanted, 1, n);
    if (tries == 1) return model.plane_of(facets.front());
    std::optional<typename M::plane_type> best;
    std::size_t best_cost = 0;
    FacetSides trial;
    for (std::size_t i = 0; i < tries; ++i) {
        const typename M::plane_type h = model.plane_of(facets[i * n / tries]);
        find_sides(model, h, facets, trial);
        const std::size_t c = cost(trial.counts);
        if (best && !(c < best_cost)) continue;
        best = h;
        best_cost = c;
        std::swap(sides, trial);
        if (c == 0) break;
    }
    return *std::move(best);
}

}  // namespace detail

/// Of `candidates` facets, the one whose plane splits the fewest others [Thibault-Naylor-1987].
struct FewestSplits {
    std::size_t candidates = 8;

    template <Clip M>
    [[nodiscard]] typename M::plane_type operator()(M& model, std::span<const typename M::facet_type> facets,
                                                    FacetSides& sides) const {
        return detail::best_facet_plane(model, facets, sides, candidates,
                                        [](const SideCounts& c) { return c.crossing(); });
    }
};

/// Of `candidates` facets, the one with the least `split_weight * splits + |facets inside - facets outside|`.
struct Balanced {
    std::size_t candidates = 8;
    std::size_t split_weight = 4;

    template <Clip M>
    [[nodiscard]] typename M::plane_type operator()(M& model, std::span<const typename M::facet_type> facets,
                                                    FacetSides& sides) const {
        return detail::best_facet_plane(model, facets, sides, candidates, [this](const SideCounts& c) {
            const std::size_t minus = c.to_minus();
            const std::size_t plus = c.to_plus();
            return split_weight * c.crossing() + std::max(minus, plus) - std::min(minus, plus);
        });
    }
};

/// A model that can turn a plane about a line: `m.planes_through(g, h)` are some planes through the line in which g and
/// h meet, none of them g or h (`clip/pencil.hpp` has them parallel to the axes); none where g and h are parallel.
// clang-format off
template <class M>
concept TurningClip = Clip<M> && requires(M& m, const typename M::plane_type& h) {
    { m.planes_through(h, h) } -> std::ranges::input_range;
    requires std::convertible_to<std::ranges::range_value_t<decltype(m.planes_through(h, h))>, typename M::plane_type>;
};
// clang-format on

/// While more than `leaf_size` facets remain, a plane that halves them, be there facets in it or not; the fall-back's
/// choice where there is none, and at the end. Two kinds of planes are tried:
///
/// 1. what the model proposes (an axis-parallel plane through a median, say);
/// 2. if that does not divide, for `turns` facets spread over the list the planes through their ridges that the model
///    can name (`TurningClip`). They divide what axis-parallel planes cannot: the facets round the apex of a cone.
///
/// A plane that sends m and p of n facets to its sides divides if 8 (m^2 + p^2) <= 7 n^2. Hence at most
/// log(n) / log(sqrt(8/7)), about 10 log2(n), such cuts lie above each other, and alone they never make more than n^2
/// pieces, however the facets lie: a bundle of long slivers that every proposal would split is left to the fall-back.
template <class Fallback = FewestSplits>
struct Structural {
    std::size_t leaf_size = 12;
    Fallback fallback = {};
    std::size_t turns = 8;

    template <ProposingClip M>
    requires PivotFor<const Fallback, M>
    [[nodiscard]] typename M::plane_type operator()(M& model, std::span<const typename M::facet_type> facets,
                                                    FacetSides& sides) const {
        if (facets.size() > leaf_size) {
            const std::size_t limit = 7 * facets.size() * facets.size();
            std::optional<typename M::plane_type> h = model.propose(facets);
            if (h) {
                find_sides(model, *h, facets, sides);
                if (cost(sides.counts) <= limit) return *std::move(h);
            }
            if constexpr (TurningClip<M>) {
                h = best_turn(model, facets);
                if (h) {
                    find_sides(model, *h, facets, sides);
                    if (cost(sides.counts) <= limit) return *std::move(h);
                }
            }
            sides.clear();
        }
        return fallback(model, facets, sides);
    }

private:
    /// Candidates are compared on about this many facets, so that a long list that nothing divides is not dear.
    static constexpr std::size_t sample_size = 256;

    /// 8 (m^2 + p^2), to be compared with 7 n^2.
    [[nodiscard]] static std::size_t cost(const SideCounts& c) {
        return 8 * (c.to_minus() * c.to_minus() + c.to_plus() * c.to_plus());
    }

    /// The plane through a ridge with the least m^2 + p^2, if it divides; a quarter to three quarters without splits is
    /// good enough to end the search.
    template <TurningClip M>
    [[nodiscard]] std::optional<typename M::plane_type> best_turn(
        M& model, std::span<const typename M::facet_type> facets) const {
        const std::size_t n = facets.size();
        const std::size_t stride = (n + sample_size - 1) / sample_size;
        const std::size_t sampled = (n + stride - 1) / stride;
        std::optional<typename M::plane_type> best;
        std::size_t best_cost = 7 * sampled * sampled + 1;
        for (std::size_t i = 0; i < turns && best_cost > 5 * sampled * sampled; ++i) {
            const typename M::facet_type& f = facets[i * n / turns];
            for (const typename M::plane_type& ridge : model.ridges(f)) {
                for (const typename M::plane_type& h : model.planes_through(model.plane_of(f), ridge)) {
                    SideCounts counts;
                    for (std::size_t k = 0; k < n; k += stride) counts.add(model.side(h, facets[k]));
                    if (cost(counts) >= best_cost) continue;
                    best = h;
                    best_cost = cost(counts);
                }
            }
        }
        return best;
    }
};

CLEAVE_END_NAMESPACE

#endif

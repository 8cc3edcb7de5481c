// SPDX-License-Identifier: Apache-2.0
/// A model of `Clip` supplies `split` or `clip`; here the other one is made of it.
///
/// `clip(m, h, f, side)` keeps the part of f on the minus or on the plus side of h, and nothing of a facet that lies in
/// h. A model with a member `clip` of its own is asked; any other is asked to split. The converse, for a model that
/// can only keep one side at a time, is `SplitByClips<M>`.
#ifndef CLEAVE_CLIP_DEFAULTS_HPP
#define CLEAVE_CLIP_DEFAULTS_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/coincident.hpp>
#include <cleave/clip/concepts.hpp>

#include <concepts>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

// clang-format off
/// A model that keeps one side of a facet: `m.clip(h, f, s)` is the part of f on the side s of h, nullopt where no
/// part of f is strictly on that side.
template <class M>
concept OneSidedClip = requires(M& m, const typename M::plane_type& h, const typename M::facet_type& f, Sign s) {
    { m.plane_of(f) } -> std::convertible_to<typename M::plane_type>;
    { m.relation(h, h) } -> std::same_as<PlaneRelation>;
    { m.clip(h, f, s) } -> std::convertible_to<std::optional<typename M::facet_type>>;
};
// clang-format on

/// The part of the facet strictly on one side of h, with its boundary.
/// Returns: nullopt where there is none; so a facet in h has neither part. Requires: `part` is minus or plus.
template <class M>
requires(OneSidedClip<M> || Clip<M>)
    [[nodiscard]] std::optional<typename M::facet_type> clip(M& m, const typename M::plane_type& h,
                                                             const typename M::facet_type& f, Sign part) {
    CLEAVE_REQUIRES(part != Sign::zero);
    if constexpr (OneSidedClip<M>) {
        return m.clip(h, f, part);
    } else {
        Split<typename M::facet_type> s = m.split(h, f);
        return part == Sign::minus ? s.minus : s.plus;
    }
}

/// All parts of the facet, from two one-sided cuts. Cost: two calls of `clip`, and one `relation` where both are empty.
template <OneSidedClip M>
[[nodiscard]] Split<typename M::facet_type> split_by_clips(M& m, const typename M::plane_type& h,
                                                           const typename M::facet_type& f) {
    Split<typename M::facet_type> result;
    result.minus = m.clip(h, f, Sign::minus);
    result.plus = m.clip(h, f, Sign::plus);
    if (result.minus && result.plus) return result;  // `side` is crossing from the start
    if (!result.minus && !result.plus) return unsplit(coincident_side(m.relation(h, m.plane_of(f))), f);
    result.side = result.minus ? FacetSide::minus : FacetSide::plus;
    return result;
}

/// A one-sided model completed to a model of `Clip`: it gains `split`, and `side` made of it.
template <OneSidedClip M>
class SplitByClips : public M {
public:
    using plane_type = typename M::plane_type;
    using facet_type = typename M::facet_type;
    using M::M;

    [[nodiscard]] Split<facet_type> split(const plane_type& h, const facet_type& f) {
        return split_by_clips(static_cast<M&>(*this), h, f);
    }
    [[nodiscard]] FacetSide side(const plane_type& h, const facet_type& f) { return split(h, f).side; }
};

CLEAVE_END_NAMESPACE

#endif

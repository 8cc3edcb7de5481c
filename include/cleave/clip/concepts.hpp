// SPDX-License-Identifier: Apache-2.0
/// The contract between geometry and binary space partitioning: `Clip` and its optional refinements.
///
/// A *model* is an object (it may carry tables, so it is passed by reference) that knows planes and facets.
/// Trees, boundary filtering and merging name nothing else: no dimension, no number.
///
/// | expression            | result           | meaning                                                     |
/// |-----------------------|------------------|-------------------------------------------------------------|
/// | `m.plane_of(f)`       | plane            | the oriented plane that carries the facet                   |
/// | `m.relation(h, g)`    | `PlaneRelation`  | crossing, same, opposite, parallel, antiparallel            |
/// | `m.side(h, f)`        | `FacetSide`      | where the facet lies with respect to the plane              |
/// | `m.split(h, f)`       | `Split<facet>`   | the parts of the facet on the minus side, on, and plus side |
/// | `m.flip(f)`           | facet            | the same set facing the other way                           |
/// | `m.flip_plane(h)`     | plane            | the same plane, other orientation                           |
/// | `m.ridges(f)`         | range of planes  | one plane through each ridge, the facet on its minus side   |
///
/// Semantic demands: all answers are exact; `side(h, f)` is `crossing` iff `split` gives both a minus and a plus part;
/// the parts of a split carry the facet's plane, meet only in the plane h, and together are the facet; `flip` is an
/// involution; a facet has non-empty interior relative to its plane.
#ifndef CLEAVE_CLIP_CONCEPTS_HPP
#define CLEAVE_CLIP_CONCEPTS_HPP

#include <cleave/geometry/plane_relation.hpp>
#include <cleave/number/sign.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <span>

CLEAVE_BEGIN_NAMESPACE

/// Where a facet lies with respect to an oriented plane h. minus/plus: in that closed half-space and not in h;
/// on_same/on_opposite: in h, co- or anti-oriented with it; crossing: its relative interior meets both open sides.
enum class FacetSide : std::uint8_t { minus, plus, on_same, on_opposite, crossing };

/// The parts of a split facet. Exactly one of `on` and (`minus`, `plus`) is populated; `side` says which.
template <class F>
struct Split {
    FacetSide side = FacetSide::crossing;
    std::optional<F> minus;
    std::optional<F> on;
    std::optional<F> plus;
};

/// The parts of a cut cell; all three are there if `side` is crossing, none otherwise.
template <class C, class F>
struct CellSplit {
    FacetSide side = FacetSide::crossing;
    std::optional<C> minus;
    std::optional<C> plus;
    std::optional<F> lid;
};

// clang-format off
/// See the table at the head of this file. Models may be stateful (split may create points), hence `M&`.
template <class M>
concept Clip = requires(M& m, const typename M::plane_type& h, const typename M::facet_type& f) {
    requires std::copyable<typename M::plane_type>;
    requires std::copyable<typename M::facet_type>;
    { m.plane_of(f) } -> std::convertible_to<typename M::plane_type>;
    { m.relation(h, h) } -> std::same_as<PlaneRelation>;
    { m.side(h, f) } -> std::same_as<FacetSide>;
    { m.split(h, f) } -> std::same_as<Split<typename M::facet_type>>;
    { m.flip(f) } -> std::convertible_to<typename M::facet_type>;
    { m.flip_plane(h) } -> std::convertible_to<typename M::plane_type>;
    { m.ridges(f) } -> std::ranges::input_range;
};

/// A model that can bound facets by boxes, so that far-away facets are told apart without exact work. Boxes are closed
/// and may be larger than the facet: `disjoint` may be answered false at will, true only when it is certain.
template <class M>
concept BoundedClip = Clip<M> && requires(M& m, const typename M::facet_type& f, const typename M::box_type& b) {
    { m.box(f) } -> std::convertible_to<typename M::box_type>;
    { m.hull(b, b) } -> std::convertible_to<typename M::box_type>;
    { m.disjoint(b, b) } -> std::convertible_to<bool>;
};

/// A model that can send single points down a tree.
template <class M>
concept LocatingClip = Clip<M> && requires(M& m, const typename M::facet_type& f, const typename M::plane_type& h,
                                           const typename M::point_type& p) {
    { m.witness(f) } -> std::convertible_to<typename M::point_type>;   // a point of the closed facet
    { m.side(h, p) } -> std::same_as<Sign>;
};

/// A model that proposes structural cuts: planes that need carry no facet, chosen to balance a tree (axis-parallel
/// planes through medians, say). nullopt where it knows none.
template <class M>
concept ProposingClip = Clip<M> && requires(M& m, std::span<const typename M::facet_type> facets) {
    { m.propose(facets) } -> std::convertible_to<std::optional<typename M::plane_type>>;
};

/// A model that knows convex cells, the sets that the branches of a tree stand for. `universe()` is all of space; a cell
/// always has an interior. `split_cell` cuts one: both parts and the *lid* between them, a facet that faces as the plane
/// does, or none of them where the cell lies on one side (it may touch the plane), as `cell_side` says.
template <class M>
concept CellClip = Clip<M> && requires(M& m, const typename M::plane_type& h, const typename M::cell_type& c) {
    requires std::movable<typename M::cell_type>;
    { m.universe() } -> std::same_as<typename M::cell_type>;
    { m.cell_side(h, c) } -> std::same_as<FacetSide>;   // minus, plus or crossing
    { m.split_cell(h, c) } -> std::same_as<CellSplit<typename M::cell_type, typename M::facet_type>>;
};
// clang-format on

CLEAVE_END_NAMESPACE

#endif

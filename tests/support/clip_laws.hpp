// SPDX-License-Identifier: Apache-2.0
/// The semantic demands of `Clip` and its refinements as checks that any model must pass, toy or real.
#ifndef CLEAVE_TESTS_SUPPORT_CLIP_LAWS_HPP
#define CLEAVE_TESTS_SUPPORT_CLIP_LAWS_HPP

#include "support/catch.hpp"

#include <cleave/clip/concepts.hpp>
#include <cleave/number/sign.hpp>

#include <cstddef>
#include <span>
#include <vector>

/// The side of the same facet after the plane has been flipped.
[[nodiscard]] inline cleave::FacetSide mirrored(cleave::FacetSide side) {
    using cleave::FacetSide;
    switch (side) {
        case FacetSide::minus:
            return FacetSide::plus;
        case FacetSide::plus:
            return FacetSide::minus;
        case FacetSide::on_same:
            return FacetSide::on_opposite;
        case FacetSide::on_opposite:
            return FacetSide::on_same;
        case FacetSide::crossing:
            return FacetSide::crossing;
    }
    return side;
}

/// The relation after the second plane has been flipped.
[[nodiscard]] inline cleave::PlaneRelation mirrored(cleave::PlaneRelation r) {
    using cleave::PlaneRelation;
    switch (r) {
        case PlaneRelation::crossing:
            return PlaneRelation::crossing;
        case PlaneRelation::same:
            return PlaneRelation::opposite;
        case PlaneRelation::opposite:
            return PlaneRelation::same;
        case PlaneRelation::parallel:
            return PlaneRelation::antiparallel;
        case PlaneRelation::antiparallel:
            return PlaneRelation::parallel;
    }
    return r;
}

/// Checks the laws for each plane, each facet and each pair of them. Splits are made, so a model that keeps tables
/// grows.
template <cleave::Clip M>
void check_clip_laws(M& m, const std::vector<typename M::facet_type>& facets,
                     const std::vector<typename M::plane_type>& planes) {
    using cleave::FacetSide;
    using cleave::PlaneRelation;
    using cleave::Sign;
    using F = typename M::facet_type;
    using H = typename M::plane_type;

    for (const H& h : planes) {
        CHECK(m.relation(h, h) == PlaneRelation::same);
        CHECK(m.relation(h, m.flip_plane(h)) == PlaneRelation::opposite);
        CHECK(m.relation(h, m.flip_plane(m.flip_plane(h))) == PlaneRelation::same);
        for (const H& g : planes) {
            CHECK(m.relation(h, g) == m.relation(g, h));
            CHECK(m.relation(h, m.flip_plane(g)) == mirrored(m.relation(h, g)));
        }
    }
    for (const F& f : facets) {
        const H own = m.plane_of(f);
        const F back = m.flip(f);
        CHECK(m.side(own, f) == FacetSide::on_same);
        CHECK(m.side(own, back) == FacetSide::on_opposite);
        CHECK(m.relation(own, m.plane_of(back)) == PlaneRelation::opposite);
        for (const H& e : m.ridges(f)) {
            CHECK(m.side(e, f) == FacetSide::minus);
            CHECK(m.relation(e, own) == PlaneRelation::crossing);
        }
        if constexpr (cleave::BoundedClip<M>) {
            CHECK_FALSE(m.disjoint(m.box(f), m.box(back)));
        }
        if constexpr (cleave::LocatingClip<M>) {
            CHECK(m.side(own, m.witness(f)) == Sign::zero);
            for (const H& e : m.ridges(f)) CHECK(m.side(e, m.witness(f)) != Sign::plus);
        }
        for (const H& h : planes) {
            const FacetSide side = m.side(h, f);
            CHECK(m.side(m.flip_plane(h), f) == mirrored(side));
            const bool on = side == FacetSide::on_same || side == FacetSide::on_opposite;
            CHECK(m.side(h, m.flip(f)) == (on ? mirrored(side) : side));
            CHECK(m.side(h, m.flip(m.flip(f))) == side);
            const PlaneRelation relation = m.relation(h, own);
            CHECK((side == FacetSide::on_same) == (relation == PlaneRelation::same));
            CHECK((side == FacetSide::on_opposite) == (relation == PlaneRelation::opposite));
            if constexpr (cleave::LocatingClip<M>) {
                const Sign s = m.side(h, m.witness(f));
                if (side == FacetSide::minus) CHECK(s != Sign::plus);
                if (side == FacetSide::plus) CHECK(s != Sign::minus);
                if (on) CHECK(s == Sign::zero);
            }

            const cleave::Split<F> split = m.split(h, f);
            CHECK(split.side == side);
            CHECK(split.minus.has_value() == (side == FacetSide::minus || side == FacetSide::crossing));
            CHECK(split.plus.has_value() == (side == FacetSide::plus || side == FacetSide::crossing));
            CHECK(split.on.has_value() == on);
            if (split.minus) CHECK(m.side(h, *split.minus) == FacetSide::minus);
            if (split.plus) CHECK(m.side(h, *split.plus) == FacetSide::plus);
            if (split.on) CHECK(m.side(h, *split.on) == side);
            if (side != FacetSide::crossing) continue;
            CHECK(m.relation(m.plane_of(*split.minus), own) == PlaneRelation::same);
            CHECK(m.relation(m.plane_of(*split.plus), own) == PlaneRelation::same);
            if constexpr (cleave::BoundedClip<M>) {
                CHECK_FALSE(m.disjoint(m.box(*split.minus), m.box(f)));
                CHECK_FALSE(m.disjoint(m.box(*split.plus), m.box(f)));
                CHECK_FALSE(m.disjoint(m.hull(m.box(*split.minus), m.box(*split.plus)), m.box(f)));
            }
            // Together the parts are the facet: every other plane sees of them what it sees of the whole.
            for (const H& g : planes) {
                const FacetSide a = m.side(g, *split.minus);
                const FacetSide b = m.side(g, *split.plus);
                CHECK(m.side(g, f) == (a == b ? a : FacetSide::crossing));
            }
        }
    }
    if constexpr (cleave::ProposingClip<M>) {
        if (!facets.empty()) {
            const std::optional<H> h = m.propose(std::span<const F>(facets));
            const std::optional<H> again = m.propose(std::span<const F>(facets));
            REQUIRE(h.has_value() == again.has_value());
            if (h) CHECK(m.relation(*h, *again) == PlaneRelation::same);
        }
    }
}

#endif

// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/defaults.hpp>

#include "support/catch.hpp"
#include "support/clip_laws.hpp"
#include "support/exact_types.hpp"
#include "support/facet_generators.hpp"

#include <cleave/clip/clip_model.hpp>

#include <optional>
#include <vector>

using namespace cleave;
using support::property;

namespace {

/// A model whose author wrote `clip` alone: Sutherland and Hodgman's polygon clipping, one side at a time.
struct ClipsPolygons {
    using plane_type = Plane<3, Integer>;
    using facet_type = Facet<3, Integer>;

    const plane_type& plane_of(const facet_type& f) const { return f.plane; }
    PlaneRelation relation(const plane_type& h, const plane_type& g) const { return cleave::relation(h, g); }
    facet_type flip(const facet_type& f) const { return cleave::flip(f); }
    plane_type flip_plane(const plane_type& h) const { return cleave::flip(h); }
    std::vector<plane_type> ridges(const facet_type& f) const { return cleave::ridges(f); }

    std::optional<facet_type> clip(const plane_type& h, const facet_type& f, Sign part) const {
        facet_type result{f.plane, {}};
        bool any = false;
        const std::size_t n = f.corners.size();
        for (std::size_t i = 0; i < n; ++i) {
            const auto& a = f.corners[i];
            const Sign here = side(h, a.point) * part;
            const Sign there = side(h, f.corners[(i + 1) % n].point) * part;
            const plane_type along = part == Sign::minus ? h : cleave::flip(h);
            any = any || here == Sign::plus;
            if (here == Sign::plus) result.corners.push_back(a);
            if (here == Sign::plus && there == Sign::minus)
                result.corners.push_back({*meet(f.plane, a.edge, h), along});
            if (here == Sign::minus && there == Sign::plus)
                result.corners.push_back({*meet(f.plane, a.edge, h), a.edge});
            if (here == Sign::zero) {
                const Sign before = side(h, f.corners[(i + n - 1) % n].point) * part;
                if (there != Sign::minus)
                    result.corners.push_back(a);
                else if (before != Sign::minus)
                    result.corners.push_back({a.point, along});
            }
        }
        if (!any) return std::nullopt;
        return result;
    }
};

static_assert(!Clip<ClipsPolygons>);
static_assert(OneSidedClip<ClipsPolygons>);
static_assert(Clip<SplitByClips<ClipsPolygons>>);
static_assert(!OneSidedClip<ClipModel<3, Integer>>);

}  // namespace

TEST_CASE("defaults: a model that splits can clip, and one that clips can split") {
    property("both models agree", [](const Facet<3, Integer>& f, const Plane<3, Integer>& h) {
        ClipModel<3, Integer> splits;
        SplitByClips<ClipsPolygons> clips;
        const auto a = splits.split(h, f);
        const auto b = clips.split(h, f);
        RC_ASSERT(a.side == b.side);
        RC_ASSERT(a.on == b.on);
        RC_ASSERT(a.minus.has_value() == b.minus.has_value());
        RC_ASSERT(a.plus.has_value() == b.plus.has_value());
        RC_ASSERT(clips.side(h, f) == splits.side(h, f));
        for (const Sign part : {Sign::minus, Sign::plus}) {
            const auto x = clip(splits, h, f, part);
            const auto y = clip(clips, h, f, part);
            RC_ASSERT(x.has_value() == y.has_value());
            RC_ASSERT(x == (part == Sign::minus ? a.minus : a.plus));
            if (!x) continue;
            RC_ASSERT(is_valid(*y));
            RC_ASSERT(x->corners.size() == y->corners.size());
            for (const auto& c : y->corners) {
                RC_ASSERT(std::find(x->corners.begin(), x->corners.end(), c) != x->corners.end());
            }
        }
    });
    property("the completed model obeys the laws",
             [](const Facet<3, Integer>& f, const Plane<3, Integer>& h, const Plane<3, Integer>& g) {
                 SplitByClips<ClipsPolygons> model;
                 check_clip_laws(model, {f}, {h, g, f.plane});
             });
}

TEST_CASE("defaults: no part is on both sides or on none") {
    ClipModel<3, Integer> model;
    const auto f = make_facet(std::vector<Point<3, Integer>>{make_point<Integer>(0, 0, 0), make_point<Integer>(1, 0, 0),
                                                             make_point<Integer>(0, 1, 0)});
    REQUIRE(f);
    CHECK_FALSE(clip(model, f->plane, *f, Sign::minus));
    CHECK_FALSE(clip(model, f->plane, *f, Sign::plus));
    CHECK_THROWS_AS(clip(model, f->plane, *f, Sign::zero), ContractViolation);
}

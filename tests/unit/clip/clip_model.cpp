// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/clip_model.hpp>

#include "support/catch.hpp"
#include "support/clip_laws.hpp"
#include "support/exact_types.hpp"
#include "support/facet_generators.hpp"
#include "support/facet_measure.hpp"

#include <cleave/clip/cut_face.hpp>
#include <cleave/clip/make_facet.hpp>

#include <span>
#include <vector>

using namespace cleave;
using support::property;

template <class M>
constexpr bool is_full_model = Clip<M>&& BoundedClip<M>&& LocatingClip<M>&& ProposingClip<M>;

static_assert(is_full_model<ClipModel<1, Integer>>);
static_assert(is_full_model<ClipModel<2, Integer>>);
static_assert(is_full_model<ClipModel<3, Integer>>);
static_assert(is_full_model<ClipModel<3, Rational>>);
static_assert(is_full_model<ClipModel<3, FixedInt<512>>>);
static_assert(is_full_model<ClipModel<2, archetype::Ring>>);
static_assert(is_full_model<ClipModel<3, archetype::Field>>);
static_assert(FaceClip<ClipModel<3, Integer>>);
static_assert(!FaceClip<ClipModel<2, Integer>>);

namespace {

/// The body of laws that every model passes, and the exact sizes that only real geometry has.
template <int D, class N>
void check_model() {
    using F = Facet<D, N>;
    using H = Plane<D, N>;
    property("the laws of Clip", [](const F& f, const F& g, const H& h, const H& k) {
        ClipModel<D, N> model;
        // Planes of the facets and their ridges are where the degenerate cases are.
        std::vector<H> planes{h, k, f.plane, flip(g.plane)};
        for (const H& e : ridges(g)) planes.push_back(e);
        check_clip_laws(model, {f, g}, planes);
    });
    property("parts are valid and their sizes add up", [](const F& f, const H& h, const F& g) {
        ClipModel<D, N> model;
        std::vector<H> planes{h, flip(h), g.plane};
        for (const H& e : ridges(g)) planes.push_back(e);
        for (const H& cut : planes) {
            const Split<F> s = model.split(cut, f);
            auto sum = fraction_of<N>(0);
            for (const auto& part : {s.minus, s.on, s.plus}) {
                if (!part) continue;
                RC_ASSERT(is_valid(*part));
                RC_ASSERT(projected_measure(*part) > 0);
                sum += projected_measure(*part);
            }
            RC_ASSERT(sum == projected_measure(f));
            for (const auto& part : {s.minus, s.plus}) {
                if (!part) continue;
                for (const Point<D, N>& p : vertices(*part)) {
                    RC_ASSERT(side(cut, p) != (part == s.minus ? Sign::plus : Sign::minus));
                }
            }
        }
    });
    property("boxes hold their facets", [](const F& f) {
        ClipModel<D, N> model;
        const Box<D, typename number_traits<N>::field_type> exact = exact_box_of(f);
        const Box<D> box = model.box(f);
        for (std::size_t i = 0; i < box.size; ++i) {
            RC_ASSERT(!(exact.lo[i] < Rational(box.lo[i])));
            RC_ASSERT(!(Rational(box.hi[i]) < exact.hi[i]));
        }
    });
}

}  // namespace

TEST_CASE("clip model: laws in D = 1") {
    check_model<1, Integer>();
}
TEST_CASE("clip model: laws in D = 2") {
    check_model<2, Integer>();
}
TEST_CASE("clip model: laws in D = 3") {
    check_model<3, Integer>();
}
TEST_CASE("clip model: laws in D = 1 over a field") {
    check_model<1, Rational>();
}
TEST_CASE("clip model: laws in D = 2 over a field") {
    check_model<2, Rational>();
}
TEST_CASE("clip model: laws in D = 3 over a field") {
    check_model<3, Rational>();
}

TEMPLATE_LIST_TEST_CASE("clip model: the same cut in every number type", "", RingAndField) {
    using N = TestType;
    ClipModel<3, N> model;
    const auto f =
        make_facet(std::vector<Point<3, N>>{make_point<N>(0, 0, 0), make_point<N>(3, 0, 1), make_point<N>(0, 3, 2)});
    REQUIRE(f);
    const auto s = model.split(make_plane<N>(2, 1, -1, -3), *f);
    REQUIRE(s.side == FacetSide::crossing);
    CHECK(is_valid(*s.minus));
    CHECK(is_valid(*s.plus));
    auto sum = projected_measure(*s.minus);
    sum += projected_measure(*s.plus);
    CHECK(sum == projected_measure(*f));
    CHECK(vertices(*s.plus).size() == 3);
    CHECK(model.box(*s.plus).hi[0] == 3.0);
}

TEMPLATE_LIST_TEST_CASE("clip model: proposals cut through a vertex, with vertices on both sides", "", RingAndField) {
    using N = TestType;
    ClipModel<2, N> model;
    std::vector<Facet<2, N>> facets;
    CHECK_FALSE(model.propose(facets));
    // A staircase, longest along x.
    for (int i = 0; i < 20; ++i) facets.push_back(*make_facet(make_point<N>(i, i / 2), make_point<N>(i + 1, i / 2)));
    const auto h = model.propose(facets);
    REQUIRE(h);
    std::size_t minus = 0;
    std::size_t plus = 0;
    for (const auto& f : facets) {
        const FacetSide s = model.side(*h, f);
        CHECK(s != FacetSide::crossing);
        minus += s == FacetSide::minus ? 1 : 0;
        plus += s == FacetSide::plus ? 1 : 0;
    }
    CHECK(minus == 10);
    CHECK(plus == 10);
    // A box has vertices at two positions of each axis only.
    const auto bottom = *make_facet(make_point<N>(0, 0), make_point<N>(5, 0));
    const auto right = *make_facet(make_point<N>(5, 0), make_point<N>(5, 1));
    CHECK_FALSE(model.propose(std::vector<Facet<2, N>>{bottom, right}));
    // Many vertices at one end: the plane moves to the next position.
    std::vector<Facet<2, N>> fan(9, *make_facet(make_point<N>(0, 0), make_point<N>(0, 1)));
    fan.push_back(*make_facet(make_point<N>(7, 0), make_point<N>(9, 1)));
    CHECK(model.propose(fan) == make_plane<N>(1, 0, -7));
    for (auto& f : fan) f = *make_facet(make_point<N>(9, 0), make_point<N>(9, 1));
    fan.push_back(*make_facet(make_point<N>(0, 0), make_point<N>(2, 1)));
    CHECK(model.propose(fan) == make_plane<N>(1, 0, -2));
}

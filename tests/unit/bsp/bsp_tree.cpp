// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/bsp_tree.hpp>

#include "support/catch.hpp"

#include <cleave/bsp/build.hpp>
#include <cleave/bsp/classify.hpp>
#include <cleave/clip/clip_model.hpp>
#include <cleave/clip/make_facet.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/rational.hpp>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using cleave::BspTree;
using cleave::Integer;
using cleave::Location;
using cleave::Rational;

static_assert(std::is_same_v<BspTree<3, Integer>, cleave::PlaneTree<cleave::Plane<3, Integer>, bool>>);
static_assert(std::is_same_v<BspTree<2, Rational, std::string>::label_type, std::string>);
static_assert(std::is_same_v<BspTree<2, Rational>::plane_type, cleave::ClipModel<2, Rational>::plane_type>);

}  // namespace

TEST_CASE("bsp tree: a triangle over the rationals") {
    // (0,0), (2,0), (0,1/2), counter-clockwise.
    using Point = cleave::Point<2, Rational>;
    // [build]
    const std::vector<Point> corners{cleave::make_point<Rational>(0, 0), cleave::make_point<Rational>(2, 0),
                                     cleave::make_point<Rational>(0, Rational(1, 2))};
    std::vector<cleave::Facet<2, Rational>> facets;
    for (std::size_t i = 0; i < 3; ++i) facets.push_back(*cleave::make_facet(corners[i], corners[(i + 1) % 3]));
    cleave::ClipModel<2, Rational> model;
    const BspTree<2, Rational> t = cleave::build(model, std::move(facets));
    const Location where = cleave::classify(model, t, cleave::make_point<Rational>(1, Rational(1, 4)));  // boundary
    // [/build]
    CHECK(where == Location::boundary);
    const auto at = [&](const Rational& x, const Rational& y) {
        return cleave::classify(model, t, cleave::make_point<Rational>(x, y));
    };
    CHECK(t.node_count() == 3);
    CHECK(at(Rational(1, 2), Rational(1, 4)) == Location::inside);
    CHECK(at(1, Rational(1, 4)) == Location::boundary);
    CHECK(at(0, Rational(1, 3)) == Location::boundary);
    CHECK(at(2, 0) == Location::boundary);
    CHECK(at(1, Rational(2501, 10000)) == Location::outside);
    CHECK(at(-1, 0) == Location::outside);
    CHECK(at(3, 0) == Location::outside);
}

TEST_CASE("bsp tree: trees made by hand carry any label") {
    const cleave::Plane<1, Integer> zero = cleave::make_plane<Integer>(1, 0);
    using Tree = BspTree<1, Integer, std::string>;
    const Tree t(zero, Tree("below"), Tree("above"));
    cleave::ClipModel<1, Integer> model;
    std::string seen;
    cleave::visit_leaves_at(model, t, cleave::make_point<Integer>(0), [&](cleave::Branch b) { seen += t.label(b); });
    CHECK(seen == "belowabove");
    // Planes are compared, not coefficients.
    CHECK(t == Tree(cleave::make_plane<Integer>(7, 0), Tree("below"), Tree("above")));
    CHECK(t != Tree(cleave::make_plane<Integer>(-7, 0), Tree("below"), Tree("above")));
}

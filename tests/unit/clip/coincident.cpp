// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/coincident.hpp>

#include "support/catch.hpp"

#include <initializer_list>

using namespace cleave;

TEST_CASE("coincident: a facet in the cutting plane is on_same or on_opposite, on neither side") {
    CHECK(coincident_side(PlaneRelation::same) == FacetSide::on_same);
    CHECK(coincident_side(PlaneRelation::opposite) == FacetSide::on_opposite);
    CHECK_THROWS_AS(coincident_side(PlaneRelation::parallel), ContractViolation);
    CHECK(is_on(FacetSide::on_same));
    CHECK(is_on(FacetSide::on_opposite));
    CHECK_FALSE(is_on(FacetSide::minus));
    CHECK_FALSE(is_on(FacetSide::plus));
    CHECK_FALSE(is_on(FacetSide::crossing));
}

TEST_CASE("coincident: signs of vertices add up to a side") {
    const auto side_of = [](std::initializer_list<Sign> signs) {
        VertexSigns all;
        for (const Sign s : signs) all.add(s);
        return all.side();
    };
    CHECK(side_of({Sign::zero, Sign::minus, Sign::zero}) == FacetSide::minus);
    CHECK(side_of({Sign::plus, Sign::plus}) == FacetSide::plus);
    CHECK(side_of({Sign::plus, Sign::zero, Sign::minus}) == FacetSide::crossing);
    VertexSigns zeros;
    CHECK(zeros.all_zero());
    zeros.add(Sign::zero);
    CHECK(zeros.all_zero());
    CHECK_THROWS_AS(zeros.side(), ContractViolation);
    zeros.add(Sign::plus);
    CHECK_FALSE(zeros.all_zero());
}

TEST_CASE("coincident: a facet that is not crossed is one of the parts") {
    const Split<int> minus = unsplit(FacetSide::minus, 7);
    CHECK(minus.side == FacetSide::minus);
    CHECK(minus.minus == 7);
    CHECK_FALSE(minus.on);
    CHECK_FALSE(minus.plus);
    const Split<int> plus = unsplit(FacetSide::plus, 7);
    CHECK(plus.plus == 7);
    CHECK_FALSE(plus.minus);
    const Split<int> on = unsplit(FacetSide::on_opposite, 7);
    CHECK(on.side == FacetSide::on_opposite);
    CHECK(on.on == 7);
    CHECK_FALSE(on.minus);
    CHECK_FALSE(on.plus);
    CHECK_THROWS_AS(unsplit(FacetSide::crossing, 7), ContractViolation);
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/plane_relation.hpp>

#include "support/catch.hpp"

using namespace cleave;

TEST_CASE("plane relation: flipping a plane exchanges same with opposite and parallel with antiparallel") {
    CHECK(flip(PlaneRelation::crossing) == PlaneRelation::crossing);
    CHECK(flip(PlaneRelation::same) == PlaneRelation::opposite);
    CHECK(flip(PlaneRelation::opposite) == PlaneRelation::same);
    CHECK(flip(PlaneRelation::parallel) == PlaneRelation::antiparallel);
    CHECK(flip(PlaneRelation::antiparallel) == PlaneRelation::parallel);
}

TEST_CASE("plane relation: coincident planes are one set") {
    CHECK(is_coincident(PlaneRelation::same));
    CHECK(is_coincident(PlaneRelation::opposite));
    CHECK_FALSE(is_coincident(PlaneRelation::crossing));
    CHECK_FALSE(is_coincident(PlaneRelation::parallel));
    CHECK_FALSE(is_coincident(PlaneRelation::antiparallel));
}

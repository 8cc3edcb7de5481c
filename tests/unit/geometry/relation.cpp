// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/relation.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/algebra/echelon.hpp>
#include <cleave/geometry/side.hpp>

#include <array>
#include <vector>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("relation: all five answers in D = 1, 2, 3", "", ExactTypes) {
    using N = TestType;
    CHECK(relation(make_plane<N>(1, -1), make_plane<N>(2, -2)) == PlaneRelation::same);
    CHECK(relation(make_plane<N>(1, -1), make_plane<N>(-2, 2)) == PlaneRelation::opposite);
    CHECK(relation(make_plane<N>(1, -1), make_plane<N>(1, -2)) == PlaneRelation::parallel);
    CHECK(relation(make_plane<N>(1, -1), make_plane<N>(-1, -2)) == PlaneRelation::antiparallel);
    CHECK(relation(make_plane<N>(1, 2, 3), make_plane<N>(2, 1, 3)) == PlaneRelation::crossing);
    CHECK(relation(make_plane<N>(1, 2, 3), make_plane<N>(3, 6, 9)) == PlaneRelation::same);
    CHECK(relation(make_plane<N>(1, 2, 3), make_plane<N>(-3, -6, -9)) == PlaneRelation::opposite);
    CHECK(relation(make_plane<N>(1, 2, 0, 3), make_plane<N>(2, 4, 0, 7)) == PlaneRelation::parallel);
    CHECK(relation(make_plane<N>(1, 2, 0, 3), make_plane<N>(-2, -4, 0, 7)) == PlaneRelation::antiparallel);
    CHECK(relation(make_plane<N>(1, 2, 0, 3), make_plane<N>(1, 2, 1, 3)) == PlaneRelation::crossing);
}

TEMPLATE_LIST_TEST_CASE("relation: A-T11, offsets say nothing about orientation", "", ExactTypes) {
    using N = TestType;
    // x = 1 and x = -1 with equal normals: the product of the offsets is negative.
    CHECK(relation(make_plane<N>(1, 0, 0, -1), make_plane<N>(1, 0, 0, 1)) == PlaneRelation::parallel);
    CHECK(relation(make_plane<N>(1, 0, 0, -1), make_plane<N>(-1, 0, 0, -1)) == PlaneRelation::antiparallel);
}

TEMPLATE_LIST_TEST_CASE("relation: A-T11, zero offsets and zero components", "", ExactTypes) {
    using N = TestType;
    // x = 0 and y = 0 have equal (zero) offsets and are not coincident.
    CHECK(relation(make_plane<N>(1, 0, 0, 0), make_plane<N>(0, 1, 0, 0)) == PlaneRelation::crossing);
    CHECK(relation(make_plane<N>(1, 0, 0, 0), make_plane<N>(2, 0, 0, 0)) == PlaneRelation::same);
    CHECK(relation(make_plane<N>(0, 1, 0, 0), make_plane<N>(0, -3, 0, 0)) == PlaneRelation::opposite);
    CHECK(relation(make_plane<N>(0, 1, 0, 0), make_plane<N>(0, 1, 0, 1)) == PlaneRelation::parallel);
    CHECK(relation(make_plane<N>(0, 1, 0, 0), make_plane<N>(0, -1, 0, 1)) == PlaneRelation::antiparallel);
    CHECK(relation(make_plane<N>(0, 1, 1, 0), make_plane<N>(0, 1, 0, 0)) == PlaneRelation::crossing);
}

TEST_CASE("relation: A-T11, the zero vector, collinear with everything, is not a plane") {
    CHECK_THROWS_AS(relation(make_plane<Integer>(0, 0, 0, 0), make_plane<Integer>(1, 0, 0, 0)), ContractViolation);
    CHECK_THROWS_AS(relation(make_plane<Integer>(0, 0, 0, 1), make_plane<Integer>(1, 0, 0, 0)), ContractViolation);
}

namespace {

/// The definition: rank one means proportional, and proportional planes are compared entry by entry.
template <int D, class N>
PlaneRelation relation_by_rank(const Plane<D, N>& h, const Plane<D, N>& g) {
    if (rank(rows_of(h.normal(), g.normal())) == 2) return PlaneRelation::crossing;
    const bool coincident = rank(rows_of(h.coefficients(), g.coefficients())) == 1;
    const N scalar(dot(h.normal(), g.normal()));
    if (number_traits<N>::sign(scalar) == Sign::plus) return coincident ? PlaneRelation::same : PlaneRelation::parallel;
    return coincident ? PlaneRelation::opposite : PlaneRelation::antiparallel;
}

template <int D>
void check_relation() {
    property("it agrees with ranks, and with flips", [](const Plane<D, Integer>& h, const Plane<D, Integer>& g) {
        const PlaneRelation r = relation(h, g);
        RC_ASSERT(r == relation_by_rank(h, g));
        RC_ASSERT(r == relation(g, h));
        RC_ASSERT(relation(h, flip(g)) == flip(r));
        RC_ASSERT((r == PlaneRelation::same) == (h == g));
    });
    property("scaled and shifted planes", [](const Plane<D, Integer>& h, int shift) {
        const int factor = std::array{1, 2, -1, -3}[support::draw_index(4)];
        typename Plane<D, Integer>::Coefficients c = scale(Integer(factor), h.coefficients());
        c[D] += Integer(shift % 3);
        const PlaneRelation positive = shift % 3 == 0 ? PlaneRelation::same : PlaneRelation::parallel;
        RC_ASSERT(relation(h, Plane<D, Integer>(c)) == (factor > 0 ? positive : flip(positive)));
    });
}

}  // namespace

TEST_CASE("relation: agrees with its definition for D = 1") {
    check_relation<1>();
}
TEST_CASE("relation: agrees with its definition for D = 2") {
    check_relation<2>();
}
TEST_CASE("relation: agrees with its definition for D = 3") {
    check_relation<3>();
}
TEST_CASE("relation: agrees with its definition for D = 4") {
    check_relation<4>();
}
TEST_CASE("relation: agrees with its definition for D = 5") {
    check_relation<5>();
}

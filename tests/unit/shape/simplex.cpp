// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <algorithm>

using namespace cleave;
using namespace support;

TEST_CASE("simplex: a segment, a triangle, a tetrahedron") {
    CHECK(ExactRegion<1>(verified(simplex<1>({{3}, {1}}))).measure() == 2);
    const Region<2> t = verified(simplex<2>({{0, 0}, {1, 0}, {0, 1}}));
    CHECK(t.face_count() == 3);
    CHECK(ExactRegion<2>(t).measure() == Rational(1, 2));
    const Region<3> s = verified(simplex<3>({{1, 2, 3}, {2, 2, 4}, {2, 3, 3}, {1, 3, 4}}));
    CHECK(s.face_count() == 4);
    CHECK(ExactRegion<3>(s).measure() == Rational(1, 3));
    CHECK(ExactRegion<3>(s).centroid() == Coordinates<3>{Rational(3, 2), Rational(5, 2), Rational(7, 2)});
}

TEST_CASE("simplex: vertices in every order give the same set") {
    std::array<Coordinates<3>, 4> v = {{{0, 0, 0}, {3, 0, 1}, {1, 2, 0}, {0, 1, 4}}};
    const Region<3> first = simplex<3>(v);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    do {
        const Region<3> s = verified(simplex<3>(std::array{v[order[0]], v[order[1]], v[order[2]], v[order[3]]}));
        CHECK(equal_sets(s, first));
    } while (std::next_permutation(order.begin(), order.end()));
    CHECK(equal_sets(verified(simplex<2>({{0, 0}, {0, 2}, {1, 0}})), simplex<2>({{0, 0}, {1, 0}, {0, 2}})));
}

TEST_CASE("simplex: vertices in one plane, on one line or in one point give the empty set") {
    CHECK(simplex<1>({{1}, {1}}).is_empty());
    CHECK(simplex<2>({{0, 0}, {1, 1}, {3, 3}}).is_empty());
    CHECK(simplex<2>({{2, 2}, {2, 2}, {3, 3}}).is_empty());
    CHECK(simplex<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}}).is_empty());
    CHECK(simplex<3>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 7, 0}}).is_empty());
    CHECK(simplex<3>({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).is_empty());
}

TEST_CASE("simplex: a volume of one part in 2^159 is not nothing") {
    const Region<3, double> thin = verified(simplex<3>(
        std::array<std::array<double, 3>, 4>{{{0, 0, 0}, {0x1p-53, 0, 0}, {0, 0x1p-53, 0}, {1, 1, 0x1p-53}}}));
    CHECK(!thin.is_empty());
    CHECK(Rational(ExactRegion<3>(thin).measure() * 6) == number_traits<Rational>::from_double(0x1p-159));
}

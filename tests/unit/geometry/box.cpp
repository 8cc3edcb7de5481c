// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/box.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <array>
#include <limits>

using namespace cleave;

namespace {

template <class B>
B box2(int x0, int y0, int x1, int y1) {
    using T = typename decltype(B::lo)::value_type;
    return B({T(x0), T(y0)}, {T(x1), T(y1)});
}

}  // namespace

TEMPLATE_TEST_CASE("box: empty, containing, hull, common and disjoint", "", (Box<2>), (Box<2, Rational>)) {
    using B = TestType;
    const B none;
    const B a = box2<B>(0, 0, 2, 2);
    const B b = box2<B>(1, 1, 3, 3);
    const B touching = box2<B>(2, 0, 4, 2);
    const B far = box2<B>(5, 0, 6, 2);

    CHECK(none.is_empty());
    CHECK_FALSE(a.is_empty());
    CHECK(box2<B>(1, 0, 0, 2).is_empty());
    CHECK(box2<B>(1, 0, 0, 2) == none);
    CHECK_FALSE(a == none);

    CHECK(hull(none, a) == a);
    CHECK(hull(a, none) == a);
    CHECK(hull(none, none) == none);
    CHECK(hull(a, b) == box2<B>(0, 0, 3, 3));
    CHECK(hull(a, far) == box2<B>(0, 0, 6, 2));

    CHECK(common(a, b) == box2<B>(1, 1, 2, 2));
    CHECK(common(a, touching) == box2<B>(2, 0, 2, 2));
    CHECK_FALSE(common(a, touching).is_empty());
    CHECK(common(a, far) == none);
    CHECK(common(a, none) == none);

    CHECK_FALSE(disjoint(a, b));
    CHECK_FALSE(disjoint(a, touching));
    CHECK(disjoint(a, far));
    CHECK(disjoint(a, none));
    CHECK(disjoint(none, none));

    CHECK(a.contains(a));
    CHECK(a.contains(none));
    CHECK_FALSE(none.contains(a));
    CHECK_FALSE(a.contains(b));
    CHECK(hull(a, b).contains(b));
    CHECK(a.contains(a.hi));
    CHECK_FALSE(a.contains(b.hi));

    CHECK(longest_axis(box2<B>(0, 0, 2, 3)) == 1);
    CHECK(longest_axis(a) == 0);
    CHECK_THROWS_AS(longest_axis(none), ContractViolation);
}

TEST_CASE("box: a box of doubles may be unbounded") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Box<1> half({0.0}, {infinity});
    const Box<1> all({-infinity}, {infinity});
    CHECK_FALSE(half.is_empty());
    CHECK(all.contains(half));
    CHECK_FALSE(half.contains(all));
    CHECK(disjoint(half, Box<1>({-2.0}, {-1.0})));
    CHECK(disjoint(all, Box<1>()));
    CHECK(hull(half, Box<1>({-2.0}, {-1.0})) == Box<1>({-2.0}, {infinity}));
}

TEST_CASE("box: of points") {
    Box<3> box;
    box.extend(std::array<double, 3>{1, 2, 3});
    CHECK(box == Box<3>(std::array<double, 3>{1, 2, 3}));
    box.extend(std::array<double, 3>{0, 5, 3});
    CHECK(box == Box<3>({0, 2, 3}, {1, 5, 3}));
}

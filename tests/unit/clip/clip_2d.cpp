// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/clip_2d.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <cleave/clip/make_facet.hpp>

#include <optional>

using namespace cleave;

namespace {

template <class N>
Facet<2, N> segment(int x0, int y0, int x1, int y1) {
    return *make_facet(make_point<N>(x0, y0), make_point<N>(x1, y1));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("clip 2d: the nine pairs of signs", "", RingAndField) {
    using N = TestType;
    const Plane<2, N> h = make_plane<N>(0, 1, 0);  // y <= 0 is inside
    // x grows with the sign of the end, so that no two segments are alike; y is the sign of the end point.
    const auto f = [](int begin, int end) { return segment<N>(-1, begin, 1, end); };
    const auto check_whole = [&](int begin, int end, FacetSide expected) {
        const auto s = split(h, f(begin, end));
        CHECK(side(h, f(begin, end)) == expected);
        CHECK(s.side == expected);
        CHECK(s.minus == (expected == FacetSide::minus ? std::optional(f(begin, end)) : std::nullopt));
        CHECK(s.plus == (expected == FacetSide::plus ? std::optional(f(begin, end)) : std::nullopt));
        CHECK(s.on == (expected == FacetSide::on_opposite ? std::optional(f(begin, end)) : std::nullopt));
    };
    check_whole(-1, -1, FacetSide::minus);
    check_whole(-1, 0, FacetSide::minus);
    check_whole(0, -1, FacetSide::minus);
    check_whole(0, 0, FacetSide::on_opposite);  // rightward along the x-axis: outside is below
    check_whole(0, 1, FacetSide::plus);
    check_whole(1, 0, FacetSide::plus);
    check_whole(1, 1, FacetSide::plus);
    const Point<2, N> x = make_point<N>(0, 0);
    const auto up = split(h, f(-1, 1));
    CHECK(up.side == FacetSide::crossing);
    CHECK(up.minus == Facet<2, N>{f(-1, 1).plane, make_point<N>(-1, -1), x});
    CHECK(up.plus == Facet<2, N>{f(-1, 1).plane, x, make_point<N>(1, 1)});
    CHECK_FALSE(up.on);
    const auto down = split(h, f(1, -1));
    CHECK(down.side == FacetSide::crossing);
    CHECK(down.minus == Facet<2, N>{f(1, -1).plane, x, make_point<N>(1, -1)});
    CHECK(down.plus == Facet<2, N>{f(1, -1).plane, make_point<N>(-1, 1), x});
    CHECK(side(h, segment<N>(3, 0, -3, 0)) == FacetSide::on_same);
}

TEST_CASE("clip 2d: a vertex is the meet of two given lines however often the facet was cut") {
    // Shortened from both ends a thousand times, alternately; bits stay those of one meet.
    Facet<2, Integer> f = segment<Integer>(0, 0, 1 << 20, 12345);
    std::size_t bits = 0;
    for (int i = 1; i <= 500; ++i) {
        f = *split(make_plane<Integer>(-1, 3, i), f).minus;             // keeps x >= 3 y + i
        f = *split(make_plane<Integer>(1, 2, i - (1 << 20)), f).minus;  // keeps x + 2 y <= 2^20 - i
        REQUIRE(is_valid(f));
        for (const Point<2, Integer>& p : vertices(f)) {
            for (const Integer& x : p.homogeneous()) bits = std::max(bits, x.bit_length());
        }
    }
    CHECK(bits <= 2 * 35 + 1);  // the facet's own line has 35 bits, the cuts have 21
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/transform.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

using namespace cleave;
using namespace support;

namespace {

/// x_0 -> -x_0.
template <int D>
AffineMap<D, Integer> mirror() {
    Matrix<D + 1, D + 1, Integer> m = identity_matrix<D + 1, Integer>();
    m(0, 0) = Integer(-1);
    return AffineMap<D, Integer>(std::move(m));
}

/// The region after a map, checked; and the same after the way by its tree and after the inverse map.
template <int D, class M>
Region<D> image_of(const AffineMap<D, M>& map, const Region<D>& region) {
    const Region<D> mapped = transform(map, region);
    if constexpr (D <= 3) {
        if (mapped.is_bounded()) verified(mapped);
    }
    CHECK(canonical(transform(*inverse(map), mapped)) == canonical(region));
    CHECK(canonical(~transform(map, ~region)) == canonical(mapped));
    CHECK(mapped.face_count() == region.face_count());
    return mapped;
}

}  // namespace

TEST_CASE("transform: a box is moved, stretched and mirrored") {
    const Region<1> segment = box<1>({1}, {3});
    CHECK(canonical(image_of(mirror<1>(), segment)) == canonical(box<1>({-3}, {-1})));
    CHECK(canonical(image_of(scaling<Rational>(Rational(-1, 3)), segment)) ==
          canonical(box<1>({-1}, {Rational(-1, 3)})));
    const Region<2> plate = box<2>({1, 0}, {3, 1});
    CHECK(canonical(image_of(mirror<2>(), plate)) == canonical(box<2>({-3, 0}, {-1, 1})));
    CHECK(canonical(image_of(rational_rotation<2, Integer>(0, 1, 1, 1), plate)) == canonical(box<2>({-1, 1}, {0, 3})));
    const Region<3> brick = box<3>({1, 0, 0}, {3, 1, 2});
    CHECK(canonical(image_of(mirror<3>(), brick)) == canonical(box<3>({-3, 0, 0}, {-1, 1, 2})));
    const auto moved = compose(translation<Rational>(1, Rational(1, 3), 0), scaling<Rational>(2, 1, -1));
    CHECK(canonical(image_of(moved, brick)) == canonical(box<3>({3, Rational(1, 3), -2}, {7, Rational(4, 3), 0})));
    const Region<4> cell = box<4>({1, 0, 0, 0}, {3, 1, 2, 1});
    CHECK(canonical(image_of(mirror<4>(), cell)) == canonical(box<4>({-3, 0, 0, 0}, {-1, 1, 2, 1})));
    const Region<5> five = box<5>({1, 0, 0, 0, 0}, {3, 1, 2, 1, 1});
    CHECK(canonical(image_of(mirror<5>(), five)) == canonical(box<5>({-3, 0, 0, 0, 0}, {-1, 1, 2, 1, 1})));
}

TEST_CASE("transform: the image of a simplex is the simplex of the images") {
    const std::array<std::array<Rational, 3>, 4> corners{
        {{0, 0, 0}, {Rational(1, 3), 0, 1}, {0, 2, Rational(1, 7)}, {5, 1, 1}}};
    for (const int mirrored : {1, -1}) {
        Matrix<4, 4, Rational> m = identity_matrix<4, Rational>();
        m(0, 0) = mirrored;
        m(0, 1) = Rational(1, 2);
        m(1, 2) = 3;
        m(2, 0) = -2;
        m(0, 3) = Rational(1, 5);
        m(3, 3) = 2;
        const AffineMap<3, Rational> map(m);
        CHECK(map.orientation() != Sign::zero);
        std::array<std::array<Rational, 3>, 4> images = corners;
        for (std::size_t c = 0; c < 4; ++c)
            for (int i = 0; i < 3; ++i) {
                Rational x = m(i, 3);
                for (int j = 0; j < 3; ++j) x += m(i, j) * corners[c][std::size_t(j)];
                images[c][std::size_t(i)] = x / 2;
            }
        CHECK(canonical(image_of(map, simplex<3>(corners))) == canonical(simplex<3>(images)));
    }
}

TEST_CASE("transform: results of operations, whose points are meets, with holes and cavities") {
    const Region<2> frame = box<2>({0, 0}, {3, 3}) - simplex<2>({{{1, 1}, {2, 1}, {Rational(4, 3), 2}}});
    const auto turn = rational_rotation<2, Integer>(0, 1, 2, 1);
    const Region<2> turned = image_of(compose(turn, mirror<2>()), frame);
    CHECK(measure(turned) == measure(frame));
    const Region<3> shell = (box<3>({0, 0, 0}, {4, 4, 4}) - box<3>({1, 1, 1}, {2, 2, 2})) -
                            simplex<3>({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 5}}});
    const auto map = compose(rational_rotation<3, Integer>(0, 2, 3, 1), mirror<3>());
    CHECK(measure(image_of(map, shell)) == measure(shell));
    CHECK(measure(image_of(scaling<Integer>(2, -3, 5), shell)) == Rational(30 * *measure(shell)));
}

TEST_CASE("transform: unbounded sets") {
    // A half-line has one end, and its two infinities differ.
    const Region<1> ray = half_space(make_plane<Integer>(-1, 2));  // x >= 2
    const Region<1> mirrored = image_of(mirror<1>(), ray);
    CHECK(canonical(mirrored) == canonical(half_space(make_plane<Integer>(1, 2))));
    CHECK(canonical(image_of(translation<Integer>(3), ray)) == canonical(half_space(make_plane<Integer>(-1, 5))));

    CHECK(canonical(image_of(mirror<2>(), half_space(make_plane<Integer>(1, 1, -1)))) ==
          canonical(half_space(make_plane<Integer>(-1, 1, -1))));
    const std::vector<Plane<3, Integer>> wedge{make_plane<Integer>(1, 2, 0, -1), make_plane<Integer>(-1, 0, 1, 0)};
    const std::vector<Plane<3, Integer>> other{make_plane<Integer>(-1, 2, 0, -1), make_plane<Integer>(1, 0, 1, 0)};
    CHECK(canonical(image_of(mirror<3>(), half_spaces<3, Integer>(wedge))) ==
          canonical(half_spaces<3, Integer>(other)));
    const Region<3> notched = half_spaces<3, Integer>(wedge) - box<3>({-1, -1, -1}, {1, 1, 1});
    const auto turn = rational_rotation<3, Integer>(1, 2, 2, 1);
    CHECK(canonical(transform(turn, notched)) == canonical(transform(turn, half_spaces<3, Integer>(wedge)) -
                                                           transform(turn, box<3>({-1, -1, -1}, {1, 1, 1}))));
    const Region<4> slab =
        half_space(make_plane<Integer>(1, 0, 0, 0, -1)) - half_space(make_plane<Integer>(1, 0, 0, 0, 1));
    CHECK(canonical(image_of(mirror<4>(), slab)) == canonical(slab));
}

TEST_CASE("transform: empty and full stay what they are") {
    CHECK(transform(mirror<3>(), Region<3>::empty()).is_empty());
    CHECK(transform(mirror<3>(), Region<3>::full()).is_full());
    CHECK(transform(scaling<Rational>(Rational(1, 2)), Region<1>::full()).is_full());
}

TEST_CASE("transform: a singular map is refused") {
    const Region<2> a = box<2>({0, 0}, {1, 1});
    CHECK_THROWS_AS(transform(scaling<Integer>(1, 0), a), ShapeError);
    CHECK_THROWS_WITH(transform(scaling<Integer>(1, 0), a),
                      "the map is singular, so images have no interior: use a map with a determinant other than 0");
    CHECK_THROWS_AS(transform(scaling<Integer>(0, 0), half_space(make_plane<Integer>(1, 1, 0))), ShapeError);
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/measure_terms.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/simplex.hpp>

#include <array>
#include <cstddef>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The terms of a region in a kernel that holds other planes and points as well.
template <int D>
std::vector<Fraction> terms(const Region<D>& region) {
    Kernel<D> kernel;
    std::array<double, std::size_t(D)> elsewhere{};
    elsewhere.fill(99);
    (void)kernel.add_point(elsewhere);
    (void)kernel.planes.intern_axis_plane(0, 99);
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    std::vector<Fraction> list;
    measure_terms<D>(kernel, region.boundary(), loaded, [&](const Integer& num, const Integer& den) {
        CHECK(!den.is_zero());
        list.push_back({num, den});
    });
    return list;
}

/// Checks the sum against tetrahedra over the origin, added up outside the library.
template <int D>
Rational sum(const Region<D>& region) {
    Rational total(0);
    for (const Fraction& t : terms(region)) total += rational(t.num, t.den);
    CHECK(total == ExactRegion<D>(region).measure());
    return total;
}

bool is_power_of_two(const Integer& x) {
    return x.trailing_zeros() + 1 == x.bit_length();
}

}  // namespace

TEST_CASE("measure terms: an end is its coordinate, plus at upper ends") {
    CHECK(terms(intervals({{-2, Rational(1, 3)}})) == std::vector<Fraction>{{Integer(2), 1}, {Integer(1), 3}});
    CHECK(sum(intervals({{-2, Rational(1, 3)}, {5, 7}})) == Rational(13, 3));
    CHECK(terms(Region<1>::empty()).empty());
}

TEST_CASE("measure terms: a segment pq is half the cross product of p and q") {
    CHECK(terms(polygon<Rational>({{1, 0}, {4, 0}, {1, 2}})) ==
          std::vector<Fraction>{{Integer(0), 2}, {Integer(8), 2}, {Integer(-2), 2}});
    CHECK(sum(polygon<Rational>({{1, 0}, {4, 0}, {1, 2}})) == 3);
    CHECK(sum(box<2>({Rational(-1, 3), Rational(-1, 5)}, {Rational(2, 3), Rational(4, 5)})) == 1);
    // A face of several segments, corners that are meets.
    CHECK(sum(box<2>({0, 0}, {4, 4}) - box<2>({1, -1}, {2, 1})) == 15);
    CHECK(sum(polygon<Rational>({{0, 0}, {3, 0}, {0, 3}}) ^ polygon<Rational>({{0, 0}, {3, 1}, {1, 3}})) ==
          Rational(17, 2) -
              2 * sum(polygon<Rational>({{0, 0}, {3, 0}, {0, 3}}) & polygon<Rational>({{0, 0}, {3, 1}, {1, 3}})));
    CHECK(terms(Region<2>::empty()).empty());
}

TEST_CASE("measure terms: faces on planes through the origin have none") {
    const Region<3> cube = box<3>({0, 0, 0}, {2, 2, 2});
    // Three faces are left; in each a fan of two tetrahedra, one over the origin's own corner or not.
    CHECK(terms(cube).size() == 6);
    CHECK(sum(cube) == 8);
    const Region<3> cone = simplex<3>({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}});
    CHECK(terms(cone) == std::vector<Fraction>{{Integer(27), 6}});
    CHECK(terms(Region<3>::empty()).empty());
}

TEST_CASE("measure terms: loops of doubles have denominators that are powers of two but for a 3") {
    const double tenth = 0.1;  // a double: its denominator is a power of two
    const Region<3> tilted(simplex<3>(std::array<std::array<double, 3>, 4>{
        {{tenth, 0.3, 0.7}, {1.1, tenth, 0.2}, {0.3, 1.3, tenth}, {0.4, 0.1, 2.3}}}));
    REQUIRE(!terms(tilted).empty());
    for (const Fraction& t : terms(tilted)) CHECK(is_power_of_two(exact_divide(t.den, Integer(3))));
    sum(tilted);
    // Where a face has a constructed corner or a fraction, its height over the origin takes part.
    const Region<3> cut = tilted & box<3>({0, 0, 0}, {1, 1, 1});
    bool other = false;
    for (const Fraction& t : terms(cut)) other = other || !is_power_of_two(abs(t.den));
    CHECK(other);
    sum(cut);
    CHECK(sum(box<3>({Rational(-1, 3), Rational(1, 7), -1}, {Rational(2, 3), Rational(8, 7), 1})) == 2);
}

TEST_CASE("measure terms: planes in every direction, faces with holes and of many pieces") {
    // Shifted so that no plane contains the origin; normals with one, two and three entries of either sign.
    const Region<3> block = box<3>({1, 2, 3}, {11, 12, 13});
    const Rational prisms = sum(prism<Rational>({{3, 4}, {7, 5}, {4, 9}}, 2, 20));
    CHECK(prisms == Rational(19, 2) * 18);
    CHECK(sum(block - prism<Rational>({{3, 4}, {7, 5}, {4, 9}}, 2, 20)) == 1000 - 95);
    CHECK(sum(block - box<3>({0, 5, 0}, {99, 6, 99})) == 900);
    const Region<3> a = simplex<3>({{1, 1, 1}, {9, 2, 4}, {3, 8, 2}, {2, 3, 9}});
    const Region<3> b = simplex<3>({{9, 9, 9}, {1, 3, 2}, {8, 1, 3}, {2, 9, 1}});
    CHECK(sum(a & b) + sum(a - b) == sum(a));
    CHECK(sum(a ^ b) == sum(a | b) - sum(a & b));
}

TEST_CASE("measure terms: a fan needs three corners, and leaves out flat triangles") {
    const std::vector<Homogeneous<3>> points = {{Integer(1), Integer(0), Integer(0), Integer(1)},
                                                {Integer(0), Integer(1), Integer(0), Integer(2)},
                                                {Integer(0), Integer(0), Integer(1), Integer(5)},
                                                {Integer(1), Integer(1), Integer(0), Integer(1)}};
    std::vector<Fraction> list;
    const auto at = [&](const Corner& c) { return points[c.point]; };
    auto term = [&](const Integer& num, const Integer& den) { list.push_back({num, den}); };
    const Corner loop[4] = {{0, no_id}, {1, no_id}, {2, no_id}, {3, no_id}};
    for (const std::size_t n : {0U, 1U, 2U}) cleave::detail::fan_terms(std::span<const Corner>(loop, n), at, term);
    CHECK(list.empty());
    cleave::detail::fan_terms(std::span<const Corner>(loop, 4), at, term);
    // (p0, p1, p2) and (p0, p2, p3): det / 6 over the product of the weights.
    CHECK(list == std::vector<Fraction>{{Integer(1), 60}, {Integer(-1), 30}});
    list.clear();
    const Corner flat[3] = {{0, no_id}, {1, no_id}, {3, no_id}};  // with the origin in one plane
    cleave::detail::fan_terms(std::span<const Corner>(flat, 3), at, term);
    CHECK(list.empty());
}

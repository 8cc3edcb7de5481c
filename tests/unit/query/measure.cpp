// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/measure.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

using namespace cleave;
using support::ExactRegion;

namespace {

/// An interval from an awkward start, so that no end is a decimal, of length `size`.
Region<1> length(const Rational& size) {
    return intervals({{Rational(1, 3), Rational(size + Rational(1, 3))}});
}

Rational power_of_ten(int n) {
    Rational p(1);
    for (int i = 0; i < (n < 0 ? -n : n); ++i) p *= 10;
    return n < 0 ? Rational(1 / p) : p;
}

/// The measure's residues modulo both primes are those of the exact fraction.
template <int D>
void check_residues(const Region<D>& region) {
    const Fraction f = number_traits<Rational>::to_fraction(*measure(region));
    const std::optional<Mod61> first = measure_modulo(region);
    const std::optional<Mod62> second = measure_modulo<second_prime>(region);
    REQUIRE(first.has_value());
    REQUIRE(second.has_value());
    CHECK(*first * Mod61(f.den) == Mod61(f.num));
    CHECK(*second * Mod62(f.den) == Mod62(f.num));
}

template <int D>
void check_constants() {
    CHECK(measure(Region<D>::empty()) == Rational(0));
    CHECK(measure_modulo(Region<D>::empty()) == Mod61(0));
    CHECK(measure_modulo<second_prime>(Region<D>::empty()) == Mod62(0));
    CHECK(measure_digits(Region<D>::empty(), 5) == "0");
    std::array<Rational, std::size_t(D)> lo;
    std::array<Rational, std::size_t(D)> hi;
    lo.fill(0);
    hi.fill(1);
    for (const Region<D>& unbounded : {Region<D>::full(), Region<D>(~box<D>(lo, hi))}) {
        CHECK(!measure(unbounded));
        CHECK(!measure_modulo(unbounded));
        CHECK(!measure_modulo<second_prime>(unbounded));
        CHECK(!measure_digits(unbounded, 5));
    }
    CHECK(measure(box<D>(lo, hi)) == Rational(1));
    CHECK(measure(~~box<D>(lo, hi)) == Rational(1));
}

}  // namespace

TEST_CASE("fraction sum: like adding one by one, whatever the number of terms") {
    CHECK(FractionSum().total() == 0);
    FractionSum sum;
    Rational expected(0);
    for (int i = 1; i <= 40; ++i) {
        const int sign = i % 3 == 0 ? -1 : 1;
        sum.add(Integer(sign * i * i), Integer(2 * i + 1));
        expected += Rational(sign * i * i, 2 * i + 1);
        CHECK(sum.total() == expected);
    }
    FractionSum signs;  // denominators of either sign, with common factors
    signs.add(Integer(6), Integer(-4));
    signs.add(Integer(-9), Integer(-6));
    CHECK(signs.total() == 0);
}

TEST_CASE("measure: nothing has 0, what is unbounded none") {
    check_constants<1>();
    check_constants<2>();
    check_constants<3>();
}

TEST_CASE("measure: length, area, volume") {
    CHECK(measure(intervals({{0, Rational(1, 3)}, {1, 2}, {5, 5}})) == Rational(4, 3));
    CHECK(measure(polygon<Rational>({{0, 0}, {4, 0}, {4, 4}, {2, 1}})) == Rational(6));
    CHECK(measure(simplex<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) == Rational(1, 6));
    // Where the numbers cancel nearly all of each other, and far from the origin.
    const Rational far = power_of_ten(40);
    const Rational tiny = power_of_ten(-40);
    CHECK(measure(box<3>({far, far, far}, {Rational(far + tiny), Rational(far + 1), Rational(far + tiny)})) ==
          Rational(tiny * tiny));
    const Region<3> ball = sphere<Rational>({1, 2, 3}, 2, {16, 8});
    const Region<3> rest = ball - box<3>({0, 0, 0}, {2, 2, 9});
    CHECK(measure(rest) == ExactRegion<3>(rest).measure());
    CHECK(measure(ball & ~rest) == Rational(*measure(ball) - *measure(rest)));
}

TEST_CASE("measure: in the fractions of the region's number type") {
    const Region<2> a = polygon<Rational>({{0, 0}, {1, 0}, {0, 1}});
    static_assert(
        std::is_same_v<decltype(measure(Region<2, Integer>(a))), std::optional<number_traits<Integer>::field_type>>);
    const auto half = measure(Region<2, Integer>(a));
    REQUIRE(half.has_value());
    CHECK(number_traits<number_traits<Integer>::field_type>::to_fraction(*half) == Fraction{1, 2});
    CHECK(!measure(Region<2, Integer>(~a)));
}

TEST_CASE("measure modulo: the residue of the exact fraction, by both primes") {
    check_residues(length(Rational(22, 7)));
    check_residues(polygon<Rational>({{Rational(1, 3), 0}, {4, Rational(-7, 5)}, {2, 9}}));
    check_residues(sphere<Rational>({1, 2, 3}, 2, {16, 8}) - box<3>({0, 0, 0}, {2, 2, 9}));
    // Different measures, different residues; equal ones, equal, however they came about.
    const Region<2> square = box<2>({0, 0}, {3, 3});
    CHECK(measure_modulo(square) == measure_modulo((square - box<2>({1, 1}, {2, 9})) | box<2>({1, 1}, {2, 3})));
    CHECK(measure_modulo(square) != measure_modulo(box<2>({0, 0}, {3, 4})));
}

TEST_CASE("measure modulo: where a prime divides denominators") {
    const Integer prime(first_prime);
    const Rational p = number_traits<Rational>::from_fraction(prime, Integer(1));
    const Rational sliver = 1 / p;
    // The measure's own denominator: no residue modulo this prime, one modulo the other.
    const Region<1> small = intervals({{0, sliver}});
    CHECK(!measure_modulo(small));
    CHECK(measure_modulo<second_prime>(small) == Mod62(1) / Mod62(prime));
    CHECK(!measure_modulo(box<3>({0, 0, 0}, {sliver, 1, 1})));
    // Only those of terms: they cancel in the sum.
    CHECK(measure_modulo(intervals({{sliver, Rational(sliver + 5)}})) == Mod61(5));
    CHECK(measure_modulo(box<2>({sliver, sliver}, {Rational(sliver + 2), Rational(sliver + 3)})) == Mod61(6));
    // Only before a term is reduced: the cross product of (1/p, 0) and (1, p) is 1.
    CHECK(measure_modulo(polygon<Rational>({{0, 0}, {sliver, 0}, {1, p}})) == Mod61(1) / Mod61(2));
    // A numerator that the prime divides is 0.
    CHECK(measure_modulo(intervals({{0, p}})) == Mod61(0));
}

TEST_CASE("measure digits: correctly rounded, with as many digits as asked for") {
    CHECK(measure_digits(length(Rational(22, 7)), 1) == "3");
    CHECK(measure_digits(length(Rational(22, 7)), 12) == "3.14285714286");
    CHECK(measure_digits(box<3>({0, 0, 0}, {2, 2, 2}), 3) == "8.00");
    CHECK(measure_digits(length(Rational(1, 8000)), 2) == "0.00012");
    CHECK(measure_digits(length(123456), 3) == "1.23e5");
    // Carries, up to one more place in front of the point.
    CHECK(measure_digits(length(Rational(Rational(19996) / 10000)), 4) == "2.000");
    CHECK(measure_digits(length(Rational(Rational(99996) / 10000)), 4) == "10.00");
    CHECK(measure_digits(length(Rational(Rational(99994) / 10000)), 4) == "9.999");
    CHECK(measure_digits(length(Rational(Rational(99996) / 10)), 4) == "1.000e4");
    CHECK(measure_digits(length(Rational(9, 10)), 1) == "0.9");
    CHECK(measure_digits(length(Rational(24, 25)), 1) == "1");
}

TEST_CASE("measure digits: ties go to even, and a hair beside a tie is no tie") {
    const Rational hair = power_of_ten(-500);
    // 1.25 and 1.35: the even neighbour is below the one and above the other.
    CHECK(measure_digits(length(Rational(5, 4)), 2) == "1.2");
    CHECK(measure_digits(length(Rational(Rational(5, 4) - hair)), 2) == "1.2");
    CHECK(measure_digits(length(Rational(Rational(5, 4) + hair)), 2) == "1.3");
    CHECK(measure_digits(length(Rational(27, 20)), 2) == "1.4");
    CHECK(measure_digits(length(Rational(Rational(27, 20) - hair)), 2) == "1.3");
    CHECK(measure_digits(length(Rational(Rational(27, 20) + hair)), 2) == "1.4");
    // The same without any fraction in the terms.
    CHECK(measure_digits(intervals({{0, Rational(5, 4)}}), 2) == "1.2");
    CHECK(measure_digits(intervals({{0, Rational(7, 4)}}), 2) == "1.8");
}

TEST_CASE("measure digits: small differences of large terms, and numbers of every size") {
    for (const int n : {-400, -60, -7, -1, 0, 1, 5, 60, 400}) {
        const Rational scale = power_of_ten(n);
        const Rational at = power_of_ten(50) + Rational(1, 3);
        const Region<1> far = intervals({{at, Rational(at + scale * Rational(2, 3))}});
        for (const int digits : {1, 5, 40})
            CHECK(measure_digits(far, digits) == to_decimal(Rational(scale * Rational(2, 3)), digits));
    }
    const Region<3> ball = sphere<Rational>({0, 0, 0}, 1, {16, 8});
    const Region<3> moved = sphere<Rational>({Rational(1, 3), Rational(1, 5), Rational(1, 7)}, 1, {16, 8});
    for (const Region<3>& r : {Region<3>(ball - moved), Region<3>(ball & moved)})
        for (const int digits : {1, 2, 17, 100}) CHECK(measure_digits(r, digits) == to_decimal(*measure(r), digits));
}

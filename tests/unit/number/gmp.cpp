// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/config.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>

#include "support/catch.hpp"
#include "support/generators.hpp"

#include <limits>

using namespace cleave;
using support::property;

TEST_CASE("gmp: integers of any length cross limb by limb and come back") {
    property("as the same decimal digits", [] {
        const Integer x = generators::draw_wide_integer(30);
        mpz_class z(0xbad);
        gmp::assign(z.get_mpz_t(), x);
        RC_ASSERT(z.get_str() == x.to_string());
        RC_ASSERT(gmp::to_integer(z.get_mpz_t()) == x);
        RC_ASSERT(gmp::to_integer<2>(z.get_mpz_t()) == x);
        RC_ASSERT(gmp::bit_length(z.get_mpz_t()) == x.bit_length());
        RC_ASSERT(arithmetic::equal(gmp::LimbsOf(z.get_mpz_t()).view(), x.view()));
    });
    const mpz_class long_one = (mpz_class(1) << 3'000'001) - 1;
    const Integer same = gmp::to_integer(long_one.get_mpz_t());
    CHECK(same.bit_length() == 3'000'001);
    CHECK(same == (Integer(1) << 3'000'001) - Integer(1));
    CHECK(number_traits<mpz_class>::from_integer(-same) == -long_one);
}

TEST_CASE("gmp: what GMP leaves in higher terms is canonical once it came through the traits") {
    CHECK(mpq_class(2, 4) != mpq_class(1, 2));  // the trap
    CHECK(number_traits<mpq_class>::from_fraction(2, 4) == mpq_class(1, 2));
    CHECK(number_traits<mpq_class>::from_fraction(2, -4) == mpq_class(-1, 2));
    mpq_class raw(6, 4);
    raw.canonicalize();
    CHECK(number_traits<mpq_class>::to_fraction(raw) == Fraction{3, 2});
}

TEST_CASE("gmp: a double is a rational, exactly") {
    CHECK(number_traits<mpq_class>::from_double(0.1) == mpq_class("3602879701896397/36028797018963968"));
    CHECK(number_traits<mpz_class>::from_double(-1e22) == mpz_class("-10000000000000000000000"));
    CHECK(number_traits<mpq_class>::to_double(mpq_class(1, 3)) == 1.0 / 3);
    // get_d() of GMP truncates; ours rounds.
    const mpz_class z = (mpz_class(1) << 60) + 255;
    CHECK(z.get_d() == 0x1p60);
    CHECK(to_double(z) == 0x1p60 + 256);
    CHECK(number_traits<mpz_class>::to_double(mpz_class(0)) == 0.0);
    CHECK(to_double(mpz_class(mpz_class(1) << 2000)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("gmp: the greatest common divisor of rationals divides both into coprime integers") {
    using T = number_traits<mpq_class>;
    CHECK(T::gcd(mpq_class(1, 2), mpq_class(1, 3)) == mpq_class(1, 6));
    CHECK(T::gcd(mpq_class(-4, 3), mpq_class(2, 9)) == mpq_class(2, 9));
    CHECK(T::gcd(mpq_class(0), mpq_class(-5, 7)) == mpq_class(5, 7));
    CHECK(T::gcd(mpq_class(0), mpq_class(0)) == 0);
}
#endif

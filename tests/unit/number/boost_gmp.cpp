// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/config.hpp>
#if defined(CLEAVE_HAS_BOOST) && defined(CLEAVE_HAS_GMP)
#include <cleave/number/boost_gmp.hpp>

#include "support/catch.hpp"
#include "support/generators.hpp"

#include <utility>

using namespace cleave;
using boost::multiprecision::mpq_rational;
using boost::multiprecision::mpz_int;
using support::property;

TEST_CASE("boost_gmp: integers of any length cross limb by limb and come back") {
    property("as the same decimal digits", [] {
        const Integer x = generators::draw_wide_integer(30);
        const mpz_int z = number_traits<mpz_int>::from_integer(x);
        RC_ASSERT(z.str() == x.to_string());
        RC_ASSERT(number_traits<mpz_int>::to_fraction(z).num == x);
        const mpq_rational q = number_traits<mpq_rational>::from_integer(x);
        RC_ASSERT(q.str() == x.to_string());
    });
}

TEST_CASE("boost_gmp: fractions are canonical") {
    using T = number_traits<mpq_rational>;
    CHECK(T::from_fraction(2, -4) == mpq_rational(-1, 2));
    CHECK(T::to_fraction(mpq_rational(6, 4)) == Fraction{3, 2});
    CHECK(T::bit_length(mpq_rational(1, 1000)) == 10);
}
#endif

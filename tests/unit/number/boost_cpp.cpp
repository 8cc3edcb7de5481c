// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/config.hpp>
#if defined(CLEAVE_HAS_BOOST)
#include <cleave/number/boost_cpp.hpp>

#include "support/catch.hpp"
#include "support/generators.hpp"

using namespace cleave;
using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using support::property;

TEST_CASE("boost_cpp: integers of any length cross limb by limb and come back") {
    property("as the same decimal digits", [] {
        const Integer x = generators::draw_wide_integer(30);
        const cpp_int z = cpp_int_limbs::from_integer(x);
        RC_ASSERT(z.str() == x.to_string());
        RC_ASSERT(cpp_int_limbs::to_integer(z) == x);
        RC_ASSERT(number_traits<cpp_int>::bit_length(z) == x.bit_length());
    });
    const cpp_int long_one = (cpp_int(1) << 3'000'001) - 1;
    const Integer same = cpp_int_limbs::to_integer(long_one);
    CHECK(same == (Integer(1) << 3'000'001) - Integer(1));
    CHECK(cpp_int_limbs::from_integer(-same) == -long_one);
}

TEST_CASE("boost_cpp: a negative denominator is no obstacle") {
    using T = number_traits<cpp_rational>;
    CHECK(T::from_fraction(2, -4) == cpp_rational(-1, 2));
    CHECK(T::from_fraction(-2, -4) == cpp_rational(1, 2));
    CHECK(T::to_fraction(cpp_rational(-6, 4)) == Fraction{-3, 2});
}

TEST_CASE("boost_cpp: a double is a rational, exactly") {
    CHECK(number_traits<cpp_rational>::from_double(0.1) == cpp_rational(3602879701896397, 36028797018963968));
    CHECK(number_traits<cpp_int>::from_double(-1e22) == cpp_int("-10000000000000000000000"));
    CHECK(to_double(cpp_rational(1, 3)) == 1.0 / 3);
}
#endif

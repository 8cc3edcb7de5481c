// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/builtin.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <limits>

using namespace cleave;

TEST_CASE("builtin: a FixedInt evaluates products of narrower ones, and throws where the result does not fit") {
    using T = number_traits<FixedInt<128>>;
    const FixedInt<64> large = std::int64_t(1) << 62;
    CHECK(T::product(large, large).to_string() == "21267647932558653966460912964485513216");  // 2^124
    const FixedInt<128> larger = T::product(large, large);
    CHECK_THROWS_AS(T::product(larger, FixedInt<64>(16)), NumberError);
    CHECK(T::product(larger, FixedInt<64>(-8)).to_string() == "-170141183460469231731687303715884105728");  // -2^127
    CHECK_THROWS_AS(T::gcd(T::product(larger, FixedInt<64>(-8)), FixedInt<128>(0)), NumberError);
}

TEST_CASE("builtin: the least number of a fixed width goes out like any other") {
    using T = number_traits<FixedInt<64>>;
    const FixedInt<64> least = std::numeric_limits<std::int64_t>::min();
    CHECK(T::to_double(least) == -0x1p63);
    CHECK(T::bit_length(least) == 64);
    CHECK(T::to_fraction(least).num == -(Integer(1) << 63));
    CHECK(T::from_integer(-(Integer(1) << 63)) == least);
    CHECK_THROWS_AS(T::from_integer(Integer(1) << 63), NumberError);
    CHECK(T::exact_divide(least, FixedInt<64>(2)) == FixedInt<64>(-(std::int64_t(1) << 62)));
    CHECK_THROWS_AS(T::exact_divide(least, FixedInt<64>(-1)), NumberError);
}

TEST_CASE("builtin: sums of products need no temporary of their own type") {
    WideInteger r = 5;
    number_traits<WideInteger>::add_product(r, Integer(6), Integer(7));
    CHECK(r == 47);
    number_traits<WideInteger>::sub_product(r, r, BasicInteger<2>(2));
    CHECK(r == -47);
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/product.hpp>

#include "support/counting.hpp"

#include "support/catch.hpp"

#include <cleave/number/builtin.hpp>

using namespace cleave;

TEST_CASE("product: sums alternate as they say") {
    const auto n = [](int value) { return Integer(value); };
    CHECK(determinant_of_two<Integer>(n(2), n(3), n(5), n(7)) == -1);
    CHECK(alternating_sum(n(2), n(3), n(5), n(7), n(11), n(13)) == 6 - 35 + 143);
    CHECK(negated_alternating_sum(n(2), n(3), n(5), n(7), n(11), n(13)) == -6 + 35 - 143);
    CHECK(alternating_sum(n(2), n(3), n(5), n(7), n(11), n(13), n(17), n(19)) == 6 - 35 + 143 - 323);
    CHECK(negated_alternating_sum(n(2), n(3), n(5), n(7), n(11), n(13), n(17), n(19)) == -6 + 35 - 143 + 323);
}

TEST_CASE("product: an accumulator may be a factor") {
    Integer x = 3;
    add_product(x, x, x);
    CHECK(x == 12);
    sub_product(x, x, x);
    CHECK(x == -132);
    counting::Number y(3);
    add_product(y, y, y);
    sub_product(y, y, counting::Number(2));
    CHECK(y.value() == -12);
}

TEST_CASE("product: factors of a fixed width are multiplied in the accumulator's width") {
    const FixedInt<64> a = std::int64_t(1) << 40;
    CHECK(product<FixedInt<128>>(a, a).to_string() == "1208925819614629174706176");  // 2^80
    FixedInt<128> sum = 1;
    add_product(sum, a, a);
    sub_product(sum, a, a);
    CHECK(sum == 1);
    CHECK_THROWS_AS(product<FixedInt<64>>(a, a), NumberError);
}

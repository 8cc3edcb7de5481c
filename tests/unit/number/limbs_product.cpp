// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs_product.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <vector>

using namespace cleave;

TEST_CASE("limbs_product: every pair of sizes up to 13 limbs") {
    oracle::Numbers numbers(1);
    for (std::size_t n = 1; n <= 13; ++n) {
        for (std::size_t m = 1; m <= n; ++m) {
            for (std::size_t i = 0; i < scaled(40); ++i) {
                std::vector<Limb> a(n);
                std::vector<Limb> b(m);
                for (Limb& limb : a) limb = i == 0 ? ~Limb(0) : numbers.limb();
                for (Limb& limb : b) limb = i == 0 ? ~Limb(0) : numbers.limb();
                std::vector<Limb> out(n + m + 1, 77);
                limbs::multiply(out.data(), a.data(), n, b.data(), m);
                REQUIRE(out.back() == 77);
                REQUIRE(oracle::from_words(out.data(), n + m) ==
                        oracle::from_words(a.data(), n) * oracle::from_words(b.data(), m));
            }
        }
    }
}

TEST_CASE("limbs_product: usable in constant expressions") {
    constexpr auto product = [] {
        const std::array<Limb, 3> a{~Limb(0), ~Limb(0), ~Limb(0)};
        const std::array<Limb, 2> b{~Limb(0), ~Limb(0)};
        std::array<Limb, 5> out{};
        limbs::multiply(out.data(), a.data(), 3, b.data(), 2);
        return out;
    }();
    // (2^192 - 1)(2^128 - 1) = 2^320 - 2^192 - 2^128 + 1
    STATIC_REQUIRE(product == std::array<Limb, 5>{1, 0, ~Limb(0), ~Limb(0) - 1, ~Limb(0)});
}

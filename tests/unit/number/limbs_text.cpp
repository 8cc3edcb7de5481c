// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs_text.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <string>
#include <vector>

using namespace cleave;

TEST_CASE("limbs_text: decimal text of every length, there and back") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class z = abs(numbers.number(i % 13));
        std::vector<Limb> a((mpz_sizeinbase(z.get_mpz_t(), 2) + 63) / 64);
        std::size_t count = 0;
        mpz_export(a.data(), &count, -1, 8, 0, 0, z.get_mpz_t());
        REQUIRE(limbs::to_decimal(a.data(), a.size()) == z.get_str());
        std::vector<Limb> back;
        REQUIRE(limbs::from_decimal(z.get_str(), back));
        REQUIRE(oracle::from_words(back.data(), back.size()) == z);
        REQUIRE(limbs::normalised_size(back.data(), back.size()) == back.size());
    }
}

TEST_CASE("limbs_text: powers of ten around the chunk of nineteen digits") {
    for (std::size_t digits = 1; digits < 80; ++digits) {
        const std::string nines(digits, '9');
        const std::string power = "1" + std::string(digits, '0');
        for (const std::string& text : {nines, power}) {
            std::vector<Limb> a;
            REQUIRE(limbs::from_decimal(text, a));
            CHECK(limbs::to_decimal(a.data(), a.size()) == text);
        }
    }
}

TEST_CASE("limbs_text: leading zeros vanish, zero is one digit") {
    std::vector<Limb> a;
    std::string padded(50, '0');
    padded += "17";
    REQUIRE(limbs::from_decimal(padded, a));
    CHECK(limbs::to_decimal(a.data(), a.size()) == "17");
    REQUIRE(limbs::from_decimal(std::string(50, '0'), a));
    CHECK(a.empty());
    CHECK(limbs::to_decimal(nullptr, 0) == "0");
    const std::vector<Limb> zeros(3);
    CHECK(limbs::to_decimal(zeros.data(), 3) == "0");
}

TEST_CASE("limbs_text: what is not a digit is refused") {
    std::vector<Limb> a;
    for (const char* text : {"", "-1", "1 ", "12a4", "+5", "1.0", "12345678901234567890x", "x2345678901234567890"})
        CHECK_FALSE(limbs::from_decimal(text, a));
}

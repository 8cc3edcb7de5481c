// SPDX-License-Identifier: Apache-2.0
/// GMP as the oracle of the number tests, and a source of numbers that hurt: long carry chains, limb boundaries.
#ifndef CLEAVE_TESTS_UNIT_NUMBER_ORACLE_HPP
#define CLEAVE_TESTS_UNIT_NUMBER_ORACLE_HPP

#include <cleave/number/basic_integer.hpp>

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace oracle {

[[nodiscard]] inline mpz_class from_words(const std::uint64_t* words, std::size_t count) {
    mpz_class r;
    mpz_import(r.get_mpz_t(), count, -1, sizeof(std::uint64_t), 0, 0, words);
    return r;
}

template <unsigned K>
[[nodiscard]] mpz_class to_mpz(const cleave::BasicInteger<K>& x) {
    const mpz_class magnitude = from_words(x.limbs().data(), x.limbs().size());
    return x.sign() == cleave::Sign::minus ? mpz_class(-magnitude) : magnitude;
}

[[nodiscard]] inline cleave::Sign sign(const mpz_class& z) {
    return cleave::sign_of_value(sgn(z));
}

template <unsigned K>
[[nodiscard]] cleave::BasicInteger<K> from_mpz(const mpz_class& z) {
    std::vector<std::uint64_t> words((mpz_sizeinbase(z.get_mpz_t(), 2) + 63) / 64);
    std::size_t count = 0;
    mpz_export(words.data(), &count, -1, sizeof(std::uint64_t), 0, 0, z.get_mpz_t());
    words.resize(count);
    return cleave::BasicInteger<K>::from_limbs(sign(z), words);
}

[[nodiscard]] inline mpz_class power_of_two(unsigned long n) {
    return mpz_class(1) << n;
}

/// Reproducible numbers.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : engine_(seed) {}

    [[nodiscard]] std::uint64_t word() { return engine_(); }

    /// Uniform in [0, bound).
    [[nodiscard]] std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }

    /// A limb of all zeros, all ones, a few bits, or noise.
    [[nodiscard]] std::uint64_t limb() {
        switch (engine_() % 6) {
            case 0:
                return 0;
            case 1:
                return ~std::uint64_t(0);
            case 2:
                return std::uint64_t(1) << (engine_() % 64);
            case 3:
                return engine_() >> (engine_() % 64);
            default:
                return engine_();
        }
    }

    /// A number of up to `limbs` limbs, of either sign.
    [[nodiscard]] mpz_class number(std::size_t limbs) {
        std::vector<std::uint64_t> words(below(limbs + 1));
        for (std::uint64_t& w : words) w = limb();
        const mpz_class r = from_words(words.data(), words.size());
        return (engine_() & 1) != 0 ? mpz_class(-r) : r;
    }

    /// A number of exactly `bits` bits, of either sign.
    [[nodiscard]] mpz_class of_bits(std::size_t bits) {
        if (bits == 0) return 0;
        std::vector<std::uint64_t> words((bits + 63) / 64);
        for (std::uint64_t& w : words) w = limb();
        mpz_class r = from_words(words.data(), words.size());
        mpz_fdiv_r_2exp(r.get_mpz_t(), r.get_mpz_t(), bits);
        mpz_setbit(r.get_mpz_t(), bits - 1);
        return (engine_() & 1) != 0 ? mpz_class(-r) : r;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace oracle

#endif

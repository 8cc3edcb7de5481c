// SPDX-License-Identifier: Apache-2.0
// rapidcheck's generators of numbers take seconds to compile wherever they are defined: once for all tests.
#include "support/generators.hpp"

#include <rapidcheck.h>

#include <bit>
#include <cstdint>
#include <utility>

namespace generators {

namespace {

/// -limit .. limit, all equally likely in every case, 0 the simplest and then 1, -1, 2, ...
rc::Gen<int> up_to(int limit) {
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 2 * limit + 1)),
                        [](int i) { return i % 2 == 0 ? -(i / 2) : (i + 1) / 2; });
}

rc::Gen<int> small_integer() {
    return rc::gen::weightedOneOf<int>({{6, up_to(3)}, {1, up_to(20)}, {1, rc::gen::just(0)}});
}

rc::Gen<cleave::Integer> wide_integer(int limbs) {
    const auto limb = rc::gen::weightedOneOf<std::uint64_t>(
        {{4, rc::gen::arbitrary<std::uint64_t>()},
         {1, rc::gen::element<std::uint64_t>(0, 1, ~std::uint64_t(0), std::uint64_t(1) << 63, 0xffffffff00000000U)}});
    return rc::gen::mapcat(rc::gen::inRange(0, limbs + 1), [limb](int count) {
        return rc::gen::map(
            rc::gen::pair(rc::gen::container<std::vector<std::uint64_t>>(static_cast<std::size_t>(count), limb),
                          rc::gen::arbitrary<bool>()),
            [](const std::pair<std::vector<std::uint64_t>, bool>& drawn) {
                cleave::Integer x = cleave::Integer::from_limbs(cleave::Sign::plus, drawn.first);
                if (drawn.second) x.negate();
                return x;
            });
    });
}

rc::Gen<cleave::Integer> integer(int limbs) {
    return rc::gen::weightedOneOf<cleave::Integer>(
        {{7, rc::gen::map(small_integer(), [](int x) { return cleave::Integer(x); })}, {1, wide_integer(limbs)}});
}

rc::Gen<cleave::Fraction> fraction() {
    const auto make = [](const std::pair<cleave::Integer, cleave::Integer>& drawn) {
        const bool zero = drawn.second.is_zero();
        return cleave::make_fraction(drawn.first, zero ? cleave::Integer(1) : drawn.second);
    };
    return rc::gen::map(rc::gen::pair(integer(4), rc::gen::weightedOneOf<cleave::Integer>(
                                                      {{3, rc::gen::just(cleave::Integer(1))}, {3, integer(4)}})),
                        make);
}

}  // namespace

cleave::Integer draw_wide_integer(int limbs) {
    return *wide_integer(limbs);
}

cleave::Integer draw_integer(int limbs) {
    return *integer(limbs);
}

cleave::Fraction draw_fraction() {
    return *fraction();
}

std::vector<cleave::Fraction> draw_fractions(std::size_t count, bool fractions, int limbs) {
    const auto entry = fractions ? fraction() : rc::gen::map(integer(limbs), [](const cleave::Integer& x) {
        return cleave::Fraction{x, 1};
    });
    return *rc::gen::container<std::vector<cleave::Fraction>>(count, entry);
}

std::vector<int> draw_repeats(int count) {
    return support::draw_ints(static_cast<std::size_t>(count), -2 * count, count);
}

double draw_finite_double() {
    return *rc::gen::weightedOneOf<double>(
        {{3, rc::gen::map(up_to(64), [](int x) { return x / 8.0; })},
         {2, rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
              const double x = std::bit_cast<double>(bits);
              return x - x == 0 ? x : 1.0;  // infinities and NaNs become 1
          })}});
}

}  // namespace generators

// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/integer.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <array>
#include <vector>

using namespace cleave;
using support::property;

namespace {

/// An integer of up to five limbs, of few bits or many, often all zeros or all ones.
Integer arbitrary() {
    std::vector<Limb> limbs(support::draw_index(6));
    for (Limb& limb : limbs) {
        const std::size_t kind = support::draw_choice({1, 1, 1, 3});
        limb =
            kind < 3 ? std::array<Limb, 3>{0, 1, ~Limb(0)}[kind] : Limb(support::draw_word(support::draw_int(1, 65)));
    }
    const bool negative = support::draw_bool();
    return Integer::from_limbs(negative ? Sign::minus : Sign::plus, limbs);
}

}  // namespace

TEST_CASE("integer: the laws of an ordered ring") {
    property("sums and products commute and associate", [] {
        const Integer a = arbitrary();
        const Integer b = arbitrary();
        const Integer c = arbitrary();
        RC_ASSERT(a + b == b + a);
        RC_ASSERT(a * b == b * a);
        RC_ASSERT((a + b) + c == a + (b + c));
        RC_ASSERT((a * b) * c == a * (b * c));
    });
    property("products distribute over sums and differences", [] {
        const Integer a = arbitrary();
        const Integer b = arbitrary();
        const Integer c = arbitrary();
        RC_ASSERT(a * (b + c) == a * b + a * c);
        RC_ASSERT(a * (b - c) == a * b - a * c);
        RC_ASSERT(a - b == a + (-b));
        RC_ASSERT(a - a == 0);
        RC_ASSERT(a * 1 == a);
        RC_ASSERT(a * 0 == 0);
        RC_ASSERT(a * -1 == -a);
    });
    property("the order respects sums and products", [] {
        const Integer a = arbitrary();
        const Integer b = arbitrary();
        const Integer c = arbitrary();
        RC_ASSERT((a < b) == (a + c < b + c));
        RC_ASSERT((a < b) == ((b - a).sign() == Sign::plus));
        RC_ASSERT((a * b).sign() == a.sign() * b.sign());
        RC_ASSERT((a * a).sign() != Sign::minus);
    });
    property("division and gcd keep their promises", [] {
        const Integer a = arbitrary();
        const Integer b = arbitrary();
        RC_PRE(!b.is_zero());
        const auto [quotient, remainder] = divide(a, b);
        RC_ASSERT(quotient * b + remainder == a);
        RC_ASSERT(abs(remainder) < abs(b));
        RC_ASSERT(exact_divide(a * b, b) == a);
        const Integer g = gcd(a, b);
        RC_ASSERT(exact_divide(a, g) * g == a);
        RC_ASSERT(gcd(exact_divide(a, g), exact_divide(b, g)) == 1);
    });
    property("text, shifts and residues keep the value", [] {
        const Integer a = arbitrary();
        const std::size_t shift = support::draw_index(300);
        RC_ASSERT(Integer::from_string(a.to_string()) == a);
        RC_ASSERT(((a << shift) >> shift) == a);
        RC_ASSERT((a << shift) == a * Integer::scaled(1, shift));
    });
}

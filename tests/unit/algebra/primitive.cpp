// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/primitive.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

using namespace cleave;
using support::property;

namespace {

template <class N>
void check_laws() {
    const Vector<3, N> v = generators::vector<3, N>();
    const Vector<3, Integer> p = primitive_integers(v);
    if (is_zero(v)) {
        RC_ASSERT(is_zero(p));
        return;
    }
    RC_ASSERT(gcd(p[0], gcd(p[1], p[2])).is_one());
    Vector<3, N> q = v;
    make_primitive(q);
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(number_traits<N>::to_fraction(q[i]) == (Fraction{p[i], 1}));
    RC_ASSERT(proportionality(v, q) == Sign::plus);
    // Any positive multiple has the same primitive vector.
    N s = generators::number<N>();
    if (number_traits<N>::sign(s) == Sign::zero) s = N(7);
    if (number_traits<N>::sign(s) == Sign::minus) s = -s;
    RC_ASSERT(primitive_integers(scale(s, v)) == p);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("primitive: one integer vector without a common factor for all positive multiples", "",
                        backends::Numbers) {
    property("in three dimensions", [] { check_laws<TestType>(); });
}

TEST_CASE("primitive: signs stay, zeros stay, fractions go") {
    Vector<4, Integer> v{-6, 0, 9, 3};
    make_primitive(v);
    CHECK(v == Vector<4, Integer>{-2, 0, 3, 1});
    const auto half = [](int n) { return number_traits<Rational>::from_fraction(n, 2); };
    CHECK(primitive_integers(Vector<3, Rational>{half(1), Rational(3), half(-5)}) == Vector<3, Integer>{1, 6, -5});
    // A vector whose entries are integers with gcd 1 half the time: 1/2 divides 1, so 1 is no reason to stop.
    Vector<2, Rational> w{Rational(1), half(1)};
    make_primitive(w);
    CHECK(w == Vector<2, Rational>{Rational(2), Rational(1)});
}

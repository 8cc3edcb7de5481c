// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/rational.hpp>

#include "support/catch.hpp"

#include <type_traits>

using namespace cleave;

TEST_CASE("rational: it is GMP's where that may be used, else Boost's, and always a field") {
    CHECK(ExactField<Rational>);
#if defined(CLEAVE_HAS_GMP)
    CHECK(std::is_same_v<Rational, mpq_class>);
#else
    CHECK(std::is_same_v<Rational, boost::multiprecision::cpp_rational>);
#endif
    const Rational third = Rational(1) / Rational(3);
    const Rational sum = third + third + third;
    CHECK(sum == Rational(1));
}

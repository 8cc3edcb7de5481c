// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/vector.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/counting.hpp"
#include "support/generators.hpp"

using namespace cleave;
using support::property;

namespace {

template <class N>
void check_sums() {
    using V = Vector<3, N>;
    const V a = generators::vector<3, N>();
    const V b = generators::vector<3, N>();
    const V c = generators::vector<3, N>();
    const N s = generators::number<N>();
    RC_ASSERT(subtract(add(a, b), b) == a);
    const N separate = dot(a, b) + dot(a, c);
    RC_ASSERT(dot(a, add(b, c)) == separate);
    const N scaled = s * dot(a, b);
    RC_ASSERT(dot(scale(s, a), b) == scaled);
    V negated = a;
    negate_in_place(negated);
    RC_ASSERT(is_zero(add(a, negated)));
    RC_ASSERT(is_zero(a) == (first_nonzero(a) == 3));
    // A sum of squares is positive.
    RC_ASSERT(number_traits<N>::sign(dot(a, a)) == (is_zero(a) ? Sign::zero : Sign::plus));
}

template <class N>
void check_proportionality() {
    using V = Vector<3, N>;
    const V a = generators::vector<3, N>();
    const N s = generators::number<N>();
    const N t = generators::number<N>();
    RC_PRE(!is_zero(a));
    const V p = scale(s, a);
    const V q = scale(t, a);
    const Sign expected = number_traits<N>::sign(s) * number_traits<N>::sign(t);
    if (expected != Sign::zero) RC_ASSERT(proportionality(p, q) == expected);
    // Against the definition: all minors vanish.
    const V b = generators::vector<3, N>();
    RC_PRE(!is_zero(b));
    bool parallel = true;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const N minor = determinant_of_two<N>(a[i], a[j], b[i], b[j]);
            parallel = parallel && number_traits<N>::sign(minor) == Sign::zero;
        }
    }
    RC_ASSERT((proportionality(a, b) != Sign::zero) == parallel);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("vector: sums, multiples and dot products obey the laws", "", backends::Numbers) {
    property("in three dimensions", [] { check_sums<TestType>(); });
}

TEMPLATE_LIST_TEST_CASE("vector: proportionality has the sign of the factor, and needs all minors zero", "",
                        backends::Numbers) {
    property("in three dimensions", [] { check_proportionality<TestType>(); });
}

TEST_CASE("vector: proportionality tells apart vectors that agree in signs and in some ratios") {
    using V = Vector<4, Integer>;
    CHECK(proportionality(V{2, -4, 0, 6}, V{3, -6, 0, 9}) == Sign::plus);
    CHECK(proportionality(V{2, -4, 0, 6}, V{-3, 6, 0, -9}) == Sign::minus);
    CHECK(proportionality(V{2, -4, 0, 6}, V{3, -6, 0, 10}) == Sign::zero);
    CHECK(proportionality(V{2, -4, 0, 6}, V{3, -6, 1, 9}) == Sign::zero);
    CHECK(proportionality(V{0, 0, 0, 6}, V{0, 0, 0, -1}) == Sign::minus);
    CHECK(proportionality(V{0, 0, 0, 6}, V{0, 0, 1, 1}) == Sign::zero);
}

TEST_CASE("vector: proportionality of vectors with different signs multiplies nothing") {
    using V = Vector<3, counting::Number>;
    const auto make = [](int x, int y, int z) {
        return V{counting::Number(x), counting::Number(y), counting::Number(z)};
    };
    const V a = make(1, 2, 3);
    const V b = make(1, 2, -3);
    counting::counts() = {};
    CHECK(proportionality(a, b) == Sign::zero);
    CHECK(counting::counts().products == 0);
}

TEST_CASE("vector: factors of different types meet in the type that is asked for") {
    const Vector<2, Integer> a{3, -5};
    const Vector<2, WideInteger> b{7, 2};
    const WideInteger d = dot<WideInteger>(a, b);
    CHECK(d == 11);
    const Vector<2, FixedInt<64>> c{std::int64_t(1) << 40, std::int64_t(1) << 40};
    CHECK(dot<FixedInt<128>>(c, c).to_string() == "2417851639229258349412352");  // 2^81
    CHECK_THROWS_AS(dot(c, c), NumberError);
}

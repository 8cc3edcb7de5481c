// SPDX-License-Identifier: Apache-2.0
// Affine maps, reflections among them, and set operations commute, in every dimension, bounded or not; measures are
// multiplied by the determinant.
#include <cleave/algebra/determinant.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/compare.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

using namespace cleave;
using namespace support;

namespace {

/// Small integers over a small weight, a mirror image as often as not.
template <int D>
AffineMap<D, Integer> random_map(Dice& dice) {
    for (;;) {
        Matrix<D + 1, D + 1, Integer> m;
        for (int i = 0; i < D; ++i)
            for (int j = 0; j <= D; ++j) m(i, j) = Integer(i == j ? dice.between(-2, 2) : dice.between(-1, 1));
        for (int j = 0; j < D; ++j) m(D, j) = Integer(0);
        m(D, D) = Integer(dice.between(1, 3));
        const AffineMap<D, Integer> map(std::move(m));
        if (map.orientation() != Sign::zero) return map;
    }
}

/// By how much the map multiplies measures.
template <int D>
Rational factor(const AffineMap<D, Integer>& map) {
    // The determinant of the homogeneous matrix is w det A; that of the map is det A / w^D.
    const Integer d = determinant(map.homogeneous());
    Integer w = map.weight();
    for (int i = 0; i < D; ++i) w *= map.weight();
    return number_traits<Rational>::from_fraction(d.sign() == Sign::minus ? -d : d, w);
}

template <int D>
Region<D> random_region(Dice& dice, bool bounded) {
    Region<D> r = region_of<D>(random_convex<D>(dice, bounded).planes);
    const Region<D> other = region_of<D>(random_convex<D>(dice, bounded).planes);
    r = apply(all_operations[std::size_t(dice.below(4))], r, other);
    return !bounded && dice.below(3) == 0 ? ~r : r;
}

template <int D>
void check_transforms(unsigned seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const bool bounded = dice.below(2) == 0;
    const Region<D> a = random_region<D>(dice, bounded);
    const Region<D> b = random_region<D>(dice, bounded);
    const AffineMap<D, Integer> f = random_map<D>(dice);
    const AffineMap<D, Integer> g = random_map<D>(dice);
    const Region<D> fa = transform(f, a);
    const Region<D> fb = transform(f, b);
    for (const Operation operation : all_operations)
        CHECK(canonical(transform(f, apply(operation, a, b))) == canonical(apply(operation, fa, fb)));
    CHECK(canonical(transform(f, ~a)) == canonical(~fa));
    CHECK(canonical(transform(*inverse(f), fa)) == canonical(a));
    CHECK(canonical(transform(g, fa)) == canonical(transform(compose(g, f), a)));
    CHECK(equal(fa, fb) == equal(a, b));
    CHECK(measure(fa).has_value() == measure(a).has_value());
    if (const auto m = measure(a)) CHECK(measure(fa) == Rational(factor(f) * *m));
    if (bounded) CHECK(Rational(*measure(fa) + *measure(fb)) == Rational(*measure(fa | fb) + *measure(fa & fb)));
}

}  // namespace

TEST_CASE("transforms: they commute with set operations in D = 1") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_transforms<1>(seed);
}
TEST_CASE("transforms: they commute with set operations in D = 2") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_transforms<2>(seed);
}
TEST_CASE("transforms: they commute with set operations in D = 3") {
    for (unsigned seed = 0; seed < scaled(40); ++seed) check_transforms<3>(seed);
}
TEST_CASE("transforms: they commute with set operations in D = 4") {
    for (unsigned seed = 0; seed < scaled(8); ++seed) check_transforms<4>(seed);
}
TEST_CASE("transforms: they commute with set operations in D = 5") {
    for (unsigned seed = 0; seed < scaled(2); ++seed) check_transforms<5>(seed);
}

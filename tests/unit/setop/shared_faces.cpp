// SPDX-License-Identifier: Apache-2.0
// The four operations by both engines on solids of four and five dimensions that share a facet, a ridge, an edge, a
// vertex, part of a facet or everything: sets by canonical form, and exact measures.
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/tree.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"
#include "support/shared_faces.hpp"

using namespace cleave;
using namespace support;

namespace {

template <int D>
Region<D> region(const HalfSpaces<D>& set) {
    return region_of<D>(set.planes);
}

/// 1 / D!, the measure of a simplex with D edges of length 1 at a right-angled corner.
Rational simplex_size(int d) {
    Rational product = 1;
    for (int i = 2; i <= d; ++i) product *= i;
    return Rational(1) / product;
}

Rational power(int base, int exponent) {
    Rational product = 1;
    for (int i = 0; i < exponent; ++i) product *= base;
    return product;
}

template <int D>
struct Results {
    Region<D> any, both, a_only, odd;
};

/// The operations on sets whose measures, and that of their common part, are known.
template <int D>
Results<D> check_pair(const Region<D>& a, const Region<D>& b, const Rational& size_a, const Rational& size_b,
                      const Rational& common) {
    CHECK(*measure(a) == size_a);
    CHECK(*measure(b) == size_b);
    const auto operate = [](Operation operation, const Region<D>& x, const Region<D>& y) {
        Region<D> result = apply(Engine::boundary_filter, operation, x, y);
        CHECK(canonical(apply(Engine::tree_merge, operation, x, y)) == canonical(result));
        return result;
    };
    const Results<D> r{operate(Operation::union_, a, b), operate(Operation::intersection, a, b),
                       operate(Operation::difference, a, b), operate(Operation::symmetric_difference, a, b)};
    CHECK(*measure(r.any) == size_a + size_b - common);
    CHECK(*measure(r.both) == common);
    CHECK(*measure(r.a_only) == size_a - common);
    CHECK(*measure(r.odd) == size_a + size_b - 2 * common);
    // What a set of lower dimension has in common is nothing.
    CHECK(r.both.is_empty() == (common == 0));
    CHECK((canonical(r.a_only) == canonical(a)) == (common == 0));
    CHECK((canonical(r.odd) == canonical(r.any)) == (common == 0));
    // The results are operands; in D = 5 that would take as long again.
    if constexpr (D == 4) {
        CHECK(canonical(operate(Operation::difference, r.any, b)) == canonical(r.a_only));
        CHECK(canonical(operate(Operation::intersection, r.any, a)) == canonical(a));
        CHECK(canonical(operate(Operation::symmetric_difference, r.odd, b)) == canonical(a));
        CHECK(canonical(operate(Operation::union_, r.a_only, r.both)) == canonical(a));
    }
    CHECK(canonical(to_region(to_tree(r.any))) == canonical(r.any));
    return r;
}

/// Mirror images in the first axes: they share a face of D - mirrored dimensions.
template <int D>
void check_mirrored(int mirrored) {
    INFO("D = " << D << ", axes mirrored: " << mirrored);
    const Rational size = simplex_size(D);
    const Region<D> simplex = region(corner_simplex<D>(0, 1));
    const Results<D> simplices =
        check_pair<D>(simplex, region(corner_simplex<D>(0, 1, mirrored)), size, size, mirrored == 0 ? size : 0);
    const Results<D> cubes = check_pair<D>(region(corner_cube<D>()), region(corner_cube<D>(mirrored)), 1, 1,
                                           mirrored == 0 ? Rational(1) : Rational(0));
    if (mirrored == 0) {
        CHECK(canonical(simplices.any) == canonical(simplex));
        CHECK(simplices.odd.is_empty());
        CHECK(cubes.a_only.is_empty());
    }
    if (mirrored == 1) {
        // Across a facet they join to one convex set, and nothing is left of the wall.
        HalfSpaces<D> joined = corner_simplex<D>(0, 1);
        joined.planes.erase(joined.planes.begin());
        joined.planes.push_back(corner_simplex<D>(0, 1, 1).planes.back());
        CHECK(canonical(simplices.any) == canonical(region(joined)));
        CHECK(canonical(cubes.any) == canonical(region(block<D>(-1, 1, 0, 1))));
    }
}

/// Two simplices that touch in less than a facet: the complement of their union, worked out from their complements,
/// gives back both.
template <int D>
void check_complements(int mirrored) {
    INFO("D = " << D << ", axes mirrored: " << mirrored);
    const Region<D> a = region(corner_simplex<D>(0, 1));
    const Region<D> b = region(corner_simplex<D>(0, 1, mirrored));
    for (const Engine engine : all_engines) {
        const Region<D> outside = apply(engine, Operation::intersection, Region<D>(~a), Region<D>(~b));
        CHECK(canonical(Region<D>(~outside)) == canonical(apply(engine, Operation::union_, a, b)));
        CHECK(canonical(apply(engine, Operation::difference, Region<D>(~b), outside)) == canonical(a));
        CHECK(apply(engine, Operation::union_, outside, Region<D>(~outside)).is_full());
    }
}

template <int D>
void check_nested() {
    INFO("D = " << D);
    const Rational size = simplex_size(D);
    const Region<D> inner = region(corner_simplex<D>(0, 1));
    const Region<D> outer = region(corner_simplex<D>(0, 2));
    const Results<D> corner = check_pair<D>(outer, inner, power(2, D) * size, size, size);
    CHECK(canonical(corner.any) == canonical(outer));
    CHECK(canonical(corner.both) == canonical(inner));
    // Without its corner the simplex is convex: the slab between two parallel planes.
    HalfSpaces<D> rest = corner_simplex<D>(0, 2);
    rest.planes.push_back(corner_simplex<D>(0, 1).planes.back());
    for (int& x : rest.planes.back()) x = -x;
    CHECK(canonical(corner.a_only) == canonical(region(rest)));
    // An inner simplex of edge D in an outer one of edge 4 D: a shell of two closed surfaces.
    const Region<D> hollow = region(corner_simplex<D>(0, 4 * D));
    const Region<D> core = region(corner_simplex<D>(1, 2 * D));
    const Results<D> apart =
        check_pair<D>(hollow, core, power(4 * D, D) * size, power(D, D) * size, power(D, D) * size);
    CHECK(apart.a_only.face_count() == 2 * (D + 1));
    CHECK(canonical(apart.any) == canonical(hollow));
    // Cubes.
    const Results<D> cubes =
        check_pair<D>(region(block<D>(0, 2, 0, 2)), region(block<D>(0, 1, 0, 1)), power(2, D), 1, 1);
    CHECK(canonical(cubes.both) == canonical(region(corner_cube<D>())));
}

template <int D>
void check_cubes_that_touch() {
    INFO("D = " << D);
    const Rational size = power(2, D);
    const Region<D> a = region(block<D>(0, 2, 0, 2));
    check_pair<D>(a, region(block<D>(2, 4, 1, 3)), size, size, 0);
    const Region<D> b = region(block<D>(1, 3, 1, 3));
    const Results<D> over = check_pair<D>(a, b, size, size, 1);
    CHECK(canonical(over.both) == canonical(region(block<D>(1, 2, 1, 2))));
    // With one side in common: [0, 2]^D and [1, 3] x [0, 2]^(D - 1).
    const Results<D> along = check_pair<D>(a, region(block<D>(1, 3, 0, 2)), size, size, size / 2);
    CHECK(canonical(along.any) == canonical(region(block<D>(0, 3, 0, 2))));
    CHECK(canonical(along.both) == canonical(region(block<D>(1, 2, 0, 2))));
    CHECK(canonical(along.a_only) == canonical(region(block<D>(0, 1, 0, 2))));
}

}  // namespace

TEST_CASE("shared faces: identical sets in D = 4 and 5") {
    check_mirrored<4>(0);
    check_mirrored<5>(0);
}

TEST_CASE("shared faces: sets with a common facet") {
    check_mirrored<4>(1);
    check_mirrored<5>(1);
}

TEST_CASE("shared faces: sets with a common ridge") {
    check_mirrored<4>(2);
    check_mirrored<5>(2);
    check_complements<4>(2);
}

TEST_CASE("shared faces: sets with a common edge") {
    check_mirrored<4>(3);
    check_mirrored<5>(4);
    check_complements<4>(3);
}

TEST_CASE("shared faces: sets with a common vertex") {
    check_mirrored<4>(4);
    check_mirrored<5>(5);
    check_complements<4>(4);
}

TEST_CASE("shared faces: nested sets") {
    check_nested<4>();
    check_nested<5>();
}

TEST_CASE("shared faces: cubes with part of a facet, a corner or sides in common") {
    check_cubes_that_touch<4>();
    check_cubes_that_touch<5>();
}

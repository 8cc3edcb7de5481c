// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/region.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/simplex.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

using namespace cleave;
using namespace support;

namespace {

template <int D>
void check_constants() {
    const Region<D> empty;
    CHECK(empty.is_empty());
    CHECK(!empty.is_full());
    CHECK(empty.is_bounded());
    CHECK(empty.face_count() == 0);
    const Region<D> full = Region<D>::full();
    CHECK(full.is_full());
    CHECK(!full.is_empty());
    CHECK(!full.is_bounded());
    CHECK(full.face_count() == 0);
    // There is one empty boundary and one full one.
    CHECK(empty.shared_boundary() == Region<D>::empty().shared_boundary());
    CHECK(full.shared_boundary() == Region<D>::full().shared_boundary());
    CHECK(complement(empty).is_full());
    CHECK(complement(full).is_empty());
    verified(empty);
    verified(full);
}

/// That the complement is the same faces turned round, and the complement of that the region itself, bit by bit.
template <int D>
void check_complement(const Region<D>& region) {
    const std::string before = dump(region.boundary());
    const Region<D> other = verified(complement(region));
    CHECK(dump(region.boundary()) == before);
    CHECK(dump(complement(other).boundary()) == before);
    CHECK(other.is_bounded() != region.is_bounded());
    CHECK(other.face_count() == region.face_count());
    const Boundary<D>& a = region.boundary();
    const Boundary<D>& b = other.boundary();
    CHECK(b.points.size() == a.points.size());
    CHECK(b.planes.size() == a.planes.size());
    for (std::size_t f = 0; f < a.faces.faces.size(); ++f) {
        CHECK(b.faces.faces[f].plane == flipped(a.faces.faces[f].plane));
        CHECK(b.faces.faces[f].source == a.faces.faces[f].source);
    }
    for (std::size_t l = 0; l + 1 < a.faces.loop_first.size(); ++l) {
        const std::span<const Corner> forth = region.surface().faces.loop(l);
        const std::span<const Corner> back = other.surface().faces.loop(l);
        REQUIRE(back.size() == forth.size());
        for (std::size_t i = 0; i < forth.size(); ++i) CHECK(back[i].point == forth[forth.size() - 1 - i].point);
    }
    const ExactRegion<D> inside(region);
    const ExactRegion<D> outside(other);
    for (int n = 0; n < 40; ++n) {
        Coordinates<D> p;
        for (std::size_t i = 0; i < std::size_t(D); ++i) p[i] = Rational((n * (3 + 4 * int(i)) % 23) - 5) / 3;
        const Where w = inside.locate(p);
        CHECK(outside.locate(p) == (w == Where::boundary ? w : w == Where::inside ? Where::outside : Where::inside));
    }
}

}  // namespace

TEST_CASE("region: empty and full are ordinary values, and empty is the default") {
    check_constants<1>();
    check_constants<2>();
    check_constants<3>();
    static_assert(Region<2>::dimension == 2);
    static_assert(std::is_same_v<Region<2>::number_type, Rational>);
    static_assert(std::is_same_v<Region<3, double>::number_type, double>);
}

TEST_CASE("region: copies share the boundary, assignment leaves other copies alone") {
    Region<3> a = box<3>({0, 0, 0}, {1, 1, 1});
    const long uses = a.shared_boundary().use_count();
    const Region<3> b = a;
    CHECK(&a.boundary() == &b.boundary());
    CHECK(a.shared_boundary() == b.shared_boundary());
    CHECK(a.shared_boundary().use_count() == uses + 1);
    const std::string before = dump(b.boundary());
    a = Region<3>::empty();
    CHECK(a.is_empty());
    CHECK(b.face_count() == 6);
    CHECK(dump(b.boundary()) == before);
    Region<3> c = b;
    const Region<3> d = std::move(c);
    CHECK(d.shared_boundary() == b.shared_boundary());
    c = d;  // a moved-from region can be assigned to
    CHECK(c.face_count() == 6);
}

TEST_CASE("region: another number type is another view of the same boundary") {
    const Region<2> a = box<2>({0, 0}, {1, 3});
    const Region<2, double> b(a);
    const Region<2, Integer> c(b);
    CHECK(b.shared_boundary() == a.shared_boundary());
    CHECK(Region<2>(c).shared_boundary() == a.shared_boundary());
    static_assert(!std::is_convertible_v<Region<2>, Region<2, double>>);  // on demand only
    CHECK(Region<2, double>(Region<2>::full()).is_full());
}

TEST_CASE("region: of a finished boundary") {
    Boundary<2> constant;
    CHECK(Region<2>(constant).is_empty());
    constant.value_at_infinity = true;
    CHECK(Region<2>(constant).is_full());
    const Region<2> a = box<2>({0, 0}, {1, 3});
    const Region<2> copy(a.boundary());
    CHECK(copy.shared_boundary() != a.shared_boundary());
    CHECK(dump(copy.boundary()) == dump(a.boundary()));
}

TEST_CASE("region: the complement turns every face round, and back") {
    check_complement<1>(intervals({{0, 1}, {Rational(5, 3), 2}}));
    check_complement<2>(box<2>({0, 0}, {4, 4}) - simplex<2>({{1, 1}, {2, 1}, {1, 3}}));
    const Region<3> cube = box<3>({0, 0, 0}, {4, 4, 4});
    check_complement<3>(cube);
    check_complement<3>(cube - box<3>({1, 1, -1}, {2, 2, 5}));  // with holes in faces
    check_complement<3>(cube - prism<Rational>({{0, 0}, {2, 1}, {1, 2}}, -1, 5));
    check_complement<3>(cube ^ simplex<3>({{1, 1, 1}, {9, 2, 1}, {2, 9, 3}, {3, 1, 9}}));
    const Region<2, double> square(box<2>({0, 0}, {1, 1}));
    CHECK(!complement(square).is_bounded());
}

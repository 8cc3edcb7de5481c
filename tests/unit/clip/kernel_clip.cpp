// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/kernel_clip.hpp>
//
#include "support/catch.hpp"
#include "support/clip_laws.hpp"

#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

using namespace cleave;

template <int D>
constexpr bool is_full_model = BoundedClip<KernelClip<D>>&& LocatingClip<KernelClip<D>>&& ProposingClip<KernelClip<D>>;
static_assert(is_full_model<1> && is_full_model<2> && is_full_model<3>);

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
struct Space {
    using Place = std::array<double, std::size_t(D)>;

    Kernel<D> kernel;
    KernelClip<D> clip{kernel};

    PlaneId plane(const std::array<int, std::size_t(D) + 1>& c) {
        typename PlaneTable<D>::Coefficients exact;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) exact[i] = Integer(c[i]);
        return kernel.planes.intern(exact);
    }
    KernelFacet<1> end(double at, bool upper) requires(D == 1) {
        const Corner c{kernel.add_point(Place{at}), no_id};
        const PlaneId h = kernel.planes.intern_axis_plane(0, at);
        return clip.make(upper ? h : flipped(h), {&c, 1});
    }
    /// Ends with lines along an axis that the segment is not parallel to.
    KernelFacet<2> segment(const Place& a, const Place& b) requires(D == 2) {
        const std::array<PointId, 2> p{kernel.add_point(a), kernel.add_point(b)};
        const int axis = a[0] != b[0] ? 0 : 1;
        std::array<Corner, 2> corners{};
        for (std::size_t i = 0; i < 2; ++i) {
            const PlaneId at = kernel.planes.intern_axis_plane(axis, (i == 0 ? a : b)[std::size_t(axis)]);
            corners[i] = {p[i], kernel.side(at, p[1 - i]) == Sign::minus ? at : flipped(at)};
        }
        return clip.make(*kernel.join(std::span<const PointId, 2>(p)), corners);
    }
    /// Edge planes along the direction (1, 2, 7), to which no face here is parallel.
    KernelFacet<3> polygon(const std::vector<Place>& places) requires(D == 3) {
        std::vector<PointId> p;
        for (const Place& x : places) p.push_back(kernel.add_point(x));
        const PlaneId f = *kernel.join(std::array{p[0], p[1], p[2]});
        const Homogeneous<3> across{Integer(1), Integer(2), Integer(7), Integer(0)};
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const PointId q = p[(i + 1) % p.size()];
            const PlaneId e = *kernel.join(std::array{kernel.coordinates(p[i]), kernel.coordinates(q), across});
            corners.push_back({p[i], orient_edge(kernel, f, e, p[i], q)});
        }
        return clip.make(f, corners);
    }
    std::vector<Corner> corners(const KernelFacet<D>& f) const {
        return {clip.corners(f).begin(), clip.corners(f).end()};
    }
    Rational coordinate(PointId p, std::size_t axis) {
        const Homogeneous<D> h = kernel.coordinates(p);
        return number_traits<Rational>::from_fraction(h[axis], h[std::size_t(D)]);
    }
    /// D = 2: the extent along `axis`; D = 3: twice the area as seen along it.
    Rational size(const KernelFacet<D>& f, std::size_t axis) {
        const std::vector<Corner> c = corners(f);
        if constexpr (D == 2) return coordinate(c[1].point, axis) - coordinate(c[0].point, axis);
        Rational sum(0);
        for (std::size_t i = 0; i < c.size(); ++i) {
            const PointId p = c[i].point;
            const PointId q = c[(i + 1) % c.size()].point;
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            sum += coordinate(p, u) * coordinate(q, v) - coordinate(p, v) * coordinate(q, u);
        }
        return sum;
    }
    /// All facets against all planes: the laws, that sizes add up whatever was asked before, and that parts have
    /// ridges.
    void check(const std::vector<KernelFacet<D>>& facets, const std::vector<PlaneId>& planes) {
        check_clip_laws(clip, facets, planes);
        if constexpr (D > 1)
            for (const KernelFacet<D>& f : facets)
                for (const PlaneId h : planes) {
                    if (f.first % 2 == 0) (void)clip.side(flipped(h), f);
                    const Split<KernelFacet<D>> s = clip.split(h, f);
                    for (std::size_t axis = 0; axis < std::size_t(D); ++axis) {
                        Rational parts(0);
                        for (const auto& part : {s.minus, s.on, s.plus})
                            if (part) parts += size(*part, axis);
                        CHECK(parts == size(f, axis));
                    }
                    for (const auto& part : {s.minus, s.plus})
                        if (part)
                            for (const PlaneId e : clip.ridges(*part)) CHECK(clip.side(e, *part) == FacetSide::minus);
                }
    }
};

}  // namespace

TEST_CASE("kernel clip: laws in D = 1") {
    Space<1> s;
    s.check({s.end(-1, false), s.end(0, true), s.end(0.5, true), s.end(0, false)},
            {s.plane({1, 1}), s.plane({1, 0}), s.plane({-2, 1}), s.plane({3, -1})});
    CHECK(s.clip.ridges(s.end(0, true)).empty());
}

TEST_CASE("kernel clip: laws in D = 2") {
    Space<2> s;
    // Of the same line: the segment, a part of it, what follows it, and the other way round.
    s.check({s.segment({0, 0}, {4, 2}), s.segment({2, 1}, {4, 2}), s.segment({4, 2}, {6, 3}), s.segment({4, 2}, {0, 0}),
             s.segment({0, 1}, {4, 3}), s.segment({3, -1}, {3, 5})},
            {s.plane({1, -2, 0}), s.plane({-1, 2, 0}), s.plane({1, -2, 2}), s.plane({1, 0, -4}), s.plane({0, -1, 1}),
             s.plane({1, 1, -5}), s.plane({3, 0, -1})});
}

TEST_CASE("kernel clip: laws in D = 3") {
    Space<3> s;
    // A square, the triangle that is half of it, the same facing down, a hexagon, a triangle on a slope.
    s.check({s.polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}), s.polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}),
             s.polygon({{0, 0, 0}, {0, 4, 0}, {4, 4, 0}}),
             s.polygon({{1, 0, 2}, {3, 0, 2}, {4, 2, 2}, {3, 4, 2}, {1, 4, 2}, {0, 2, 2}}),
             s.polygon({{4, 0, 0}, {0, 4, 0}, {0, 0, 4}})},
            {s.plane({0, 0, 1, 0}), s.plane({0, 0, -1, 2}), s.plane({1, -1, 0, 0}), s.plane({1, 0, 0, -4}),
             s.plane({1, 1, 1, -4}), s.plane({2, 3, 5, -7}), s.plane({-3, 0, 0, 1})});
}

TEST_CASE("kernel clip: coincident, parallel and antiparallel planes of any size") {
    Space<3> s;
    const PlaneId h = s.plane({2, -3, 0, 1});
    CHECK(s.clip.relation(h, s.plane({4, -6, 0, 2})) == PlaneRelation::same);
    CHECK(s.clip.relation(h, s.plane({-2, 3, 0, -1})) == PlaneRelation::opposite);
    CHECK(s.clip.relation(h, s.plane({4, -6, 0, 3})) == PlaneRelation::parallel);
    CHECK(s.clip.relation(h, s.plane({-4, 6, 0, 3})) == PlaneRelation::antiparallel);
    CHECK(s.clip.relation(h, s.plane({2, 3, 0, 1})) == PlaneRelation::crossing);
    // Normals that doubles cannot tell apart.
    const Integer big = Integer::scaled(1, 2000);
    const auto huge = [&](int last) {
        return s.kernel.planes.intern({big, Integer(big + Integer(last)), Integer(0), Integer(last)});
    };
    CHECK(s.clip.relation(huge(1), huge(2)) == PlaneRelation::crossing);
    CHECK(s.clip.relation(huge(1), huge(1)) == PlaneRelation::same);
}

TEST_CASE("kernel clip: a cut names its points, and gives both parts the plane of the cut") {
    Space<3> s;
    const KernelFacet<3> f = s.polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    const std::vector<Corner> before = s.corners(f);
    const PlaneId h = s.plane({3, 0, 0, -4});
    const Split<KernelFacet<3>> cut = s.clip.split(h, f);
    REQUIRE(cut.side == FacetSide::crossing);
    const std::vector<Corner> minus = s.corners(*cut.minus);
    const std::vector<Corner> plus = s.corners(*cut.plus);
    REQUIRE(minus.size() == 4);
    REQUIRE(plus.size() == 4);
    CHECK(std::count_if(minus.begin(), minus.end(), [&](const Corner& c) { return c.edge == h; }) == 1);
    CHECK(std::count_if(plus.begin(), plus.end(), [&](const Corner& c) { return c.edge == flipped(h); }) == 1);
    for (const PointId p : {PointId(4), PointId(5)}) {
        const PointRecord<3>& r = s.kernel.point(p);
        CHECK(r.kind == PointRecord<3>::Kind::meet);
        CHECK(r.planes[0] == unoriented(f.plane));
        CHECK(r.planes[2] == unoriented(h));
        CHECK(s.coordinate(p, 0) == Rational(4, 3));
    }
    CHECK(s.kernel.point_count() == 6);
    // Through corners nothing is made, and handles given out before are good.
    const Split<KernelFacet<3>> diagonal = s.clip.split(s.plane({1, -1, 0, 0}), f);
    CHECK(s.kernel.point_count() == 6);
    CHECK(diagonal.minus->size == 3);
    CHECK(diagonal.plus->size == 3);
    CHECK(s.corners(f) == before);
    CHECK(s.corners(*cut.minus) == minus);
    // A touching plane gives the facet back as it is.
    const Split<KernelFacet<3>> touching = s.clip.split(s.plane({1, 0, 0, -4}), f);
    CHECK(touching.side == FacetSide::minus);
    CHECK(touching.minus->first == f.first);
}

TEST_CASE("kernel clip: a flipped facet keeps each plane with its edge") {
    Space<3> s;
    const KernelFacet<3> f = s.polygon({{4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
    const KernelFacet<3> g = s.clip.flip(f);
    CHECK(g.plane == flipped(f.plane));
    const std::vector<Corner> a = s.corners(f);
    const std::vector<Corner> b = s.corners(g);
    CHECK(b == std::vector<Corner>{{a[2].point, a[1].edge}, {a[1].point, a[0].edge}, {a[0].point, a[2].edge}});
    CHECK(s.corners(s.clip.flip(g)) == a);
    CHECK(s.clip.box(g).lo == f.box.lo);
    CHECK(s.clip.box(g).hi == f.box.hi);
    std::vector<Corner> segment{{1, 10}, {2, 12}};
    KernelClip<2>::reverse_corners(segment);  // ends keep their lines
    CHECK(segment == std::vector<Corner>{{2, 12}, {1, 10}});
}

TEST_CASE("bounds: closed boxes, empty until something is included") {
    Bounds<2> a;
    CHECK(a.disjoint(a));
    a.include({1, 2}, 0);
    CHECK(a.lo == std::array<double, 2>{1, 2});
    CHECK(a.hi == std::array<double, 2>{1, 2});
    CHECK(!a.disjoint(a));
    Bounds<2> b;
    b.include({3, 0}, 0);
    b.include({1, 1}, 0);
    CHECK(a.disjoint(b));
    b.include({2, 2}, 0);  // now they touch in (1, 2)
    CHECK(!a.disjoint(b));
    CHECK(!b.disjoint(a));
    a.include(b);
    CHECK(a.lo == std::array<double, 2>{1, 0});
    CHECK(a.hi == std::array<double, 2>{3, 2});
    Bounds<1> near;
    near.include({1}, 0.25);
    CHECK(near.lo[0] < 0.75);  // wider than the error, for the rounding
    CHECK(near.lo[0] > 0.7499);
    CHECK(near.hi[0] > 1.25);
    for (const double x : {0.0, infinity}) {
        Bounds<1> anywhere;
        anywhere.include({x}, infinity);
        CHECK(anywhere.lo[0] == -infinity);
        CHECK(anywhere.hi[0] == infinity);
    }
}

TEST_CASE("kernel clip: boxes contain corners that no double is, and that are beyond all of them") {
    Space<1> s;
    const auto box_at = [&](const Integer& num, const Integer& den) {
        const Corner c{s.kernel.add_point(Homogeneous<1>{num, den}), no_id};
        return s.clip.make(s.kernel.planes.intern({den, -num}), {&c, 1}).box;
    };
    const Bounds<1> third = box_at(Integer(1), Integer(3));
    CHECK(number_traits<Rational>::from_double(third.lo[0]) < Rational(1, 3));
    CHECK(number_traits<Rational>::from_double(third.hi[0]) > Rational(1, 3));
    CHECK(third.hi[0] - third.lo[0] < 0x1p-48);
    const Bounds<1> far = box_at(Integer::scaled(1, 3000), Integer(1));
    CHECK(!far.disjoint(third));  // not known where it is, so disjoint from nothing
    CHECK(KernelClip<1>::hull(far, third).hi[0] == infinity);
}

TEST_CASE("kernel clip: proposed planes halve what can be halved") {
    Space<2> s;
    std::vector<KernelFacet<2>> row;
    for (int i = 0; i < 20; ++i) row.push_back(s.segment({double(i), 0}, {double(i + 1), 0}));
    const std::optional<PlaneId> middle = s.clip.propose(row);
    REQUIRE(middle.has_value());
    CHECK(*middle == s.kernel.planes.intern_axis_plane(0, 10));  // between two segments: none is split
    std::vector<KernelFacet<2>> column;
    for (int i = 0; i < 20; ++i) column.push_back(s.segment({0, double(3 * i)}, {1, double(3 * i)}));
    CHECK(*s.clip.propose(column) == s.kernel.planes.intern_axis_plane(1, 30));
    // Nineteen in one place and one apart, all in one place, all across each other.
    const std::vector<KernelFacet<2>> same(19, row[0]);
    CHECK(!s.clip.propose(same));
    std::vector<KernelFacet<2>> apart = same;
    apart.push_back(row[9]);
    CHECK(!s.clip.propose(apart));
    std::vector<KernelFacet<2>> bundle;
    for (int i = 0; i < 20; ++i) bundle.push_back(s.segment({double(-i - 1), double(-i)}, {20, double(i + 1)}));
    CHECK(!s.clip.propose(bundle));
    CHECK(!s.clip.propose({}));
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/polytope.hpp>
//
#include <cleave/clip/polytope_clip.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The cell that half-spaces leave; it must not become empty.
template <int D>
Polytope cell_of(Kernel<D>& kernel, const HalfSpaces<D>& set) {
    PolytopeCutter<D> cutter(kernel);
    Polytope cell = universe(kernel);
    for (const IntegerPlane<D>& p : set.planes) {
        PolytopeSplit s = cutter.split(intern(kernel, p), cell);
        REQUIRE(s.side != FacetSide::plus);
        if (s.side == FacetSide::crossing) cell = std::move(s.minus);
    }
    return cell;
}

template <int D>
HalfSpaces<D> cube(int lo, int hi) {
    std::array<int, std::size_t(D)> a{};
    std::array<int, std::size_t(D)> b{};
    a.fill(lo);
    b.fill(hi);
    return integer_box<D>(a, b);
}

/// |x_1| + ... + |x_D| <= 1.
template <int D>
HalfSpaces<D> cross_polytope() {
    HalfSpaces<D> h;
    for (unsigned signs = 0; signs < (1U << unsigned(D)); ++signs) {
        IntegerPlane<D> p{};
        for (unsigned i = 0; i < unsigned(D); ++i) p[i] = (signs >> i & 1U) != 0 ? 1 : -1;
        p[std::size_t(D)] = -1;
        h.planes.push_back(p);
    }
    return h;
}

/// Every plane of every vertex goes through it, every bounding plane through a vertex is known, edges are those that
/// incidences give.
template <int D>
void check_polytope(Kernel<D>& kernel, const Polytope& p, const std::vector<PlaneId>& bounding) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto own = p.planes_of(i);
        CHECK(std::is_sorted(own.begin(), own.end()));
        CHECK(own.size() >= std::size_t(D));
        for (const std::uint32_t k : own) CHECK(kernel.side(2 * k, p.points[i]) == Sign::zero);
        for (const PlaneId h : bounding)
            if (kernel.side(h, p.points[i]) == Sign::zero) CHECK(p.has(i, unoriented(h)));
    }
    Polytope again = p;
    again.edges.clear();
    PolytopeCutter<D>(kernel).find_edges(again);
    auto edges = p.edges;
    std::sort(edges.begin(), edges.end());
    CHECK(edges == again.edges);
}

/// How many faces lie two dimensions below the polytope: the largest faces of its largest faces, each once.
std::size_t count_ridges(const Polytope& p) {
    std::vector<std::vector<PointId>> ridges;
    for (const PolytopeFace& facet : largest_faces(p)) {
        const Polytope f = subpolytope(p, facet.vertices);
        for (const PolytopeFace& ridge : largest_faces(f)) {
            std::vector<PointId> points;
            for (const std::uint32_t v : ridge.vertices) points.push_back(f.points[v]);
            std::sort(points.begin(), points.end());
            ridges.push_back(points);
        }
    }
    std::sort(ridges.begin(), ridges.end());
    ridges.erase(std::unique(ridges.begin(), ridges.end()), ridges.end());
    return ridges.size();
}

template <int D>
void check_known() {
    Kernel<D> kernel;
    const std::size_t corners = std::size_t(1) << unsigned(D);
    const auto d = std::size_t(D);
    const Polytope all = universe(kernel);
    CHECK(all.size() == corners);
    CHECK(all.edges.size() == d * corners / 2);
    CHECK(largest_faces(all).size() == 2 * d);
    for (const PointId p : all.points) CHECK(kernel.is_infinite(p));

    const Polytope c = cell_of(kernel, cube<D>(0, 2));
    CHECK(c.size() == corners);
    CHECK(c.edges.size() == d * corners / 2);
    for (const PointId p : c.points) CHECK(!kernel.is_infinite(p));

    const Polytope cross = cell_of(kernel, cross_polytope<D>());
    CHECK(cross.size() == 2 * d);
    CHECK(cross.edges.size() == (D == 1 ? 1 : 2 * d * (d - 1)));
    CHECK(largest_faces(cross).size() == (D == 1 ? 2 : corners));
    if (D >= 2) CHECK(count_ridges(cross) == d * corners / 2);
}

/// The plane x_1 = x_2 cuts the cube through half of its vertices and makes none.
template <int D>
void check_diagonal() {
    Kernel<D> kernel;
    PolytopeCutter<D> cutter(kernel);
    const Polytope c = cell_of(kernel, cube<D>(0, 1));
    const std::size_t points = kernel.point_count();
    IntegerPlane<D> diagonal{};
    diagonal[0] = 1;
    diagonal[1] = -1;
    const PlaneId h = intern(kernel, diagonal);
    const PolytopeSplit s = cutter.split(h, c);
    CHECK(s.side == FacetSide::crossing);
    CHECK(kernel.point_count() == points);
    const std::size_t corners = std::size_t(1) << unsigned(D);
    CHECK(s.minus.size() == corners * 3 / 4);
    CHECK(s.plus.size() == corners * 3 / 4);
    CHECK(s.lid.size() == corners / 2);
    // A prism over a triangle with the cube of D - 2 dimensions: three times its corners, and its edges at each.
    const std::size_t rest = corners / 4;
    CHECK(s.minus.edges.size() == 3 * rest + 3 * (std::size_t(D - 2) * rest / 2));
    CHECK(s.lid.edges.size() == std::size_t(D - 1) * rest);
    std::vector<PlaneId> bounding{h};
    for (const IntegerPlane<D>& p : cube<D>(0, 1).planes) bounding.push_back(intern(kernel, p));
    check_polytope(kernel, s.minus, bounding);
    check_polytope(kernel, s.plus, bounding);
    // It touches the parts and cuts them no more.
    CHECK(cutter.split(h, s.minus).side == FacetSide::minus);
    CHECK(cutter.split(h, s.plus).side == FacetSide::plus);
    CHECK(cutter.split(flipped(h), s.plus).side == FacetSide::minus);
    CHECK(cutter.side(h, s.lid) == FacetSide::on_same);
}

template <int D>
void check_random_cuts(unsigned seed) {
    Dice dice(seed);
    Kernel<D> kernel;
    PolytopeCutter<D> cutter(kernel);
    Polytope cell = universe(kernel);
    std::vector<PlaneId> bounding;
    for (int n = 0; n < 2 * D + 2; ++n) {
        const HalfSpaces<D> one = random_convex<D>(dice, false);
        const PlaneId h = intern(kernel, one.planes.back());
        PolytopeSplit s = cutter.split(h, cell);
        if (s.side != FacetSide::crossing) continue;
        bounding.push_back(h);
        CHECK(s.lid.size() >= std::size_t(D));
        check_polytope(kernel, s.minus, bounding);
        check_polytope(kernel, s.plus, bounding);
        cell = dice.below(2) == 0 ? std::move(s.minus) : std::move(s.plus);
    }
}

}  // namespace

TEST_CASE("polytope: cubes and cross polytopes in D = 1 to 6 have the faces they are known for") {
    check_known<1>();
    check_known<2>();
    check_known<3>();
    check_known<4>();
    check_known<5>();
    check_known<6>();
}

TEST_CASE("polytope: a cut through vertices makes no new ones, and touching is not cutting") {
    check_diagonal<2>();
    check_diagonal<3>();
    check_diagonal<4>();
    check_diagonal<5>();
}

TEST_CASE("polytope: vertices know every bounding plane, edges follow from them, after random cuts") {
    for (unsigned seed = 0; seed < scaled(40); ++seed) {
        check_random_cuts<1>(seed);
        check_random_cuts<2>(seed);
        check_random_cuts<3>(seed);
        check_random_cuts<4>(seed);
    }
    for (unsigned seed = 0; seed < scaled(10); ++seed) check_random_cuts<5>(seed);
}

TEST_CASE("polytope: an edge on more planes than it needs is cut at the meet of independent ones") {
    // Four planes through the axis x_4 of 4-space, three of them dependent: x_1, x_2, x_1 + x_2 and x_3.
    Kernel<4> kernel;
    HalfSpaces<4> wedge;
    wedge.planes = {{-1, 0, 0, 0, 0}, {0, -1, 0, 0, 0}, {-1, -1, 0, 0, 0}, {0, 0, -1, 0, 0}, {0, 0, 0, -1, 0}};
    PolytopeCutter<4> cutter(kernel);
    Polytope cell = universe(kernel);
    for (const IntegerPlane<4>& p :
         {IntegerPlane<4>{-1, -1, 0, 0, 0}, wedge.planes[0], wedge.planes[1], wedge.planes[3], wedge.planes[4]}) {
        PolytopeSplit s = cutter.split(intern(kernel, p), cell);
        REQUIRE(s.side == FacetSide::crossing);
        cell = std::move(s.minus);
    }
    const PolytopeSplit s = cutter.split(intern<4>(kernel, {0, 0, 0, 1, -5}), cell);
    REQUIRE(s.side == FacetSide::crossing);
    std::size_t finite = 0;
    for (const PointId p : s.lid.points) {
        if (kernel.is_infinite(p)) continue;
        ++finite;
        const Homogeneous<4> x = kernel.coordinates(p);
        CHECK(x[0].is_zero());
        CHECK(x[1].is_zero());
        CHECK(x[2].is_zero());
        CHECK(x[3] == x[4] * Integer(5));
    }
    CHECK(finite == 1);
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/facets.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/simplex.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// A region's facets in a kernel of their own.
template <int D>
struct Facets {
    Region<D> region;
    Kernel<D> kernel;
    KernelClip<D> clip{kernel};
    PointInterner<D> points{kernel};
    LoadedBoundary<D> loaded;
    LoadedFacets<D> made;

    explicit Facets(const Region<D>& r) : region(r), loaded(load(region.boundary(), kernel)) {
        made = make_facets(region.boundary(), loaded, clip, points);
    }
    std::vector<KernelFacet<D>> of_face(std::uint32_t f) const {
        std::vector<KernelFacet<D>> list;
        for (std::size_t i = 0; i < made.face.size(); ++i)
            if (made.face[i] == f) list.push_back(made.facets[i]);
        return list;
    }
    Coordinates<D> place(PointId p) {
        const Homogeneous<D> h = kernel.coordinates(p);
        Coordinates<D> x;
        for (std::size_t i = 0; i < std::size_t(D); ++i) x[i] = rational(h[i], h[std::size_t(D)]);
        return x;
    }
    bool all_corners(const KernelFacet<D>& f, PlaneId h, Sign never) {
        const auto corners = clip.corners(f);
        return std::all_of(corners.begin(), corners.end(),
                           [&](const Corner& c) { return kernel.side(h, c.point) != never; });
    }
    /// Whether an edge of the one has the other on its far side.
    bool parted(const KernelFacet<D>& a, const KernelFacet<D>& b) {
        for (const PlaneId e : clip.ridges(a))
            if (all_corners(b, e, Sign::minus)) return true;
        for (const PlaneId e : clip.ridges(b))
            if (all_corners(a, e, Sign::minus)) return true;
        return false;
    }
};

/// Twice the area of a loop, as a vector.
Coordinates<3> doubled_area(const std::vector<Coordinates<3>>& loop) {
    Coordinates<3> sum{0, 0, 0};
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Coordinates<3> c = cross(subtract(loop[i], loop[0]), subtract(loop[i + 1], loop[0]));
        for (std::size_t j = 0; j < 3; ++j) sum[j] += c[j];
    }
    return sum;
}

/// Checks that the facets are convex, within their face and apart, that they fill it, and that nothing but the face's
/// own edges cut them. Returns: the number of facets of each face.
std::vector<std::size_t> counts(const Region<3>& region) {
    Facets<3> s(region);
    const ExactRegion<3> exact(region);
    std::vector<std::size_t> result;
    std::size_t total = 0;
    CHECK(std::is_sorted(s.made.face.begin(), s.made.face.end()));
    for (std::uint32_t f = 0; f < region.face_count(); ++f) {
        const FaceList::Face& face = region.boundary().faces.faces[f];
        const std::vector<KernelFacet<3>> facets = s.of_face(f);
        std::set<std::uint32_t> own;
        Coordinates<3> missing{0, 0, 0};
        for (std::uint32_t l = 0; l < face.loop_count; ++l) {
            for (const Corner& c : region.boundary().faces.loop(face.first_loop + l))
                own.insert(unoriented(s.loaded.corner(c).edge));
            const Coordinates<3> area = doubled_area(exact.faces()[f].loops[l]);
            for (std::size_t i = 0; i < 3; ++i) missing[i] += area[i];
        }
        for (std::size_t i = 0; i < facets.size(); ++i) {
            CHECK(facets[i].plane == s.loaded.plane(face.plane));
            std::vector<Coordinates<3>> loop;
            Coordinates<3> middle{0, 0, 0};
            for (const Corner& c :
                 std::vector<Corner>(s.clip.corners(facets[i]).begin(), s.clip.corners(facets[i]).end())) {
                loop.push_back(s.place(c.point));
                CHECK(s.all_corners(facets[i], c.edge, Sign::plus));
                CHECK(s.kernel.side(c.edge, c.point) == Sign::zero);
                CHECK(own.count(unoriented(c.edge)) == 1);
            }
            for (const Coordinates<3>& p : loop) middle = along(middle, Rational(1, long(loop.size())), p);
            CHECK(exact.on_face(f, middle));
            const Coordinates<3> area = doubled_area(loop);
            for (std::size_t k = 0; k < 3; ++k) missing[k] -= area[k];
            for (std::size_t j = 0; j < i; ++j) CHECK(s.parted(facets[i], facets[j]));
        }
        CHECK(missing == Coordinates<3>{0, 0, 0});
        result.push_back(facets.size());
        total += facets.size();
    }
    CHECK(total == s.made.facets.size());
    return result;
}

using Loop = std::vector<std::array<Rational, 2>>;

}  // namespace

TEST_CASE("facets: in one and two dimensions, one for each end and each segment") {
    Facets<1> ends(intervals({{0, 1}, {2, 3}}));
    CHECK(ends.made.face == std::vector<std::uint32_t>{0, 1, 2, 3});
    for (const KernelFacet<1>& f : ends.made.facets) CHECK(f.size == 1);
    // The lower side of a square with a notch is one face of two segments.
    Facets<2> notched(box<2>({0, 0}, {4, 4}) - box<2>({1, -1}, {2, 1}));
    REQUIRE(notched.of_face(0).size() == 2);
    CHECK(notched.made.facets.size() == notched.region.face_count() + 1);
    Rational length(0);
    for (const KernelFacet<2>& f : notched.of_face(0)) {
        CHECK(f.plane == notched.loaded.plane(notched.region.boundary().faces.faces[0].plane));
        const auto corners = notched.clip.corners(f);
        length += notched.place(corners[1].point)[0] - notched.place(corners[0].point)[0];
    }
    CHECK(length == 3);
    CHECK(Facets<2>(Region<2>::full()).made.facets.empty());
}

TEST_CASE("facets: convex faces stay whole, corner by corner") {
    CHECK(counts(box<3>({0, 0, 0}, {1, 2, 3})) == std::vector<std::size_t>(6, 1));
    CHECK(counts(simplex<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) == std::vector<std::size_t>(4, 1));
    // Straight corners make nothing less convex, nor does a complement.
    const Loop dozen = {{3, 0}, {6, 0}, {8, 2}, {9, 3}, {9, 6}, {7, 8}, {6, 9}, {3, 9}, {1, 7}, {0, 6}, {0, 3}, {1, 2}};
    const Region<3> solid = prism<Rational>(dozen, 0, 1);
    CHECK(counts(solid) == std::vector<std::size_t>(14, 1));
    CHECK(counts(~solid) == std::vector<std::size_t>(14, 1));
    Facets<3> s(solid);
    for (std::uint32_t f = 0; f < 14; ++f) {
        std::vector<Corner> corners(s.clip.corners(s.made.facets[f]).begin(), s.clip.corners(s.made.facets[f]).end());
        std::vector<Corner> given;
        for (const Corner& c : solid.boundary().faces.loop(f)) given.push_back(s.loaded.corner(c));
        const auto start = std::find(given.begin(), given.end(), corners.front());
        REQUIRE(start != given.end());
        std::rotate(given.begin(), start, given.end());
        CHECK(corners == given);
    }
}

TEST_CASE("facets: faces that are not convex, of few corners and of many") {
    const Region<3> corner = prism<Rational>({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1);
    CHECK(counts(corner) == std::vector<std::size_t>{2, 2, 1, 1, 1, 1, 1, 1});
    CHECK(counts(~corner) == std::vector<std::size_t>{2, 2, 1, 1, 1, 1, 1, 1});
    // A cut through a far corner: the line of the notch's side meets (4, 4).
    CHECK(counts(prism<Rational>({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, 0, 1))[0] == 2);
    // Combs and saws: all notches at one height, and each at its own.
    for (const int step : {0, 1}) {
        Loop comb = {{24, -1}, {24, 9}};
        for (int x = 11; x >= 0; --x) {
            comb.push_back({2 * x + 1, x * step});
            comb.push_back({2 * x, 10 + step * (x % 3)});
        }
        comb.push_back({0, -1});
        const std::vector<std::size_t> pieces = counts(prism(comb, 0, 1));
        CHECK(pieces[0] >= 12);
        CHECK(pieces[0] == pieces[1]);
    }
    // A spiral: the lines of its inner edges cross all windings.
    CHECK(counts(prism<Rational>({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 2}, {7, 2}, {7, 7}, {2, 7}, {2, 4}, {5, 4},
                                  {5, 5}, {3, 5}, {3, 6}, {6, 6}, {6, 3}, {1, 3}, {1, 8}, {8, 8}, {8, 1}, {0, 1}},
                                 0, 1))[0] > 8);
}

TEST_CASE("facets: holes, islands, several pieces, and loops that touch") {
    const Region<3> plate = box<3>({0, 0, 0}, {9, 9, 1});
    const auto through = [](const Loop& loop) { return prism(loop, -1, 2); };
    const Region<3> holed = plate - box<3>({1, 1, -1}, {3, 3, 2}) - through({{5, 2}, {8, 3}, {6, 7}});
    CHECK(counts(holed)[4] >= 6);
    CHECK(counts(holed | box<3>({1, 1, 0}, {2, 2, 1}))[4] >= 6);
    CHECK(counts((plate - box<3>({1, 1, -1}, {8, 8, 2})) | box<3>({3, 3, 0}, {5, 5, 1})).size() > 6);
    // A bar cut in two: its long faces are in two pieces each.
    const std::vector<std::size_t> bar = counts(box<3>({0, 0, 0}, {9, 1, 1}) - box<3>({3, -1, -1}, {4, 2, 2}));
    CHECK(std::count(bar.begin(), bar.end(), 2U) == 4);
    // Holes that touch a side, a corner, each other, and themselves.
    counts(plate - through({{9, 4}, {7, 5}, {6, 4}, {7, 3}}));
    counts(plate - through({{0, 0}, {2, 1}, {1, 2}}));
    counts(plate - through({{1, 1}, {3, 1}, {3, 3}, {1, 3}}) - through({{3, 3}, {5, 3}, {5, 5}, {3, 5}}));
    counts(plate - through({{1, 1}, {4, 1}, {4, 4}, {7, 4}, {7, 7}, {4, 7}, {4, 4}, {1, 4}}));
    counts(plate - through({{0, 4}, {4, 0}, {9, 4}, {4, 9}}));  // four corners remain
}

TEST_CASE("facets: slanted faces, whose corners are meets of planes") {
    const Region<3> wedge = simplex<3>({{-7, -3, -1}, {40, -2, -1}, {-5, 60, -1}, {-3, -2, 7}});
    const Region<3> holed = (box<3>({0, 0, 0}, {9, 9, 20}) - box<3>({1, 1, -1}, {3, 3, 21}) -
                             prism<Rational>({{5, 2}, {8, 3}, {6, 7}}, -1, 21)) &
                            wedge;
    const std::vector<std::size_t> pieces = counts(holed);
    CHECK(*std::max_element(pieces.begin(), pieces.end()) >= 6);
    counts(~holed);
}

TEST_CASE("facets: the cutter takes edges in any order, and points under any name") {
    Kernel<3> kernel;
    PointInterner<3> points(kernel);
    const PlaneId top = kernel.planes.intern({Integer(0), Integer(0), Integer(1), Integer(0)});
    const double xy[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const auto point = [&](std::size_t i) { return kernel.add_point(std::array{xy[i][0], xy[i][1], 0.0}); };
    std::vector<KernelFaceCutter::Edge> edges;
    for (const std::size_t i : {2U, 0U, 3U, 1U}) {
        const PointId a = point(i);
        const PointId b = point((i + 1) % 4);  // each corner twice, as two points
        const PlaneId wall =
            *kernel.join(std::array{kernel.coordinates(a), kernel.coordinates(b), axis_direction<3>(2)});
        edges.push_back({a, b, orient_edge(kernel, top, wall, a, b)});
    }
    std::size_t emitted = 0;
    KernelFaceCutter(kernel, points).cut(top, edges, [&](std::span<const Corner> loop) {
        ++emitted;
        REQUIRE(loop.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(points(loop[i].point) == loop[i].point);
            CHECK(kernel.side(loop[i].edge, loop[(i + 1) % 4].point) == Sign::zero);
            CHECK(kernel.side(loop[i].edge, loop[(i + 2) % 4].point) == Sign::minus);
        }
    });
    CHECK(emitted == 1);
}

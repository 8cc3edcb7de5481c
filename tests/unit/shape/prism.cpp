// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/prism.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/mesh/from_region.hpp>
#include <cleave/shape/box.hpp>

using namespace cleave;
using namespace support;

TEST_CASE("prism: over a triangle, ends in either order") {
    const Region<3> p = verified(prism<Rational>({{0, 0}, {4, 0}, {1, 1}}, 0, 5));
    CHECK(p.face_count() == 5);
    CHECK(ExactRegion<3>(p).measure() == 10);
    CHECK(equal_sets(p, prism<Rational>({{0, 0}, {4, 0}, {1, 1}}, 5, 0)));
    CHECK(equal_sets(prism(box<2>({0, 0}, {2, 3}), 1, 4), box<3>({0, 0, 1}, {2, 3, 4})));
}

TEST_CASE("prism: bottom, top, then one face for each side") {
    const ExactRegion<3> p(prism<Rational>({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 3, 7));
    CHECK(p.faces()[0].plane == Coefficients<3>{0, 0, -1, 3});
    CHECK(p.faces()[1].plane == Coefficients<3>{0, 0, 1, -7});
    CHECK(p.faces()[2].plane == Coefficients<3>{0, -1, 0, 0});
    CHECK(p.faces()[3].plane == Coefficients<3>{1, 0, 0, -2});
}

TEST_CASE("prism: a base with holes gives caps with holes") {
    const Region<2> ring = box<2>({0, 0}, {3, 3}) - box<2>({1, 1}, {2, 2});
    const Region<3> tube = verified(prism(ring, 0, 2));
    CHECK(tube.face_count() == 10);
    CHECK(tube.boundary().faces.faces[0].loop_count == 2);
    CHECK(tube.boundary().faces.faces[1].loop_count == 2);
    CHECK(ExactRegion<3>(tube).measure() == 16);
    CHECK(ExactRegion<3>(tube).boundary_measure() == 2 * 8 + 2 * (12 + 4));
    CHECK(equal_sets(tube, box<3>({0, 0, 0}, {3, 3, 2}) - box<3>({1, 1, -1}, {2, 2, 3})));
}

TEST_CASE("prism: a non-convex base") {
    const Region<3> n =
        verified(prism<Rational>({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 4}, {1, 4}, {1, 2}, {0, 2}}, 0, 1));
    CHECK(ExactRegion<3>(n).measure() == 5);
    CHECK(ExactRegion<3>(n).boundary_measure() == 22);
    // Slightly concave: the corner at (2, 1e-7).
    const Region<3> dent = verified(prism<Rational>({{0, 0}, {2, Rational(1, 10000000)}, {4, 0}, {2, 2}}, 0, 2));
    CHECK(ExactRegion<3>(dent).measure() == Rational(8 - Rational(1, 2500000)));
    const ExactRegion<3> exact(dent);
    CHECK(exact.locate({2, 1, 1}) == Where::inside);
    for (const auto& p :
         std::vector<Coordinates<3>>{{2, 1, 3}, {2, 1, -3}, {2, -1, 1}, {2, 3, 1}, {-1, 1, 1}, {4, 1, 1}})
        CHECK(exact.locate(p) == Where::outside);
    CHECK(exact.locate({2, Rational(1, 20000000), 1}) == Where::outside);
}

TEST_CASE("prism: bases that touch themselves, and bases with corners in the middle of a side") {
    const Region<2> bow = polygon<Rational>({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}});
    CHECK(ExactRegion<3>(verified(prism(bow, 0, 3))).measure() == 6);
    const Region<2> checkers = box<2>({0, 0}, {1, 1}) | box<2>({1, 1}, {2, 2}) | box<2>({2, 0}, {3, 1});
    const Region<3> blocks = verified(prism(checkers, 0, 1));
    CHECK(ExactRegion<3>(blocks).measure() == 3);
    for (const FaceList::Face& f : blocks.boundary().faces.faces)
        if (f.loop_count == 3) CHECK(unoriented(f.plane) != no_id);
    const Region<2> slab = box<2>({0, 0}, {2, 1}) | box<2>({2, 0}, {5, 1});
    CHECK(equal_sets(verified(prism(slab, 0, 1)), box<3>({0, 0, 0}, {5, 1, 1})));
    const Region<2> pinned = box<2>({0, 0}, {4, 4}) - polygon<Rational>({{0, 2}, {2, 1}, {2, 3}});
    CHECK(ExactRegion<3>(verified(prism(pinned, 0, 1))).measure() == 14);
}

TEST_CASE("prism: the numbers of a constructed base are kept") {
    const Region<2> a = polygon<Rational>({{0, 0}, {7, 1}, {3, 5}});
    const Region<2> b = polygon<Rational>({{1, -2}, {6, 4}, {2, 3}});
    const Region<2> base = a & b;
    REQUIRE(base.face_count() >= 3);
    const Region<3> p = verified(prism(base, Rational(1, 3), Rational(2, 3)));
    CHECK(Rational(3 * ExactRegion<3>(p).measure()) == ExactRegion<2>(base).measure());
    CHECK(equal_sets(p, prism(a, Rational(1, 3), Rational(2, 3)) & prism(b, 0, 1)));
    // Every vertical plane of the prism is a line of the triangles.
    for (const PointRecord<3>& r : p.boundary().points)
        if (r.kind == PointRecord<3>::Kind::meet)
            for (const std::uint32_t k : r.planes)
                for (const Integer& x : p.boundary().planes.exact(k)) CHECK(x.bit_length() <= 6);
}

TEST_CASE("prism: bases of random polygons agree with intersections of slabs") {
    const Region<2> a = polygon<Rational>({{0, 0}, {6, 0}, {6, 6}, {3, 2}, {0, 6}});
    const Region<2> b = polygon<Rational>({{1, 1}, {5, 0}, {4, 5}, {3, 3}, {2, 4}});
    for (const Operation operation : all_operations) {
        const Region<2> flat = checked(operation, a, b);
        const Region<3> solid = checked(operation, prism(a, 0, 2), prism(b, 0, 2));
        CHECK(equal_sets(verified(prism(flat, 0, 2)), solid));
    }
}

TEST_CASE("prism: nothing between equal heights or over nothing") {
    CHECK(prism(box<2>({0, 0}, {1, 1}), 3, 3).is_empty());
    CHECK(prism(Region<2>::empty(), 0, 1).is_empty());
}

TEST_CASE("prism: an unbounded base is refused") {
    CHECK_THROWS_AS(prism(Region<2>(~box<2>({0, 0}, {1, 1})), 0, 1), ShapeError);
    CHECK_THROWS_AS(prism(Region<2>::full(), 0, 1), ShapeError);
}

TEST_CASE("prism: caps with holes become closed triangle meshes") {
    const Region<2> ring = box<2>({0, 0}, {3, 3}) - box<2>({1, 1}, {2, 2});
    const RationalMesh mesh = to_rational_mesh(prism(ring, 0, 2));
    CHECK(equal_sets(verified(to_region(mesh)), prism(ring, 0, 2)));
}

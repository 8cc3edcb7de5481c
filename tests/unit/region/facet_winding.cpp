// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/facet_winding.hpp>
//
#include "support/catch.hpp"

#include <cleave/geometry/point_interner.hpp>

#include <array>
#include <cstdint>
#include <vector>

using namespace cleave;

namespace {

/// Boxes as facets with planes, in a kernel.
class Boxes {
public:
    Boxes() : points_(kernel_), facets_(kernel_) {}

    /// Six facets: the one below and the one above on each axis in turn.
    void add(const std::array<double, 3>& lo, const std::array<double, 3>& hi, bool inside_out = false) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true}) {
                const std::size_t u = (axis + 1) % 3;
                const std::size_t v = (axis + 2) % 3;
                std::vector<std::array<double, 3>> loop(4, lo);
                for (std::size_t i = 0; i < 4; ++i) {
                    loop[i][axis] = upper ? hi[axis] : lo[axis];
                    if (i == 1 || i == 2) loop[i][u] = hi[u];
                    if (i >= 2) loop[i][v] = hi[v];
                }
                if (upper == inside_out) std::reverse(loop.begin(), loop.end());
                add(loop);
            }
        }
    }

    void add(const std::vector<std::array<double, 3>>& loop) {
        std::vector<PointId> ids;
        for (const auto& x : loop) ids.push_back(points_(kernel_.add_point(x)));
        const PlaneId plane = kernel_.join(std::array<PointId, 3>{ids[0], ids[1], ids[2]}).value();
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < ids.size(); ++i)
            corners.push_back({ids[i], plane_across(kernel_, plane, ids[i], ids[(i + 1) % ids.size()])});
        facets_.add(static_cast<std::uint32_t>(facets_.size()), plane, corners);
    }

    FacetWinding::Sides beside(std::uint32_t f, std::vector<std::uint32_t> coplanar = {}, int at_infinity = 0) {
        FacetWinding winding(facets_, at_infinity);
        const std::vector<Corner> piece(facets_.corners(f).begin(), facets_.corners(f).end());
        return winding.beside(f, piece, coplanar);
    }

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(facets_.size()); }

private:
    Kernel<3> kernel_;
    PointInterner<3> points_;
    ConvexFacets facets_;
};

void check(const FacetWinding::Sides& sides, int minus, int plus, std::uint32_t first) {
    CHECK(sides.minus == minus);
    CHECK(sides.plus == plus);
    CHECK(sides.first == first);
}

}  // namespace

TEST_CASE("facet winding: nested boxes, the ray along edges and through corners of others") {
    Boxes boxes;
    boxes.add({0, 0, 0}, {8, 8, 8});
    boxes.add({2, 2, 2}, {6, 6, 6});
    boxes.add({3, 3, 3}, {5, 5, 5}, true);
    for (std::uint32_t f = 0; f < 6; ++f) check(boxes.beside(f), 1, 0, f);
    for (std::uint32_t f = 6; f < 12; ++f) check(boxes.beside(f), 2, 1, f);
    for (std::uint32_t f = 12; f < 18; ++f) check(boxes.beside(f), 2, 1, f);  // seen from inside
    // Boxes with edges and corners right above the middle of the first one's faces.
    Boxes corners;
    corners.add({0, 0, 0}, {2, 2, 2});
    corners.add({1, 1, 3}, {3, 3, 5});
    corners.add({-1, -1, 4}, {1, 1, 6});
    for (std::uint32_t f = 0; f < corners.size(); ++f) check(corners.beside(f), 1, 0, f);
}

TEST_CASE("facet winding: facets that coincide") {
    Boxes boxes;
    boxes.add({0, 0, 0}, {2, 2, 2});
    boxes.add({0, 0, 0}, {2, 2, 2});
    boxes.add({0, 0, 0}, {2, 2, 2}, true);
    for (std::uint32_t f = 0; f < 6; ++f) {
        check(boxes.beside(f, {f + 6, f + 12}), 1, 0, f);
        check(boxes.beside(f + 6, {f, f + 12}), 1, 0, f);
        check(boxes.beside(f + 12, {f, f + 6}), 0, 1, f);
    }
    // One that only overlaps elsewhere does not count.
    Boxes beside;
    beside.add({0, 0, 0}, {2, 2, 2});
    beside.add({5, 0, 0}, {7, 2, 2});
    check(beside.beside(4, {10}), 1, 0, 4);
}

TEST_CASE("facet winding: a corner of another facet where the ray would start") {
    for (const bool below : {false, true}) {
        Boxes boxes;
        boxes.add({0, 0, 0}, {2, 2, 2});
        const double z = below ? -1 : 1;
        boxes.add({{1, 1, 0}, {3, 0, z}, {0, 3, z}});
        boxes.add({{1, 1, 0}, {0, 3, z}, {-3, -3, z}});
        boxes.add({{1, 1, 0}, {-3, -3, z}, {3, 0, z}});
        boxes.add({{0, 3, z}, {3, 0, z}, {-3, -3, z}});
        // The pyramid is inside out if it stands on its apex, and then inside the box.
        check(boxes.beside(4), below ? 1 : 1, 0, 4);
        CHECK(boxes.beside(9).minus - boxes.beside(9).plus == 1);
    }
}

TEST_CASE("facet winding: no double is inside the facet, coordinates are huge, space is full") {
    Boxes boxes;
    boxes.add({0x1p53, 0x1p53, 0x1p53}, {0x1p53 + 2, 0x1p53 + 2, 0x1p53 + 2});
    boxes.add({0, 0, 0}, {0x1p54, 0x1p54, 0x1p54});
    for (std::uint32_t f = 0; f < 6; ++f) check(boxes.beside(f), 2, 1, f);
    for (std::uint32_t f = 6; f < 12; ++f) check(boxes.beside(f), 1, 0, f);
    for (std::uint32_t f = 6; f < 12; ++f) check(boxes.beside(f, {}, 1), 2, 1, f);
    Boxes huge;
    huge.add({-0x1p1023, -0x1p1023, -0x1p1023}, {0x1p1023, 0x1p1023, 0x1p1023});
    huge.add({-0x1p1023, -0x1p-1000, 0x1p-1022}, {0x1p-1022, 0x1p-1000, 0x1p1000});
    for (std::uint32_t f = 0; f < 6; ++f) check(huge.beside(f), 1, 0, f);
    CHECK(huge.beside(7).minus == 2);
}

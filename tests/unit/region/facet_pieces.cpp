// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/facet_pieces.hpp>
//
#include "support/catch.hpp"
#include "support/dice.hpp"

#include <cleave/number/rational.hpp>

#include <array>
#include <cstddef>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

constexpr int size = 12;

/// A square in the plane z = 0, vertical planes through integer points, and what is cut along them.
class Square {
public:
    Square() : clip_(kernel_), pieces_(clip_) {
        const PlaneId plane = 2 * unoriented(kernel_.planes.intern_axis_plane(2, 0));
        const std::array<std::array<int, 2>, 5> at{{{0, 0}, {size, 0}, {size, size}, {0, size}, {0, 0}}};
        std::vector<Corner> loop;
        for (std::size_t i = 0; i < 4; ++i) {
            const int axis = i % 2 == 0 ? 1 : 0;
            const PlaneId edge = kernel_.planes.intern_axis_plane(axis, i == 1 || i == 2 ? size : 0);
            loop.push_back({point(at[i][0], at[i][1]), i == 1 || i == 2 ? edge : flipped(edge)});
        }
        facet_ = clip_.make(plane, loop);
    }

    PointId point(int x, int y) { return kernel_.add_point(std::array<double, 3>{double(x), double(y), 0}); }

    CutSegment segment(int x, int y, int u, int v) {
        // (v - y) X - (u - x) Y + c = 0
        PlaneTable<3>::Coefficients c{Integer(v - y), Integer(x - u), Integer(0), Integer((u - x) * y - (v - y) * x)};
        return {point(x, y), point(u, v), kernel_.planes.intern(std::move(c))};
    }

    /// Twice the area of a piece, from its corners in order.
    Rational area(const KernelFacet<3>& piece) {
        Rational sum(0);
        const std::vector<Corner> corners(clip_.corners(piece).begin(), clip_.corners(piece).end());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Homogeneous<3> a = kernel_.coordinates(corners[i].point);
            const Homogeneous<3> b = kernel_.coordinates(corners[(i + 1) % corners.size()].point);
            sum += number_traits<Rational>::from_fraction(Integer(a[0] * b[1] - a[1] * b[0]), Integer(a[3] * b[3]));
        }
        return sum;
    }

    std::vector<KernelFacet<3>> cut(const std::vector<CutSegment>& segments) {
        std::vector<KernelFacet<3>> out;
        pieces_.cut(facet_, segments, [&](const KernelFacet<3>& piece) { out.push_back(piece); });
        return out;
    }

    /// Whether the middle of the segment, if it is in the square, is inside a piece.
    bool enters(const CutSegment& s, const KernelFacet<3>& piece) {
        const auto &p = kernel_.point(s.from).approximation, &q = kernel_.point(s.to).approximation;
        const PointId middle = kernel_.add_point(std::array<double, 3>{p[0] / 2 + q[0] / 2, p[1] / 2 + q[1] / 2, 0});
        for (const PlaneId edge : clip_.ridges(piece))
            if (kernel_.side(edge, middle) != Sign::minus) return false;
        return true;
    }

private:
    Kernel<3> kernel_;
    KernelClip<3> clip_;
    FacetPieces pieces_;
    KernelFacet<3> facet_;
};

}  // namespace

TEST_CASE("facet pieces: cut where a segment runs, whole where none does") {
    Square square;
    CHECK(square.cut({}).size() == 1);
    CHECK(square.cut({square.segment(3, 0, 3, 12)}).size() == 2);
    CHECK(square.cut({square.segment(3, 2, 3, 5)}).size() == 2);
    CHECK(square.cut({square.segment(-3, 2, 0, 5)}).size() == 1);     // ends on the edge
    CHECK(square.cut({square.segment(0, 2, 0, 5)}).size() == 1);      // along the edge
    CHECK(square.cut({square.segment(13, 20, 20, 13)}).size() == 1);  // outside
    CHECK(square.cut({square.segment(-3, -3, 20, 20)}).size() == 2);  // corner to corner and beyond
    CHECK(square.cut({square.segment(0, 6, 12, 6), square.segment(6, 0, 6, 12)}).size() == 4);
    CHECK(square.cut({square.segment(0, 6, 12, 6), square.segment(3, 6, 9, 6)}).size() == 2);
    // The second only lies above the first: what is below it stays whole.
    CHECK(square.cut({square.segment(0, 6, 12, 6), square.segment(6, 6, 6, 12)}).size() == 3);
}

TEST_CASE("facet pieces: random segments; pieces fill the facet, and no segment enters one") {
    Dice dice(51);
    for (std::size_t n = 0; n < scaled(60); ++n) {
        Square square;
        std::vector<CutSegment> segments;
        for (int i = dice.between(1, 25); i > 0; --i) {
            const int x = dice.between(-2, size + 2), y = dice.between(-2, size + 2);
            const int u = dice.between(-2, size + 2), v = dice.between(-2, size + 2);
            if (x != u || y != v) segments.push_back(square.segment(x, y, u, v));
        }
        Rational sum(0);
        for (const KernelFacet<3>& piece : square.cut(segments)) {
            const Rational area = square.area(piece);
            CHECK(area > 0);
            sum += area;
            for (const CutSegment& s : segments) CHECK_FALSE(square.enters(s, piece));
        }
        CHECK(sum == 2 * size * size);
    }
}

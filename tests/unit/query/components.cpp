// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/components.hpp>

#include "support/catch.hpp"

#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#include <algorithm>
#include <vector>

using namespace cleave;

namespace {

Region<3> cube(Rational x, Rational y, Rational z, Rational size) {
    return box<3>({x, y, z}, {Rational(x + size), Rational(y + size), Rational(z + size)});
}

struct Counts {
    std::size_t shells;
    std::size_t components;
    friend bool operator==(const Counts&, const Counts&) = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.shells << " shells, " << c.components << " components";
}

/// Also checks that the components are closed, connected, disjoint parts that make up the region.
Counts count(const Region<3>& region) {
    const Connectivity c = connectivity(region);
    CHECK(c.closed);
    const std::vector<Region<3>> parts = components(region);
    CHECK(parts.size() == c.components);
    std::size_t shells = 0;
    Region<3> whole = Region<3>::empty();
    for (const Region<3>& part : parts) {
        const Connectivity alone = connectivity(part);
        CHECK(alone.closed);
        CHECK(alone.components == 1);
        shells += alone.shells;
        CHECK((whole & part).is_empty());
        whole |= part;
    }
    CHECK(shells == c.shells);
    CHECK((whole ^ region).is_empty());
    return {c.shells, c.components};
}

/// A prism over a polygon in the plane of x and z, along y from y0 to y1.
Region<3> along_y(const std::vector<std::array<Rational, 2>>& xz, Rational y0, Rational y1) {
    RationalMesh mesh;
    const auto n = static_cast<std::uint32_t>(xz.size());
    for (const Rational& y : {y0, y1})
        for (const auto& p : xz) mesh.points.push_back({p[0], y, p[1]});
    std::vector<std::uint32_t> front, back;
    for (std::uint32_t i = 0; i < n; ++i) {
        front.push_back(i);
        back.push_back(2 * n - 1 - i);
        mesh.add_face({i, n + i, n + (i + 1) % n, (i + 1) % n});
    }
    mesh.add_face(front);
    mesh.add_face(back);
    return to_region(mesh);
}

}  // namespace

TEST_CASE("components: constants", "[components]") {
    CHECK(count(Region<3>::empty()) == Counts{0, 0});
    CHECK(count(Region<3>::full()) == Counts{0, 1});
}

TEST_CASE("components: one cube and its complement", "[components]") {
    const Region<3> a = cube(0, 0, 0, 2);
    CHECK(count(a) == Counts{1, 1});
    CHECK(count(~a) == Counts{1, 1});
}

TEST_CASE("components: two cubes apart, overlapping, and sharing a face", "[components]") {
    const Region<3> a = cube(0, 0, 0, 2);
    CHECK(count(a | cube(5, 0, 0, 2)) == Counts{2, 2});
    CHECK(count(a | cube(1, 1, 1, 2)) == Counts{1, 1});
    CHECK(count(a | cube(2, 0, 0, 2)) == Counts{1, 1});
    CHECK(count(a | cube(2, 1, 1, 2)) == Counts{1, 1});
    CHECK(count(~(a | cube(5, 0, 0, 2))) == Counts{2, 1});
}

TEST_CASE("components: what touches in an edge or a vertex is not connected", "[components]") {
    const Region<3> a = cube(0, 0, 0, 2);
    CHECK(count(a | cube(2, 2, 0, 2)) == Counts{2, 2});
    CHECK(count(a | cube(2, 2, 1, 2)) == Counts{2, 2});
    CHECK(count(a | cube(2, 2, 2, 2)) == Counts{2, 2});
    CHECK(count(a | cube(2, 2, 0, 2) | cube(0, 2, 2, 2) | cube(2, 0, 2, 2)) == Counts{4, 4});
    // The complement is connected around the contact, and its boundary with it.
    CHECK(count(~(a | cube(2, 2, 0, 2))) == Counts{1, 1});
    CHECK(count(~(a | cube(2, 2, 2, 2))) == Counts{2, 1});
}

TEST_CASE("components: cavities belong to the shell around them", "[components]") {
    const Region<3> outer = cube(0, 0, 0, 10);
    const Region<3> hollow = outer - cube(2, 2, 2, 6);
    CHECK(count(hollow) == Counts{2, 1});
    CHECK(count(hollow | cube(4, 4, 4, 2)) == Counts{3, 2});
    CHECK(count(hollow | (cube(3, 3, 3, 4) - cube(4, 4, 4, 2))) == Counts{4, 2});
    CHECK(count(hollow | (cube(3, 3, 3, 4) - cube(4, 4, 4, 2)) | cube(20, 0, 0, 1)) == Counts{5, 3});
    CHECK(count(outer - cube(1, 1, 1, 2) - cube(5, 5, 5, 2)) == Counts{3, 1});
    CHECK(count(~hollow) == Counts{2, 2});
    // A hollow cube in the cavity of a hollow cube: each void goes to the innermost shell around it.
    const std::vector<Region<3>> parts = components(hollow | (cube(3, 3, 3, 4) - cube(4, 4, 4, 2)));
    REQUIRE(parts.size() == 2);
    std::vector<Rational> volumes{*measure(parts[0]), *measure(parts[1])};
    std::sort(volumes.begin(), volumes.end());
    CHECK(volumes == std::vector<Rational>{64 - 8, 1000 - 216});
}

TEST_CASE("components: cavities that touch their shell or each other", "[components]") {
    const Region<3> outer = cube(0, 0, 0, 10);
    // In a vertex of the shell's face, from the inside: the cavity's boundary is a surface of its own.
    const Region<3> spike = simplex<3>({{{5, 5, 10}, {4, 4, 5}, {6, 4, 5}, {5, 7, 5}}});
    CHECK(count(outer - spike) == Counts{2, 1});
    // Two cavities that share an edge: each wedge of the interior lies between a face of the one and one of the other.
    CHECK(count(outer - cube(2, 2, 2, 2) - cube(4, 4, 2, 2)) == Counts{2, 1});
    CHECK(count(outer - cube(2, 2, 2, 2) - cube(4, 4, 4, 2)) == Counts{3, 1});
}

TEST_CASE("components: tunnels connect the contours of a face", "[components]") {
    const Region<3> outer = cube(0, 0, 0, 10);
    const Region<3> x = box<3>({-1, 4, 4}, {11, 6, 6});
    const Region<3> y = box<3>({4, -1, 4}, {6, 11, 6});
    const Region<3> z = box<3>({4, 4, -1}, {6, 6, 11});
    CHECK(count(outer - x) == Counts{1, 1});
    CHECK(count(outer - x - y - z) == Counts{1, 1});
    CHECK(count((outer - x) | box<3>({-1, Rational(9, 2), Rational(9, 2)}, {11, Rational(11, 2), Rational(11, 2)})) ==
          Counts{2, 2});
    // A cavity next to a tunnel.
    CHECK(count(outer - x - cube(1, 1, 1, 1)) == Counts{2, 1});
}

TEST_CASE("components: one face in several pieces", "[components]") {
    // The bar's upper face comes back as one face of two pieces, in different components.
    const Region<3> bar = box<3>({0, 0, 0}, {10, 2, 2});
    CHECK(count(bar - box<3>({4, -1, -1}, {6, 3, 3})) == Counts{2, 2});
    // Rings within rings, cut from one slab: faces of several pieces with holes, nested.
    Region<3> rings = box<3>({-9, -9, 0}, {9, 9, 1});
    for (int r = 8; r > 0; --r) {
        const Region<3> square = box<3>({-r, -r, 0}, {r, r, 1});
        rings = r % 2 == 0 ? rings - square : rings | square;
    }
    CHECK(count(rings) == Counts{5, 5});
    // Turned by (3, 4, 5), so that no contour is parallel to an axis.
    const std::vector<std::array<Rational, 2>> diamond{{3, -4}, {4, 3}, {-3, 4}, {-4, -3}};
    Region<3> turned = Region<3>::empty();
    for (int r = 9; r > 0; --r) {
        std::vector<std::array<Rational, 2>> scaled = diamond;
        for (auto& p : scaled) p = {Rational(p[0] * r), Rational(p[1] * r)};
        turned = r % 2 == 1 ? turned | prism(scaled, 0, 1) : turned - prism(scaled, 0, 1);
    }
    CHECK(count(turned) == Counts{5, 5});
}

TEST_CASE("components: holes side by side, aligned, touching in corners", "[components]") {
    Region<3> plate = box<3>({0, 0, 0}, {20, 20, 1});
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) plate -= box<3>({2 + 4 * i, 2 + 4 * j, -1}, {4 + 4 * i, 4 + 4 * j, 2});
    CHECK(count(plate) == Counts{1, 1});
    // A chessboard of holes: the remaining squares hang together in edges alone.
    Region<3> board = box<3>({0, 0, 0}, {4, 4, 1});
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if ((i + j) % 2 == 0) board -= box<3>({i, j, -1}, {i + 1, j + 1, 2});
    CHECK(count(board) == Counts{8, 8});
    // A ring of holes that touch in corners separates the middle.
    Region<3> ring = box<3>({0, 0, 0}, {5, 5, 1});
    for (const auto& [i, j] : std::vector<std::pair<int, int>>{{2, 1}, {1, 2}, {3, 2}, {2, 3}})
        ring -= box<3>({i, j, -1}, {i + 1, j + 1, 2});
    CHECK(count(ring) == Counts{2, 2});
}

TEST_CASE("components: a notch that reaches a face from inside separates what it touches", "[components]") {
    const Region<3> block = box<3>({0, 0, 0}, {4, 4, 2});
    // The roof over the whole bottom touches the upper face along a line: two prisms remain, the face is in one piece.
    const Region<3> roof = along_y({{0, 0}, {4, 0}, {2, 2}}, 0, 4);
    CHECK(count(block - roof) == Counts{2, 2});
    // A shorter roof leaves a bridge.
    CHECK(count(block - along_y({{0, 0}, {4, 0}, {2, 2}}, 1, 4)) == Counts{1, 1});
    CHECK(count(block - along_y({{0, 0}, {4, 0}, {2, 2}}, 1, 3)) == Counts{1, 1});
    // Within the block: nothing is separated, but the cavity's edge opens the upper face.
    CHECK(count(block - along_y({{1, 1}, {3, 1}, {2, 2}}, 1, 3)) == Counts{1, 1});
    // From outside, an edge that lies on a face connects nothing and separates nothing.
    CHECK(count(block | along_y({{1, 3}, {2, 2}, {3, 3}}, -1, 5)) == Counts{2, 2});
    // A step: the edge runs from the lower face under the upper step.
    const Region<3> step = block | box<3>({0, 0, 2}, {4, 2, 4});
    CHECK(count(step - along_y({{0, 0}, {4, 0}, {2, 2}}, 0, 4)) == Counts{1, 1});
    CHECK(count(step - along_y({{0, 0}, {4, 0}, {2, 2}}, 2, 4)) == Counts{1, 1});
    CHECK(count(step - along_y({{0, 0}, {4, 0}, {2, 2}}, 0, 4) - box<3>({0, 0, 2}, {4, 2, 3})) == Counts{3, 3});
    // Two roofs crossing at right angles leave four pyramids.
    const Region<3> across = [] {
        RationalMesh mesh;
        mesh.points = {{0, 0, 0}, {0, 4, 0}, {0, 2, 2}, {4, 0, 0}, {4, 4, 0}, {4, 2, 2}};
        mesh.add_face({0, 2, 1});
        mesh.add_face({3, 4, 5});
        mesh.add_face({0, 1, 4, 3});
        mesh.add_face({0, 3, 5, 2});
        mesh.add_face({1, 2, 5, 4});
        return to_region(mesh);
    }();
    CHECK(count(block - roof - across) == Counts{4, 4});
}

TEST_CASE("components: a result with curved outlines and constructed points", "[components]") {
    const Region<3> ball = sphere<Rational>({0, 0, 0}, 3);
    const Region<3> drilled = ball - box<3>({-1, -1, -4}, {1, 1, 4});
    CHECK(count(drilled) == Counts{1, 1});
    const Region<3> slices = ball - box<3>({-4, -4, -1}, {4, 4, 0}) - box<3>({-4, -4, 1}, {4, 4, 2});
    CHECK(count(slices) == Counts{3, 3});
    CHECK(count(slices ^ sphere<Rational>({0, 0, 0}, 1)) == Counts{4, 4});
    CHECK(count(slices ^ sphere<Rational>({0, 0, Rational(1, 2)}, Rational(1, 4))) == Counts{4, 3});
}

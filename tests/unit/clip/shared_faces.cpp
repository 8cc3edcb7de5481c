// SPDX-License-Identifier: Apache-2.0
// Solids of four and five dimensions that share a facet, a ridge, an edge, a vertex or everything: the side of every
// facet of one with respect to every plane of the other as worked out by hand, and the parts of those that are cut.
#include <cleave/clip/polytope_clip.hpp>

#include "support/catch.hpp"
#include "support/clip_laws.hpp"
#include "support/shared_faces.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

constexpr FacetSide below = FacetSide::minus;
constexpr FacetSide above = FacetSide::plus;
constexpr FacetSide same = FacetSide::on_same;
constexpr FacetSide opposite = FacetSide::on_opposite;
constexpr FacetSide cut = FacetSide::crossing;

/// The side of facet f of one solid with respect to plane h of the other.
using Table = std::function<FacetSide(int f, int h)>;

/// A convex solid; facet i lies in plane i.
template <int D>
struct Solid {
    Polytope cell;
    std::vector<PlaneId> planes;
    std::vector<PolytopeFacet<D>> facets;
};

template <int D>
class Pair {
public:
    Pair(const HalfSpaces<D>& first, const HalfSpaces<D>& second) : a(solid(first)), b(solid(second)) {}

    /// Checks the sides of a's facets with respect to b's planes, and the other way round.
    void check_sides(const Table& of_a, const Table& of_b) {
        check_sides(a, b, of_a);
        check_sides(b, a, of_b);
        std::vector<PolytopeFacet<D>> facets = a.facets;
        facets.insert(facets.end(), b.facets.begin(), b.facets.end());
        std::vector<PlaneId> planes = a.planes;
        for (const PlaneId h : b.planes) planes.push_back(flipped(h));
        check_clip_laws(model, facets, planes);
    }

    /// How many vertices of a are at the place of one of b.
    std::size_t common_vertices() {
        return std::size_t(std::count_if(a.cell.points.begin(), a.cell.points.end(), [&](PointId p) {
            return std::any_of(b.cell.points.begin(), b.cell.points.end(),
                               [&](PointId q) { return kernel.same(p, q); });
        }));
    }

    /// Whether two polytopes have the same vertices, by place.
    bool equal(const Polytope& p, const Polytope& q) {
        return p.size() == q.size() && std::all_of(p.points.begin(), p.points.end(), [&](PointId x) {
                   return std::any_of(q.points.begin(), q.points.end(), [&](PointId y) { return kernel.same(x, y); });
               });
    }

    Kernel<D> kernel;
    PolytopeClip<D> model{kernel};
    Solid<D> a;
    Solid<D> b;

private:
    Solid<D> solid(const HalfSpaces<D>& set) {
        Solid<D> s;
        s.cell = model.universe();
        for (const IntegerPlane<D>& p : set.planes) {
            s.planes.push_back(intern(kernel, p));
            auto parts = model.split_cell(s.planes.back(), s.cell);
            REQUIRE(parts.side == cut);
            s.cell = *std::move(parts.minus);
        }
        const std::vector<PolytopeFace> faces = largest_faces(s.cell);
        REQUIRE(faces.size() == s.planes.size());
        for (const PlaneId h : s.planes)
            for (const PolytopeFace& face : faces) {
                if (face.plane != unoriented(h)) continue;
                Polytope body = subpolytope(s.cell, face.vertices);
                model.find_edges(body);
                s.facets.push_back(model.make(h, std::move(body)));
            }
        REQUIRE(s.facets.size() == s.planes.size());
        return s;
    }

    void check_sides(const Solid<D>& of, const Solid<D>& with, const Table& expected) {
        for (std::size_t h = 0; h < with.planes.size(); ++h) {
            bool minus = false;
            bool plus = false;
            for (std::size_t f = 0; f < of.facets.size(); ++f) {
                INFO("facet " << f << ", plane " << h);
                const FacetSide side = expected(int(f), int(h));
                CHECK(model.side(with.planes[h], of.facets[f]) == side);
                const Split<PolytopeFacet<D>> s = model.split(with.planes[h], of.facets[f]);
                CHECK(s.side == side);
                if (s.side == cut)
                    check_parts(with.planes[h], model.body(of.facets[f]), model.body(*s.minus), model.body(*s.plus));
                minus = minus || side == below || side == cut;
                plus = plus || side == above || side == cut;
            }
            // A solid lies where its facets do.
            INFO("plane " << h);
            const FacetSide side = minus ? (plus ? cut : below) : above;
            CHECK(model.cell_side(with.planes[h], of.cell) == side);
            auto s = model.split_cell(with.planes[h], of.cell);
            CHECK(s.side == side);
            CHECK(s.lid.has_value() == (side == cut));
            if (s.side == cut) check_parts(with.planes[h], of.cell, *s.minus, *s.plus);
            if (s.side == cut) CHECK(model.plane_of(*s.lid) == with.planes[h]);
        }
    }

    /// The parts have the vertices of their side and in the plane, and one more for each edge that changes sides.
    void check_parts(PlaneId h, const Polytope& whole, const Polytope& minus, const Polytope& plus) {
        std::vector<PointId> kept_minus;
        std::vector<PointId> kept_plus;
        for (const PointId p : whole.points) {
            if (kernel.side(h, p) != Sign::plus) kept_minus.push_back(p);
            if (kernel.side(h, p) != Sign::minus) kept_plus.push_back(p);
        }
        const auto crossings = std::count_if(whole.edges.begin(), whole.edges.end(), [&](const auto& e) {
            return kernel.side(h, whole.points[e.first]) * kernel.side(h, whole.points[e.second]) == Sign::minus;
        });
        const std::vector<PointId> made_minus = without(minus.points, kept_minus);
        const std::vector<PointId> made_plus = without(plus.points, kept_plus);
        CHECK(made_minus == made_plus);
        CHECK(std::ptrdiff_t(made_minus.size()) == crossings);
        CHECK(minus.size() == kept_minus.size() + made_minus.size());
        CHECK(plus.size() == kept_plus.size() + made_plus.size());
        for (const PointId p : made_minus) {
            CHECK(kernel.side(h, p) == Sign::zero);
            CHECK(std::find(whole.points.begin(), whole.points.end(), p) == whole.points.end());
        }
    }

    static std::vector<PointId> without(std::vector<PointId> all, std::vector<PointId> some) {
        std::sort(all.begin(), all.end());
        std::sort(some.begin(), some.end());
        std::vector<PointId> rest;
        std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
        return rest;
    }
};

template <int D>
void check_mirrored_simplices(int mirrored) {
    INFO("D = " << D << ", axes mirrored: " << mirrored);
    Pair<D> pair(corner_simplex<D>(0, 1), corner_simplex<D>(0, 1, mirrored));
    CHECK(pair.common_vertices() == std::size_t(D - mirrored + 1));
    // A plane across a mirrored axis divides them: its facet lies in it facing against it, all else beyond. One across
    // another axis is a plane of both. The sloping plane leaves the other simplex on its inside; it meets it in the
    // vertices that both have at its end of the axes.
    const Table table = [mirrored](int f, int h) {
        if (h < mirrored) return f == h ? opposite : above;
        if (h < D || mirrored == 0) return f == h ? same : below;
        return below;
    };
    pair.check_sides(table, table);
}

template <int D>
void check_mirrored_cubes(int mirrored) {
    INFO("D = " << D << ", axes mirrored: " << mirrored);
    Pair<D> pair(corner_cube<D>(), corner_cube<D>(mirrored));
    CHECK(pair.common_vertices() == std::size_t(1) << unsigned(D - mirrored));
    const auto table = [mirrored](bool upper_is_near) -> Table {
        return [mirrored, upper_is_near](int f, int h) {
            if (h / 2 >= mirrored) return f == h ? same : below;
            // Of the two planes of the other cube across a mirrored axis, the near one divides the cubes.
            if ((h % 2 == 1) != upper_is_near) return below;
            return f == (upper_is_near ? h - 1 : h + 1) ? opposite : above;
        };
    };
    pair.check_sides(table(true), table(false));
}

template <int D>
void check_nested_at_a_vertex() {
    INFO("D = " << D);
    Pair<D> pair(corner_simplex<D>(0, 2), corner_simplex<D>(0, 1));
    CHECK(pair.common_vertices() == 1);
    const Table inner = [](int f, int h) { return f == h && h < D ? same : below; };
    const Table outer = [&](int f, int h) { return h < D ? inner(f, h) : (f == D ? above : cut); };
    pair.check_sides(outer, inner);
    // What the inner sloping plane leaves of the outer simplex is the inner one, and so with their facets.
    const PlaneId h = pair.b.planes[D];
    auto s = pair.model.split_cell(h, pair.a.cell);
    REQUIRE(s.side == cut);
    CHECK(pair.equal(*s.minus, pair.b.cell));
    CHECK(s.plus->size() == 2 * D);
    CHECK(pair.equal(pair.model.body(*s.lid), pair.model.body(pair.b.facets[D])));
    for (std::size_t f = 0; f < D; ++f) {
        const auto parts = pair.model.split(h, pair.a.facets[f]);
        REQUIRE(parts.side == cut);
        CHECK(pair.equal(pair.model.body(*parts.minus), pair.model.body(pair.b.facets[f])));
        CHECK(pair.model.body(*parts.plus).size() == 2 * (D - 1));
    }
}

template <int D>
void check_nested_apart() {
    INFO("D = " << D);
    Pair<D> pair(corner_simplex<D>(0, 4 * D), corner_simplex<D>(1, 2 * D));
    CHECK(pair.common_vertices() == 0);
    // The outer facet beside a plane of the inner simplex is beyond it, the others are cut.
    pair.check_sides([](int f, int h) { return f == h ? above : cut; }, [](int, int) { return below; });
}

template <int D>
void check_nested_cubes() {
    INFO("D = " << D);
    Pair<D> pair(block<D>(0, 2, 0, 2), block<D>(0, 1, 0, 1));
    CHECK(pair.common_vertices() == 1);
    const Table inner = [](int f, int h) { return h % 2 == 0 && f == h ? same : below; };
    const Table outer = [&](int f, int h) {
        if (h % 2 == 0) return inner(f, h);
        return f / 2 != h / 2 ? cut : (f == h ? above : below);
    };
    pair.check_sides(outer, inner);
    // Halved across every axis, minus sides kept, the outer cube becomes the inner one.
    Polytope rest = pair.a.cell;
    for (std::size_t i = 0; i < D; ++i) {
        auto s = pair.model.split_cell(pair.b.planes[2 * i + 1], rest);
        REQUIRE(s.side == cut);
        CHECK(s.plus->size() == rest.size());
        CHECK(pair.model.body(*s.lid).size() == rest.size() / 2);
        rest = *std::move(s.minus);
    }
    CHECK(pair.equal(rest, pair.b.cell));
}

/// A cube of edge 2, and beside it one that touches the middle of its upper facet across the first axis and more.
template <int D>
void check_part_of_a_facet() {
    INFO("D = " << D);
    Pair<D> pair(block<D>(0, 2, 0, 2), block<D>(2, 4, 1, 3));
    CHECK(pair.common_vertices() == 0);
    const auto table = [](bool first) -> Table {
        return [first](int f, int h) {
            const int near = first ? 0 : 1;
            if (h / 2 == 0) return h != near ? below : (f == 1 - near ? opposite : above);
            // Across the other axes they overlap by half: the plane at the middle is the other's lower or upper one.
            if (h % 2 != near) return below;
            return f / 2 != h / 2 ? cut : (f == h ? above : below);
        };
    };
    pair.check_sides(table(true), table(false));
}

}  // namespace

TEST_CASE("shared faces: identical simplices and cubes") {
    check_mirrored_simplices<4>(0);
    check_mirrored_simplices<5>(0);
    check_mirrored_cubes<4>(0);
    check_mirrored_cubes<5>(0);
}

TEST_CASE("shared faces: a facet") {
    check_mirrored_simplices<4>(1);
    check_mirrored_simplices<5>(1);
    check_mirrored_cubes<4>(1);
    check_mirrored_cubes<5>(1);
}

TEST_CASE("shared faces: a ridge") {
    check_mirrored_simplices<4>(2);
    check_mirrored_simplices<5>(2);
    check_mirrored_cubes<4>(2);
    check_mirrored_cubes<5>(2);
}

TEST_CASE("shared faces: a triangle and a square in D = 5") {
    check_mirrored_simplices<5>(3);
    check_mirrored_cubes<5>(3);
}

TEST_CASE("shared faces: an edge") {
    check_mirrored_simplices<4>(3);
    check_mirrored_simplices<5>(4);
    check_mirrored_cubes<4>(3);
    check_mirrored_cubes<5>(4);
}

TEST_CASE("shared faces: a vertex") {
    check_mirrored_simplices<4>(4);
    check_mirrored_simplices<5>(5);
    check_mirrored_cubes<4>(4);
    check_mirrored_cubes<5>(5);
}

TEST_CASE("shared faces: a simplex in another one, in its corner") {
    check_nested_at_a_vertex<4>();
    check_nested_at_a_vertex<5>();
}

TEST_CASE("shared faces: a simplex in another one, apart from its boundary") {
    check_nested_apart<4>();
    check_nested_apart<5>();
}

TEST_CASE("shared faces: a cube in the corner of another one") {
    check_nested_cubes<4>();
    check_nested_cubes<5>();
}

TEST_CASE("shared faces: part of a facet") {
    check_part_of_a_facet<4>();
    check_part_of_a_facet<5>();
}

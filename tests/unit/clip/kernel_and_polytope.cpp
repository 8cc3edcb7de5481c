// SPDX-License-Identifier: Apache-2.0
// The unrolled model of facets and the one for any dimension, side by side in D = 2 and 3: the same sides, the same
// parts, the same ridges, for random facets and planes with small integers, unbounded ones included.
#include <cleave/clip/kernel_clip.hpp>
#include <cleave/clip/polytope_clip.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <cleave/region/polytope_faces.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// What was compared, so that a test can say that nothing was left out.
struct Seen {
    std::size_t facets = 0;     ///< facets and parts of facets
    std::size_t unbounded = 0;  ///< those with a vertex at infinity
    std::size_t crossing = 0;   ///< cuts through the interior
    std::size_t corners = 0;    ///< those of them through a vertex
    std::size_t touching = 0;   ///< planes that touch a facet and leave it on one side
    std::size_t on = 0;         ///< planes of facets
};

template <int D>
class Twins {
public:
    explicit Twins(Seen& seen) : seen_(&seen) {}

    /// Cuts the facets of a set by all planes, and their parts again.
    void check(const HalfSpaces<D>& set, const std::vector<IntegerPlane<D>>& planes) {
        std::vector<PlaneId> cuts;
        for (const IntegerPlane<D>& p : planes) {
            cuts.push_back(intern(kernel_, p));
            cuts.push_back(flipped(cuts.back()));
        }
        for (const Twin& f : facets_of(set)) {
            check(f, cuts, 2);
            check({fast_.flip(f.fast), general_.flip(f.general)}, cuts, 1);
        }
    }

private:
    /// A facet in both models.
    struct Twin {
        KernelFacet<D> fast;
        PolytopeFacet<D> general;
    };

    std::vector<Twin> facets_of(const HalfSpaces<D>& set) {
        Polytope cell = general_.universe();
        std::vector<PlaneId> sides;
        for (const IntegerPlane<D>& p : set.planes) {
            const PlaneId h = intern(kernel_, p);
            auto s = general_.split_cell(h, cell);
            if (s.side == FacetSide::plus) return {};
            if (s.side == FacetSide::minus) continue;
            sides.push_back(h);
            cell = *std::move(s.minus);
        }
        std::vector<Twin> facets;
        for (const PolytopeFace& face : largest_faces(cell)) {
            const auto h =
                std::find_if(sides.begin(), sides.end(), [&](PlaneId side) { return unoriented(side) == face.plane; });
            if (h == sides.end()) continue;  // at infinity
            Polytope body = subpolytope(cell, face.vertices);
            general_.find_edges(body);
            std::vector<Corner> loop;
            append_loop(kernel_, *h, body, loop);
            facets.push_back({fast_.make(*h, loop), general_.make(*h, std::move(body))});
        }
        return facets;
    }

    void check(const Twin& f, const std::vector<PlaneId>& cuts, int depth) {
        CHECK(fast_.plane_of(f.fast) == general_.plane_of(f.general));
        const std::vector<PointId> vertices = sorted(general_.body(f.general).points);
        check_vertices(fast_points(f.fast), vertices);
        check_ridges(f, vertices);
        ++seen_->facets;
        seen_->unbounded +=
            std::any_of(vertices.begin(), vertices.end(), [&](PointId p) { return kernel_.is_infinite(p); }) ? 1 : 0;
        for (const PlaneId h : cuts) {
            const FacetSide side = general_.side(h, f.general);
            // The unrolled model keeps the signs of the last question: ask for them, and not.
            if (depth == 1) CHECK(fast_.side(h, f.fast) == side);
            const Split<KernelFacet<D>> a = fast_.split(h, f.fast);
            const Split<PolytopeFacet<D>> b = general_.split(h, f.general);
            CHECK(a.side == side);
            CHECK(b.side == side);
            CHECK(a.minus.has_value() == b.minus.has_value());
            CHECK(a.on.has_value() == b.on.has_value());
            CHECK(a.plus.has_value() == b.plus.has_value());
            const bool meets = std::any_of(vertices.begin(), vertices.end(),
                                           [&](PointId p) { return kernel_.side(h, p) == Sign::zero; });
            if (side == FacetSide::on_same || side == FacetSide::on_opposite) ++seen_->on;
            if ((side == FacetSide::minus || side == FacetSide::plus) && meets) ++seen_->touching;
            if (side != FacetSide::crossing) continue;
            ++seen_->crossing;
            seen_->corners += meets ? 1 : 0;
            const std::vector<PlaneId> again = depth > 1 ? cuts : std::vector<PlaneId>();
            check({*a.minus, *b.minus}, again, depth - 1);
            check({*a.plus, *b.plus}, again, depth - 1);
        }
    }

    /// The facet is on the minus side of its ridges' planes, and they meet it in the same vertices in both models.
    void check_ridges(const Twin& f, const std::vector<PointId>& vertices) {
        const auto on_ridges = [&](const std::vector<PlaneId>& planes) {
            std::vector<std::vector<std::size_t>> ridges;
            for (const PlaneId e : planes) {
                CHECK(fast_.side(e, f.fast) == FacetSide::minus);
                CHECK(general_.side(e, f.general) == FacetSide::minus);
                ridges.emplace_back();
                for (std::size_t i = 0; i < vertices.size(); ++i)
                    if (kernel_.side(e, vertices[i]) == Sign::zero) ridges.back().push_back(i);
                CHECK(ridges.back().size() == std::size_t(D - 1));
            }
            std::sort(ridges.begin(), ridges.end());
            return ridges;
        };
        CHECK(on_ridges(fast_.ridges(f.fast)) == on_ridges(general_.ridges(f.general)));
    }

    std::vector<PointId> fast_points(const KernelFacet<D>& f) {
        std::vector<PointId> points;
        for (const Corner& c : fast_.corners(f)) points.push_back(c.point);
        return sorted(std::move(points));
    }

    /// In the order of their exact coordinates.
    std::vector<PointId> sorted(std::vector<PointId> points) {
        std::sort(points.begin(), points.end(), [&](PointId p, PointId q) {
            for (int i = 0; i < D; ++i)
                if (const Sign s = kernel_.compare(i, p, q); s != Sign::zero) return s == Sign::minus;
            return false;
        });
        return points;
    }

    void check_vertices(const std::vector<PointId>& a, const std::vector<PointId>& b) {
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(kernel_.same(a[i], b[i]));
        for (std::size_t i = 0; i + 1 < a.size(); ++i) CHECK_FALSE(kernel_.same(a[i], a[i + 1]));
    }

    Seen* seen_;
    Kernel<D> kernel_;
    KernelClip<D> fast_{kernel_};
    PolytopeClip<D> general_{kernel_};
};

template <int D>
void check_random(std::size_t seeds) {
    Seen seen;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        INFO("seed " << seed);
        Dice dice(seed);
        const HalfSpaces<D> set = random_convex<D>(dice, seed % 2 == 0);
        std::vector<IntegerPlane<D>> planes = set.planes;
        while (planes.size() < set.planes.size() + 4)
            planes.push_back(random_convex<D>(dice, dice.below(2) == 0).planes.back());
        Twins<D>(seen).check(set, planes);
    }
    // None of what the models must agree on is rare.
    CHECK(seen.facets >= 5 * seeds);
    CHECK(seen.unbounded >= seeds);
    CHECK(seen.crossing >= 2 * seeds);
    if (D == 3) CHECK(4 * seen.corners >= seeds);  // a segment has no vertex inside
    CHECK(seen.touching >= 2 * seeds);
    CHECK(seen.on >= 2 * seeds);
}

}  // namespace

TEST_CASE("kernel and polytope: both models cut facets in D = 2 alike") {
    check_random<2>(100);
}
TEST_CASE("kernel and polytope: both models cut facets in D = 3 alike") {
    check_random<3>(30);
}

// SPDX-License-Identifier: Apache-2.0
// How triangles meet is tested with `find_self_intersections`; here, convex facets of more corners.
#include <cleave/region/facet_meeting.hpp>
//
#include "support/catch.hpp"
#include "support/dice.hpp"

#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/facets.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

using Position = std::array<double, 3>;

/// Facets with planes, and the same cut into triangles whose inner edges say so.
class Facets {
public:
    Facets() : points_(kernel_), facets_(kernel_), triangles_(kernel_) {}

    void add(const std::vector<Position>& loop) {
        const auto face = static_cast<std::uint32_t>(facets_.size());
        std::vector<PointId> ids;
        for (const Position& x : loop) ids.push_back(points_(kernel_.add_point(x)));
        const PlaneId plane = kernel_.join(std::array<PointId, 3>{ids[0], ids[1], ids[2]}).value();
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < ids.size(); ++i)
            corners.push_back({ids[i], plane_across(kernel_, plane, ids[i], ids[(i + 1) % ids.size()])});
        facets_.add(face, plane, corners);
        for (std::size_t i = 1; i + 1 < ids.size(); ++i) {
            const std::array<Corner, 3> t{Corner{ids[0], no_id}, Corner{ids[i], no_id}, Corner{ids[i + 1], no_id}};
            const std::array<bool, 3> inner{i > 1, false, i + 2 < ids.size()};
            triangles_.add(face, no_id, t, inner);
        }
    }

    MeetingKind meet(std::uint32_t a, std::uint32_t b) {
        FacetMeetings meetings(facets_);
        const std::optional<MeetingKind> decided = meetings.decide(a, b);
        const FacetMeeting met = meetings.meet(a, b);
        if (decided) CHECK(*decided == met.kind);
        return met.kind;
    }

    FacetMeeting meeting(std::uint32_t a, std::uint32_t b) { return FacetMeetings(facets_).meet(a, b); }
    const Position& position(PointId p) const { return kernel_.point(p).approximation; }

    /// By triangles: the strongest of theirs, except that what they have in common may be shared by the facets only.
    MeetingKind meet_by_triangles(std::uint32_t a, std::uint32_t b) {
        FacetMeetings meetings(triangles_);
        MeetingKind strongest = MeetingKind::none;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (triangles_[t].face != a) continue;
            for (std::uint32_t u = 0; u < triangles_.size(); ++u)
                if (triangles_[u].face == b) strongest = std::max(strongest, meetings.meet(t, u).kind);
        }
        return strongest;
    }

private:
    Kernel<3> kernel_;
    PointInterner<3> points_;
    ConvexFacets facets_, triangles_;
};

/// A convex polygon: the corners of a rectangle or hexagon in one of a few planes, on small integers.
std::vector<Position> draw_polygon(Dice& dice) {
    const double x = dice.below(4);
    const double y = dice.below(4);
    const double w = dice.between(1, 3);
    const double h = dice.between(1, 3);
    std::vector<std::array<double, 2>> flat{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    if (dice.below(2) == 0)
        flat = {{x + 1, y}, {x + w + 1, y}, {x + w + 2, y + h}, {x + w + 1, y + 2 * h}, {x + 1, y + 2 * h}, {x, y + h}};
    const int axis = dice.below(3);
    const double at = dice.below(4);
    const double tilt = dice.below(3) - 1;
    std::vector<Position> out;
    for (const auto& [u, v] : flat) {
        Position p{};
        p[std::size_t(axis)] = at + tilt * u;
        p[std::size_t((axis + 1) % 3)] = u;
        p[std::size_t((axis + 2) % 3)] = v;
        out.push_back(p);
    }
    if (dice.below(2) == 0) std::reverse(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("facet meeting: rectangles that cross, touch and share") {
    Facets f;
    f.add({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    f.add({{1, 1, -1}, {3, 1, -1}, {3, 1, 1}, {1, 1, 1}});  // through the first
    f.add({{4, 0, 0}, {4, 4, 0}, {4, 4, 3}, {4, 0, 3}});    // at its edge
    f.add({{4, 4, 0}, {0, 4, 0}, {0, 4, -3}, {4, 4, -3}});  // at its next edge
    f.add({{4, 1, 0}, {4, 3, 0}, {6, 3, 0}, {6, 1, 0}});    // beside it, at a part of its edge
    f.add({{0, 0, 0}, {4, 4, 0}, {4, 4, 5}, {0, 0, 5}});    // on its diagonal
    f.add({{2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}});    // over its corner
    CHECK(f.meet(0, 1) == MeetingKind::crossing);
    CHECK(f.meet(0, 2) == MeetingKind::shared);
    CHECK(f.meet(0, 3) == MeetingKind::shared);
    CHECK(f.meet(2, 3) == MeetingKind::shared);
    CHECK(f.meet(0, 4) == MeetingKind::touch);
    CHECK(f.meet(0, 5) == MeetingKind::touch);
    CHECK(f.meet(0, 6) == MeetingKind::overlap);
    CHECK(f.meet(1, 2) == MeetingKind::none);
    const FacetMeeting through = f.meeting(0, 1);
    CHECK(through.through_first);
    CHECK(through.through_second);
    CHECK(std::minmax(f.position(through.from), f.position(through.to)) ==
          std::pair<const Position&, const Position&>(Position{1, 1, 0}, Position{3, 1, 0}));
    const FacetMeeting diagonal = f.meeting(0, 5);
    CHECK(diagonal.through_first);
    CHECK_FALSE(diagonal.through_second);
}

TEST_CASE("facet meeting: random polygons meet as their triangles do") {
    Dice dice(41);
    std::array<std::size_t, 5> seen{};
    for (std::size_t n = 0; n < scaled(1500); ++n) {
        Facets f;
        f.add(draw_polygon(dice));
        f.add(draw_polygon(dice));
        const MeetingKind kind = f.meet(0, 1);
        ++seen[std::size_t(kind)];
        CAPTURE(n);
        CHECK(f.meet(1, 0) == kind);
        CHECK(f.meet_by_triangles(0, 1) == kind);
    }
    for (const std::size_t s : seen) CHECK(s > 0);
}

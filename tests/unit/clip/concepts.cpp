// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/concepts.hpp>

#include "support/catch.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

using namespace cleave;

namespace {

/// The least that is a model: answers without meaning.
struct Least {
    using plane_type = int;
    using facet_type = double;

    plane_type plane_of(facet_type) const { return 0; }
    PlaneRelation relation(plane_type, plane_type) const { return PlaneRelation::same; }
    FacetSide side(plane_type, facet_type) const { return FacetSide::minus; }
    Split<facet_type> split(plane_type, facet_type f) const {
        return {FacetSide::minus, f, std::nullopt, std::nullopt};
    }
    facet_type flip(facet_type f) const { return -f; }
    plane_type flip_plane(plane_type h) const { return -h; }
    std::array<plane_type, 0> ridges(facet_type) const { return {}; }
};

struct WithBoxes : Least {
    using box_type = int;
    box_type box(facet_type) const { return 0; }
    box_type hull(box_type a, box_type) const { return a; }
    bool disjoint(box_type, box_type) const { return false; }
};

struct WithPoints : Least {
    using point_type = char;
    using Least::side;
    point_type witness(facet_type) const { return 'p'; }
    Sign side(plane_type, point_type) const { return Sign::zero; }
};

struct WithProposals : Least {
    std::optional<plane_type> propose(std::span<const facet_type>) const { return std::nullopt; }
};

struct NoSplit : Least {
    void split(plane_type, facet_type) const = delete;
};

struct SplitWithoutSide : Least {
    std::vector<facet_type> split(plane_type, facet_type f) const { return {f}; }
};

struct BoolRelation : Least {
    bool relation(plane_type, plane_type) const { return true; }
};

struct MovedFacet {
    MovedFacet(MovedFacet&&) = default;
};

struct FacetCannotBeCopied : Least {
    using facet_type = MovedFacet;
};

}  // namespace

static_assert(Clip<Least>);
static_assert(!BoundedClip<Least> && !LocatingClip<Least> && !ProposingClip<Least>);
static_assert(BoundedClip<WithBoxes>);
static_assert(LocatingClip<WithPoints>);
static_assert(ProposingClip<WithProposals>);
static_assert(!Clip<NoSplit>);
static_assert(!Clip<SplitWithoutSide>);
static_assert(!Clip<BoolRelation>);
static_assert(!Clip<FacetCannotBeCopied>);
static_assert(!Clip<int>);

TEST_CASE("concepts: a split starts out empty") {
    const Split<int> s;
    CHECK_FALSE(s.minus);
    CHECK_FALSE(s.on);
    CHECK_FALSE(s.plus);
}

// SPDX-License-Identifier: Apache-2.0
/// What becomes of facets that lie in the cutting plane, and how the signs of a facet's vertices add up to its side.
///
/// A facet in the plane h is on no side of it. Sending it to the side of its own orientation, as is sometimes done,
/// makes the union of a set with itself empty and its intersection a double cover; so there are two answers of their
/// own, and each operation decides what to keep:
///
/// | plane of the facet is | `FacetSide`   | the inside of the facet's set lies |
/// |-----------------------|---------------|------------------------------------|
/// | h                     | `on_same`     | on the minus side of h             |
/// | h flipped             | `on_opposite` | on the plus side of h              |
#ifndef CLEAVE_CLIP_COINCIDENT_HPP
#define CLEAVE_CLIP_COINCIDENT_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/geometry/plane_relation.hpp>

#include <optional>

CLEAVE_BEGIN_NAMESPACE

/// The side of a facet that lies in the plane. Requires: the planes are coincident.
[[nodiscard]] constexpr FacetSide coincident_side(PlaneRelation r) {
    CLEAVE_REQUIRES(is_coincident(r));
    return r == PlaneRelation::same ? FacetSide::on_same : FacetSide::on_opposite;
}

/// Whether the facet lies in the plane.
[[nodiscard]] constexpr bool is_on(FacetSide s) noexcept {
    return s == FacetSide::on_same || s == FacetSide::on_opposite;
}

/// Which signs occur among the vertices of a facet.
class VertexSigns {
public:
    /// Counts one more vertex.
    constexpr void add(Sign s) noexcept {
        minus_ = minus_ || s == Sign::minus;
        plus_ = plus_ || s == Sign::plus;
    }

    /// Whether all vertices so far are on the plane: for a facet's vertices this means that the facet is.
    [[nodiscard]] constexpr bool all_zero() const noexcept { return !minus_ && !plus_; }

    /// The side of the convex hull of the vertices.
    ///
    /// | minus occurs | plus occurs | side       |
    /// |--------------|-------------|------------|
    /// | yes          | no          | `minus`    |
    /// | no           | yes         | `plus`     |
    /// | yes          | yes         | `crossing` |
    ///
    /// Zeros do not matter: a facet that touches the plane is not cut by it. Requires: not all_zero().
    [[nodiscard]] constexpr FacetSide side() const {
        CLEAVE_REQUIRES(!all_zero());
        if (minus_ && plus_) return FacetSide::crossing;
        return minus_ ? FacetSide::minus : FacetSide::plus;
    }

private:
    bool minus_ = false;
    bool plus_ = false;
};

/// The split of a facet that is not crossed: all of it goes to the part that `side` names.
template <class F>
[[nodiscard]] Split<F> unsplit(FacetSide side, const F& facet) {
    CLEAVE_REQUIRES(side != FacetSide::crossing);
    Split<F> result;
    result.side = side;
    if (is_on(side)) {
        result.on = facet;
    } else {
        (side == FacetSide::minus ? result.minus : result.plus) = facet;
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif

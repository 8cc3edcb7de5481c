// SPDX-License-Identifier: Apache-2.0
/// `ClipModel<D, N>`: the model of `Clip` for a user's number type in D = 1, 2, 3. It is stateless and keeps no tables,
/// so it is the form to read and the oracle to test others against, not the fast one.
#ifndef CLEAVE_CLIP_CLIP_MODEL_HPP
#define CLEAVE_CLIP_CLIP_MODEL_HPP

#include <cleave/clip/clip_1d.hpp>
#include <cleave/clip/clip_2d.hpp>
#include <cleave/clip/clip_3d.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/facet.hpp>
#include <cleave/clip/facet_box.hpp>
#include <cleave/geometry/box.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// `Clip`, `BoundedClip`, `LocatingClip` and `ProposingClip` over `Plane<D, N>` and `Facet<D, N>`; in D = 3 also
/// `FaceClip` (clip/cut_face.hpp).
template <int D, ExactRing N>
requires(1 <= D && D <= 3) struct ClipModel {
    using plane_type = Plane<D, N>;
    using facet_type = Facet<D, N>;
    using point_type = CrossPoint<D, N>;
    using box_type = Box<D>;

    [[nodiscard]] const plane_type& plane_of(const facet_type& f) const { return f.plane; }
    [[nodiscard]] PlaneRelation relation(const plane_type& h, const plane_type& g) const {
        return cleave::relation(h, g);
    }
    [[nodiscard]] FacetSide side(const plane_type& h, const facet_type& f) const { return cleave::side(h, f); }
    [[nodiscard]] Sign side(const plane_type& h, const point_type& p) const { return cleave::side(h, p); }
    [[nodiscard]] Split<facet_type> split(const plane_type& h, const facet_type& f) const {
        return cleave::split(h, f);
    }
    [[nodiscard]] facet_type flip(const facet_type& f) const { return cleave::flip(f); }
    [[nodiscard]] plane_type flip_plane(const plane_type& h) const { return cleave::flip(h); }
    [[nodiscard]] auto ridges(const facet_type& f) const { return cleave::ridges(f); }

    /// Of doubles, rounded outward: disjoint boxes are a proof.
    [[nodiscard]] box_type box(const facet_type& f) const { return box_of(f); }
    [[nodiscard]] box_type hull(const box_type& a, const box_type& b) const { return cleave::hull(a, b); }
    [[nodiscard]] bool disjoint(const box_type& a, const box_type& b) const { return cleave::disjoint(a, b); }

    /// The first vertex.
    [[nodiscard]] point_type witness(const facet_type& f) const { return vertices(f).front(); }

    /// The axis-parallel plane through the median of all vertices along the axis on which they spread most, moved to
    /// the next vertex where the median is an end of the spread.
    /// Returns: nullopt where the facets have vertices at fewer than three positions along that axis, since then no
    /// plane through a vertex has some on both sides. Cost: O(n log n) exact comparisons.
    [[nodiscard]] std::optional<plane_type> propose(std::span<const facet_type> facets) const {
        std::vector<point_type> points;
        Box<D, typename number_traits<N>::field_type> all;
        for (const facet_type& f : facets) {
            for (const point_type& p : vertices(f)) {
                points.push_back(p);
                all.extend(p.coordinates());
            }
        }
        if (points.empty()) return std::nullopt;
        const std::size_t axis = longest_axis(all);
        const auto before = [axis](const point_type& a, const point_type& b) {
            return compare_coordinate(a, b, axis) == Sign::minus;
        };
        std::sort(points.begin(), points.end(), before);
        auto median = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
        // A median at the least or the greatest position would leave one side empty: the next one inside is taken.
        if (!before(points.front(), *median)) {
            median = std::upper_bound(points.begin(), points.end(), *median, before);
        } else if (!before(*median, points.back())) {
            median = std::lower_bound(points.begin(), points.end(), *median, before);
            if (median != points.begin()) --median;
        }
        if (median == points.end() || !before(points.front(), *median) || !before(*median, points.back())) {
            return std::nullopt;
        }
        typename plane_type::Coefficients h;
        for (N& x : h) x = N(0);
        h[axis] = median->weight();
        h[D] = N(-(*median)[axis]);
        return plane_type(std::move(h));
    }

    /// D = 3: the lexicographic order of points.
    [[nodiscard]] Sign compare(const point_type& a, const point_type& b) const { return cleave::compare(a, b); }

    /// D = 3: the point in which h crosses the edge from a to b of a face. It is named by its three planes alone.
    [[nodiscard]] point_type cross(const plane_type& h, const plane_type& face, const plane_type& edge,
                                   const point_type& /*a*/, const point_type& /*b*/) const requires(D == 3) {
        return *meet(face, edge, h);
    }
};

CLEAVE_END_NAMESPACE

#endif

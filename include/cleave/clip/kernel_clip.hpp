// SPDX-License-Identifier: Apache-2.0
/// The Clip model over the indexed kernel, for D = 1, 2, 3: facets are small handles into a pool of corners.
#ifndef CLEAVE_CLIP_KERNEL_CLIP_HPP
#define CLEAVE_CLIP_KERNEL_CLIP_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/loop.hpp>
#include <cleave/clip/propose.hpp>
#include <cleave/geometry/bounds.hpp>
#include <cleave/geometry/kernel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A facet: an oriented plane, a run of corners in the model's pool, and a box.
template <int D>
struct KernelFacet {
    PlaneId plane = no_id;
    std::uint32_t first = 0;
    std::uint32_t size = 0;
    Bounds<D> box;
};

/// Clip (Bounded, Locating, Proposing) over `Kernel<D>`. Split parts share corners by value; nothing is freed before
/// the model is, so handles stay valid.
template <int D>
class KernelClip {
    static_assert(D >= 1 && D <= 3, "facets of the indexed kernel exist for D = 1, 2, 3");

public:
    using plane_type = PlaneId;
    using facet_type = KernelFacet<D>;
    using point_type = PointId;
    using box_type = Bounds<D>;

    explicit KernelClip(Kernel<D>& kernel) : kernel_(&kernel) {}

    [[nodiscard]] Kernel<D>& kernel() const noexcept { return *kernel_; }

    /// Adds a convex facet. Requires: corners in outward order, at least D of them (1 for D = 1).
    facet_type make(PlaneId plane, std::span<const Corner> corners) {
        facet_type f;
        f.plane = plane;
        f.first = static_cast<std::uint32_t>(pool_.size());
        f.size = static_cast<std::uint32_t>(corners.size());
        pool_.insert(pool_.end(), corners.begin(), corners.end());
        bound(f);
        return f;
    }

    /// The corners of f. Invalidated by the next facet that is made.
    [[nodiscard]] std::span<const Corner> corners(const facet_type& f) const {
        return {pool_.data() + f.first, f.size};
    }

    [[nodiscard]] PlaneId plane_of(const facet_type& f) const noexcept { return f.plane; }
    [[nodiscard]] PlaneId flip_plane(PlaneId h) const noexcept { return flipped(h); }

    [[nodiscard]] PlaneRelation relation(PlaneId h, PlaneId g) const { return kernel_->planes.relation(h, g); }

    /// The side of h on which the point lies.
    Sign side(PlaneId h, PointId p) { return kernel_->side(h, p); }

    /// Where the facet lies. The signs of its corners are kept for a split by the same plane that follows.
    FacetSide side(PlaneId h, const facet_type& f) {
        if (unoriented(h) == unoriented(f.plane)) return h == f.plane ? FacetSide::on_same : FacetSide::on_opposite;
        signs_.resize(f.size);
        signs_of_ = {h, f.first, f.size};
        bool below = false;
        bool above = false;
        for (std::uint32_t i = 0; i < f.size; ++i) {
            const Sign s = kernel_->side(h, pool_[f.first + i].point);
            signs_[i] = s;
            below = below || s == Sign::minus;
            above = above || s == Sign::plus;
        }
        CLEAVE_ASSERT(below || above);
        return below ? (above ? FacetSide::crossing : FacetSide::minus) : FacetSide::plus;
    }

    Split<facet_type> split(PlaneId h, const facet_type& f) {
        Split<facet_type> out;
        const bool known = signs_of_ == std::array<std::uint32_t, 3>{h, f.first, f.size};
        out.side = known && unoriented(h) != unoriented(f.plane) ? side_of_signs() : side(h, f);
        switch (out.side) {
            case FacetSide::minus:
                out.minus = f;
                break;
            case FacetSide::plus:
                out.plus = f;
                break;
            case FacetSide::crossing:
                split_crossing(h, f, out);
                break;
            case FacetSide::on_same:
            case FacetSide::on_opposite:
                out.on = f;
                break;
        }
        return out;
    }

    /// The same set facing the other way: corners reversed, edge planes shifted by one so that each stays with its
    /// edge.
    facet_type flip(const facet_type& f) {
        scratch_.assign(pool_.begin() + f.first, pool_.begin() + f.first + f.size);
        reverse_corners(scratch_);
        facet_type g = f;
        g.plane = flipped(f.plane);
        g.first = static_cast<std::uint32_t>(pool_.size());
        pool_.insert(pool_.end(), scratch_.begin(), scratch_.end());
        return g;
    }

    /// Reverses a cycle of corners; D = 3: (p_i, e_i) becomes (p_i, e_{i-1}) in reverse order.
    static void reverse_corners(std::vector<Corner>& corners) {
        std::reverse(corners.begin(), corners.end());
        if constexpr (D == 3) {
            for (std::size_t i = 0; i + 1 < corners.size(); ++i) std::swap(corners[i].edge, corners[i + 1].edge);
        }
    }

    /// One plane through each ridge, the facet on its minus side. A copy: splitting may move the pool.
    [[nodiscard]] std::vector<PlaneId> ridges(const facet_type& f) const {
        std::vector<PlaneId> planes;
        if constexpr (D > 1) {
            planes.reserve(f.size);
            for (const Corner& c : corners(f)) planes.push_back(c.edge);
        }
        return planes;
    }

    [[nodiscard]] const box_type& box(const facet_type& f) const noexcept { return f.box; }
    [[nodiscard]] static box_type hull(const box_type& a, const box_type& b) {
        box_type c = a;
        c.include(b);
        return c;
    }
    [[nodiscard]] static bool disjoint(const box_type& a, const box_type& b) noexcept { return a.disjoint(b); }

    [[nodiscard]] PointId witness(const facet_type& f) const { return pool_[f.first].point; }

    /// See `propose_axis_cut`.
    std::optional<PlaneId> propose(std::span<const facet_type> facets) {
        return propose_axis_cut<D>(*kernel_, facets, centres_);
    }

private:
    void bound(facet_type& f) {
        f.box = {};
        for (std::uint32_t i = 0; i < f.size; ++i) {
            const PointId p = pool_[f.first + i].point;
            if (!(kernel_->point(p).error < std::numeric_limits<double>::infinity())) kernel_->refine(p);
            f.box.include(kernel_->point(p).approximation, kernel_->point(p).error);
        }
    }

    [[nodiscard]] FacetSide side_of_signs() const {
        bool below = false;
        bool above = false;
        for (const Sign s : signs_) {
            below = below || s == Sign::minus;
            above = above || s == Sign::plus;
        }
        return below ? (above ? FacetSide::crossing : FacetSide::minus) : FacetSide::plus;
    }

    void split_crossing(PlaneId h, const facet_type& f, Split<facet_type>& out) {
        minus_.clear();
        plus_.clear();
        if constexpr (D == 2) {
            const Corner a = pool_[f.first];
            const Corner b = pool_[f.first + 1];
            const PointId x = kernel_->cross(h, a.point, b.point, {unoriented(f.plane)});
            std::vector<Corner>& first = signs_[0] == Sign::minus ? minus_ : plus_;
            std::vector<Corner>& second = signs_[0] == Sign::minus ? plus_ : minus_;
            const PlaneId end = signs_[0] == Sign::minus ? h : flipped(h);
            first = {a, Corner{x, end}};
            second = {Corner{x, flipped(end)}, b};
        } else if constexpr (D == 3) {
            const std::span<const Corner> loop = corners(f);
            split_loop<Corner>(
                loop, std::span<const Sign>(signs_), h, flipped(h),
                [&](std::size_t i, std::size_t j) {
                    return kernel_->cross(h, loop[i].point, loop[j].point,
                                          {unoriented(f.plane), unoriented(loop[i].edge)});
                },
                [&](const Corner& c) { minus_.push_back(c); }, [&](const Corner& c) { plus_.push_back(c); });
        }
        out.minus = make(f.plane, minus_);
        out.plus = make(f.plane, plus_);
    }

    Kernel<D>* kernel_;
    std::vector<Corner> pool_;
    std::vector<Corner> scratch_, minus_, plus_;
    std::vector<Sign> signs_;
    std::array<std::uint32_t, 3> signs_of_ = {no_id, no_id, no_id};
    std::vector<std::pair<double, double>> centres_;
};

CLEAVE_END_NAMESPACE

#endif

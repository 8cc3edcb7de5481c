// SPDX-License-Identifier: Apache-2.0
/// `PolytopeClip<D>`: facets and cells of any dimension as convex polytopes over the indexed kernel.
#ifndef CLEAVE_CLIP_POLYTOPE_CLIP_HPP
#define CLEAVE_CLIP_POLYTOPE_CLIP_HPP

#include <cleave/clip/concepts.hpp>
#include <cleave/clip/polytope.hpp>
#include <cleave/clip/propose.hpp>
#include <cleave/geometry/bounds.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A facet: an oriented plane, the number of a polytope in the model's pool, and a box.
template <int D>
struct PolytopeFacet {
    PlaneId plane = no_id;
    std::uint32_t body = no_id;
    Bounds<D> box;
};

/// Clip (Bounded, Locating, Proposing) and CellClip for every D >= 1, unbounded facets and cells included. The general
/// form; `KernelClip` is the unrolled one for facets of D = 1, 2, 3. Nothing in the pool is freed before the model is.
template <int D>
class PolytopeClip {
public:
    using plane_type = PlaneId;
    using facet_type = PolytopeFacet<D>;
    using cell_type = Polytope;
    using point_type = PointId;
    using box_type = Bounds<D>;

    explicit PolytopeClip(Kernel<D>& kernel) : kernel_(&kernel), cutter_(kernel) {}

    [[nodiscard]] Kernel<D>& kernel() const noexcept { return *kernel_; }

    /// Adds a facet. Requires: a polytope of dimension D - 1 in the plane, which each of its vertices knows.
    facet_type make(PlaneId plane, Polytope body) {
        facet_type f;
        f.plane = plane;
        f.body = static_cast<std::uint32_t>(pool_.size());
        for (const PointId p : body.points) {
            if (!(kernel_->point(p).error < std::numeric_limits<double>::infinity())) kernel_->refine(p);
            f.box.include(kernel_->point(p).approximation, kernel_->point(p).error);
        }
        pool_.push_back(std::move(body));
        return f;
    }

    /// The vertices of f and their planes. Valid as long as the model.
    [[nodiscard]] const Polytope& body(const facet_type& f) const { return pool_[f.body]; }

    /// Finds edges from incidences (see `PolytopeCutter::find_edges`).
    void find_edges(Polytope& p) { cutter_.find_edges(p); }

    [[nodiscard]] PlaneId plane_of(const facet_type& f) const noexcept { return f.plane; }
    [[nodiscard]] PlaneId flip_plane(PlaneId h) const noexcept { return flipped(h); }
    [[nodiscard]] PlaneRelation relation(PlaneId h, PlaneId g) const { return kernel_->planes.relation(h, g); }
    Sign side(PlaneId h, PointId p) { return kernel_->side(h, p); }

    FacetSide side(PlaneId h, const facet_type& f) {
        if (unoriented(h) == unoriented(f.plane)) return on(h, f);
        return cutter_.side(h, body(f));
    }

    Split<facet_type> split(PlaneId h, const facet_type& f) {
        Split<facet_type> out;
        if (unoriented(h) == unoriented(f.plane)) {
            out.side = on(h, f);
            out.on = f;
            return out;
        }
        PolytopeSplit s = cutter_.split(h, body(f));
        out.side = s.side;
        CLEAVE_ASSERT(s.side != FacetSide::on_same);
        if (s.side == FacetSide::minus) out.minus = f;
        if (s.side == FacetSide::plus) out.plus = f;
        if (s.side == FacetSide::crossing) {
            out.minus = make(f.plane, std::move(s.minus));
            out.plus = make(f.plane, std::move(s.plus));
        }
        return out;
    }

    [[nodiscard]] facet_type flip(const facet_type& f) const {
        facet_type g = f;
        g.plane = flipped(f.plane);
        return g;
    }

    /// One plane through each ridge, the facet on its minus side; planes of the frame where the facet is unbounded.
    [[nodiscard]] std::vector<PlaneId> ridges(const facet_type& f) {
        std::vector<PlaneId> planes;
        const Polytope& p = body(f);
        for (const PolytopeFace& face : largest_faces(p)) {
            std::size_t off = 0;
            while (p.has(off, face.plane)) ++off;
            const PlaneId h = 2 * face.plane;
            planes.push_back(kernel_->side(h, p.points[off]) == Sign::minus ? h : flipped(h));
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
    [[nodiscard]] PointId witness(const facet_type& f) const { return body(f).points.front(); }

    /// See `propose_axis_cut`.
    std::optional<PlaneId> propose(std::span<const facet_type> facets) {
        return propose_axis_cut<D>(*kernel_, facets, centres_);
    }

    /// All of space.
    [[nodiscard]] cell_type universe() { return cleave::universe(*kernel_); }

    /// minus, plus or crossing: a cell has an interior.
    FacetSide cell_side(PlaneId h, const cell_type& c) { return cutter_.side(h, c); }

    CellSplit<cell_type, facet_type> split_cell(PlaneId h, const cell_type& c) {
        PolytopeSplit s = cutter_.split(h, c);
        CellSplit<cell_type, facet_type> out;
        out.side = s.side;
        if (s.side != FacetSide::crossing) return out;
        out.minus = std::move(s.minus);
        out.plus = std::move(s.plus);
        out.lid = make(h, std::move(s.lid));
        return out;
    }

private:
    static FacetSide on(PlaneId h, const facet_type& f) {
        return h == f.plane ? FacetSide::on_same : FacetSide::on_opposite;
    }

    Kernel<D>* kernel_;
    PolytopeCutter<D> cutter_;
    std::deque<Polytope> pool_;
    std::vector<std::pair<double, double>> centres_;
};

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Convex polytopes of any dimension over the indexed kernel, in the form of vertex incidences, and their cuts.
///
/// Each vertex knows *every* bounding plane through it, and the polytope knows which vertices span an edge. That is
/// all: a face is the set of vertices that have some planes in common, so two vertices span an edge exactly if no third
/// one has all the planes that they share [Fukuda-Prodon-1996]. A cut needs the signs of the vertices, a new vertex on
/// each edge that changes sides, and the edges among the vertices in the cut. Numbers never grow: a new vertex is the
/// meet of D given planes.
#ifndef CLEAVE_CLIP_POLYTOPE_HPP
#define CLEAVE_CLIP_POLYTOPE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/geometry/kernel.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A convex polytope: a cell (of the dimension of space), a facet (one less) or a face of one of them. Its vertices are
/// extreme. It is empty where it has no vertices; there are no others without interior in their own dimension.
struct Polytope {
    std::vector<PointId> points;           ///< of the vertices
    std::vector<std::uint32_t> plane_end;  ///< vertex i has the planes [plane_end[i - 1], plane_end[i])
    std::vector<std::uint32_t> planes;     ///< unoriented planes through the vertices, ascending for each
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< indices of vertices, the smaller first

    [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
    [[nodiscard]] bool empty() const noexcept { return points.empty(); }
    [[nodiscard]] std::span<const std::uint32_t> planes_of(std::size_t i) const {
        const std::uint32_t first = i == 0 ? 0 : plane_end[i - 1];
        return {planes.data() + first, plane_end[i] - first};
    }
    /// Whether vertex i is known to lie on plane k.
    [[nodiscard]] bool has(std::size_t i, std::uint32_t k) const {
        const std::span<const std::uint32_t> own = planes_of(i);
        return std::find(own.begin(), own.end(), k) != own.end();
    }

    /// Adds a vertex. Requires: `through` ascends.
    void add_vertex(PointId p, std::span<const std::uint32_t> through) {
        points.push_back(p);
        planes.insert(planes.end(), through.begin(), through.end());
        plane_end.push_back(static_cast<std::uint32_t>(planes.size()));
    }
    void clear() {
        points.clear();
        plane_end.clear();
        planes.clear();
        edges.clear();
    }
};

/// The parts of a cut polytope; `lid` is the part in the cut. With `side` other than crossing all three are empty: the
/// polytope is undivided.
struct PolytopeSplit {
    FacetSide side = FacetSide::crossing;
    Polytope minus;
    Polytope plus;
    Polytope lid;
};

/// Finds edges and cuts polytopes in D-space. Keeps scratch memory; not thread-safe.
template <int D>
class PolytopeCutter {
public:
    explicit PolytopeCutter(Kernel<D>& kernel) : kernel_(&kernel) {}

    /// Where the polytope lies; `on_same` where all of it lies in h. The signs of the vertices are kept for `split`.
    FacetSide side(PlaneId h, const Polytope& p) {
        signs_.resize(p.size());
        bool below = false;
        bool above = false;
        for (std::size_t i = 0; i < p.size(); ++i) {
            signs_[i] = p.has(i, unoriented(h)) ? Sign::zero : kernel_->side(h, p.points[i]);
            below = below || signs_[i] == Sign::minus;
            above = above || signs_[i] == Sign::plus;
        }
        if (below) return above ? FacetSide::crossing : FacetSide::minus;
        return above ? FacetSide::plus : FacetSide::on_same;
    }

    /// Cuts the polytope. Cost: a side test for each vertex; for m vertices in the cut up to m^3 comparisons of small
    /// sets, far fewer where few planes meet in a vertex.
    PolytopeSplit split(PlaneId h, const Polytope& p) {
        PolytopeSplit s;
        s.side = side(h, p);
        if (s.side == FacetSide::crossing) cut(h, p, s);
        return s;
    }

    /// Adds the edges among the vertices of p, from their planes alone. Requires: p has no edges yet, every bounding
    /// plane through a vertex is known, and p is at least a segment.
    void find_edges(Polytope& p) {
        const auto n = static_cast<std::uint32_t>(p.size());
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = i + 1; j < n; ++j)
                if (adjacent(p, i, j)) p.edges.emplace_back(i, j);
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;

    /// The planes that vertices i and j have in common, ascending.
    std::span<const std::uint32_t> common(const Polytope& p, std::size_t i, std::size_t j) {
        const std::span<const std::uint32_t> a = p.planes_of(i);
        const std::span<const std::uint32_t> b = p.planes_of(j);
        common_.clear();
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common_));
        return common_;
    }

    /// Whether no third vertex has all the planes that i and j share. An edge has at least D - 1 of them.
    bool adjacent(const Polytope& p, std::uint32_t i, std::uint32_t j) {
        const std::span<const std::uint32_t> shared = common(p, i, j);
        if (shared.size() + 1 < std::size_t(D)) return false;
        for (std::uint32_t v = 0; v < p.size(); ++v) {
            if (v == i || v == j) continue;
            const std::span<const std::uint32_t> own = p.planes_of(v);
            if (std::includes(own.begin(), own.end(), shared.begin(), shared.end())) return false;
        }
        return true;
    }

    /// D - 1 of the planes through a line whose meet is that line.
    std::array<std::uint32_t, D - 1> line_of(std::span<const std::uint32_t> through) {
        std::array<std::uint32_t, D - 1> line{};
        // Two different planes through a line always cross in it, and fewer than that are needed below D = 3.
        if (D <= 3 || through.size() + 1 == std::size_t(D)) {
            std::copy_n(through.begin(), D - 1, line.begin());
            return line;
        }
        // What is independent modulo a prime is independent.
        std::array<std::array<Mod61, D>, D> echelon{};
        std::array<std::size_t, D> pivot{};
        std::size_t rank = 0;
        for (const std::uint32_t k : through) {
            std::array<Mod61, D> row{};
            std::copy_n(kernel_->planes.residues(k).begin(), D, row.begin());
            for (std::size_t r = 0; r < rank; ++r) {
                const Mod61 factor = row[pivot[r]];
                for (std::size_t c = 0; c < D; ++c) row[c] -= factor * echelon[r][c];
            }
            std::size_t at = 0;
            while (at < D && row[at].is_zero()) ++at;
            if (at == D) continue;
            const Mod61 inverse = row[at].inverse();
            for (Mod61& x : row) x *= inverse;
            echelon[rank] = row;
            pivot[rank] = at;
            line[rank++] = k;
            if (rank + 1 == std::size_t(D)) return line;
        }
        return exact_line_of(through);
    }

    /// The same by exact ranks: for normals that are dependent modulo the prime by chance.
    std::array<std::uint32_t, D - 1> exact_line_of(std::span<const std::uint32_t> through) const {
        std::array<std::uint32_t, D - 1> line{};
        std::size_t rank = 0;
        for (const std::uint32_t k : through) {
            line[rank] = k;
            const Echelon<WideInteger> e(int(rank) + 1, D, [&](int i, int j) {
                return WideInteger(kernel_->planes.exact(line[std::size_t(i)])[std::size_t(j)]);
            });
            if (e.rank() == int(rank) + 1 && ++rank + 1 == std::size_t(D)) return line;
        }
        CLEAVE_CHECK_CONTRACT("requirement", rank + 1 == std::size_t(D));
        return line;
    }

    void cut(PlaneId h, const Polytope& p, PolytopeSplit& s) {
        const std::uint32_t k = unoriented(h);
        minus_.assign(p.size(), none);
        plus_.assign(p.size(), none);
        lid_.assign(p.size(), none);
        for (std::uint32_t i = 0; i < p.size(); ++i) {
            if (signs_[i] == Sign::zero) {
                with_plane(p.planes_of(i), k);
                lid_[i] = add_to_all(s, p.points[i], minus_[i], plus_[i]);
            } else if (signs_[i] == Sign::minus) {
                minus_[i] = static_cast<std::uint32_t>(s.minus.size());
                s.minus.add_vertex(p.points[i], p.planes_of(i));
            } else {
                plus_[i] = static_cast<std::uint32_t>(s.plus.size());
                s.plus.add_vertex(p.points[i], p.planes_of(i));
            }
        }
        for (const auto& [i, j] : p.edges) {
            if (signs_[i] * signs_[j] == Sign::minus) {
                const std::span<const std::uint32_t> shared = common(p, i, j);
                const PointId x = kernel_->cross(h, p.points[i], p.points[j], line_of(shared));
                with_plane(shared, k);
                std::uint32_t in_minus = none;
                std::uint32_t in_plus = none;
                add_to_all(s, x, in_minus, in_plus);
                const bool i_below = signs_[i] == Sign::minus;
                add_edge(s.minus, minus_[i_below ? i : j], in_minus);
                add_edge(s.plus, plus_[i_below ? j : i], in_plus);
            } else if (signs_[i] == Sign::zero && signs_[j] == Sign::zero) {
                add_edge(s.minus, minus_[i], minus_[j]);
                add_edge(s.plus, plus_[i], plus_[j]);
                add_edge(s.lid, lid_[i], lid_[j]);
            } else if (signs_[i] == Sign::minus || signs_[j] == Sign::minus) {
                add_edge(s.minus, minus_[i], minus_[j]);
            } else {
                add_edge(s.plus, plus_[i], plus_[j]);
            }
        }
        join_lid(s);
    }

    /// Adds a vertex with the planes of `with_` to both parts and the lid. Returns its index in the lid.
    std::uint32_t add_to_all(PolytopeSplit& s, PointId p, std::uint32_t& in_minus, std::uint32_t& in_plus) {
        in_minus = static_cast<std::uint32_t>(s.minus.size());
        in_plus = static_cast<std::uint32_t>(s.plus.size());
        const auto in_lid = static_cast<std::uint32_t>(s.lid.size());
        s.minus.add_vertex(p, with_);
        s.plus.add_vertex(p, with_);
        s.lid.add_vertex(p, with_);
        in_parts_.resize(in_lid);
        in_parts_.push_back({in_minus, in_plus});
        return in_lid;
    }

    /// Adds the new edges among the vertices of the lid to the lid and to both parts.
    void join_lid(PolytopeSplit& s) {
        Polytope& lid = s.lid;
        old_edges_ = lid.edges;
        std::sort(old_edges_.begin(), old_edges_.end());
        const auto n = static_cast<std::uint32_t>(lid.size());
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = i + 1; j < n; ++j) {
                if (!old_edges_.empty() && std::binary_search(old_edges_.begin(), old_edges_.end(), std::pair(i, j)))
                    continue;
                if (!adjacent(lid, i, j)) continue;
                lid.edges.emplace_back(i, j);
                add_edge(s.minus, in_parts_[i].first, in_parts_[j].first);
                add_edge(s.plus, in_parts_[i].second, in_parts_[j].second);
            }
    }

    /// `through` and k, ascending, into `with_`.
    void with_plane(std::span<const std::uint32_t> through, std::uint32_t k) {
        with_.assign(through.begin(), through.end());
        const auto at = std::lower_bound(with_.begin(), with_.end(), k);
        if (at == with_.end() || *at != k) with_.insert(at, k);
    }

    static void add_edge(Polytope& p, std::uint32_t i, std::uint32_t j) {
        p.edges.emplace_back(std::min(i, j), std::max(i, j));
    }

    Kernel<D>* kernel_;
    std::vector<Sign> signs_;
    std::vector<std::uint32_t> minus_, plus_, lid_;  // a vertex's index in the parts
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_parts_, old_edges_;
    std::vector<std::uint32_t> common_, with_;
};

/// All of D-space: the infimaximal frame, a cube whose 2^D vertices lie at infinity.
template <int D>
[[nodiscard]] Polytope universe(Kernel<D>& kernel) {
    Polytope p;
    for (std::uint32_t v = 0; v < (1U << unsigned(D)); ++v) {
        std::array<std::uint32_t, D> through{};
        for (int i = 0; i < D; ++i) through[std::size_t(i)] = kernel.planes.frame(i, (v >> unsigned(i) & 1U) != 0);
        const PointId x = kernel.add_meet(through);
        std::sort(through.begin(), through.end());
        p.add_vertex(x, through);
        for (int i = 0; i < D; ++i)
            if ((v >> unsigned(i) & 1U) == 0) p.edges.emplace_back(v, v | 1U << unsigned(i));
    }
    return p;
}

/// A face of a polytope: a plane that holds it, and its vertices.
struct PolytopeFace {
    std::uint32_t plane = no_id;  ///< unoriented, the least of those that hold exactly these vertices
    std::vector<std::uint32_t> vertices;
};

/// The largest proper faces of a polytope (the facets of a cell, the ridges of a facet), in the order of their planes.
/// Planes that hold all of the polytope are passed over. Cost: planes times vertices, and pairs of planes.
[[nodiscard]] inline std::vector<PolytopeFace> largest_faces(const Polytope& p) {
    std::vector<std::uint32_t> all = p.planes;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<PolytopeFace> faces;
    for (const std::uint32_t k : all) {
        PolytopeFace face{k, {}};
        for (std::uint32_t i = 0; i < p.size(); ++i)
            if (p.has(i, k)) face.vertices.push_back(i);
        if (face.vertices.size() < p.size()) faces.push_back(std::move(face));
    }
    std::vector<PolytopeFace> largest;
    for (std::size_t a = 0; a < faces.size(); ++a) {
        bool covered = false;
        for (std::size_t b = 0; b < faces.size() && !covered; ++b) {
            const std::vector<std::uint32_t>& x = faces[a].vertices;
            const std::vector<std::uint32_t>& y = faces[b].vertices;
            if (a == b || x.size() > y.size() || (x.size() == y.size() && (b > a || x != y))) continue;
            covered = std::includes(y.begin(), y.end(), x.begin(), x.end());
        }
        if (!covered) largest.push_back(faces[a]);
    }
    return largest;
}

/// The polytope of some vertices of another one, with all their planes; edges are left out.
[[nodiscard]] inline Polytope subpolytope(const Polytope& p, std::span<const std::uint32_t> vertices) {
    Polytope sub;
    for (const std::uint32_t i : vertices) sub.add_vertex(p.points[i], p.planes_of(i));
    return sub;
}

CLEAVE_END_NAMESPACE

#endif

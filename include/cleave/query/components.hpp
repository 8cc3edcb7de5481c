// SPDX-License-Identifier: Apache-2.0
/// The connected components of a set's interior, exactly: how many there are, and each as a region.
#ifndef CLEAVE_QUERY_COMPONENTS_HPP
#define CLEAVE_QUERY_COMPONENTS_HPP

#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/number/traits.hpp>
#include <cleave/query/shells.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Which component of the interior each shell bounds.
///
/// From a point in a face of each shell a ray is cast: how often it passes each shell, even or odd, says which shells
/// contain the point and, for its own shell, whether that is an outer shell or a void. Of the outer shells around a
/// void the innermost belongs to the same component, the one that lies in all the others; where there is none, the void
/// belongs to the unbounded component.
class ShellComponents {
public:
    /// Cost: for each shell, the faces that one ray meets.
    ShellComponents(Shells& shells, bool value_at_infinity) : shells_(&shells), edges_(&shells.edges()) {
        cast_all();
        component_.assign(shells.count(), no_id);
        if (value_at_infinity) unbounded_ = static_cast<std::uint32_t>(count_++);
        for (std::size_t s = 0; s < component_.size(); ++s)
            if (outer_[s]) component_[s] = static_cast<std::uint32_t>(count_++);
        for (std::size_t s = 0; s < component_.size(); ++s)
            if (!outer_[s]) component_[s] = of_void(s);
    }

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] bool is_outer(std::size_t shell) const { return outer_[shell]; }

    /// The component of a shell; the unbounded one, where there is one, is 0. `no_id` only for a boundary that is none.
    [[nodiscard]] std::uint32_t of_shell(std::size_t shell) const { return component_[shell]; }

private:
    void cast_all() {
        const std::size_t n = shells_->count();
        outer_.assign(n, false);
        around_.resize(n);
        // In each shell the face with the fewest edges that is not parallel to the ray.
        std::vector<std::uint32_t> chosen(n, no_id);
        for (std::uint32_t e = 0; e < edges_->size(); ++e) {
            const std::uint32_t f = (*edges_)[e].face;
            std::uint32_t& best = chosen[shells_->of_edge(e)];
            if (normal_x(f) == Sign::zero) continue;
            if (best == no_id || size_of(f) < size_of((*edges_)[best].face)) best = e;
        }
        std::vector<std::uint32_t> passed;
        for (std::uint32_t s = 0; s < n; ++s) {
            if (chosen[s] == no_id) continue;
            const std::uint32_t f = (*edges_)[chosen[s]].face;
            const std::optional<PointId> q = point_in_face(f, s);
            if (!q) continue;
            passed = cast(*q, f);
            const bool inside = std::find(passed.begin(), passed.end(), s) != passed.end();
            // Just left of q the point is inside the shell or not, and in the interior where the face looks to the
            // right: an outer shell has both or neither.
            outer_[s] = inside == (normal_x(f) == Sign::plus);
            for (const std::uint32_t t : passed)
                if (t != s) around_[s].push_back(t);
        }
    }

    [[nodiscard]] std::uint32_t of_void(std::size_t s) const {
        std::uint32_t best = no_id;
        std::size_t best_depth = 0;
        for (const std::uint32_t t : around_[s]) {
            if (!outer_[t]) continue;
            std::size_t depth = 1;
            for (const std::uint32_t u : around_[t]) depth += outer_[u] ? 1U : 0U;
            if (depth > best_depth) {
                best_depth = depth;
                best = t;
            }
        }
        return best == no_id ? unbounded_ : component_[best];
    }

    [[nodiscard]] std::size_t size_of(std::uint32_t f) const { return edges_->first(f + 1) - edges_->first(f); }

    [[nodiscard]] Sign normal_x(std::uint32_t f) const {
        const PlaneId plane = edges_->plane(f);
        const Sign s = shells_->kernel().planes.exact(unoriented(plane))[0].sign();
        return is_flipped(plane) ? -s : s;
    }

    /// The shells that the ray from q towards -x, a little above q in y and by far less in z, passes an odd number of
    /// times. Face `own`, in which q lies, is not counted.
    [[nodiscard]] std::vector<std::uint32_t> cast(PointId q, std::uint32_t own) {
        Kernel<3>& kernel = shells_->kernel();
        const Box<3> at = box_of(kernel, q);
        std::vector<std::uint32_t> crossed;  // once for each time
        const auto reaches = [&](const Box<3>& box) {
            return box.lo[0] <= at.hi[0] && box.lo[1] <= at.hi[1] && at.lo[1] <= box.hi[1] && box.lo[2] <= at.hi[2] &&
                   at.lo[2] <= box.hi[2];
        };
        shells_->boxes().hierarchy().visit_if(reaches, [&](std::size_t index) {
            const auto f = static_cast<std::uint32_t>(index);
            const Sign normal = normal_x(f);
            // On the line, the plane is where x = q_x - h(q) / n_x. A face is passed where q sees it on that side; no
            // other face contains q.
            if (f == own || normal == Sign::zero || kernel.side(edges_->plane(f), q) != normal) return;
            for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1); ++e)
                if (passes_right_of(e, q)) crossed.push_back(shells_->of_edge(e));
        });
        // Within a face, the edges of one shell to the right of the line are odd in number where the line meets it.
        std::sort(crossed.begin(), crossed.end());
        std::vector<std::uint32_t> odd;
        for (std::size_t i = 0; i < crossed.size();) {
            std::size_t j = i;
            while (j < crossed.size() && crossed[j] == crossed[i]) ++j;
            if ((j - i) % 2 != 0) odd.push_back(crossed[i]);
            i = j;
        }
        return odd;
    }

    /// Seen along x: whether edge e crosses the ray from q towards +y that runs just above q.
    [[nodiscard]] bool passes_right_of(std::uint32_t e, PointId q) const {
        Kernel<3>& kernel = shells_->kernel();
        PointId low = (*edges_)[e].from;
        PointId high = (*edges_)[e].to;
        const bool from_above = kernel.compare(2, low, q) == Sign::plus;
        if (from_above == (kernel.compare(2, high, q) == Sign::plus)) return false;
        if (from_above) std::swap(low, high);
        const Sign y_low = kernel.compare(1, low, q);
        const Sign y_high = kernel.compare(1, high, q);
        if (y_low == y_high) return y_low == Sign::plus;
        // det(low, high, q) > 0: q is to the left. Through q itself the edge passes below q's shift in y.
        return turn(kernel, low, high, q, Projection::along(0)) == Sign::plus;
    }

    /// A point in the relative interior of face f, in a piece of shell s. Seen along the axis on which the face's
    /// normal is longest: halfway between an edge with the interior above it and the edge next above, at an abscissa
    /// where no edge of the face ends.
    [[nodiscard]] std::optional<PointId> point_in_face(std::uint32_t f, std::uint32_t s) {
        Kernel<3>& kernel = shells_->kernel();
        const PlaneId plane = edges_->plane(f);
        const int drop = dominant_axis(kernel, unoriented(plane));
        const auto& n = kernel.planes.exact(unoriented(plane));
        const bool reversed = (n[std::size_t(drop)].sign() == Sign::minus) != is_flipped(plane);
        const int u = reversed ? (drop + 2) % 3 : (drop + 1) % 3;
        const int v = reversed ? (drop + 1) % 3 : (drop + 2) % 3;
        std::uint32_t below = no_id;
        for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1) && below == no_id; ++e)
            if (shells_->of_edge(e) == s && kernel.compare(u, (*edges_)[e].from, (*edges_)[e].to) == Sign::minus)
                below = e;
        if (below == no_id) return std::nullopt;
        const PointId start = (*edges_)[below].from;
        PointId stop = (*edges_)[below].to;
        for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1); ++e) {
            const PointId p = (*edges_)[e].from;
            if (kernel.compare(u, p, start) == Sign::plus && kernel.compare(u, p, stop) == Sign::minus) stop = p;
        }
        const Rational at = Rational(coordinate(start, u) + coordinate(stop, u)) / 2;
        const Rational low = height(below, at, u, v);
        std::optional<Rational> high;
        for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1); ++e) {
            const BoundaryEdge& edge = (*edges_)[e];  // with the interior below it
            if (kernel.compare(u, edge.to, start) == Sign::plus || kernel.compare(u, edge.from, stop) == Sign::minus)
                continue;
            Rational h = height(e, at, u, v);
            if (h > low && (!high || h < *high)) high = std::move(h);
        }
        if (!high) return std::nullopt;
        std::array<Rational, 3> x;
        x[std::size_t(u)] = at;
        x[std::size_t(v)] = Rational(low + *high) / 2;
        using Traits = number_traits<Rational>;
        const Rational sum = Traits::from_integer(n[3]) + Traits::from_integer(n[std::size_t(u)]) * x[std::size_t(u)] +
                             Traits::from_integer(n[std::size_t(v)]) * x[std::size_t(v)];
        x[std::size_t(drop)] = Rational(-sum) / Traits::from_integer(n[std::size_t(drop)]);
        return add_point<Rational, 3>(kernel, x);
    }

    [[nodiscard]] Rational coordinate(PointId p, int axis) const {
        const Homogeneous<3> x = shells_->kernel().coordinates(p);
        return number_traits<Rational>::from_fraction(x[std::size_t(axis)], x[3]);
    }

    /// Coordinate v where edge e has coordinate u = at.
    [[nodiscard]] Rational height(std::uint32_t e, const Rational& at, int u, int v) const {
        const PointId p = (*edges_)[e].from;
        const PointId q = (*edges_)[e].to;
        const Rational a = coordinate(p, u);
        const Rational b = coordinate(p, v);
        return b + Rational(coordinate(q, v) - b) * Rational(at - a) / Rational(coordinate(q, u) - a);
    }

    Shells* shells_;
    const BoundaryEdges* edges_;
    std::vector<bool> outer_;
    std::vector<std::vector<std::uint32_t>> around_;  // per shell: the others that contain it
    std::vector<std::uint32_t> component_;            // per shell
    std::uint32_t unbounded_ = no_id;
    std::size_t count_ = 0;
};

/// What connects to what in a 3-D boundary.
struct Connectivity {
    bool closed = true;          ///< edges of faces cancel out along every line: the boundary has no gap
    std::size_t shells = 0;      ///< connected surfaces
    std::size_t components = 0;  ///< connected pieces of the interior
};

/// Shells and components of a set, all decided exactly. The interior is the topological one: parts that share points,
/// edges, but no piece of facet are not connected. Empty: no component; full: one, without shells.
/// Cost: O(n log n) for n edges, and one ray for each shell.
template <class N>
[[nodiscard]] Connectivity connectivity(const Region<3, N>& region) {
    Shells shells(region.boundary());
    const ShellComponents components(shells, region.boundary().value_at_infinity);
    return {shells.is_closed(), shells.count(), components.count()};
}

/// The connected components of the interior, each as a region with its cavities, in the order of their first faces, an
/// unbounded one first. Sources are those of the region's faces.
/// Cost: as `connectivity`, and a copy of the faces.
template <class N>
[[nodiscard]] std::vector<Region<3, N>> components(const Region<3, N>& region) {
    const Boundary<3>& boundary = region.boundary();
    Shells shells(boundary);
    const ShellComponents found(shells, region.boundary().value_at_infinity);
    if (found.count() == 1) return {region};
    const BoundaryEdges& edges = shells.edges();
    Kernel<3>& kernel = shells.kernel();
    PointInterner<3> points(kernel);
    FaceMerger<3> merger(kernel, points);
    std::vector<FaceList> faces(found.count());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_component;  // edges of one face
    std::vector<Corner> piece;
    for (std::uint32_t f = 0; f < edges.face_count(); ++f) {
        by_component.clear();
        for (std::uint32_t e = edges.first(f); e < edges.first(f + 1); ++e)
            by_component.push_back({found.of_shell(shells.of_edge(e)), e});
        std::sort(by_component.begin(), by_component.end());
        for (std::size_t i = 0; i < by_component.size();) {
            const std::uint32_t component = by_component[i].first;
            merger.begin(edges.plane(f));
            for (; i < by_component.size() && by_component[i].first == component; ++i) {
                const BoundaryEdge& e = edges[by_component[i].second];
                merger.add_edge(e.from, e.to, e.plane);
            }
            if (component != no_id) merger.finish(faces[component], boundary.faces.faces[f].source);
        }
    }
    std::vector<Region<3, N>> result;
    for (std::size_t c = 0; c < faces.size(); ++c)
        result.emplace_back(freeze(kernel, faces[c], c == 0 && region.boundary().value_at_infinity, points));
    return result;
}

CLEAVE_END_NAMESPACE

#endif

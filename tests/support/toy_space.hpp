// SPDX-License-Identifier: Apache-2.0
/// A space without geometry: axis-parallel planes at integer positions, facets that are axis-parallel boxes of one
/// dimension less, and points on a half-integer grid. Enough to run every tree algorithm in every dimension, with
/// oracles that look at each grid cell one by one.
///
/// D = 1: oriented points. D = 2: axis-parallel segments. D = 3: axis-parallel rectangles.
#ifndef CLEAVE_TESTS_SUPPORT_TOY_SPACE_HPP
#define CLEAVE_TESTS_SUPPORT_TOY_SPACE_HPP

#include <cleave/bsp/classify.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/number/sign.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace toy {

using Integer = std::int64_t;

/// The plane x[axis] = at; `outside` is the sign of x[axis] - at on its plus side.
struct Plane {
    std::size_t axis = 0;
    Integer at = 0;
    cleave::Sign outside = cleave::Sign::plus;

    friend bool operator==(const Plane&, const Plane&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Plane& h) {
        return out << "x" << h.axis << (h.outside == cleave::Sign::plus ? " < " : " > ") << h.at;
    }
};

/// The box [low, high] in the plane: low = high = plane.at along its axis, low < high along the others.
template <std::size_t D>
struct Facet {
    Plane plane;
    std::array<Integer, D> low{};
    std::array<Integer, D> high{};

    friend bool operator==(const Facet&, const Facet&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Facet& f) {
        out << "{" << f.plane << ":";
        for (std::size_t i = 0; i < D; ++i) out << " [" << f.low[i] << "," << f.high[i] << "]";
        return out << "}";
    }
};

/// A point by twice its coordinates, so that the middle of a grid cell is a point.
template <std::size_t D>
using Point = std::array<Integer, D>;

/// A closed box. The hull of facets.
template <std::size_t D>
struct Box {
    std::array<Integer, D> low{};
    std::array<Integer, D> high{};
};

/// How often a model was asked. Counted, so that tests can say what an algorithm may cost.
struct Counts {
    std::size_t sides = 0;
    std::size_t splits = 0;
};

/// The Clip model (bounded, locating, proposing).
template <std::size_t D>
class Space {
public:
    using plane_type = Plane;
    using facet_type = Facet<D>;
    using point_type = Point<D>;
    using box_type = Box<D>;

    Counts counts;

    [[nodiscard]] Plane plane_of(const facet_type& f) const { return f.plane; }

    [[nodiscard]] cleave::PlaneRelation relation(const Plane& h, const Plane& g) const {
        using cleave::PlaneRelation;
        if (h.axis != g.axis) return PlaneRelation::crossing;
        const bool same_way = h.outside == g.outside;
        if (h.at == g.at) return same_way ? PlaneRelation::same : PlaneRelation::opposite;
        return same_way ? PlaneRelation::parallel : PlaneRelation::antiparallel;
    }

    [[nodiscard]] cleave::FacetSide side(const Plane& h, const facet_type& f) {
        using cleave::FacetSide;
        ++counts.sides;
        const Integer low = f.low[h.axis];
        const Integer high = f.high[h.axis];
        if (low < h.at && h.at < high) return FacetSide::crossing;
        if (low == high && low == h.at) {
            return f.plane.outside == h.outside ? FacetSide::on_same : FacetSide::on_opposite;
        }
        return (high <= h.at) == (h.outside == cleave::Sign::plus) ? FacetSide::minus : FacetSide::plus;
    }

    [[nodiscard]] cleave::Split<facet_type> split(const Plane& h, const facet_type& f) {
        using cleave::FacetSide;
        ++counts.splits;
        cleave::Split<facet_type> s;
        s.side = side(h, f);
        --counts.sides;
        switch (s.side) {
            case FacetSide::minus:
                s.minus = f;
                break;
            case FacetSide::plus:
                s.plus = f;
                break;
            case FacetSide::on_same:
            case FacetSide::on_opposite:
                s.on = f;
                break;
            case FacetSide::crossing: {
                facet_type low = f;
                facet_type high = f;
                low.high[h.axis] = h.at;
                high.low[h.axis] = h.at;
                const bool low_is_minus = h.outside == cleave::Sign::plus;
                s.minus = low_is_minus ? low : high;
                s.plus = low_is_minus ? high : low;
                break;
            }
        }
        return s;
    }

    [[nodiscard]] Plane flip_plane(const Plane& h) const { return Plane{h.axis, h.at, -h.outside}; }
    [[nodiscard]] facet_type flip(const facet_type& f) const {
        facet_type g = f;
        g.plane = flip_plane(f.plane);
        return g;
    }

    [[nodiscard]] std::vector<Plane> ridges(const facet_type& f) const {
        std::vector<Plane> planes;
        for (std::size_t i = 0; i < D; ++i) {
            if (i == f.plane.axis) continue;
            planes.push_back(Plane{i, f.low[i], cleave::Sign::minus});
            planes.push_back(Plane{i, f.high[i], cleave::Sign::plus});
        }
        return planes;
    }

    [[nodiscard]] box_type box(const facet_type& f) const { return box_type{f.low, f.high}; }
    [[nodiscard]] box_type hull(const box_type& a, const box_type& b) const {
        box_type c = a;
        for (std::size_t i = 0; i < D; ++i) {
            c.low[i] = std::min(a.low[i], b.low[i]);
            c.high[i] = std::max(a.high[i], b.high[i]);
        }
        return c;
    }
    [[nodiscard]] bool disjoint(const box_type& a, const box_type& b) const {
        for (std::size_t i = 0; i < D; ++i) {
            if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return true;
        }
        return false;
    }

    /// The middle of the facet.
    [[nodiscard]] point_type witness(const facet_type& f) const {
        point_type p{};
        for (std::size_t i = 0; i < D; ++i) p[i] = f.low[i] + f.high[i];
        return p;
    }
    [[nodiscard]] cleave::Sign side(const Plane& h, const point_type& p) const {
        return cleave::sign_of_value(p[h.axis] - 2 * h.at) * h.outside;
    }

    /// The plane through the median of the facets' middles along the longest axis of their hull. Facets often lie in
    /// it: a grid has few planes.
    [[nodiscard]] std::optional<Plane> propose(std::span<const facet_type> facets) const {
        box_type all = box(facets.front());
        for (const facet_type& f : facets) all = hull(all, box(f));
        std::size_t axis = 0;
        for (std::size_t i = 1; i < D; ++i) {
            if (all.high[i] - all.low[i] > all.high[axis] - all.low[axis]) axis = i;
        }
        if (all.low[axis] == all.high[axis]) return std::nullopt;
        std::vector<Integer> middles;
        for (const facet_type& f : facets) middles.push_back(f.low[axis] + f.high[axis]);
        const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
        std::nth_element(middles.begin(), median, middles.end());
        const Integer at = *median / 2;
        return Plane{axis, at, cleave::Sign::plus};
    }
};

static_assert(cleave::BoundedClip<Space<1>> && cleave::LocatingClip<Space<1>> && cleave::ProposingClip<Space<1>>);
static_assert(cleave::BoundedClip<Space<2>> && cleave::LocatingClip<Space<2>> && cleave::ProposingClip<Space<2>>);
static_assert(cleave::BoundedClip<Space<3>> && cleave::LocatingClip<Space<3>> && cleave::ProposingClip<Space<3>>);

/// The oracle: a set of unit cells of the grid [0, size)^D, and a colour for all of space around it.
template <std::size_t D>
class Grid {
public:
    explicit Grid(Integer size, bool around = false) : size_(size), around_(around) {
        std::size_t n = 1;
        for (std::size_t i = 0; i < D; ++i) n *= static_cast<std::size_t>(size);
        cells_.assign(n, around);
    }

    [[nodiscard]] Integer size() const { return size_; }
    /// The colour far away.
    [[nodiscard]] bool around() const { return around_; }

    /// Whether the unit cell with this lowest corner belongs to the set.
    [[nodiscard]] bool cell(const std::array<Integer, D>& c) const {
        for (const Integer x : c) {
            if (x < 0 || x >= size_) return around_;
        }
        return cells_[index(c)];
    }

    /// Gives the cells of the box [low, high] the colour `value`.
    Grid& fill(const std::array<Integer, D>& low, const std::array<Integer, D>& high, bool value = true) {
        for_each([&](const std::array<Integer, D>& c) {
            for (std::size_t i = 0; i < D; ++i) {
                if (c[i] < low[i] || c[i] >= high[i]) return;
            }
            cells_[index(c)] = value;
        });
        return *this;
    }

    [[nodiscard]] Grid complement() const {
        Grid g = *this;
        g.around_ = !around_;
        g.cells_.flip();
        return g;
    }

    /// Looks at the cells whose closure contains the point.
    [[nodiscard]] cleave::Location locate(const Point<D>& p) const {
        bool inside = false;
        bool outside = false;
        for (std::size_t corner = 0; corner < (std::size_t{1} << D); ++corner) {
            std::array<Integer, D> c{};
            for (std::size_t i = 0; i < D; ++i) {
                const bool upper = ((corner >> i) & 1U) != 0;
                const bool odd = (p[i] & 1) != 0;  // between two grid planes: one cell, counted twice
                c[i] = odd ? (p[i] - 1) / 2 : p[i] / 2 - (upper ? 0 : 1);
            }
            (cell(c) ? inside : outside) = true;
        }
        if (inside && outside) return cleave::Location::boundary;
        return inside ? cleave::Location::inside : cleave::Location::outside;
    }

    /// Calls f for each point of the half-integer grid on and around the cells.
    template <class F>
    void for_each_point(F&& f) const {
        Point<D> p{};
        p.fill(-3);
        for (;;) {
            f(p);
            std::size_t i = 0;
            while (i < D && ++p[i] > 2 * size_ + 3) p[i++] = -3;
            if (i == D) return;
        }
    }

    /// The boundary, facing outward, each part once. Unit facets in one plane that follow each other along an axis are
    /// joined into one, so that cuts have something to split.
    [[nodiscard]] std::vector<Facet<D>> boundary() const {
        std::vector<Facet<D>> facets;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const std::size_t along = axis == 0 ? D - 1 : 0;
            for_each_layer(axis, [&](std::array<Integer, D> above) {
                std::array<Integer, D> below = above;
                --below[axis];
                const bool inside_below = cell(below);
                if (inside_below == cell(above)) return;
                Facet<D> f{Plane{axis, above[axis], inside_below ? cleave::Sign::plus : cleave::Sign::minus}, above,
                           above};
                for (std::size_t i = 0; i < D; ++i) f.high[i] += i == axis ? 0 : 1;
                if (D > 1 && !facets.empty() && continues(facets.back(), f, along)) {
                    facets.back().high[along] = f.high[along];
                } else {
                    facets.push_back(f);
                }
            });
        }
        return facets;
    }

    friend bool operator==(const Grid&, const Grid&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Grid& g) {
        out << "grid of " << g.size_ << ", around " << g.around_ << ": ";
        for (const bool c : g.cells_) out << (c ? '#' : '.');
        return out;
    }

private:
    [[nodiscard]] std::size_t index(const std::array<Integer, D>& c) const {
        std::size_t k = 0;
        for (std::size_t i = D; i-- > 0;) k = k * static_cast<std::size_t>(size_) + static_cast<std::size_t>(c[i]);
        return k;
    }

    /// Calls f with each cell.
    template <class F>
    void for_each(F&& f) const {
        std::array<Integer, D> c{};
        for (;;) {
            f(c);
            std::size_t i = 0;
            while (i < D && ++c[i] == size_) c[i++] = 0;
            if (i == D) return;
        }
    }

    /// Calls f with each cell, and one more layer along `axis`; the cells of a row along `D - 1` (axis 0) or 0 follow
    /// each other.
    template <class F>
    void for_each_layer(std::size_t axis, F&& f) const {
        std::array<Integer, D> c{};
        for (;;) {
            f(c);
            bool carried = true;
            for (std::size_t k = 0; k < D && carried; ++k) {
                const std::size_t i = axis == 0 ? D - 1 - k : k;
                carried = ++c[i] == size_ + (i == axis ? 1 : 0);
                if (carried) c[i] = 0;
            }
            if (carried) return;
        }
    }

    [[nodiscard]] static bool continues(const Facet<D>& f, const Facet<D>& g, std::size_t along) {
        if (!(f.plane == g.plane) || f.high[along] != g.low[along]) return false;
        for (std::size_t i = 0; i < D; ++i) {
            if (i != along && (f.low[i] != g.low[i] || f.high[i] != g.high[i])) return false;
        }
        return true;
    }

    Integer size_;
    bool around_;
    std::vector<bool> cells_;
};

/// The 2n facets of n unit gaps and n unit intervals on a line: [0,1], [2,3], [4,5], ...
[[nodiscard]] inline std::vector<Facet<1>> comb(std::size_t n) {
    std::vector<Facet<1>> facets;
    for (std::size_t k = 0; k < 2 * n; ++k) {
        const auto x = static_cast<Integer>(k);
        facets.push_back(Facet<1>{Plane{0, x, k % 2 == 0 ? cleave::Sign::minus : cleave::Sign::plus}, {x}, {x}});
    }
    return facets;
}

}  // namespace toy

#endif

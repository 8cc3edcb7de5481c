// SPDX-License-Identifier: Apache-2.0
/// Prisms: a polygon set with holes, swept along the z axis.
#ifndef CLEAVE_SHAPE_PRISM_HPP
#define CLEAVE_SHAPE_PRISM_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/kernel.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/region.hpp>
#include <cleave/shape/rational_point.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Lifts the boundary of a bounded polygon set to that of its prism. Planes and points of the base become planes and
/// points of the prism one by one, so nothing is calculated anew: a line a x + b y + c = 0 is the same vertical plane,
/// a point that is the meet of two lines is the meet of two vertical planes and a horizontal one.
class PrismBuilder {
public:
    PrismBuilder(const Boundary<2>& base, const Rational& bottom, const Rational& top)
        : base_(&base), loaded_(load(base, flat_)), z_{bottom, top} {
        for (std::uint32_t k = 0; k < base.planes.size(); ++k) {
            const auto& line = base.planes.exact(k);
            planes_.push_back(kernel_.planes.intern({line[0], line[1], Integer(0), line[2]}));
        }
        for (std::size_t level = 0; level < 2; ++level) {
            const Fraction z = number_traits<Rational>::to_fraction(z_[level]);
            // Facing up; the bottom cap is turned round below.
            horizontal_[level] = kernel_.planes.intern({Integer(0), Integer(0), z.den, -z.num});
            for (PointId p = 0; p < base.points.size(); ++p) points_[level].push_back(lift(p, level));
        }
    }

    Boundary<3> build() {
        add_cap(0);
        add_cap(1);
        for (const FaceList::Face& face : base_->faces.faces) add_wall(face);
        return freeze(kernel_, faces_, false, [](PointId p) { return p; });
    }

private:
    /// A segment of the base's boundary with the line it lies on.
    struct Segment {
        PointId from;
        PointId to;
        PlaneId line;
        bool used;
    };

    [[nodiscard]] PlaneId vertical(PlaneId line) const { return planes_[unoriented(line)] ^ (line & 1U); }

    PointId lift(PointId p, std::size_t level) {
        PointId lifted = no_id;
        const PointRecord<2>& r = base_->points[p];
        if (r.kind == PointRecord<2>::Kind::meet) {
            lifted = kernel_.add_meet(
                {unoriented(planes_[r.planes[0]]), unoriented(planes_[r.planes[1]]), unoriented(horizontal_[level])});
        } else {
            const Homogeneous<2> x = flat_.coordinates(loaded_.first_point + p);
            lifted = cleave::add_point<3>(kernel_, {make_fraction(x[0], x[2]), make_fraction(x[1], x[2]),
                                                    number_traits<Rational>::to_fraction(z_[level])});
            for (const std::uint32_t k : r.planes)
                if (k != no_id) kernel_.note_incidence(lifted, unoriented(planes_[k]));
            kernel_.note_incidence(lifted, unoriented(horizontal_[level]));
        }
        return lifted;
    }

    /// One face with all loops of the base, at the bottom run through backwards.
    void add_cap(std::size_t level) {
        std::vector<Segment> segments;
        for (const FaceList::Face& face : base_->faces.faces)
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::span<const Corner> ends = base_->faces.loop(l);
                segments.push_back({ends[0].point, ends[1].point, face.plane, false});
            }
        std::sort(segments.begin(), segments.end(),
                  [](const Segment& a, const Segment& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
        faces_.begin_face(level == 1 ? horizontal_[1] : flipped(horizontal_[0]),
                          {0, static_cast<std::uint32_t>(level)});
        std::vector<Corner> loop;
        for (Segment& first : segments) {
            if (first.used) continue;
            loop.clear();
            for (Segment* s = &first; s != nullptr; s = next(segments, *s)) {
                s->used = true;
                loop.push_back({points_[level][s->from], vertical(s->line)});
            }
            if (level == 0) KernelClip<3>::reverse_corners(loop);
            faces_.add_loop(loop);
        }
    }

    /// The unused segment that continues `s`: of several, the first clockwise from the way back, so that the set stays
    /// on the left in one sector and a loop never crosses itself.
    Segment* next(std::vector<Segment>& segments, const Segment& s) {
        auto i = std::lower_bound(segments.begin(), segments.end(), s.to,
                                  [](const Segment& a, PointId p) { return a.from < p; });
        Segment* best = nullptr;
        for (; i != segments.end() && i->from == s.to; ++i)
            if (!i->used && (best == nullptr || before(s, *i, *best))) best = &*i;
        return best;
    }

    /// Whether the way along `a` comes before that along `b`, turning clockwise from the way back along `in`.
    bool before(const Segment& in, const Segment& a, const Segment& b) {
        const int x = half(in, a);
        const int y = half(in, b);
        return x != y ? x < y : turn(a, b) == Sign::minus;
    }

    /// The part of the clockwise turn from the way back along `in` in which `out` leaves: 0 before straight on (a left
    /// turn of the path), 1 straight on, 2 after it.
    int half(const Segment& in, const Segment& out) {
        const Sign left = turn(in, out);
        return left == Sign::plus ? 0 : (left == Sign::zero ? 1 : 2);
    }

    /// The sign of the cross product of two directions: normals of lines are directions turned by the same angle.
    [[nodiscard]] Sign turn(const Segment& a, const Segment& b) const {
        const auto& m = base_->planes.exact(unoriented(a.line));
        const auto& n = base_->planes.exact(unoriented(b.line));
        const Sign s = (WideInteger(m[0]) * WideInteger(n[1]) - WideInteger(m[1]) * WideInteger(n[0])).sign();
        return is_flipped(a.line) == is_flipped(b.line) ? s : -s;
    }

    /// One face for each face of the base: a rectangle for each of its segments.
    void add_wall(const FaceList::Face& face) {
        faces_.begin_face(vertical(face.plane), {0, static_cast<std::uint32_t>(faces_.faces.size())});
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            const std::span<const Corner> ends = base_->faces.loop(l);
            const std::array<Corner, 4> rectangle = {
                Corner{points_[0][ends[0].point], flipped(horizontal_[0])},
                Corner{points_[0][ends[1].point], vertical(ends[1].edge)},
                Corner{points_[1][ends[1].point], horizontal_[1]},
                Corner{points_[1][ends[0].point], vertical(ends[0].edge)},
            };
            faces_.add_loop(rectangle);
        }
    }

    const Boundary<2>* base_;
    Kernel<2> flat_;
    LoadedBoundary<2> loaded_;
    std::array<Rational, 2> z_;
    Kernel<3> kernel_;
    std::vector<PlaneId> planes_;  // of the base's unoriented lines
    std::array<PlaneId, 2> horizontal_{};
    std::array<std::vector<PointId>, 2> points_;
    FaceList faces_;
};

}  // namespace detail

/// The points above `base` between the planes z = z0 and z = z1, which may come in either order; with z0 = z1, or an
/// empty base, the empty set. Face 0 is the bottom, face 1 the top (each one polygon set with holes), then one face for
/// each face of the base. The numbers of the base are kept, whatever operations it came from.
/// Throws: ShapeError for an unbounded base; NumberError for a z that is infinite or NaN.
template <class N>
[[nodiscard]] Region<3, N> prism(const Region<2, N>& base, const std::type_identity_t<N>& z0,
                                 const std::type_identity_t<N>& z1) {
    if (!base.is_bounded())
        throw ShapeError("the base of a prism is unbounded: intersect it with a bounded polygon first");
    Rational bottom = to_rational(z0);
    Rational top = to_rational(z1);
    if (bottom == top || base.is_empty()) return Region<3, N>::empty();
    if (top < bottom) std::swap(bottom, top);
    return Region<3, N>(detail::PrismBuilder(base.boundary(), bottom, top).build());
}

/// The prism over one polygon, given counter-clockwise: `prism<Rational>({{0, 0}, {4, 0}, {1, 1}}, 0, 5)`.
/// Throws: as `polygon`, and as above.
template <class N = Rational>
[[nodiscard]] Region<3, N> prism(const std::vector<std::array<N, 2>>& loop, const std::type_identity_t<N>& z0,
                                 const std::type_identity_t<N>& z1) {
    return prism(polygon<N>(loop), z0, z1);
}

CLEAVE_END_NAMESPACE

#endif

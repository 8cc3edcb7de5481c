// SPDX-License-Identifier: Apache-2.0
/// How two convex facets of one surface meet.
#ifndef CLEAVE_REGION_FACET_MEETING_HPP
#define CLEAVE_REGION_FACET_MEETING_HPP

#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/region/convex_facets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The ways in which two facets meet, weakest first.
enum class MeetingKind : std::uint8_t {
    none,      ///< not at all
    shared,    ///< in common corners, or all of a common edge, and nowhere else
    touch,     ///< elsewhere too, but no inner point of the one face is an inner point of the other
    crossing,  ///< on different planes, with inner points in common
    overlap    ///< on one plane, with inner points in common
};

/// Two facets and what they have in common. A stretch of a line goes from `from` to `to`, which differ; otherwise both
/// are `no_id`.
struct FacetMeeting {
    MeetingKind kind = MeetingKind::none;
    PointId from = no_id;
    PointId to = no_id;
    bool through_first = false;   ///< whether the stretch runs through the inside of the first facet
    bool through_second = false;  ///< whether it runs through the inside of the second
};

/// Decides how the facets of one list meet, two at a time. Most neighbours are decided by the sides of their corners.
/// The rest is the common line of two planes, with the facets' stretches of it ordered by exact points.
class FacetMeetings {
public:
    explicit FacetMeetings(ConvexFacets& facets) : facets_(&facets) {}

    /// How facets a and b meet, where the sides of their corners tell. Two triangles whose corners all lie beside the
    /// other's plane are always decided, by the test of [Guigue-Devillers-2003] where they have no corner in common.
    /// Cost: some 10 ns for triangles of doubles.
    [[nodiscard]] std::optional<MeetingKind> decide(std::uint32_t a, std::uint32_t b) {
        find_common(a, b);
        signs_of(a, b, sides_b_);
        if (sides_b_.is_one_sided()) {
            if (sides_b_.all_zero()) {
                // Zeros are dear. Once both planes have ids, no other pair of coplanar neighbours costs as much.
                static_cast<void>(facets_->plane(a));
                static_cast<void>(facets_->plane(b));
            }
            if (const auto kind = decide_one_sided(a, b, sides_b_)) return kind;
            if (sides_b_.all_zero()) {
                sides_a_.reset(facets_->corners(a).size());
                return decide_one_sided(b, a, sides_a_);
            }
        }
        signs_of(b, a, sides_a_);
        if (sides_a_.is_one_sided())
            if (const auto kind = decide_one_sided(b, a, sides_a_)) return kind;
        if (sides_a_.is_one_sided() || sides_b_.is_one_sided()) return std::nullopt;
        if (facets_->corners(a).size() != 3 || facets_->corners(b).size() != 3) return std::nullopt;
        const std::size_t zeros = sides_a_.zeros + sides_b_.zeros;
        if (common_ == 1 && zeros == 2) return at_common_corner();
        if (common_ == 0 && zeros == 0 && (*facets_)[a].is_plain && (*facets_)[b].is_plain) return apart(a, b);
        return std::nullopt;
    }

    /// How facets a and b meet.
    [[nodiscard]] FacetMeeting meet(std::uint32_t a, std::uint32_t b) {
        find_common(a, b);
        signs_of(a, b, sides_b_);
        if (sides_b_.all_zero()) return meet_in_plane(a, b);
        signs_of(b, a, sides_a_);
        return meet_on_line(a, b);
    }

private:
    /// The sides of one facet's corners with respect to the other's plane.
    struct Sides {
        std::vector<Sign> sign;
        std::size_t zeros = 0;
        bool below = false;
        bool above = false;

        /// All n are zero.
        void reset(std::size_t n) {
            sign.assign(n, Sign::zero);
            zeros = n;
            below = above = false;
        }
        void count() {
            zeros = 0;
            for (const Sign s : sign) {
                below = below || s == Sign::minus;
                above = above || s == Sign::plus;
                zeros += s == Sign::zero ? 1U : 0U;
            }
        }
        [[nodiscard]] bool is_one_sided() const noexcept { return !below || !above; }
        [[nodiscard]] bool all_zero() const noexcept { return !below && !above; }
    };

    /// The stretch of a line that a facet covers, its ends in the order of an axis.
    struct Stretch {
        PointId from = no_id;
        PointId to = no_id;
        [[nodiscard]] bool is_empty() const noexcept { return from == no_id; }
    };

    [[nodiscard]] bool has_corner(std::uint32_t f, PointId p) const {
        for (const Corner& c : facets_->corners(f))
            if (c.point == p) return true;
        return false;
    }

    void find_common(std::uint32_t a, std::uint32_t b) {
        common_ = 0;
        for (const Corner& c : facets_->corners(b)) common_ += has_corner(a, c.point) ? 1U : 0U;
    }

    /// Whether edge e of facet f, which facet g of another face has as well, is inside either face.
    [[nodiscard]] bool is_inner_to_one(std::uint32_t f, std::size_t e, std::uint32_t g) const {
        if ((*facets_)[f].face == (*facets_)[g].face) return false;
        if (facets_->is_inner(f, e)) return true;
        const PointId from = facets_->corner(f, e);
        const PointId to = facets_->corner(f, facets_->next(f, e));
        for (std::size_t i = 0; i < facets_->corners(g).size(); ++i) {
            const PointId p = facets_->corner(g, i);
            const PointId q = facets_->corner(g, facets_->next(g, i));
            if (facets_->is_inner(g, i) && ((p == from && q == to) || (p == to && q == from))) return true;
        }
        return false;
    }

    /// The sides of g's corners with respect to f's plane.
    void signs_of(std::uint32_t f, std::uint32_t g, Sides& out) {
        const std::size_t n = facets_->corners(g).size();
        out.reset(n);
        if (facets_->are_known_coplanar(f, g)) return;
        for (std::size_t i = 0; i < n; ++i) {
            const PointId p = facets_->corner(g, i);
            if (common_ == 0 || !has_corner(f, p)) out.sign[i] = facets_->side(f, p);
        }
        out.count();
    }

    /// Facet g has no corner on one side of f's plane: all that can meet f are its corners in the plane. If those that
    /// are not f's own lie beyond one of f's edges, and f's own are ends of that edge, they alone are common.
    std::optional<MeetingKind> decide_one_sided(std::uint32_t f, std::uint32_t g, const Sides& sides) {
        if (sides.zeros == 0) return MeetingKind::none;
        if (sides.zeros == common_ && common_ == 1) return MeetingKind::shared;
        for (std::size_t e = 0; e < facets_->corners(f).size(); ++e) {
            const PointId from = facets_->corner(f, e);
            const PointId to = facets_->corner(f, facets_->next(f, e));
            bool beyond = true;
            std::size_t own = 0;
            for (std::size_t i = 0; i < sides.sign.size() && beyond; ++i) {
                if (sides.sign[i] != Sign::zero) continue;
                const PointId p = facets_->corner(g, i);
                if (p == from || p == to)
                    ++own;
                else
                    beyond = !has_corner(f, p) && facets_->edge_side(f, e, p) == Sign::plus;
            }
            if (!beyond) continue;
            // Two of them are an edge of g as well: all else of g is beyond it or off the plane.
            if (own == 2 && is_inner_to_one(f, e, g)) return std::nullopt;
            return own == 0 ? MeetingKind::none : MeetingKind::shared;
        }
        return std::nullopt;
    }

    /// Two triangles with one corner in common, each with its other corners on both sides of the other's plane: along
    /// the planes' common line both run from that corner, the same way or not.
    ///
    /// Proof. With the corner as origin, a = (0, p, q) and b = (0, u, v), points of the two stretches are x p + y q and
    /// z u + w v with positive factors, and x p + y q = t (z u + w v) for some t. The determinant with p and u gives
    /// y det(p, u, q) = t w det(p, u, v), where det(p, u, q) = -det(p, q, u) is minus the side of u, and det(p, u, v) =
    /// det(u, v, p) is the side of p. They run the same way where t is positive.
    [[nodiscard]] MeetingKind at_common_corner() const {
        const Sign p = sides_a_.sign[(find(sides_a_, Sign::zero) + 1) % 3];
        const Sign u = sides_b_.sign[(find(sides_b_, Sign::zero) + 1) % 3];
        return p * u == Sign::plus ? MeetingKind::shared : MeetingKind::crossing;
    }

    static std::size_t find(const Sides& sides, Sign s) {
        return std::size_t(std::find(sides.sign.begin(), sides.sign.end(), s) - sides.sign.begin());
    }

    /// Two triangles of doubles with no corner in the other's plane and some on both sides of it.
    ///
    /// Proof. Let p be the corner of a that is alone on its side of b's plane, u that of b, d = n_a x n_b the direction
    /// of the common line, and let lines pq and uv meet it at x and y. Then det(q - p, u - p, v - p) is a positive
    /// multiple of det(x - p, d, y - u) times the coordinate of y - x along d, and that determinant is
    /// ((x - p) . n_b) ((y - u) . n_a), the product of the sides of p and u. Within a, counter-clockwise p, q, r, the
    /// point on pq comes before the one on pr along d iff p is on the minus side of b; within b the other way round.
    std::optional<MeetingKind> apart(std::uint32_t a, std::uint32_t b) {
        const std::size_t i = lone(sides_a_);
        const std::size_t j = lone(sides_b_);
        const Sign p = sides_a_.sign[i];
        const Sign u = sides_b_.sign[j];
        const bool a_rises = p == Sign::minus;
        const bool b_rises = u == Sign::plus;
        const std::size_t a_low = (i + (a_rises ? 1 : 2)) % 3;
        const std::size_t a_high = (i + (a_rises ? 2 : 1)) % 3;
        const std::size_t b_low = (j + (b_rises ? 1 : 2)) % 3;
        const std::size_t b_high = (j + (b_rises ? 2 : 1)) % 3;
        const auto order = [&](std::size_t q, std::size_t v) {  // of the point on uv after that on pq
            return plane_side(at(a, i), at(a, q), at(b, j), at(b, v)) * p * u;
        };
        const Sign first = order(a_high, b_low);
        if (first == Sign::plus) return MeetingKind::none;
        const Sign second = order(a_low, b_high);
        if (second == Sign::minus) return MeetingKind::none;
        return first == Sign::zero || second == Sign::zero ? MeetingKind::touch : MeetingKind::crossing;
    }

    /// The corner whose side no other corner is on.
    static std::size_t lone(const Sides& sides) {
        const Sign few =
            sides.sign[0] == sides.sign[1] || sides.sign[0] == sides.sign[2] ? -sides.sign[0] : sides.sign[0];
        return find(sides, few);
    }

    [[nodiscard]] const std::array<double, 3>& at(std::uint32_t f, std::size_t i) const {
        return facets_->position(facets_->corner(f, i));
    }

    /// Convex polygons in a plane have common inner points unless an edge of one separates them; otherwise what they
    /// have in common is spanned by corners of one that lie on the other.
    FacetMeeting meet_in_plane(std::uint32_t a, std::uint32_t b) {
        if (!separates(a, b) && !separates(b, a)) return {MeetingKind::overlap};
        bool meet = false;
        bool shared = true;
        for (const auto& [f, g] : {std::pair(a, b), std::pair(b, a)}) {
            for (const Corner& c : facets_->corners(g)) {
                if (has_corner(f, c.point)) {
                    meet = true;
                } else if (contains(f, c.point)) {
                    meet = true;
                    shared = false;
                }
            }
        }
        if (!meet) return {MeetingKind::none};
        return {shared ? MeetingKind::shared : MeetingKind::touch};
    }

    bool separates(std::uint32_t f, std::uint32_t g) {
        for (std::size_t e = 0; e < facets_->corners(f).size(); ++e) {
            bool beyond = true;
            for (std::size_t i = 0; i < facets_->corners(g).size() && beyond; ++i)
                beyond = facets_->edge_side(f, e, facets_->corner(g, i)) != Sign::minus;
            if (beyond) return true;
        }
        return false;
    }

    bool contains(std::uint32_t f, PointId p) {
        for (std::size_t e = 0; e < facets_->corners(f).size(); ++e)
            if (facets_->edge_side(f, e, p) == Sign::plus) return false;
        return true;
    }

    /// Facets on different planes: what both cover of the planes' common line.
    FacetMeeting meet_on_line(std::uint32_t a, std::uint32_t b) {
        if (sides_a_.zeros == 0 && sides_a_.is_one_sided()) return {};
        if (sides_b_.zeros == 0 && sides_b_.is_one_sided()) return {};
        const PlaneId f = facets_->plane(a);
        const PlaneId g = facets_->plane(b);
        Kernel<3>& kernel = facets_->kernel();
        axis_ = edge_direction(kernel, f, g).axis;
        const Stretch x = stretch(a, g, sides_a_);
        const Stretch y = stretch(b, f, sides_b_);
        if (x.is_empty() || y.is_empty()) return {};
        const Stretch both{later(x.from, y.from), earlier(x.to, y.to)};
        const Sign order = kernel.compare(axis_, both.from, both.to);
        if (order == Sign::plus) return {};
        if (order == Sign::zero) return {common_ != 0 ? MeetingKind::shared : MeetingKind::touch};
        FacetMeeting out{MeetingKind::touch, both.from, both.to, !sides_a_.is_one_sided(), !sides_b_.is_one_sided()};
        const bool apart = (*facets_)[a].face != (*facets_)[b].face;  // one face's parts have inner edges in common
        const bool inside_a = out.through_first || (apart && on_inner_edge(a, sides_a_, both));
        const bool inside_b = out.through_second || (apart && on_inner_edge(b, sides_b_, both));
        if (inside_a && inside_b)
            out.kind = MeetingKind::crossing;
        else if (!inside_a && !inside_b && is_shared(a, b, sides_a_, both) && is_shared(b, a, sides_b_, both))
            out.kind = MeetingKind::shared;
        return out;
    }

    /// Where facet f meets plane h, which is not its own.
    Stretch stretch(std::uint32_t f, PlaneId h, const Sides& sides) {
        Stretch out;
        const auto add = [&](PointId p) {
            out.from = out.from == no_id ? p : earlier(out.from, p);
            out.to = out.to == no_id ? p : later(out.to, p);
        };
        for (std::size_t i = 0; i < sides.sign.size(); ++i) {
            const std::size_t j = facets_->next(f, i);
            if (sides.sign[i] == Sign::zero) add(facets_->corner(f, i));
            if (sides.sign[i] * sides.sign[j] != Sign::minus) continue;
            const PlaneId edge = facets_->edge(f, i);
            add(facets_->kernel().cross(h, facets_->corner(f, i), facets_->corner(f, j),
                                        {unoriented(facets_->plane(f)), unoriented(edge)}));
        }
        return out;
    }

    PointId earlier(PointId p, PointId q) { return facets_->kernel().compare(axis_, q, p) == Sign::minus ? q : p; }
    PointId later(PointId p, PointId q) { return facets_->kernel().compare(axis_, q, p) == Sign::plus ? q : p; }

    bool on_inner_edge(std::uint32_t f, const Sides& sides, const Stretch& both) {
        for (std::size_t i = 0; i < sides.sign.size(); ++i) {
            const std::size_t j = facets_->next(f, i);
            if (!facets_->is_inner(f, i) || sides.sign[i] != Sign::zero || sides.sign[j] != Sign::zero) continue;
            Stretch edge{earlier(facets_->corner(f, i), facets_->corner(f, j)),
                         later(facets_->corner(f, i), facets_->corner(f, j))};
            edge = {later(edge.from, both.from), earlier(edge.to, both.to)};
            if (facets_->kernel().compare(axis_, edge.from, edge.to) == Sign::minus) return true;
        }
        return false;
    }

    /// Whether the ends of the stretch are corners of both, and so is every corner of f on it.
    bool is_shared(std::uint32_t f, std::uint32_t g, const Sides& sides, const Stretch& both) {
        if (!has_corner(f, both.from) || !has_corner(f, both.to)) return false;
        for (std::size_t i = 0; i < sides.sign.size(); ++i) {
            const PointId p = facets_->corner(f, i);
            if (sides.sign[i] == Sign::zero && facets_->kernel().compare(axis_, p, both.from) != Sign::minus &&
                facets_->kernel().compare(axis_, p, both.to) != Sign::plus && !has_corner(g, p))
                return false;
        }
        return true;
    }

    ConvexFacets* facets_;
    Sides sides_a_, sides_b_;  // of the first facet's corners for the second's plane, and vice versa
    std::size_t common_ = 0;   // corners
    int axis_ = 0;             // along which points on the common line are ordered
};

CLEAVE_END_NAMESPACE

#endif

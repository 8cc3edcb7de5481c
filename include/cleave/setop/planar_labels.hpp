// SPDX-License-Identifier: Apache-2.0
/// Segments in the plane, cut where other operands touch them, with what is on either side of the pieces.
///
/// At a contact the other operand's segments are rays from one point. Going round it from a piece, the first ray tells
/// what the piece is in: the ray has the operand on its left. A ray along the piece tells both sides by its direction.
/// So crossings, touching vertices, common stretches and vertices where many segments meet are one rule, and all pieces
/// of a segment that an operand touches are told about it; what it does not touch is told over the vertices.
#ifndef CLEAVE_SETOP_PLANAR_LABELS_HPP
#define CLEAVE_SETOP_PLANAR_LABELS_HPP

#include <cleave/setop/label_forest.hpp>
#include <cleave/setop/planar_contacts.hpp>
#include <cleave/setop/planar_location.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A piece of a segment that others touch. It starts where the one before it ends, the first where the segment starts.
struct PlanarPiece {
    PointId end = no_id;
    PlaneId end_line = no_id;                      ///< another line through the end; `no_id` for the segment's own end
    BooleanFunction::Bits above = 0, below = 0;    ///< the operands just above and just below, the own one left out
    BooleanFunction::Bits same = 0, opposite = 0;  ///< the operands with a coincident piece, by its direction
};

/// Cuts and labels segments. Labels of segments that nothing touches are found when they are asked for.
class PlanarLabels {
public:
    using Bits = BooleanFunction::Bits;

    explicit PlanarLabels(PlanarContacts& contacts)
        : contacts_(&contacts), forest_(contacts.own_point_count()), locators_(contacts.operand_count()) {
        all_ = contacts.operand_count() == 64 ? ~Bits(0) : (Bits(1) << contacts.operand_count()) - 1;
        for (std::uint32_t i = 0; i < contacts.operand_count(); ++i)
            far_ |= Bits(contacts.boundary(i).value_at_infinity ? 1 : 0) << i;
        const std::vector<PlanarSegment>& segments = contacts.segments();
        const std::vector<PlanarContact>& list = contacts.contacts();
        std::size_t n = 0;
        for (std::uint32_t s = 0; s < segments.size(); ++s) {
            const std::size_t first = n;
            while (n < list.size() && list[n].segment == s) ++n;
            if (n > first)
                cut(s, {list.data() + first, n - first});
            else if (needs_labels(segments[s].operand))
                forest_.join(segments[s].from, segments[s].to, 0);
        }
        cuts_.push_back({no_id, static_cast<std::uint32_t>(pieces_.size())});
        complete();
    }

    /// A segment that others touch.
    struct Cut {
        std::uint32_t segment;
        std::uint32_t first_piece;
    };

    /// All of them, by number, and one more whose first piece is past the last.
    [[nodiscard]] const std::vector<Cut>& cuts() const noexcept { return cuts_; }
    /// The pieces of cut n.
    [[nodiscard]] std::span<const PlanarPiece> pieces(std::size_t n) const {
        return {pieces_.data() + cuts_[n].first_piece, cuts_[n + 1].first_piece - cuts_[n].first_piece};
    }

    /// The other operands that contain a point of operand i; bits of those on whose boundary it lies are 0.
    [[nodiscard]] Bits at(std::uint32_t i, PointId p) {
        const Bits apart = contacts_->apart(i);
        const Bits others = all_ & ~(Bits(1) << i);
        if (apart == others) return far_ & apart;
        Bits missing = others & ~apart & ~forest_.known(p);
        for (std::uint32_t j = 0; missing != 0; ++j, missing >>= 1U)
            if ((missing & 1U) != 0) forest_.learn(p, Bits(1) << j, locate(j, p) ? Bits(1) << j : 0);
        return (forest_.label(p) & others & ~apart) | (far_ & apart);
    }

    /// The operands that contain what is far away.
    [[nodiscard]] Bits far() const noexcept { return far_; }
    /// Whether no two contacts contradict each other. They do where an operand intersects itself.
    [[nodiscard]] bool is_consistent() const noexcept { return forest_.is_consistent(); }
    /// Points that a ray was cast for.
    [[nodiscard]] std::size_t located() const noexcept { return located_; }

private:
    /// A contact, and the number of the cut that its point is: 0 for the segment's start.
    struct Ranked {
        const PlanarContact* contact;
        std::uint32_t operand;
        std::uint32_t rank;
    };

    /// What an operand has along a piece: whether it contains both sides, or a coincident piece.
    struct Beside {
        bool inside = false;
        bool opposite = false;
        std::uint32_t coincides = no_id;  // the segment with that piece
    };

    /// Pieces of a segment that not all operands touch.
    struct Open {
        std::uint32_t segment;
        std::uint32_t first, past;
        Bits told;  // by those that do
    };

    [[nodiscard]] bool needs_labels(std::uint32_t i) const { return contacts_->apart(i) != (all_ & ~(Bits(1) << i)); }

    /// Whether operand j contains p, which is not on its boundary.
    bool locate(std::uint32_t j, PointId p) {
        const Bounds<2>& bounds = contacts_->boundary(j).bounds;
        const PointRecord<2>& r = contacts_->kernel().point(p);
        for (std::size_t x = 0; x < 2; ++x)
            if (r.error == 0 && (r.approximation[x] < bounds.lo[x] || r.approximation[x] > bounds.hi[x]))
                return contacts_->boundary(j).value_at_infinity;
        if (!locators_[j]) locators_[j].emplace(*contacts_, j);
        ++located_;
        return locators_[j]->contains(p);
    }

    /// Cuts a segment at its contacts and labels the pieces.
    void cut(std::uint32_t segment, std::span<const PlanarContact> contacts) {
        const PlanarSegment& s = contacts_->segments()[segment];
        rank(s, contacts);
        const auto first = static_cast<std::uint32_t>(pieces_.size());
        const auto count = static_cast<std::uint32_t>(ends_.size());
        cuts_.push_back({segment, first});
        pieces_.resize(first + count);
        for (std::uint32_t n = 0; n < count; ++n) pieces_[first + n].end = ends_[n];
        const std::span<PlanarPiece> pieces(pieces_.data() + first, count);
        Bits told = 0;
        Bits from = 0;
        Bits to = 0;
        for (std::size_t n = 0; n < ranked_.size();) {
            const std::uint32_t j = ranked_[n].operand;
            std::size_t end = n;
            while (end < ranked_.size() && ranked_[end].operand == j) ++end;
            const std::span<const Ranked> of_one(ranked_.data() + n, end - n);
            tell(s, of_one, pieces);
            const Bits bit = Bits(1) << j;
            told |= bit;
            // Points on the other boundary count as outside: any rule will do, as long as all segments follow it.
            if (of_one.front().rank != 0) from |= pieces.front().above & bit;
            if (of_one.back().rank != count) to |= pieces.back().above & bit;
            n = end;
        }
        for (const Ranked& r : ranked_) {
            if (r.rank == 0 || r.rank == count) continue;
            PlaneId& line = pieces[r.rank - 1].end_line;
            line = std::min(line, line_across(s, *r.contact));
        }
        forest_.learn(s.from, told, from);
        forest_.learn(s.to, told, to);
        forest_.join(s.from, s.to, from ^ to);
        if ((all_ & ~told & ~(Bits(1) << s.operand)) == 0) return;
        open_.push_back({segment, first, first + count, told});
    }

    /// Fills in what the operands that do not touch a segment contain, when all is joined.
    void complete() {
        for (const Open& o : open_) {
            const PlanarSegment& s = contacts_->segments()[o.segment];
            const Bits rest = at(s.operand, s.from) & ~o.told;
            for (std::uint32_t n = o.first; n < o.past; ++n) {
                pieces_[n].above |= rest;
                pieces_[n].below |= rest;
            }
        }
        open_ = {};
    }

    /// Finds the pieces' ends, `ends_`, and the contacts by operand and place, `ranked_`.
    void rank(const PlanarSegment& s, std::span<const PlanarContact> contacts) {
        Kernel<2>& kernel = contacts_->kernel();
        const PointId from = contacts_->place(s.from);
        const PointId to = contacts_->place(s.to);
        ends_.clear();
        for (const PlanarContact& c : contacts)
            if (c.point != from && c.point != to) ends_.push_back(c.point);
        if (ends_.size() > 1) {
            std::sort(ends_.begin(), ends_.end());
            ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
            const AxisDirection d = edge_direction(kernel, s.line, no_id);
            std::sort(ends_.begin(), ends_.end(),
                      [&](PointId p, PointId q) { return p != q && kernel.compare(d.axis, q, p) == d.sign; });
        }
        ends_.push_back(to);
        if (rank_.size() < kernel.point_count()) rank_.resize(kernel.point_count(), 0);
        for (std::uint32_t n = 0; n < ends_.size(); ++n) rank_[ends_[n]] = n + 1;
        rank_[from] = 0;
        ranked_.clear();
        for (const PlanarContact& c : contacts)
            ranked_.push_back({&c, contacts_->segments()[c.other].operand, rank_[c.point]});
        std::sort(ranked_.begin(), ranked_.end(), [](const Ranked& a, const Ranked& b) {
            return a.operand != b.operand ? a.operand < b.operand
                                          : std::pair(a.rank, a.contact) < std::pair(b.rank, b.contact);
        });
    }

    /// Labels pieces with respect to one operand, whose contacts are given along the segment.
    void tell(const PlanarSegment& s, std::span<const Ranked> contacts, std::span<PlanarPiece> pieces) {
        const Bits bit = Bits(1) << contacts.front().operand;
        const auto set = [&](std::uint32_t begin, std::uint32_t end, const Beside& b) {
            const bool coincides = b.coincides != no_id;
            for (std::uint32_t n = begin; n < end; ++n) {
                PlanarPiece& p = pieces[n];
                if (coincides) (b.opposite ? p.opposite : p.same) |= bit;
                if (coincides ? b.opposite : b.inside) p.above |= bit;
                if (coincides ? !b.opposite : b.inside) p.below |= bit;
            }
        };
        for (std::size_t n = 0; n < contacts.size();) {
            const std::uint32_t rank = contacts[n].rank;
            std::size_t end = n;
            while (end < contacts.size() && contacts[end].rank == rank) ++end;
            const std::span<const Ranked> here = contacts.subspan(n, end - n);
            if (n == 0 && rank != 0) set(0, rank, beside(s, here, false));
            const auto count = static_cast<std::uint32_t>(pieces.size());
            if (rank < count) {
                const Beside b = beside(s, here, true);
                // A common stretch has contacts with its segment at its ends alone. Where the other operand touches
                // itself, others of its segments have contacts on the way, which tell nothing.
                if (b.coincides != no_id) {
                    const auto stop = std::find_if(contacts.begin() + std::ptrdiff_t(end), contacts.end(),
                                                   [&](const Ranked& r) { return r.contact->other == b.coincides; });
                    if (stop != contacts.end())
                        while (contacts[end].rank != stop->rank) ++end;
                }
                set(rank, end < contacts.size() ? contacts[end].rank : count, b);
            }
            n = end;
        }
    }

    /// A way from the point of a contact along the other segment.
    struct Ray {
        PlaneId line = no_id;
        PointId far = no_id;
        bool along = true;      // whether it runs like its segment
        std::uint8_t part = 3;  // anticlockwise from the piece: 0: less than a half turn, 1: a half turn, 2: more
    };

    /// What one operand has along the piece that leaves a point forward or backward along s. `here`: all its contacts
    /// in that point.
    Beside beside(const PlanarSegment& s, std::span<const Ranked> here, bool forward) {
        Ray first;
        Beside found;
        const auto visit = [&](std::uint32_t name, const PlanarSegment& t, PointId far, bool along) {
            Ray r{t.line, far, along, 1};
            if (unoriented(t.line) == unoriented(s.line)) {
                if ((along == (t.line == s.line)) == forward) {
                    found.coincides = name;
                    found.opposite = t.line != s.line;
                    return;
                }
            } else {
                const bool left = contacts_->kernel().side(s.line, far) == Sign::minus;
                r.part = left == forward ? 0 : 2;
            }
            if (r.part < first.part || (r.part == first.part && r.part != 1 && is_before(r, first))) first = r;
        };
        for (const Ranked& x : here) {
            const PlanarSegment& t = contacts_->segments()[x.contact->other];
            if (!x.contact->ends) visit(x.contact->other, t, t.to, true);
            if (!x.contact->starts) visit(x.contact->other, t, t.from, false);
        }
        // The set is on the left of the segment, so a ray against its segment has it on the clockwise side.
        found.inside = !first.along;
        return found;
    }

    /// Whether ray a comes before b anticlockwise. Requires: they are less than a half turn apart.
    bool is_before(const Ray& a, const Ray& b) {
        return contacts_->kernel().side(a.line, b.far) == (a.along ? Sign::minus : Sign::plus);
    }

    /// A line other than the segment's through a contact inside it, unflipped.
    [[nodiscard]] PlaneId line_across(const PlanarSegment& s, const PlanarContact& c) const {
        const PlanarSegment& t = contacts_->segments()[c.other];
        if (unoriented(t.line) != unoriented(s.line)) return t.line & ~1U;
        return contacts_->corner(c.other, c.starts ? 0 : 1).edge & ~1U;
    }

    PlanarContacts* contacts_;
    LabelForest forest_;
    std::vector<std::optional<PlanarLocation>> locators_;
    std::vector<Cut> cuts_;
    std::vector<PlanarPiece> pieces_;
    std::vector<Open> open_;
    std::vector<PointId> ends_;
    std::vector<Ranked> ranked_;
    std::vector<std::uint32_t> rank_;  // of a point on the segment that is cut
    Bits all_ = 0;
    Bits far_ = 0;
    std::size_t located_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

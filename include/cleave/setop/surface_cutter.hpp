// SPDX-License-Identifier: Apache-2.0
/// Cuts a face that other operands touch: its edges and the common segments become pieces between the common points,
/// with what is on either side of them.
#ifndef CLEAVE_SETOP_SURFACE_CUTTER_HPP
#define CLEAVE_SETOP_SURFACE_CUTTER_HPP

#include <cleave/setop/contact_sides.hpp>
#include <cleave/setop/coplanar_cover.hpp>
#include <cleave/setop/touched_vertices.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// For each operand a bit: whether it contains what is just above and just below some part of a face.
struct SideBits {
    std::uint64_t above = 0;
    std::uint64_t below = 0;

    friend bool operator==(const SideBits&, const SideBits&) = default;
};

/// A part of a face's edge (the face on its left) or a common segment inside it (the face on both sides).
struct FacePiece {
    using Bits = std::uint64_t;

    PointId from = no_id;  ///< of the kernel; `no_id` for a vertex that no one asked the kernel for
    PointId to = no_id;
    std::uint32_t n = no_id;    ///< the edge in the face's outline; `no_id` for a common segment
    std::uint32_t cut = no_id;  ///< a record of the face that is not coplanar and contains the piece, if any
    bool along = true;          ///< whether that record runs like the piece
    Bits known = 0;             ///< the operands of which both sides are known
    SideBits left, right;       ///< `right` only of common segments

    void set(std::uint32_t j, TwoSided l, TwoSided r) {
        const Bits bit = Bits(1) << j;
        known |= bit;
        left.above |= l.above ? bit : 0;
        left.below |= l.below ? bit : 0;
        right.above |= r.above ? bit : 0;
        right.below |= r.below ? bit : 0;
    }

    /// The operands in `which`, no edge or cut of which is at the piece, are on both of its sides as `value` says.
    void learn(Bits which, const SideBits& value) {
        which &= ~known;
        known |= which;
        for (SideBits* s : {&left, &right}) {
            s->above |= value.above & which;
            s->below |= value.below & which;
        }
    }
};

/// One face at a time.
class SurfaceCutter {
public:
    using Bits = FacePiece::Bits;

    SurfaceCutter(SurfaceOperands& operands, const TouchedVertices& touched)
        : operands_(&operands), touched_(&touched), sides_(operands), cover_(operands) {}

    /// Appends the pieces of face f of operand i to `pieces`: those of the edges in the outline's order, each edge's
    /// in the order along it, then the segments inside. `known`, `value`: what holds for the whole operand. Labels are
    /// what contacts tell, and what follows from it across points that an operand does not touch.
    void cut(const FaceOutline& outline, const FaceRecords& records, Bits known, Bits value,
             std::vector<FacePiece>& pieces) {
        begin(outline, records);
        const std::size_t first = pieces.size();
        plain_.known = known;
        plain_.left = plain_.right = {value, value};
        for (std::uint32_t n = 0; n < outline.entries.size(); ++n) cut_edge(n, pieces);
        cut_inside(pieces);
        spread({pieces.data() + first, pieces.size() - first});
    }

    /// Spreads what is known across points through which the operand in question does not cut the face. Requires:
    /// `pieces` are those that `cut` made of the face.
    void spread(const FaceOutline& outline, const FaceRecords& records, std::span<FacePiece> pieces) {
        begin(outline, records);
        spread(pieces);
    }

private:
    void begin(const FaceOutline& outline, const FaceRecords& records) {
        outline_ = &outline;
        records_ = records;
        by_point_.clear();
        edge_points_.clear();
        edge_segments_.clear();
        for (const PointContact& c : records.points) {
            by_point_.push_back(&c);
            if (c.of_face.kind == Feature::Kind::edge) edge_points_.push_back({c.of_face.corner, c.point});
        }
        const auto is_before = [](const PointContact* a, const PointContact* b) {
            if (a->point != b->point) return a->point < b->point;
            return std::pair(a->operand, a) < std::pair(b->operand, b);
        };
        std::sort(by_point_.begin(), by_point_.end(), is_before);
        std::sort(edge_points_.begin(), edge_points_.end());
        edge_points_.erase(std::unique(edge_points_.begin(), edge_points_.end()), edge_points_.end());
        for (std::uint32_t s = 0; s < records.segments.size(); ++s)
            if (records.segments[s].corner != no_id) edge_segments_.push_back({records.segments[s].corner, s});
        std::sort(edge_segments_.begin(), edge_segments_.end());
    }

    // --- contacts at a point -----------------------------------------------------------------------------------------

    [[nodiscard]] std::span<const PointContact* const> at(PointId x) const {
        const auto first = std::lower_bound(by_point_.begin(), by_point_.end(), x,
                                            [](const PointContact* c, PointId p) { return c->point < p; });
        auto last = first;
        while (last != by_point_.end() && (*last)->point == x) ++last;
        return {by_point_.data() + (first - by_point_.begin()), std::size_t(last - first)};
    }

    /// The operands that contacts at a point are with.
    static Bits operands_of(std::span<const PointContact* const> contacts) {
        Bits all = 0;
        for (const PointContact* c : contacts) all |= Bits(1) << c->operand;
        return all;
    }

    /// Learns from the contacts at one end of a piece about operands that are not known yet. A piece inside the face
    /// may run through a coplanar face of another operand: what has it in its plane tells nothing then, nor does a
    /// ridge that stands on such a face.
    template <class SideAhead>
    void learn_from(PointId x, FacePiece& piece, SideAhead&& side_ahead) {
        std::span<const PointContact* const> contacts = at(x);
        while (!contacts.empty()) {
            const std::uint32_t j = contacts.front()->operand;
            std::size_t n = 0;
            while (n < contacts.size() && contacts[n]->operand == j) ++n;
            if ((piece.known >> j & 1U) == 0) {
                bool in_plane = false;
                const std::optional<bool> inside = sides_.beside(j, contacts.first(n), [&](std::uint32_t g) {
                    const Sign s = side_ahead(j, g);
                    in_plane = in_plane || s == Sign::zero;
                    return s;
                });
                if (inside && (piece.n != no_id || (!in_plane && !is_in_coplanar(j, x))))
                    piece.set(j, {*inside, *inside}, {*inside, *inside});
            }
            contacts = contacts.subspan(n);
        }
    }

    /// Whether a coplanar face of operand j contains the end of a piece. Such a face has no contact there unless it is
    /// the end of something of either face. Requires: the point is on none of that face's edges.
    bool is_in_coplanar(std::uint32_t j, PointId x) {
        std::uint32_t last = no_id;
        for (const SegmentRecord& r : records_.segments) {
            if (r.operand != j || r.up_down != 0 || r.other == last) continue;
            last = r.other;
            if (cover_(j, r.other, x)) return true;
        }
        return false;
    }

    // --- edges -------------------------------------------------------------------------------------------------------

    void cut_edge(std::uint32_t n, std::vector<FacePiece>& pieces) {
        const std::uint32_t i = outline_->operand;
        const FaceOutline::Entry& from = outline_->entries[n];
        const FaceOutline::Entry& to = outline_->entries[from.next];
        points_.clear();
        for (auto p = std::lower_bound(edge_points_.begin(), edge_points_.end(), std::pair(from.corner, 0U));
             p != edge_points_.end() && p->first == from.corner; ++p)
            points_.push_back(p->second);
        if (points_.size() > 1) sort_along(i, from.point, to.point);
        const bool from_on = touched_->by(operands_->vertex(i, from.point)) != 0;
        const bool to_on = touched_->by(operands_->vertex(i, to.point)) != 0;
        PointId a = from_on ? operands_->point(i, from.point) : operands_->known_point(i, from.point);
        points_.push_back(to_on ? operands_->point(i, to.point) : operands_->known_point(i, to.point));
        for (std::size_t k = 0; k < points_.size(); ++k) {
            FacePiece piece = plain_;
            piece.from = a;
            piece.to = points_[k];
            piece.n = n;
            label_on_boundary(from.corner, k, piece);
            const auto side_of_vertex = [&](PointId v) {
                return [&, v](std::uint32_t j, std::uint32_t g) { return operands_->side(j, g, i, v); };
            };
            if (k > 0 || from_on) learn_from(piece.from, piece, side_of_vertex(to.point));
            if (k + 1 < points_.size() || to_on) learn_from(piece.to, piece, side_of_vertex(from.point));
            pieces.push_back(piece);
            a = points_[k];
        }
    }

    void sort_along(std::uint32_t i, PointId p, PointId q) {
        Kernel<3>& kernel = operands_->kernel();
        const auto& x = operands_->position(i, p);
        const auto& y = operands_->position(i, q);
        AxisDirection d;
        if (operands_->is_of_doubles(i, p) && operands_->is_of_doubles(i, q)) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto size = [&](int other) { return std::abs(y[std::size_t(other)] - x[std::size_t(other)]); };
                if (d.axis < 0 || size(axis) > size(d.axis)) d.axis = axis;
            }
            d.sign = y[std::size_t(d.axis)] > x[std::size_t(d.axis)] ? Sign::plus : Sign::minus;
        } else {
            d = direction_between(kernel, operands_->point(i, p), operands_->point(i, q));
        }
        std::sort(points_.begin(), points_.end(),
                  [&](PointId s, PointId t) { return s != t && kernel.compare(d.axis, t, s) == d.sign; });
    }

    /// Where other operands' faces contain the piece that ends at the edge's point k, they tell what is on its left.
    void label_on_boundary(std::uint32_t corner, std::size_t k, FacePiece& piece) {
        found_.clear();
        for (auto s = std::lower_bound(edge_segments_.begin(), edge_segments_.end(), std::pair(corner, 0U));
             s != edge_segments_.end() && s->first == corner; ++s) {
            const SegmentRecord& r = records_.segments[s->second];
            // The segment's ends are among the edge's points; it contains the piece between k - 1 and k.
            const std::ptrdiff_t a = rank(piece.n, r.from);
            const std::ptrdiff_t b = rank(piece.n, r.to);
            if (std::min(a, b) < std::ptrdiff_t(k) && std::ptrdiff_t(k) <= std::max(a, b))
                found_.push_back({&r, s->second, a < b});
        }
        label_found(piece);
    }

    /// The number of a point on the edge: -1 for its start, the last for its end.
    std::ptrdiff_t rank(std::uint32_t n, PointId p) const {
        if (p == operands_->known_point(outline_->operand, outline_->entries[n].point)) return -1;
        return std::find(points_.begin(), points_.end(), p) - points_.begin();
    }

    /// Labels a piece by the records that contain it, `found_`.
    void label_found(FacePiece& piece) {
        if (found_.empty()) return;
        std::sort(found_.begin(), found_.end(), [](const RecordAtPiece& a, const RecordAtPiece& b) {
            return std::pair(a.record->operand, a.index) < std::pair(b.record->operand, b.index);
        });
        for (const RecordAtPiece& x : found_) {
            if (piece.cut != no_id || x.record->up_down == 0) continue;
            piece.cut = x.index;
            piece.along = x.along;
        }
        std::span<const RecordAtPiece> rest = found_;
        while (!rest.empty()) {
            const std::uint32_t j = rest.front().record->operand;
            std::size_t n = 0;
            while (n < rest.size() && rest[n].record->operand == j) ++n;
            if (const std::optional<TwoSided> on = on_coplanar(piece, rest.first(n))) {
                piece.set(j, *on, *on);
            } else {
                const ContactSides::BothSides both =
                    sides_.of_segment(outline_->operand, outline_->face, rest.first(n));
                piece.set(j, both.left, both.right);
            }
            rest = rest.subspan(n);
        }
    }

    /// What a coplanar face of the records' operand tells that has the piece inside and not on an edge: the operand
    /// touches itself there, with the faces of the records. Nothing where there is none.
    std::optional<TwoSided> on_coplanar(const FacePiece& piece, std::span<const RecordAtPiece> found) {
        if (piece.n != no_id) return std::nullopt;  // the face's edge would have a record of it
        for (const RecordAtPiece& x : found)
            if (x.record->up_down == 0) return std::nullopt;
        PointId middle = no_id;
        for (const SegmentRecord& r : records_.segments) {
            if (r.operand != found.front().record->operand || r.up_down != 0) continue;
            if (middle == no_id) middle = add_midpoint(operands_->kernel(), piece.from, piece.to);
            if (cover_(r.operand, r.other, middle)) return TwoSided{r.opposite, !r.opposite};
        }
        return std::nullopt;
    }

    // --- common segments inside the face -----------------------------------------------------------------------------

    void cut_inside(std::vector<FacePiece>& pieces) {
        order_.clear();
        const auto ends = [&](std::uint32_t s) {
            const SegmentRecord& r = records_.segments[s];
            return std::minmax(r.from, r.to);
        };
        for (std::uint32_t s = 0; s < records_.segments.size(); ++s)
            if (records_.segments[s].corner == no_id) order_.push_back(s);
        if (order_.size() > 1)
            std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
                const std::pair<PointId, PointId> x = ends(a);
                const std::pair<PointId, PointId> y = ends(b);
                return x != y ? x < y : a < b;
            });
        const bool several = operands_->count() > 2;
        Kernel<3>& kernel = operands_->kernel();
        for (std::size_t n = 0; n < order_.size();) {
            const std::pair<PointId, PointId> both = ends(order_[n]);
            found_.clear();
            FacePiece piece = plain_;
            piece.from = records_.segments[order_[n]].from;
            piece.to = records_.segments[order_[n]].to;
            for (; n < order_.size() && std::pair<PointId, PointId>(ends(order_[n])) == both; ++n) {
                const SegmentRecord& r = records_.segments[order_[n]];
                found_.push_back({&r, order_[n], r.from == piece.from});
            }
            label_found(piece);
            if (several) {
                const auto side_of_point = [&](PointId p) {
                    return [&, p](std::uint32_t j, std::uint32_t g) { return kernel.side(operands_->plane(j, g), p); };
                };
                learn_from(piece.from, piece, side_of_point(piece.to));
                learn_from(piece.to, piece, side_of_point(piece.from));
            }
            pieces.push_back(piece);
        }
    }

    // --- what follows from it ----------------------------------------------------------------------------------------

    /// An end of a piece: a place is a point of the kernel, or a vertex that nothing touches.
    struct End {
        std::uint64_t place;
        std::uint32_t piece;
    };

    /// Pieces that meet in a point through which none of an operand's cuts of the face goes have the same label: they
    /// are in that operand all or none, or all on one face of it.
    void spread(std::span<FacePiece> pieces) {
        if (operands_->count() <= 2) return;
        collect_ends(pieces);
        std::vector<std::size_t> work;
        for (std::size_t n = 0; n < starts_.size() - 1; ++n) work.push_back(starts_.size() - 2 - n);
        std::vector<bool> waits(work.size(), true);
        while (!work.empty()) {
            const std::size_t at = work.back();
            work.pop_back();
            waits[at] = false;
            Bits known = 0;
            SideBits value;
            const std::span<const End> here(ends_.data() + starts_[at], starts_[at + 1] - starts_[at]);
            for (const End& e : here) {
                const FacePiece& p = pieces[e.piece];
                value.above |= p.left.above & p.known & ~known;
                value.below |= p.left.below & p.known & ~known;
                known |= p.known;
            }
            known &= ~on_[at];
            for (const End& e : here) {
                FacePiece& p = pieces[e.piece];
                if ((known & ~p.known) == 0) continue;
                p.learn(known, value);
                for (const std::size_t other : places_[e.piece]) {
                    if (waits[other]) continue;
                    waits[other] = true;
                    work.push_back(other);
                }
            }
        }
    }

    void collect_ends(std::span<const FacePiece> pieces) {
        ends_.clear();
        starts_.clear();
        on_.clear();
        places_.assign(pieces.size(), {0, 0});
        for (std::uint32_t k = 0; k < pieces.size(); ++k) {
            const FacePiece& p = pieces[k];
            ends_.push_back({place(p, p.from, true), k});
            ends_.push_back({place(p, p.to, false), k});
        }
        std::sort(ends_.begin(), ends_.end(),
                  [](const End& a, const End& b) { return std::pair(a.place, a.piece) < std::pair(b.place, b.piece); });
        std::vector<bool> has_one(pieces.size(), false);
        for (std::size_t n = 0; n < ends_.size(); ++n) {
            if (n == 0 || ends_[n].place != ends_[n - 1].place) {
                starts_.push_back(n);
                on_.push_back(
                    (ends_[n].place & vertex_place) != 0 ? 0 : operands_of(at(static_cast<PointId>(ends_[n].place))));
            }
            places_[ends_[n].piece][has_one[ends_[n].piece] ? 1 : 0] = starts_.size() - 1;
            has_one[ends_[n].piece] = true;
        }
        starts_.push_back(ends_.size());
    }

    [[nodiscard]] std::uint64_t place(const FacePiece& piece, PointId p, bool is_start) const {
        if (piece.n == no_id) return p;
        const FaceOutline::Entry& from = outline_->entries[piece.n];
        const PointId v = is_start ? from.point : outline_->entries[from.next].point;
        const bool is_vertex = p == no_id || p == operands_->known_point(outline_->operand, v);
        if (!is_vertex || touched_->by(operands_->vertex(outline_->operand, v)) != 0) return p;
        return vertex_place | v;
    }

    static constexpr std::uint64_t vertex_place = std::uint64_t(1) << 32U;

    SurfaceOperands* operands_;
    const TouchedVertices* touched_;
    ContactSides sides_;
    CoplanarCover cover_;
    const FaceOutline* outline_ = nullptr;
    FaceRecords records_;
    FacePiece plain_;
    std::vector<const PointContact*> by_point_;
    std::vector<std::pair<std::uint32_t, PointId>> edge_points_;          // by the edge's corner
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edge_segments_;  // the same; indices of records
    std::vector<PointId> points_;                                         // of one edge, in order, its end the last
    std::vector<RecordAtPiece> found_;
    std::vector<std::uint32_t> order_;
    std::vector<End> ends_;
    std::vector<std::size_t> starts_;
    std::vector<Bits> on_;  // the operands at each place
    std::vector<std::array<std::size_t, 2>> places_;
};

CLEAVE_END_NAMESPACE

#endif

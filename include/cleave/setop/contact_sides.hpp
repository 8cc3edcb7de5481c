// SPDX-License-Identifier: Apache-2.0
/// What the faces of another operand that meet a face in a point or a segment tell about the sides of it.
#ifndef CLEAVE_SETOP_CONTACT_SIDES_HPP
#define CLEAVE_SETOP_CONTACT_SIDES_HPP

#include <cleave/setop/contact_records.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Whether the other operand contains what is just above and just below some part of a face.
struct TwoSided {
    bool above = false;
    bool below = false;

    friend bool operator==(const TwoSided&, const TwoSided&) = default;
};

/// A record of a segment that contains some piece.
struct RecordAtPiece {
    const SegmentRecord* record;
    std::uint32_t index;  ///< among the face's records
    bool along;           ///< whether it runs like the piece
};

/// Decides sides from contacts alone.
class ContactSides {
public:
    explicit ContactSides(SurfaceOperands& operands) : operands_(&operands) {}

    struct BothSides {
        TwoSided left, right;
    };

    /// What is beside a segment of face f of operand i, from all faces of one other operand at it. Going round the
    /// segment, what is next to a face is inside on its minus side: the first face from the left above the plane tells
    /// what is just above the left side, and so on. A coplanar face on the left tells both.
    [[nodiscard]] BothSides of_segment(std::uint32_t i, std::uint32_t f, std::span<const RecordAtPiece> found) {
        const RecordAtPiece* first[2] = {nullptr, nullptr};  // from the left; beneath, above
        const RecordAtPiece* last[2] = {nullptr, nullptr};
        const RecordAtPiece* coplanar[2] = {nullptr, nullptr};  // on the left, on the right
        for (const RecordAtPiece& x : found) {
            if (x.record->up_down == 0) {
                const std::uint8_t sides = x.record->left_right;
                if ((sides & 1U) != 0) coplanar[x.along ? 0 : 1] = &x;
                if ((sides & 2U) != 0) coplanar[x.along ? 1 : 0] = &x;
                continue;
            }
            for (const unsigned level : {0U, 1U}) {
                if ((x.record->up_down & (1U << level)) == 0) continue;
                if (first[level] == nullptr || is_before(i, f, x, *first[level], level)) first[level] = &x;
                if (last[level] == nullptr || is_before(i, f, *last[level], x, level)) last[level] = &x;
            }
        }
        return {side_of(true, first, coplanar), side_of(false, last, coplanar)};
    }

    /// Whether operand j contains the stretch of an edge or segment that leaves a point, as far as a face or a plain
    /// ridge at the point tells. `contacts`: all contacts with j there. `side_ahead(g)`: the side of face g's plane on
    /// which the stretch's other end lies. Requires: no face of j contains the stretch.
    template <class SideAhead>
    [[nodiscard]] std::optional<bool> beside(std::uint32_t j, std::span<const PointContact* const> contacts,
                                             SideAhead&& side_ahead) {
        const PointContact* first = nullptr;
        const PointContact* second = nullptr;  // the other face at a ridge
        for (const PointContact* c : contacts) {
            if (c->of_other.kind == Feature::Kind::vertex) return std::nullopt;
            if (first == nullptr) {
                first = c;
            } else if (c->other == first->other) {
                continue;
            } else if (c->of_other.kind == Feature::Kind::interior || first->of_other.kind == Feature::Kind::interior ||
                       !is_same_edge(j, *c, *first)) {
                return std::nullopt;  // where the other boundary touches itself, one face does not tell all
            } else if (second == nullptr || c->other == second->other) {
                second = c;
            } else {
                return std::nullopt;
            }
        }
        if (first == nullptr) return std::nullopt;
        if (first->of_other.kind == Feature::Kind::interior) {
            const Sign s = side_ahead(first->other);
            if (s == Sign::zero) return std::nullopt;
            return s == Sign::minus;
        }
        if (second == nullptr) return std::nullopt;
        return beside_ridge(j, *first, *second, side_ahead);
    }

private:
    bool is_same_edge(std::uint32_t j, const PointContact& a, const PointContact& b) const {
        return edge_ends(j, a.of_other.corner, a.other) == edge_ends(j, b.of_other.corner, b.other);
    }

    std::pair<PointId, PointId> edge_ends(std::uint32_t j, std::uint32_t corner, std::uint32_t face) const {
        const FaceList& list = operands_->boundary(j).faces;
        std::uint32_t l = list.faces[face].first_loop;
        while (list.loop_first[l + 1] <= corner) ++l;
        const std::uint32_t next = corner + 1 == list.loop_first[l + 1] ? list.loop_first[l] : corner + 1;
        return std::minmax({list.corners[corner].point, list.corners[next].point});
    }

    template <class SideAhead>
    std::optional<bool> beside_ridge(std::uint32_t j, const PointContact& a, const PointContact& b,
                                     SideAhead&& side_ahead) {
        const FaceList& list = operands_->boundary(j).faces;
        const FaceList::Face& face = list.faces[b.other];
        if (face.loop_count != 1 || list.loop(face.first_loop).size() != 3) return std::nullopt;
        const std::uint32_t first = list.loop_first[face.first_loop];
        const PointId opposite = list.corners[first + (b.of_other.corner - first + 2) % 3].point;
        const Sign bend = operands_->side(j, a.other, j, opposite);
        const Sign s = side_ahead(a.other);
        const Sign t = side_ahead(b.other);
        if (bend == Sign::zero) {
            if (s == Sign::zero) return std::nullopt;
            return s == Sign::minus;
        }
        if (s == Sign::zero) return t == Sign::minus;
        if (t == Sign::zero) return s == Sign::minus;
        const bool both = s == Sign::minus && t == Sign::minus;
        const bool either = s == Sign::minus || t == Sign::minus;
        return bend == Sign::minus ? both : either;
    }

    static TwoSided side_of(bool left, const RecordAtPiece* const (&nearest)[2],
                            const RecordAtPiece* const (&coplanar)[2]) {
        if (const RecordAtPiece* c = coplanar[left ? 0 : 1]) return {c->record->opposite, !c->record->opposite};
        if (const RecordAtPiece* x = nearest[1] != nullptr ? nearest[1] : nearest[0]) {
            const bool inside = x->along == left;
            return {inside, inside};
        }
        if (const RecordAtPiece* c = coplanar[left ? 1 : 0]) return {c->record->opposite, !c->record->opposite};
        return {};
    }

    /// Whether x comes before y, going from the left of the segment to its right above the plane of face f (level 1) or
    /// beneath it (0). A corner of y's face on that side of f tells: it is on the right of x's plane.
    bool is_before(std::uint32_t i, std::uint32_t f, const RecordAtPiece& x, const RecordAtPiece& y, unsigned level) {
        const std::uint32_t j = y.record->operand;
        const FaceList& list = operands_->boundary(j).faces;
        const FaceList::Face& face = list.faces[y.record->other];
        const Sign wanted = level == 1 ? Sign::plus : Sign::minus;
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l)
            for (const Corner& c : list.loop(l)) {
                if (operands_->side(i, f, j, c.point) != wanted) continue;
                return operands_->side(j, x.record->other, j, c.point) == (x.along ? Sign::plus : Sign::minus);
            }
        return false;
    }

    SurfaceOperands* operands_;
};

CLEAVE_END_NAMESPACE

#endif

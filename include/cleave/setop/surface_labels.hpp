// SPDX-License-Identifier: Apache-2.0
/// For every face that another operand touches: its edges and the common segments, cut at the common points, with what
/// is on either side of them.
#ifndef CLEAVE_SETOP_SURFACE_LABELS_HPP
#define CLEAVE_SETOP_SURFACE_LABELS_HPP

#include <cleave/setop/label_forest.hpp>
#include <cleave/setop/point_location.hpp>
#include <cleave/setop/surface_contacts.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Whether the other operand contains what is just above and just below some part of a face.
struct TwoSided {
    bool above = false;
    bool below = false;

    friend bool operator==(const TwoSided&, const TwoSided&) = default;
};

/// A part of a face's edge (the face on its left) or a common segment inside it (the face on both sides).
struct FacePiece {
    PointId from = no_id;  ///< of the kernel; `no_id` for a vertex that no one asked the kernel for
    PointId to = no_id;
    std::uint32_t n = no_id;    ///< the edge in the face's outline; `no_id` for a common segment
    std::uint32_t cut = no_id;  ///< a record of the face that is not coplanar and contains the piece, if any
    bool along = true;          ///< whether that record runs like the piece
    bool is_known = false;      ///< whether `left` is known; else it is what the edge's free vertices say
    TwoSided left, right;
};

/// Decides sides. One face at a time; labels that no contact tells spread over vertices.
class SurfaceLabels {
public:
    SurfaceLabels(SurfaceOperands& operands, const SurfaceContacts& contacts)
        : operands_(&operands), contacts_(&contacts), forest_(operands.vertex_count()) {
        for (const std::uint32_t i : {0U, 1U}) {
            touched_[i].assign(operands.boundary(i).points.size(), 0);
            find_touched(i);
        }
        for (const std::uint32_t i : {0U, 1U}) spread(i);
    }

    /// The records of one face.
    struct FaceRecords {
        std::span<const SegmentRecord> segments;
        std::span<const PointContact> points;
    };

    /// The records of faces of operand i, asked for in ascending order.
    class Walk {
    public:
        Walk(const SurfaceContacts& contacts, std::uint32_t i)
            : segments_(contacts.segments(i)), points_(contacts.points(i)) {}

        FaceRecords of(std::uint32_t face) { return {take(segments_, face), take(points_, face)}; }

    private:
        template <class Record>
        static std::span<const Record> take(std::span<const Record>& rest, std::uint32_t face) {
            std::size_t skip = 0;
            while (skip < rest.size() && rest[skip].face < face) ++skip;
            std::size_t n = skip;
            while (n < rest.size() && rest[n].face == face) ++n;
            const std::span<const Record> found = rest.subspan(skip, n - skip);
            rest = rest.subspan(n);
            return found;
        }

        std::span<const SegmentRecord> segments_;
        std::span<const PointContact> points_;
    };

    /// Cuts face f of operand i into `pieces` and labels them.
    void cut(std::uint32_t i, std::uint32_t f, const FaceRecords& records, const FaceOutline& outline,
             std::vector<FacePiece>& pieces) {
        pieces.clear();
        for (std::uint32_t n = 0; n < outline.entries.size(); ++n) cut_edge(i, f, records, outline, n, pieces);
        cut_inside(i, f, records, pieces);
    }

    /// Whether the other operand contains vertex p of operand i. Requires: it is not on its boundary.
    bool contains(std::uint32_t i, PointId p) {
        const std::uint32_t v = operands_->vertex(i, p);
        if (forest_.known(v) == 0) {
            forest_.learn(v, 1, locator(1 - i).contains(i, p) ? 1 : 0);
            ++located_;
        }
        return forest_.label(v) != 0;
    }

    /// The label of a piece that is not known: what a free end says, or else a ray from its middle.
    bool resolve(std::uint32_t i, const FacePiece& piece, const FaceOutline& outline) {
        const FaceOutline::Entry& from = outline.entries[piece.n];
        const FaceOutline::Entry& to = outline.entries[from.next];
        if (!touched_[i][from.point] && is_end(i, piece.from, from.point)) return contains(i, from.point);
        if (!touched_[i][to.point] && is_end(i, piece.to, to.point)) return contains(i, to.point);
        ++located_;
        Kernel<3>& kernel = operands_->kernel();
        const Homogeneous<3> a = kernel.coordinates(piece.from == no_id ? operands_->point(i, from.point) : piece.from);
        const Homogeneous<3> b = kernel.coordinates(piece.to == no_id ? operands_->point(i, to.point) : piece.to);
        Homogeneous<3> middle;
        for (std::size_t x = 0; x < 3; ++x) {
            WideInteger sum(a[x] * WideInteger(b[3]));
            add_product(sum, b[x], a[3]);
            middle[x] = Integer(sum);
        }
        middle[3] = Integer(a[3] * WideInteger(b[3]) * WideInteger(Integer(2)));
        return locator(1 - i).contains(kernel.add_point(std::move(middle)));
    }

    /// Whether vertex p of operand i is on the other operand's boundary.
    [[nodiscard]] bool is_touched(std::uint32_t i, PointId p) const { return touched_[i][p] != 0; }
    /// Whether no two contacts contradict each other. They do where an operand intersects itself.
    [[nodiscard]] bool is_consistent() const noexcept { return forest_.is_consistent(); }
    /// Points whose place no contact told.
    [[nodiscard]] std::size_t located() const noexcept { return located_; }

private:
    bool is_end(std::uint32_t i, PointId at, PointId vertex) const {
        return at == no_id || at == operands_->known_point(i, vertex);
    }

    PointLocation& locator(std::uint32_t i) {
        if (!locators_[i]) locators_[i].emplace(*operands_, i);
        return *locators_[i];
    }

    void find_touched(std::uint32_t i) {
        const FaceList& list = operands_->boundary(i).faces;
        for (const PointContact& c : contacts_->points(i))
            if (c.of_face.kind == Feature::Kind::vertex) touched_[i][list.corners[c.of_face.corner].point] = 1;
    }

    /// Joins the ends of edges that nothing meets, and learns from contacts and from vertices beyond the other's box.
    void spread(std::uint32_t i) {
        const Boundary<3>& b = operands_->boundary(i);
        const Boundary<3>& other = operands_->boundary(1 - i);
        Walk walk(*contacts_, i);
        FaceOutline outline;
        std::vector<FacePiece> pieces;
        for (const std::uint32_t f : contacts_->near(i)) {
            const FaceRecords records = walk.of(f);
            outline.read(*operands_, i, f);
            for (const FaceOutline::Entry& e : outline.entries)
                if (is_outside(b.points[e.point], other.bounds))
                    forest_.learn(operands_->vertex(i, e.point), 1, other.value_at_infinity ? 1 : 0);
            if (records.points.empty()) {
                for (const FaceOutline::Entry& e : outline.entries) join(i, e.point, outline.entries[e.next].point);
                continue;
            }
            pieces.clear();
            for (std::uint32_t n = 0; n < outline.entries.size(); ++n) {
                const std::size_t first = pieces.size();
                cut_edge(i, f, records, outline, n, pieces);
                const PointId p = outline.entries[n].point;
                const PointId q = outline.entries[outline.entries[n].next].point;
                if (!touched_[i][p] && !touched_[i][q] && pieces.size() == first + 1 && !pieces[first].is_known)
                    join(i, p, q);
                learn(i, p, pieces[first]);
                learn(i, q, pieces.back());
            }
        }
    }

    static bool is_outside(const PointRecord<3>& r, const Bounds<3>& box) {
        for (std::size_t x = 0; x < 3; ++x)
            if (r.error == 0 && (r.approximation[x] < box.lo[x] || r.approximation[x] > box.hi[x])) return true;
        return false;
    }

    void join(std::uint32_t i, PointId p, PointId q) {
        if (touched_[i][p] == 0 && touched_[i][q] == 0)
            forest_.join(operands_->vertex(i, p), operands_->vertex(i, q), 0);
    }

    void learn(std::uint32_t i, PointId p, const FacePiece& piece) {
        if (touched_[i][p] == 0 && piece.is_known) forest_.learn(operands_->vertex(i, p), 1, piece.left.above ? 1 : 0);
    }

    // --- pieces of one edge ------------------------------------------------------------------------------------------

    void cut_edge(std::uint32_t i, std::uint32_t f, const FaceRecords& records, const FaceOutline& outline,
                  std::uint32_t n, std::vector<FacePiece>& pieces) {
        const FaceOutline::Entry& from = outline.entries[n];
        const FaceOutline::Entry& to = outline.entries[from.next];
        points_.clear();
        for (const PointContact& c : records.points)
            if (c.of_face.kind == Feature::Kind::edge && c.of_face.corner == from.corner) points_.push_back(c.point);
        if (points_.size() > 1) sort_along(i, from.point, to.point);
        const bool from_on = touched_[i][from.point] != 0;
        const bool to_on = touched_[i][to.point] != 0;
        PointId a = from_on ? operands_->point(i, from.point) : operands_->known_point(i, from.point);
        points_.push_back(to_on ? operands_->point(i, to.point) : operands_->known_point(i, to.point));
        for (std::size_t k = 0; k < points_.size(); ++k) {
            FacePiece piece;
            piece.from = a;
            piece.to = points_[k];
            piece.n = n;
            label_on_boundary(i, f, records, outline, from.corner, k, piece);
            if (!piece.is_known) {
                const bool has_start = k > 0 || from_on;
                const bool has_end = k + 1 < points_.size() || to_on;
                std::optional<bool> inside;
                if (has_start) inside = beside(i, records, piece.from, to.point);
                if (!inside && has_end) inside = beside(i, records, piece.to, from.point);
                if (inside) {
                    piece.is_known = true;
                    piece.left = {*inside, *inside};
                }
            }
            pieces.push_back(piece);
            a = points_[k];
        }
    }

    void sort_along(std::uint32_t i, PointId p, PointId q) {
        Kernel<3>& kernel = operands_->kernel();
        const auto& x = operands_->position(i, p);
        const auto& y = operands_->position(i, q);
        std::array<int, 3> axes{0, 1, 2};
        const auto size = [&](int axis) { return std::abs(y[std::size_t(axis)] - x[std::size_t(axis)]); };
        std::sort(axes.begin(), axes.end(), [&](int s, int t) { return size(s) > size(t); });
        Sign up = Sign::zero;
        int axis = axes[0];
        if (operands_->is_of_doubles(i, p) && operands_->is_of_doubles(i, q)) {
            up = y[std::size_t(axis)] > x[std::size_t(axis)] ? Sign::plus : Sign::minus;
        } else {
            for (const int candidate : axes) {
                axis = candidate;
                up = kernel.compare(axis, operands_->point(i, q), operands_->point(i, p));
                if (up != Sign::zero) break;
            }
        }
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        std::sort(points_.begin(), points_.end(),
                  [&](PointId s, PointId t) { return s != t && kernel.compare(axis, t, s) == up; });
    }

    /// Where the other operand's faces contain the piece: they tell what is on its left.
    void label_on_boundary(std::uint32_t i, std::uint32_t f, const FaceRecords& records, const FaceOutline& outline,
                           std::uint32_t corner, std::size_t k, FacePiece& piece) {
        found_.clear();
        for (std::uint32_t s = 0; s < records.segments.size(); ++s) {
            const SegmentRecord& r = records.segments[s];
            if (r.corner != corner) continue;
            // The segment's ends are among the edge's points; it contains the piece between k - 1 and k.
            const std::ptrdiff_t a = rank(i, outline, piece.n, r.from);
            const std::ptrdiff_t b = rank(i, outline, piece.n, r.to);
            const auto low = std::min(a, b);
            const auto high = std::max(a, b);
            if (low < std::ptrdiff_t(k) && std::ptrdiff_t(k) <= high) found_.push_back({&r, s, a < b});
        }
        if (found_.empty()) return;
        piece.is_known = true;
        label(i, f, piece);
    }

    /// The number of a point on the edge: -1 for its start, the last for its end.
    std::ptrdiff_t rank(std::uint32_t i, const FaceOutline& outline, std::uint32_t n, PointId p) const {
        const FaceOutline::Entry& from = outline.entries[n];
        if (p == operands_->known_point(i, from.point)) return -1;
        const auto at = std::find(points_.begin(), points_.end(), p);
        return at - points_.begin();
    }

    /// Whether the other operand contains the stretch of an edge that leaves its point x towards vertex `ahead`, as far
    /// as a face or a plain ridge at x tells. Requires: no face contains the stretch.
    std::optional<bool> beside(std::uint32_t i, const FaceRecords& records, PointId x, PointId ahead) {
        const std::uint32_t j = 1 - i;
        const PointContact* first = nullptr;
        const PointContact* second = nullptr;  // the other face at a ridge
        for (const PointContact& c : records.points) {
            if (c.point != x) continue;
            if (c.of_other.kind == Feature::Kind::vertex) return std::nullopt;
            if (first == nullptr) {
                first = &c;
            } else if (c.other == first->other) {
                continue;
            } else if (c.of_other.kind == Feature::Kind::interior || first->of_other.kind == Feature::Kind::interior ||
                       !is_same_edge(j, c.of_other.corner, c.other, first->of_other.corner, first->other)) {
                return std::nullopt;  // where the other boundary touches itself, one face does not tell all
            } else if (second == nullptr || c.other == second->other) {
                second = &c;
            } else {
                return std::nullopt;
            }
        }
        if (first == nullptr) return std::nullopt;
        if (first->of_other.kind == Feature::Kind::interior) {
            const Sign s = operands_->side(j, first->other, i, ahead);
            if (s == Sign::zero) return std::nullopt;
            return s == Sign::minus;
        }
        if (second == nullptr) return std::nullopt;
        return beside_ridge(i, *first, *second, ahead);
    }

    bool is_same_edge(std::uint32_t j, std::uint32_t corner, std::uint32_t face, std::uint32_t other_corner,
                      std::uint32_t other_face) const {
        return edge_ends(j, corner, face) == edge_ends(j, other_corner, other_face);
    }

    std::pair<PointId, PointId> edge_ends(std::uint32_t j, std::uint32_t corner, std::uint32_t face) const {
        const FaceList& list = operands_->boundary(j).faces;
        std::uint32_t l = list.faces[face].first_loop;
        while (list.loop_first[l + 1] <= corner) ++l;
        const std::uint32_t next = corner + 1 == list.loop_first[l + 1] ? list.loop_first[l] : corner + 1;
        return std::minmax({list.corners[corner].point, list.corners[next].point});
    }

    std::optional<bool> beside_ridge(std::uint32_t i, const PointContact& a, const PointContact& b, PointId ahead) {
        const std::uint32_t j = 1 - i;
        const FaceList& list = operands_->boundary(j).faces;
        const FaceList::Face& face = list.faces[b.other];
        if (face.loop_count != 1 || list.loop(face.first_loop).size() != 3) return std::nullopt;
        const std::uint32_t first = list.loop_first[face.first_loop];
        const PointId opposite = list.corners[first + (b.of_other.corner - first + 2) % 3].point;
        const Sign bend = operands_->side(j, a.other, j, opposite);
        const Sign s = operands_->side(j, a.other, i, ahead);
        const Sign t = operands_->side(j, b.other, i, ahead);
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

    // --- common segments inside a face -------------------------------------------------------------------------------

    void cut_inside(std::uint32_t i, std::uint32_t f, const FaceRecords& records, std::vector<FacePiece>& pieces) {
        order_.clear();
        for (std::uint32_t s = 0; s < records.segments.size(); ++s)
            if (records.segments[s].corner == no_id) order_.push_back(s);
        const auto key = [&](std::uint32_t s) {
            return std::pair(std::min(records.segments[s].from, records.segments[s].to),
                             std::max(records.segments[s].from, records.segments[s].to));
        };
        if (order_.size() > 1)
            std::sort(order_.begin(), order_.end(),
                      [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
        for (std::size_t n = 0; n < order_.size();) {
            const auto ends = key(order_[n]);
            found_.clear();
            FacePiece piece;
            piece.from = records.segments[order_[n]].from;
            piece.to = records.segments[order_[n]].to;
            for (; n < order_.size() && key(order_[n]) == ends; ++n) {
                const SegmentRecord& r = records.segments[order_[n]];
                found_.push_back({&r, order_[n], r.from == piece.from});
            }
            piece.is_known = true;
            label(i, f, piece);
            pieces.push_back(piece);
        }
    }

    // --- all faces at one segment ------------------------------------------------------------------------------------

    struct Found {
        const SegmentRecord* record;
        std::uint32_t index;
        bool along;  // whether it runs like the piece
    };

    /// What is beside the piece, from the other operand's faces at it, `found_`. Going round the segment, what is next
    /// to a face is inside on its minus side: the first face from the left above the plane tells what is just above
    /// the left side, and so on. A coplanar face on the left tells both.
    void label(std::uint32_t i, std::uint32_t f, FacePiece& piece) {
        const Found* first[2] = {nullptr, nullptr};  // from the left; beneath, above
        const Found* last[2] = {nullptr, nullptr};
        const Found* coplanar[2] = {nullptr, nullptr};  // on the left, on the right
        for (const Found& x : found_) {
            if (x.record->up_down == 0) {
                const std::uint8_t sides = x.record->left_right;
                if ((sides & 1U) != 0) coplanar[x.along ? 0 : 1] = &x;
                if ((sides & 2U) != 0) coplanar[x.along ? 1 : 0] = &x;
                continue;
            }
            if (piece.cut == no_id) {
                piece.cut = x.index;
                piece.along = x.along;
            }
            for (const unsigned level : {0U, 1U}) {
                if ((x.record->up_down & (1U << level)) == 0) continue;
                if (first[level] == nullptr || is_before(i, f, x, *first[level], level)) first[level] = &x;
                if (last[level] == nullptr || is_before(i, f, *last[level], x, level)) last[level] = &x;
            }
        }
        piece.left = side_of(true, first, coplanar);
        piece.right = side_of(false, last, coplanar);
    }

    static TwoSided side_of(bool left, const Found* const (&nearest)[2], const Found* const (&coplanar)[2]) {
        if (const Found* c = coplanar[left ? 0 : 1]) return {c->record->opposite, !c->record->opposite};
        const auto beside = [&](const Found& x) { return x.along == left; };
        const Found* above = nearest[1] != nullptr ? nearest[1] : nullptr;
        const Found* below = nearest[0];
        if (above == nullptr && below == nullptr) {
            const Found* c = coplanar[left ? 1 : 0];
            if (c == nullptr) return {};
            return {c->record->opposite, !c->record->opposite};
        }
        const bool inside = above != nullptr ? beside(*above) : beside(*below);
        return {inside, inside};
    }

    /// Whether x comes before y, going from the left of the segment to its right above the plane of face f (level 1) or
    /// beneath it (0). A corner of y's face on that side of f tells: it is on the right of x's plane.
    bool is_before(std::uint32_t i, std::uint32_t f, const Found& x, const Found& y, unsigned level) {
        const std::uint32_t j = 1 - i;
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
    const SurfaceContacts* contacts_;
    BasicLabelForest<std::uint8_t> forest_;
    std::array<std::vector<char>, 2> touched_;
    std::array<std::optional<PointLocation>, 2> locators_;
    std::vector<PointId> points_;  // of one edge, in order, its end the last
    std::vector<Found> found_;
    std::vector<std::uint32_t> order_;
    std::size_t located_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

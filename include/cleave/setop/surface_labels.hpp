// SPDX-License-Identifier: Apache-2.0
/// For every face near other operands, what is on either side of each part of it.
#ifndef CLEAVE_SETOP_SURFACE_LABELS_HPP
#define CLEAVE_SETOP_SURFACE_LABELS_HPP

#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/setop/coplanar_cover.hpp>
#include <cleave/setop/patch_labels.hpp>
#include <cleave/setop/point_location.hpp>
#include <cleave/setop/surface_cutter.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Cuts the faces that are touched, and labels pieces and vertices: by contacts, by what spreads from them, and where
/// neither tells by a ray.
class SurfaceLabels {
public:
    using Bits = FacePiece::Bits;

    /// `progress` is asked whether to stop.
    SurfaceLabels(SurfaceOperands& operands, const SurfaceContacts& contacts, ExecutorRef executor,
                  const ProgressReporter* progress)
        : operands_(&operands),
          contacts_(&contacts),
          touched_(operands, contacts),
          cutter_(operands, touched_),
          patches_(operands.vertex_count()),
          cover_(operands),
          first_piece_(operands.count()),
          locators_(operands.count()) {
        for (std::uint32_t i = 0; i < operands.count(); ++i)
            if (operands.boundary(i).value_at_infinity) far_ |= Bits(1) << i;
        join_untouched(executor, progress);
        // At least so many, nearly always; to move them again and again would take long.
        std::size_t points = 0;
        for (std::uint32_t i = 0; i < operands.count(); ++i) points += contacts.points(i).size();
        pieces_.reserve(points);
        for (std::uint32_t i = 0; i < operands.count(); ++i) cut_faces(i, progress);
        patches_.close();
    }

    /// The operands that contain what is far away.
    [[nodiscard]] Bits far() const noexcept { return far_; }

    /// The pieces of the near face with this number; none where nothing touches it. Labels may be missing.
    [[nodiscard]] std::span<FacePiece> pieces(std::uint32_t i, std::size_t near) {
        const std::vector<std::size_t>& first = first_piece_[i];
        return {pieces_.data() + first[near], first[near + 1] - first[near]};
    }

    /// Finds all labels that the pieces of a face lack.
    void complete(const FaceOutline& outline, const FaceRecords& records, std::span<FacePiece> pieces) {
        const std::uint32_t i = outline.operand;
        const bool several = operands_->count() > 2;
        bool asked = false;
        for (FacePiece& p : pieces) {
            for (const bool at_start : {true, false}) learn_from_vertex(outline, p, at_start, false);
            asked = asked || missing(i, p) != 0;
        }
        if (several && asked) cutter_.spread(outline, records, pieces);
        for (FacePiece& p : pieces) {
            if (missing(i, p) == 0) continue;
            for (const bool at_start : {true, false}) learn_from_vertex(outline, p, at_start, true);
            locate(outline, records, p);
            if (several) cutter_.spread(outline, records, pieces);
        }
    }

    /// The operands that contain vertex p of operand i. Requires: it is on no other operand's boundary.
    Bits containing(std::uint32_t i, PointId p) {
        const std::uint32_t v = operands_->vertex(i, p);
        const Bits neighbours = contacts_->neighbours(i);
        const PatchLabels::Label label = patches_.at(v);
        if ((neighbours & ~label.known) == 0) return (label.value & neighbours) | far(i);
        find(i, p, neighbours & ~label.known);
        return (patches_.label(v) & neighbours) | far(i);
    }

    /// Whether no two contacts contradict each other. They do where an operand intersects itself.
    [[nodiscard]] bool is_consistent() const noexcept { return patches_.is_consistent(); }
    /// Points whose place no contact told.
    [[nodiscard]] std::size_t located() const noexcept { return located_; }

private:
    /// What holds for all of operand i, because its bounds do not meet the other's: the value of the others far away.
    [[nodiscard]] Bits far(std::uint32_t i) const { return far_ & ~contacts_->neighbours(i) & ~bit(i); }

    static Bits bit(std::uint32_t i) { return Bits(1) << i; }

    [[nodiscard]] Bits missing(std::uint32_t i, const FacePiece& p) const {
        return contacts_->neighbours(i) & ~p.known;
    }

    PointLocation& locator(std::uint32_t i) {
        if (!locators_[i]) locators_[i].emplace(*operands_, i);
        return *locators_[i];
    }

    // --- before all is known -----------------------------------------------------------------------------------------

    /// A vertex, or two, and operands of which something is known there.
    struct Note {
        std::uint32_t v, w;
        Bits operands;
    };

    /// What the near faces of one operand tell before any is cut.
    struct Notes {
        std::vector<Note> outside;  // vertices beyond operands' bounds
        std::vector<Note> links;    // see PatchLabels::link
    };

    /// Joins the corners of faces without contacts. No two operands have a vertex in common, so they go side by side.
    void join_untouched(ExecutorRef executor, const ProgressReporter* progress) {
        std::vector<Notes> notes(operands_->count());
        executor.for_each_index(operands_->count(), [&](std::size_t i) {
            join_untouched(static_cast<std::uint32_t>(i), progress, notes[i]);
        });
        for (const Notes& n : notes) {
            for (const Note& o : n.outside) patches_.learn(o.v, o.operands, far_);
            for (const Note& l : n.links) patches_.link(l.v, l.w, l.operands);
        }
    }

    void join_untouched(std::uint32_t i, const ProgressReporter* progress, Notes& notes) {
        const FaceList& list = operands_->boundary(i).faces;
        RecordWalk walk = contacts_->walk(i);
        std::vector<bool> seen(operands_->boundary(i).points.size(), false);
        std::size_t looked_at = 0;
        for (const std::uint32_t f : contacts_->near(i)) {
            if (looked_at++ % 4096 == 0 && progress != nullptr) progress->throw_if_stopped();
            for (const Corner& c : list.corners_of(f)) {
                if (seen[c.point]) continue;
                seen[c.point] = true;
                if (const Bits outside = beyond(i, c.point); outside != 0)
                    notes.outside.push_back({operands_->vertex(i, c.point), no_id, outside});
            }
            if (!walk.of(f).points.empty()) continue;
            const FaceList::Face& face = list.faces[f];
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::span<const Corner> loop = list.loop(l);
                for (std::size_t n = 1; n < loop.size(); ++n) join(i, loop[n - 1].point, loop[n].point, notes);
            }
        }
    }

    void join(std::uint32_t i, PointId p, PointId q, Notes& notes) {
        const std::uint32_t v = operands_->vertex(i, p);
        const std::uint32_t w = operands_->vertex(i, q);
        const Bits touched = touched_.by(v) | touched_.by(w);
        if (touched == 0)
            patches_.join(v, w);
        else
            notes.links.push_back({v, w, contacts_->neighbours(i) & ~touched});
    }

    /// The operands beyond whose bounds a vertex of operand i is: there they have their value far away.
    [[nodiscard]] Bits beyond(std::uint32_t i, PointId p) const {
        Bits outside = 0;
        for (Bits rest = contacts_->neighbours(i); rest != 0; rest &= rest - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(rest));
            if (is_outside(operands_->boundary(i).points[p], operands_->boundary(j).bounds)) outside |= bit(j);
        }
        return outside;
    }

    void cut_faces(std::uint32_t i, const ProgressReporter* progress) {
        const std::span<const std::uint32_t> near = contacts_->near(i);
        RecordWalk walk = contacts_->walk(i);
        FaceOutline outline;
        first_piece_[i].reserve(near.size() + 1);
        for (const std::uint32_t f : near) {
            first_piece_[i].push_back(pieces_.size());
            const FaceRecords records = walk.of(f);
            if (records.points.empty()) continue;
            if ((pieces_.size() & 0xffU) < 4 && progress != nullptr) progress->throw_if_stopped();
            outline.read(*operands_, i, f);
            cutter_.cut(outline, records, ~contacts_->neighbours(i), far(i), pieces_);
            tell_vertices(outline, records, pieces_.size());
        }
        first_piece_[i].push_back(pieces_.size());
    }

    static bool is_outside(const PointRecord<3>& r, const Bounds<3>& box) {
        if (r.error == 0) {
            for (std::size_t x = 0; x < 3; ++x)
                if (r.approximation[x] > box.hi[x] || r.approximation[x] < box.lo[x]) return true;
            return false;
        }
        Bounds<3> at;
        at.include(r.approximation, r.error);
        return at.disjoint(box);
    }

    /// What the pieces of edges tell about the vertices at their ends. Pieces are those from `first_piece_` on.
    void tell_vertices(const FaceOutline& outline, const FaceRecords& records, std::size_t end) {
        const std::uint32_t i = outline.operand;
        const Bits neighbours = contacts_->neighbours(i);
        std::size_t k = first_piece_[i].back();
        for (std::uint32_t n = 0; n < outline.entries.size(); ++n) {
            const FacePiece& first = pieces_[k];
            while (k + 1 < end && pieces_[k + 1].n == n) ++k;
            const FacePiece& last = pieces_[k++];
            const FaceOutline::Entry& from = outline.entries[n];
            const PointId q = outline.entries[from.next].point;
            const std::uint32_t v = operands_->vertex(i, from.point);
            const std::uint32_t w = operands_->vertex(i, q);
            const Bits at_v = touched_.by(v);
            const Bits at_w = touched_.by(w);
            patches_.learn(v, first.known & neighbours & ~at_v, first.left.above);
            patches_.learn(w, last.known & neighbours & ~at_w, last.left.above);
            if (&first == &last && at_v == 0 && at_w == 0) {
                patches_.join(v, w);
                continue;
            }
            Bits met = at_v | at_w;
            if (operands_->count() == 2) continue;  // the one other operand meets the edge
            for (const PointContact& c : records.points)
                if (c.of_face.kind == Feature::Kind::edge && c.of_face.corner == from.corner) met |= bit(c.operand);
            patches_.link(v, w, neighbours & ~met);
        }
    }

    // --- afterwards --------------------------------------------------------------------------------------------------

    /// A piece has the label of a vertex at its end, except for operands that touch the vertex.
    void learn_from_vertex(const FaceOutline& outline, FacePiece& piece, bool at_start, bool search) {
        if (piece.n == no_id) return;
        const std::uint32_t i = outline.operand;
        const FaceOutline::Entry& from = outline.entries[piece.n];
        const PointId v = at_start ? from.point : outline.entries[from.next].point;
        const PointId end = at_start ? piece.from : piece.to;
        if (end != no_id && end != operands_->known_point(i, v)) return;
        const std::uint32_t vertex = operands_->vertex(i, v);
        const Bits wanted = missing(i, piece) & ~touched_.by(vertex);
        if (wanted == 0) return;
        if (search) find(i, v, wanted & ~patches_.known(vertex));
        const Bits label = patches_.label(vertex);
        piece.learn(wanted & patches_.known(vertex), {label, label});
    }

    /// Finds bits of a vertex's label by rays.
    void find(std::uint32_t i, PointId p, Bits wanted) {
        if (wanted == 0) return;
        Bits value = 0;
        for (Bits rest = wanted; rest != 0; rest &= rest - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(rest));
            if (contains(j, operands_->boundary(i).points[p], [&](PointLocation& l) { return l.contains(i, p); }))
                value |= bit(j);
        }
        patches_.tell(operands_->vertex(i, p), wanted, value);
    }

    /// Finds the rest of a piece's label: in coplanar faces, and by rays from the piece's middle.
    void locate(const FaceOutline& outline, const FaceRecords& records, FacePiece& piece) {
        const std::uint32_t i = outline.operand;
        if (missing(i, piece) == 0) return;
        Kernel<3>& kernel = operands_->kernel();
        const PointId from = piece.from != no_id ? piece.from : operands_->point(i, outline.entries[piece.n].point);
        const PointId to =
            piece.to != no_id ? piece.to : operands_->point(i, outline.entries[outline.entries[piece.n].next].point);
        const PointId middle = add_midpoint(kernel, from, to);
        for (const SegmentRecord& r : records.segments) {
            if (r.up_down != 0 || (missing(i, piece) & bit(r.operand)) == 0) continue;
            if (!cover_(r.operand, r.other, middle)) continue;
            const Bits above = r.opposite ? bit(r.operand) : 0;
            piece.learn(bit(r.operand), {above, above ^ bit(r.operand)});
        }
        const Bits wanted = missing(i, piece);
        Bits value = 0;
        for (Bits rest = wanted; rest != 0; rest &= rest - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(rest));
            if (contains(j, kernel.point(middle), [&](PointLocation& l) { return l.contains(middle); }))
                value |= bit(j);
        }
        piece.learn(wanted, {value, value});
    }

    template <class Ask>
    bool contains(std::uint32_t j, const PointRecord<3>& r, Ask&& ask) {
        if (is_outside(r, operands_->boundary(j).bounds)) return (far_ & bit(j)) != 0;
        ++located_;
        return ask(locator(j));
    }

    SurfaceOperands* operands_;
    const SurfaceContacts* contacts_;
    TouchedVertices touched_;
    SurfaceCutter cutter_;
    PatchLabels patches_;
    CoplanarCover cover_;
    Bits far_ = 0;
    std::vector<FacePiece> pieces_;
    std::vector<std::vector<std::size_t>> first_piece_;  // of each near face, and the end
    std::vector<std::optional<PointLocation>> locators_;
    std::size_t located_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

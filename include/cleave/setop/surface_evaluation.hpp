// SPDX-License-Identifier: Apache-2.0
/// Set operations on bounded boundaries in 3-D whose cost follows where they meet: the localised engine.
///
/// Faces whose boxes meet are compared in pairs; what a pair has in common gets names that all faces at it agree on
/// (`FaceContact`), and where three operands meet, segments cut each other (`SegmentNoding`). A touched face is a set
/// of directed edges: parts of its own, and the common segments. What is on their left follows from the faces that meet
/// there (`SurfaceLabels`), for each operand above and below apart, so that coplanar faces, ridges and contacts are no
/// special case. Other faces take their label from their vertices and pass by index: no plane, copy or predicate is
/// ever spent on them.
#ifndef CLEAVE_SETOP_SURFACE_EVALUATION_HPP
#define CLEAVE_SETOP_SURFACE_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/setop/options.hpp>
#include <cleave/setop/surface_labels.hpp>
#include <cleave/setop/surface_result.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One evaluation. Requires: 1 to 64 operands, finite and conforming.
class SurfaceEvaluation {
public:
    using Bits = BooleanFunction::Bits;

    /// Whether these operands are what this engine is made for.
    static bool is_for(std::span<const Boundary<3>* const> operands) {
        return !operands.empty() && operands.size() <= BooleanFunction::max_arity &&
               std::all_of(operands.begin(), operands.end(),
                           [](const Boundary<3>* b) { return b->is_finite && b->is_conforming; });
    }

    SurfaceEvaluation(std::span<const Boundary<3>* const> operands, const BooleanFunction& function,
                      const OperationOptions& options)
        : operands_(operands),
          face_count_(begin(operands, options.progress)),
          contacts_(operands_, options.executor, options.progress, face_count_),
          labels_(operands_, contacts_, options.executor, options.progress),
          merger_(operands_.kernel(), operands_.interner()),
          result_(operands_),
          function_(function),
          options_(options) {
        if (options.progress != nullptr) options.progress->advance(face_count_);
        sound_ = labels_.is_consistent();
        for (std::uint32_t i = 0; i < operands_.count(); ++i)
            if (sound_) assemble(i);
        sound_ = sound_ && labels_.is_consistent();
        if (!sound_) return;
        boundary_ = result_.finish(function_(labels_.far()), options.executor, options.progress, face_count_);
        if (options.progress != nullptr) options.progress->finish();
    }

    /// Whether all that was found out fits together. It does unless an operand intersects itself; there is no result
    /// then.
    [[nodiscard]] bool is_sound() const noexcept { return sound_; }

    /// The result. Requires: `is_sound()`.
    [[nodiscard]] Boundary<3> finish() {
        CLEAVE_REQUIRES(sound_);
        if (options_.counts != nullptr) {
            counts_.kernel = operands_.kernel().counts();
            counts_.face_pairs = contacts_.pair_count();
            counts_.points_located = labels_.located();
            *options_.counts = counts_;
        }
        return std::move(boundary_);
    }

private:
    /// Pairs, contacts, labels, what becomes of faces and the result are a share of the work each, as large as the
    /// operands have faces.
    static std::size_t begin(std::span<const Boundary<3>* const> operands, ProgressReporter* progress) {
        std::size_t faces = 0;
        for (const Boundary<3>* b : operands) faces += b->faces.faces.size();
        if (progress != nullptr) progress->begin("faces", 5 * faces);
        return faces;
    }

    /// What happens to a part of a face.
    enum class Action : std::uint8_t { drop, keep, flip };

    /// An edge of the result's part of a face.
    struct OutEdge {
        PointId from, to;
        std::size_t piece;
        bool left;  // whether the part is on the piece's left
    };

    [[nodiscard]] Action action(std::uint32_t i, const SideBits& s) const {
        const Bits own = Bits(1) << i;
        const Bits others = ~own;
        // A part that several operands have comes from the first of them.
        if (((s.above ^ s.below) & (own - 1)) != 0) return Action::drop;
        const bool below = function_(own | (s.below & others));
        const bool above = function_(s.above & others);
        if (below == above) return Action::drop;
        return below ? Action::keep : Action::flip;
    }

    void assemble(std::uint32_t i) {
        const Boundary<3>& b = operands_.boundary(i);
        Bits last_inside = 0;  // neighbours have much in common
        Action last_action = action(i, {0, 0});
        const Action beyond = action(i, {labels_.far(), labels_.far()});
        const std::span<const std::uint32_t> near = contacts_.near(i);
        std::size_t at = 0;
        RecordWalk walk = contacts_.walk(i);
        const auto face_count = static_cast<std::uint32_t>(b.faces.faces.size());
        for (std::uint32_t f = 0; f < face_count && sound_; ++f) {
            const std::uint32_t next = at == near.size() ? face_count : near[at];
            if (f < next && beyond != Action::drop) {
                counts_.faces_whole += next - f;
                result_.add_copies(i, f, next, beyond == Action::flip);
            }
            if (options_.progress != nullptr) options_.progress->advance(next - f + (next < face_count ? 1U : 0U));
            f = next;
            if (f == face_count) break;
            const FaceRecords records = walk.of(f);
            pieces_ = labels_.pieces(i, at++);
            if (!pieces_.empty()) {
                assemble_touched(i, f, records);
                continue;
            }
            const Bits inside = labels_.containing(i, first_corner(i, b.faces.faces[f].first_loop));
            if (has_one_label(i, f, inside)) {
                if (inside != last_inside) {
                    last_inside = inside;
                    last_action = action(i, {inside, inside});
                }
                copy(i, f, last_action);
                continue;
            }
            // A face in several pieces, on different sides of operands that do not touch it.
            outline_.read(operands_, i, f);
            untouched_.clear();
            for (std::uint32_t n = 0; n < outline_.entries.size(); ++n) {
                FacePiece piece;
                piece.n = n;
                const Bits here = labels_.containing(i, outline_.entries[n].point);
                piece.learn(~Bits(0), {here, here});
                untouched_.push_back(piece);
            }
            pieces_ = untouched_;
            assemble_touched(i, f, records);
        }
    }

    [[nodiscard]] PointId first_corner(std::uint32_t i, std::uint32_t loop) const {
        const FaceList& list = operands_.boundary(i).faces;
        return list.corners[list.loop_first[loop]].point;
    }

    /// Whether all loops of a face that nothing touches have this label: a face may be in several pieces.
    bool has_one_label(std::uint32_t i, std::uint32_t f, Bits inside) {
        const FaceList::Face& face = operands_.boundary(i).faces.faces[f];
        for (std::uint32_t l = 1; l < face.loop_count; ++l)
            if (labels_.containing(i, first_corner(i, face.first_loop + l)) != inside) return false;
        return true;
    }

    void copy(std::uint32_t i, std::uint32_t f, Action a) {
        if (a == Action::drop) return;
        ++counts_.faces_whole;
        result_.add_copies(i, f, f + 1, a == Action::flip);
    }

    void assemble_touched(std::uint32_t i, std::uint32_t f, const FaceRecords& records) {
        ++counts_.faces_crossed;
        outline_.read(operands_, i, f);
        labels_.complete(outline_, records, pieces_);
        Action only = Action::drop;
        bool same = true;
        bool split = false;
        actions_.clear();
        for (std::size_t n = 0; n < pieces_.size(); ++n) {
            const FacePiece& p = pieces_[n];
            const Action left = action(i, p.left);
            const Action right = p.n == no_id ? action(i, p.right) : left;
            if (n == 0) only = left;
            same = same && left == only && right == only;
            split = split || (p.n != no_id && n > 0 && pieces_[n - 1].n == p.n);
            actions_.push_back({left, right});
        }
        if (same && (!split || only == Action::drop)) return copy(i, f, only);
        for (const Action what : {Action::keep, Action::flip}) {
            edges_.clear();
            for (std::size_t n = 0; n < pieces_.size(); ++n) {
                const FacePiece& p = pieces_[n];
                const bool left = actions_[n].first == what;
                if (p.n != no_id) {
                    if (left) add_edge(start(i, p), end(i, p), n, true, what);
                } else if (left != (actions_[n].second == what)) {
                    if (left)
                        add_edge(p.from, p.to, n, true, what);
                    else
                        add_edge(p.to, p.from, n, false, what);
                }
            }
            if (!edges_.empty()) emit(i, f, records, what);
        }
    }

    PointId start(std::uint32_t i, const FacePiece& p) {
        return p.from != no_id ? p.from : operands_.point(i, outline_.entries[p.n].point);
    }
    PointId end(std::uint32_t i, const FacePiece& p) {
        return p.to != no_id ? p.to : operands_.point(i, outline_.entries[outline_.entries[p.n].next].point);
    }

    void add_edge(PointId from, PointId to, std::size_t piece, bool left, Action what) {
        if (what == Action::keep)
            edges_.push_back({from, to, piece, left});
        else
            edges_.push_back({to, from, piece, left});
    }

    void emit(std::uint32_t i, std::uint32_t f, const FaceRecords& records, Action what) {
        ++counts_.faces_merged;
        std::sort(edges_.begin(), edges_.end(),
                  [](const OutEdge& a, const OutEdge& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
        ends_.clear();
        for (const OutEdge& e : edges_) ends_.push_back(e.to);
        std::sort(ends_.begin(), ends_.end());
        if (!std::equal(ends_.begin(), ends_.end(), edges_.begin(),
                        [](PointId p, const OutEdge& e) { return p == e.from; })) {
            sound_ = false;
            return;
        }
        const bool plain = std::adjacent_find(edges_.begin(), edges_.end(), [](const OutEdge& a, const OutEdge& b) {
                               return a.from == b.from;
                           }) == edges_.end();
        const PlaneId plane = operands_.plane(i, f);
        merger_.begin(what == Action::keep ? plane : flipped(plane));
        for (const OutEdge& e : edges_) merger_.add_edge(e.from, e.to, edge_plane(i, f, records, e, !plain));
        result_.add_faces([&](FaceList& list) { merger_.finish_conforming(list, {i, f}); });
    }

    /// The plane of an edge of the result, the result's part of the face on its minus side; `no_id` where nobody will
    /// need it: for a whole edge of an input mesh.
    PlaneId edge_plane(std::uint32_t i, std::uint32_t f, const FaceRecords& records, const OutEdge& e, bool needed) {
        const FacePiece& p = pieces_[e.piece];
        if (p.n != no_id) {
            const FaceOutline::Entry& from = outline_.entries[p.n];
            const FaceOutline::Entry& to = outline_.entries[from.next];
            const bool given = operands_.boundary(i).faces.corners[from.corner].edge != no_id;
            if (!needed && !given && is_whole(i, p, from.point, to.point)) return no_id;
            return operands_.oriented_edge_plane(i, f, from.corner, from.point, to.point, outline_.opposite(p.n));
        }
        if (p.cut == no_id) return plane_across(operands_.kernel(), operands_.plane(i, f), e.from, e.to);
        // A record has its plane's minus side on its left.
        const SegmentRecord& r = records.segments[p.cut];
        const PlaneId h = operands_.plane(r.operand, r.other);
        return e.left == p.along ? h : flipped(h);
    }

    bool is_whole(std::uint32_t i, const FacePiece& p, PointId from, PointId to) const {
        return (p.from == no_id || p.from == operands_.known_point(i, from)) &&
               (p.to == no_id || p.to == operands_.known_point(i, to)) && operands_.is_of_doubles(i, from) &&
               operands_.is_of_doubles(i, to);
    }

    FaceOutline outline_;
    SurfaceOperands operands_;
    std::size_t face_count_;
    SurfaceContacts contacts_;
    SurfaceLabels labels_;
    FaceMerger<3> merger_;
    SurfaceResult result_;
    BooleanFunction function_;
    OperationOptions options_;
    std::span<FacePiece> pieces_;  // of the face in hand
    std::vector<FacePiece> untouched_;
    std::vector<std::pair<Action, Action>> actions_;
    std::vector<OutEdge> edges_;
    std::vector<PointId> ends_;
    Boundary<3> boundary_;
    OperationCounts counts_;
    bool sound_ = true;
};

CLEAVE_END_NAMESPACE

#endif

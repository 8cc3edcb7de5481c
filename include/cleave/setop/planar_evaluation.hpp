// SPDX-License-Identifier: Apache-2.0
/// Set operations on bounded boundaries in the plane whose cost follows where they meet: the localised engine in 2-D.
///
/// Segments whose boxes meet are compared in pairs (`PlanarContacts`), cut at their common points and labelled by what
/// is on either side (`PlanarLabels`). The Boolean function of both sides decides about a piece; the pieces of one
/// face are put together again. A face that has one fate, touched or not, comes back as it went in.
#ifndef CLEAVE_SETOP_PLANAR_EVALUATION_HPP
#define CLEAVE_SETOP_PLANAR_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/setop/options.hpp>
#include <cleave/setop/planar_contacts.hpp>
#include <cleave/setop/planar_labels.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One evaluation, for any number of operands.
class PlanarEvaluation {
public:
    using Bits = BooleanFunction::Bits;

    /// Whether these operands are what this engine is made for.
    static bool is_for(std::span<const Boundary<2>* const> operands) {
        return std::all_of(operands.begin(), operands.end(), [](const Boundary<2>* b) { return b->is_finite; });
    }

    /// Requires: `is_for(operands)`.
    PlanarEvaluation(std::span<const Boundary<2>* const> operands, const BooleanFunction& function,
                     const OperationOptions& options)
        : contacts_(operands, options.progress),
          labels_(contacts_),
          merger_(contacts_.kernel(), contacts_.interner()),
          function_(function),
          options_(options) {
        out_.faces.reserve(contacts_.segments().size());
        for (std::uint32_t i = 0; i < contacts_.operand_count(); ++i) assemble(i);
        sound_ = labels_.is_consistent() && is_balanced();
        if (sound_ && options.progress != nullptr) options.progress->finish();
    }

    /// Whether all that was found out fits together. It does unless an operand intersects itself; there is no result
    /// then.
    [[nodiscard]] bool is_sound() const noexcept { return sound_; }

    /// The result. Requires: `is_sound()`.
    [[nodiscard]] Boundary<2> finish() {
        CLEAVE_REQUIRES(sound_);
        Boundary<2> result =
            freeze(contacts_.kernel(), out_, function_(labels_.far()), [&](PointId p) { return contacts_.place(p); });
        if (options_.counts != nullptr) {
            counts_.kernel = contacts_.kernel().counts();
            counts_.facets = contacts_.segments().size();
            counts_.face_pairs = contacts_.pair_count();
            counts_.points_located = labels_.located();
            *options_.counts = counts_;
        }
        return result;
    }

private:
    /// What happens to a piece.
    enum class Action : std::uint8_t { drop, keep, flip };

    [[nodiscard]] Action action(Bits below, Bits above) const {
        const bool value = function_(below);
        if (function_(above) == value) return Action::drop;
        return value ? Action::keep : Action::flip;
    }

    [[nodiscard]] Action action(std::uint32_t i, const PlanarPiece& p) const {
        const Bits own = Bits(1) << i;
        // A piece that several operands have comes from the first.
        if (((p.same | p.opposite) & (own - 1)) != 0) return Action::drop;
        return action(p.below | own, p.above);
    }

    /// The action for whole segments of operand i inside these others; the last answer is kept, for it hardly changes.
    [[nodiscard]] Action action_inside(std::uint32_t i, Bits others) {
        if (i != last_operand_ || others != last_others_) {
            last_action_ = action(others | Bits(1) << i, others);
            last_operand_ = i;
            last_others_ = others;
        }
        return last_action_;
    }

    void assemble(std::uint32_t i) {
        const FaceList& list = contacts_.boundary(i).faces;
        const std::uint32_t first = contacts_.first_segment(i);
        for (std::uint32_t f = 0; f < list.faces.size(); ++f) {
            const FaceList::Face& face = list.faces[f];
            if (options_.progress != nullptr) options_.progress->advance(face.loop_count);
            const std::size_t cut = next_cut_;
            find_actions(i, first + face.first_loop, first + face.first_loop + face.loop_count);
            counts_.faces_crossed += next_cut_ != cut ? 1U : 0U;
            if (std::adjacent_find(actions_.begin(), actions_.end(), std::not_equal_to<>()) != actions_.end()) {
                merge(i, f, cut, Action::keep);
                merge(i, f, cut, Action::flip);
            } else if (actions_.front() != Action::drop) {
                copy(i, f, actions_.front());
            }
        }
    }

    /// The actions for all pieces of segments of one face, one for a segment that nothing touches.
    void find_actions(std::uint32_t i, std::uint32_t begin, std::uint32_t end) {
        actions_.clear();
        for (std::uint32_t s = begin; s < end; ++s) {
            if (labels_.cuts()[next_cut_].segment == s) {
                for (const PlanarPiece& p : labels_.pieces(next_cut_)) actions_.push_back(action(i, p));
                ++next_cut_;
            } else {
                actions_.push_back(action_inside(i, labels_.at(i, contacts_.segments()[s].from)));
            }
        }
    }

    [[nodiscard]] PlaneId line(std::uint32_t i, std::uint32_t f, Action a) const {
        const PlaneId h = contacts_.loaded(i).plane(contacts_.boundary(i).faces.faces[f].plane);
        return a == Action::flip ? flipped(h) : h;
    }

    void copy(std::uint32_t i, std::uint32_t f, Action a) {
        ++counts_.faces_whole;
        const FaceList::Face& face = contacts_.boundary(i).faces.faces[f];
        out_.begin_face(line(i, f, a), {i, f});
        const std::uint32_t first = contacts_.first_segment(i) + face.first_loop;
        for (std::uint32_t s = first; s < first + face.loop_count; ++s) {
            std::array<Corner, 2> ends{contacts_.corner(s, 0), contacts_.corner(s, 1)};
            if (a == Action::flip) std::swap(ends[0], ends[1]);
            out_.add_loop(ends);
        }
    }

    /// Puts the pieces of face f with one action together, which are those of `actions_`; `cut` is its first segment
    /// that others touch.
    void merge(std::uint32_t i, std::uint32_t f, std::size_t cut, Action a) {
        if (std::find(actions_.begin(), actions_.end(), a) == actions_.end()) return;
        ++counts_.faces_merged;
        const FaceList::Face& face = contacts_.boundary(i).faces.faces[f];
        merger_.begin(line(i, f, a));
        const auto add = [&](Corner from, Corner to) {
            std::array<Corner, 2> ends{from, to};
            if (a == Action::flip) std::swap(ends[0], ends[1]);
            merger_.add(ends);
        };
        std::size_t n = 0;
        const std::uint32_t first = contacts_.first_segment(i) + face.first_loop;
        for (std::uint32_t s = first; s < first + face.loop_count; ++s) {
            const Corner last = contacts_.corner(s, 1);
            Corner from = contacts_.corner(s, 0);
            if (labels_.cuts()[cut].segment != s) {
                if (actions_[n++] == a) add(from, last);
                continue;
            }
            const PlanarSegment& segment = contacts_.segments()[s];
            for (const PlanarPiece& p : labels_.pieces(cut)) {
                const bool inner = p.end_line != no_id;
                const bool is_in = actions_[n++] == a;
                const PlaneId h = inner ? facing(p.end_line, segment.from) : no_id;
                if (is_in) add(from, inner ? Corner{p.end, h} : last);
                if (inner) from = {p.end, flipped(h)};
            }
            ++cut;
        }
        merger_.finish(out_, {i, f});
    }

    /// The line, turned so that the point is on its minus side.
    PlaneId facing(PlaneId h, PointId p) { return contacts_.kernel().side(h, p) == Sign::minus ? h : flipped(h); }

    /// Whether as many segments of the result start as end in each point.
    bool is_balanced() {
        std::vector<std::int32_t> surplus(contacts_.kernel().point_count(), 0);
        for (std::size_t c = 0; c < out_.corners.size(); c += 2) {
            ++surplus[contacts_.place(out_.corners[c].point)];
            --surplus[contacts_.place(out_.corners[c + 1].point)];
        }
        return std::all_of(surplus.begin(), surplus.end(), [](std::int32_t n) { return n == 0; });
    }

    PlanarContacts contacts_;
    PlanarLabels labels_;
    FaceMerger<2> merger_;
    BooleanFunction function_;
    OperationOptions options_;
    std::size_t next_cut_ = 0;
    std::vector<Action> actions_;  // of the pieces of one face
    std::uint32_t last_operand_ = no_id;
    Bits last_others_ = 0;
    Action last_action_ = Action::drop;
    FaceList out_;
    OperationCounts counts_;
    bool sound_ = true;
};

CLEAVE_END_NAMESPACE

#endif

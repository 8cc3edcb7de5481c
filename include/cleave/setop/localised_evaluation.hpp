// SPDX-License-Identifier: Apache-2.0
/// Set operations on bounded boundaries in 3-D whose cost follows where the operands meet.
///
/// A face of the result is a set of directed edges: edges of the input face, and the common segments with faces of
/// other operands. What is on an edge's left follows from where it is: next to a proper crossing the face that crosses
/// tells which side is inside its operand, and along an edge that nothing crosses the answer stays the same, so labels
/// spread over vertices (`LabelForest`) to faces that no other operand touches. Those are copied by index. No plane is
/// ever constructed, and where nothing is crossed no predicate is evaluated.
///
/// Faces that meet others in any special way (coplanar, edge on face, vertex on edge) are left to boundary filtering,
/// which decides each of them by itself; both ways are exact, so their results fit together.
#ifndef CLEAVE_SETOP_LOCALISED_EVALUATION_HPP
#define CLEAVE_SETOP_LOCALISED_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/setop/boundary_filter.hpp>
#include <cleave/setop/face_crossing.hpp>
#include <cleave/setop/label_forest.hpp>
#include <cleave/setop/options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One evaluation: loads the operands into a kernel, finds where they meet, and assembles faces.
template <int D>
requires(D == 3) class LocalisedEvaluation {
public:
    using Bits = BooleanFunction::Bits;

    /// Requires: every boundary is finite (`Boundary::is_finite`).
    LocalisedEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                        const OperationOptions& options)
        : clip_(kernel_),
          points_(kernel_),
          merger_(kernel_, points_),
          crossing_(kernel_),
          function_(function),
          options_(&options) {
        loads_.resize(operands.size());
        for (std::size_t i = 0; i < operands.size(); ++i) {
            CLEAVE_REQUIRES(operands[i]->is_finite);
            loads_[i].boundary = operands[i];
            loads_[i].loaded = load(*operands[i], kernel_);
            loads_[i].state.assign(operands[i]->faces.faces.size(), 0);
            find_boxes(loads_[i]);
        }
        input_points_ = kernel_.point_count();
        // Each pair of operands counts with its faces, and every face once more when it is assembled.
        std::size_t faces = 0;
        for (const Load& o : loads_) faces += o.state.size();
        if (options.progress != nullptr) options.progress->begin("faces", loads_.size() * faces);
        find_crossings();
        spread_labels();
        assemble();
        if (options.progress != nullptr) options.progress->finish();
    }

    Boundary<D> finish() {
        Bits far = 0;
        for (std::size_t i = 0; i < loads_.size(); ++i) far |= Bits(loads_[i].boundary->value_at_infinity ? 1 : 0) << i;
        // Input points are different from each other and from all crossings. Only filtering makes further points, where
        // it cuts faces into convex ones, and those may lie on input points.
        const bool plain = filter_ == nullptr;
        Boundary<D> result = freeze(kernel_, out_, function_(far),
                                    [&](PointId p) { return plain && p < input_points_ ? p : points_(p); });
        if (options_->counts != nullptr) *options_->counts = counts();
        return result;
    }

private:
    static constexpr Bits special = ~Bits(0);

    OperationCounts counts() const {
        OperationCounts c = counts_;
        c.kernel = kernel_.counts();
        if (filter_) c.trees = filter_->counts();
        for (const auto& o : facets_) c.facets += o.facets.size();
        for (const Load& o : loads_)
            for (const Bits state : o.state) {
                c.faces_filtered += state == special || (state & (state - 1)) != 0 ? 1U : 0U;
                c.faces_crossed += state != special && state != 0 ? 1U : 0U;
            }
        return c;
    }

    struct Load {
        const Boundary<D>* boundary = nullptr;
        LoadedBoundary<D> loaded;
        std::vector<Bounds<D>> boxes;  // of faces
        /// For each face the operands that cross it properly, or `special`.
        std::vector<Bits> state;
        std::vector<std::uint32_t> facet_face;  // of each facet, once there are facets
    };

    /// A common segment of a face with a face of another operand: on its left it is inside that operand.
    struct Cut {
        std::uint32_t operand;
        std::uint32_t face;
        PointId from;
        PointId to;
        PlaneId plane;  // of the other face
        std::uint32_t other;
    };

    /// A point where a face of another operand pierces the edge that starts at a corner.
    struct Pierce {
        std::uint32_t operand;
        std::uint32_t corner;
        PointId point;
        PlaneId plane;
        std::uint32_t other;
    };

    // --- where faces meet --------------------------------------------------------------------------------------------

    void find_boxes(Load& o) {
        const FaceList& list = o.boundary->faces;
        o.boxes.resize(list.faces.size());
        for (std::size_t f = 0; f < list.faces.size(); ++f) {
            const FaceList::Face& face = list.faces[f];
            const std::uint32_t last = list.loop_first[face.first_loop + face.loop_count];
            for (std::uint32_t c = list.loop_first[face.first_loop]; c < last; ++c) {
                const PointRecord<D>& r = o.boundary->points[list.corners[c].point];
                o.boxes[f].include(r.approximation, r.error);
            }
        }
    }

    void find_crossings() {
        for (std::uint32_t i = 0; i < loads_.size(); ++i)
            for (std::uint32_t j = i + 1; j < loads_.size(); ++j) find_crossings(i, j);
        const auto by_face = [](const Cut& a, const Cut& b) {
            return std::pair(a.operand, a.face) < std::pair(b.operand, b.face);
        };
        std::stable_sort(cuts_.begin(), cuts_.end(), by_face);
        std::stable_sort(pierces_.begin(), pierces_.end(), [](const Pierce& a, const Pierce& b) {
            return std::pair(a.operand, a.corner) < std::pair(b.operand, b.corner);
        });
        sort_pierces();
    }

    void find_crossings(std::uint32_t i, std::uint32_t j) {
        const std::vector<std::uint32_t> a = faces_near(loads_[i], loads_[j].boundary->bounds);
        const std::vector<std::uint32_t> b = faces_near(loads_[j], loads_[i].boundary->bounds);
        std::size_t units = loads_[i].state.size() + loads_[j].state.size();
        if (!a.empty() && !b.empty()) {
            // The hierarchy of the fewer faces is asked for each of the others.
            const bool ask_a = a.size() >= b.size();
            const std::vector<std::uint32_t>& asked = ask_a ? a : b;
            const std::vector<std::uint32_t>& stored = ask_a ? b : a;
            const BoxHierarchy<D> faces = hierarchy(loads_[ask_a ? j : i], stored);
            for (const std::uint32_t f : asked) {
                faces.for_each_meeting(box_of(loads_[ask_a ? i : j], f), [&](std::size_t n) {
                    meet(i, ask_a ? f : stored[n], j, ask_a ? stored[n] : f);
                });
                advance(1);
                --units;
            }
        }
        advance(units);
    }

    void advance(std::size_t units) {
        if (options_->progress != nullptr) options_->progress->advance(units);
    }

    static std::vector<std::uint32_t> faces_near(const Load& o, const Bounds<D>& box) {
        std::vector<std::uint32_t> near;
        for (std::uint32_t f = 0; f < o.boxes.size(); ++f)
            if (!o.boxes[f].disjoint(box)) near.push_back(f);
        return near;
    }

    static BoxHierarchy<D> hierarchy(const Load& o, const std::vector<std::uint32_t>& faces) {
        std::vector<Box<D>> boxes(faces.size());
        for (std::size_t n = 0; n < faces.size(); ++n) boxes[n] = box_of(o, faces[n]);
        return BoxHierarchy<D>(boxes);
    }

    static Box<D> box_of(const Load& o, std::uint32_t face) {
        Box<D> box;
        box.lo = o.boxes[face].lo;
        box.hi = o.boxes[face].hi;
        return box;
    }

    void meet(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t h) {
        ++counts_.face_pairs;
        if (loads_[i].state[f] == special && loads_[j].state[h] == special) return;
        const LoadedFace<D> a{loads_[i].boundary, &loads_[i].loaded, f};
        const LoadedFace<D> b{loads_[j].boundary, &loads_[j].loaded, h};
        switch (crossing_.meet(a, loads_[i].boxes[f], b, loads_[j].boxes[h])) {
            case FaceMeeting::none:
                return;
            case FaceMeeting::special:
                loads_[i].state[f] = special;
                loads_[j].state[h] = special;
                return;
            case FaceMeeting::crossing:
                break;
        }
        loads_[i].state[f] |= Bits(1) << j;
        loads_[j].state[h] |= Bits(1) << i;
        const std::span<const typename FaceCrossing<D>::End> ends = crossing_.ends();
        for (std::size_t n = 0; n + 1 < ends.size(); n += 2) {
            const PointId p = points_(ends[n].point);
            const PointId q = points_(ends[n + 1].point);
            cuts_.push_back({i, f, p, q, b.plane(), j});
            cuts_.push_back({j, h, q, p, a.plane(), i});
        }
        for (const auto& e : ends) {
            const PointId p = points_(e.point);
            if (e.of_first)
                pierces_.push_back({i, e.corner, p, b.plane(), j});
            else
                pierces_.push_back({j, e.corner, p, a.plane(), i});
        }
    }

    /// Orders the points on each edge from its start.
    void sort_pierces() {
        for (std::size_t n = 0; n < pierces_.size();) {
            std::size_t end = n + 1;
            while (end < pierces_.size() && pierces_[end].operand == pierces_[n].operand &&
                   pierces_[end].corner == pierces_[n].corner)
                ++end;
            if (end - n > 1) {
                const Load& o = loads_[pierces_[n].operand];
                const Corner& c = o.boundary->faces.corners[pierces_[n].corner];
                const PlaneId plane = o.loaded.plane(plane_of_corner(*o.boundary, pierces_[n].corner));
                const AxisDirection d = edge_direction(kernel_, plane, o.loaded.plane(c.edge));
                std::sort(pierces_.begin() + std::ptrdiff_t(n), pierces_.begin() + std::ptrdiff_t(end),
                          [&](const Pierce& a, const Pierce& b) {
                              return a.point != b.point && kernel_.compare(d.axis, b.point, a.point) == d.sign;
                          });
            }
            n = end;
        }
    }

    static PlaneId plane_of_corner(const Boundary<D>& b, std::uint32_t corner) {
        const auto loop = std::upper_bound(b.faces.loop_first.begin(), b.faces.loop_first.end(), corner) - 1 -
                          b.faces.loop_first.begin();
        const auto face = std::upper_bound(b.faces.faces.begin(), b.faces.faces.end(), std::uint32_t(loop),
                                           [](std::uint32_t l, const FaceList::Face& f) { return l < f.first_loop; }) -
                          1;
        return face->plane;
    }

    // --- which operands contain which vertices ----------------------------------------------------------------------

    /// The points on the edge that starts at a corner, in order.
    [[nodiscard]] std::span<const Pierce> on_edge(std::uint32_t operand, std::uint32_t corner) const {
        const auto first = std::lower_bound(pierces_.begin(), pierces_.end(), std::pair(operand, corner),
                                            [](const Pierce& p, const std::pair<std::uint32_t, std::uint32_t>& key) {
                                                return std::pair(p.operand, p.corner) < key;
                                            });
        auto last = first;
        while (last != pierces_.end() && last->operand == operand && last->corner == corner) ++last;
        return {first, last};
    }

    [[nodiscard]] LoadedFace<D> loaded_face(std::uint32_t operand, std::uint32_t face) const {
        return {loads_[operand].boundary, &loads_[operand].loaded, face};
    }

    void spread_labels() {
        labels_ = LabelForest(input_points_);
        for (std::uint32_t i = 0; i < loads_.size(); ++i) {
            const Load& o = loads_[i];
            for (std::uint32_t f = 0; f < o.state.size(); ++f) {
                if (o.state[f] == special) continue;
                loaded_face(i, f).for_each_edge([&](std::uint32_t corner, PointId a, PointId b) {
                    Bits crossed = 0;
                    if (o.state[f] != 0) crossed = learn_from_edge(i, corner, a);
                    if (a != b) labels_.join(a, b, crossed);
                });
            }
        }
    }

    /// What the faces that pierce an edge tell about its start. Returns: the bits in which its end differs from that.
    Bits learn_from_edge(std::uint32_t operand, std::uint32_t corner, PointId start) {
        Bits crossed = 0;
        for (const Pierce& x : on_edge(operand, corner)) {
            const Bits bit = Bits(1) << x.other;
            // Before its first face the edge is inside where the face has it below; the start is on the same side of
            // that face's plane as the stretch before the point, for an edge crosses a plane once.
            if ((crossed & bit) == 0 && (labels_.known(start) & bit) == 0)
                labels_.learn(start, bit, kernel_.side(x.plane, start) == Sign::minus ? bit : 0);
            crossed ^= bit;
        }
        return crossed;
    }

    /// The label of a point on a face that is not special, its own operand's bit left out.
    Bits label_of(std::uint32_t operand, PointId p) {
        const Bits others = all_bits() & ~(Bits(1) << operand);
        const Bits missing = others & ~labels_.known(p);
        for (std::uint32_t j = 0; missing != 0 && j < loads_.size(); ++j) {
            const Bits bit = Bits(1) << j;
            if ((missing & bit) == 0) continue;
            labels_.learn(p, bit, filter().contains(j, p) ? bit : 0);
            ++counts_.points_located;
        }
        return labels_.label(p) & others;
    }

    [[nodiscard]] Bits all_bits() const noexcept {
        return loads_.size() == 64 ? ~Bits(0) : (Bits(1) << loads_.size()) - 1;
    }

    // --- special faces
    // ------------------------------------------------------------------------------------------------

    /// Boundary filtering of the same operands, made when first needed.
    BoundaryFilter<KernelClip<D>>& filter() {
        if (filter_) return *filter_;
        for (Load& o : loads_) {
            LoadedFacets<D> facets = make_facets(*o.boundary, o.loaded, clip_, points_);
            o.facet_face = std::move(facets.face);
            facets_.push_back({std::move(facets.facets), o.boundary->value_at_infinity});
        }
        filter_ = std::make_unique<BoundaryFilter<KernelClip<D>>>(clip_, facets_, function_);
        return *filter_;
    }

    void assemble_special(std::uint32_t i, std::uint32_t f) {
        BoundaryFilter<KernelClip<D>>& by_trees = filter();
        const std::vector<std::uint32_t>& face_of = loads_[i].facet_face;
        const auto [first, last] = std::equal_range(face_of.begin(), face_of.end(), f);
        pieces_.clear();
        std::size_t whole[2] = {0, 0};
        for (auto at = first; at != last; ++at)
            by_trees.filter_facet(
                i, std::size_t(at - face_of.begin()),
                [&](std::size_t, std::size_t, Action action, const KernelFacet<D>& piece, bool is_whole) {
                    pieces_.push_back({piece, action});
                    whole[action == Action::flip ? 1 : 0] += is_whole ? 1 : 0;
                });
        const auto all = std::size_t(last - first);
        if (whole[0] == all) return copy_face(i, f, Action::keep);
        if (whole[1] == all) return copy_face(i, f, Action::flip);
        for (const Action action : {Action::keep, Action::flip}) {
            merger_.begin(oriented(i, f, action));
            for (const auto& [piece, its_action] : pieces_) {
                if (its_action != action) continue;
                const auto corners = clip_.corners(piece);
                loop_.assign(corners.begin(), corners.end());
                if (action == Action::flip) reverse_loop<D>(loop_);
                merger_.add(loop_);
            }
            finish_face(i, f);
        }
    }

    // --- results
    // ------------------------------------------------------------------------------------------------------

    /// What becomes of a piece of operand i's boundary that is in the operands `others`.
    [[nodiscard]] Action action(std::uint32_t i, Bits others) const {
        const bool below = function_(others | Bits(1) << i);
        if (function_(others) == below) return Action::drop;
        return below ? Action::keep : Action::flip;
    }

    [[nodiscard]] PlaneId oriented(std::uint32_t i, std::uint32_t f, Action action) const {
        const PlaneId plane = loaded_face(i, f).plane();
        return action == Action::flip ? flipped(plane) : plane;
    }

    void assemble() {
        std::size_t cut = 0;
        for (std::uint32_t i = 0; i < loads_.size(); ++i) {
            for (std::uint32_t f = 0; f < loads_[i].state.size(); ++f) {
                advance(1);
                const std::size_t first = cut;
                while (cut < cuts_.size() && cuts_[cut].operand == i && cuts_[cut].face == f) ++cut;
                const Bits state = loads_[i].state[f];
                if (state == special || (state & (state - 1)) != 0)
                    assemble_special(i, f);
                else
                    assemble_plain(i, f, std::span(cuts_).subspan(first, cut - first));
            }
        }
    }

    /// A face that at most one other operand crosses, and properly.
    void assemble_plain(std::uint32_t i, std::uint32_t f, std::span<const Cut> cuts) {
        edges_.clear();
        Bits elsewhere = 0;  // the operands around the face that do not cross it
        bool is_first = true;
        bool one_piece = true;  // the face is, as far as those operands can tell
        bool same = true;       // all edges have the action `only`
        Action only = Action::drop;
        const Bits crossing = loads_[i].state[f];
        loaded_face(i, f).for_each_edge([&](std::uint32_t corner, PointId a, PointId b) {
            Bits label = label_of(i, a);
            if (is_first) elsewhere = label & ~crossing;
            one_piece = one_piece && (label & ~crossing) == elsewhere;
            is_first = false;
            const PlaneId e = loads_[i].loaded.plane(loads_[i].boundary->faces.corners[corner].edge);
            const auto add = [&](PointId p, PointId q) {
                const Action what = action(i, label);
                if (edges_.empty()) only = what;
                same = same && what == only;
                if (p != q) edges_.push_back({p, q, e, what});
            };
            PointId from = a;
            if (crossing != 0) {
                for (const Pierce& x : on_edge(i, corner)) {
                    add(from, x.point);
                    label ^= Bits(1) << x.other;
                    from = x.point;
                }
            }
            add(from, b);
        });
        // Parts of a face in several pieces may be in different operands; which cut is in which is not known then.
        if (!one_piece && !cuts.empty()) return assemble_special(i, f);
        if (!cuts.empty()) {
            const Action inside = action(i, elsewhere | crossing);
            const Action outside = action(i, elsewhere);
            same = same && inside == outside;
            if (inside != outside)
                for (const Cut& c : cuts) {
                    edges_.push_back({c.from, c.to, c.plane, inside});
                    edges_.push_back({c.to, c.from, flipped(c.plane), outside});
                }
        }
        if (same) {
            if (only != Action::drop) copy_face(i, f, only);
            return;
        }
        for (const Action what : {Action::keep, Action::flip}) {
            merger_.begin(oriented(i, f, what));
            for (const DirectedEdge& e : edges_) {
                if (e.action != what) continue;
                if (what == Action::keep)
                    merger_.add_edge(e.from, e.to, e.plane);
                else
                    merger_.add_edge(e.to, e.from, e.plane);
            }
            finish_face(i, f);
        }
    }

    void finish_face(std::uint32_t i, std::uint32_t f) {
        const std::size_t before = out_.faces.size();
        merger_.finish(out_, {i, f});
        counts_.faces_merged += out_.faces.size() - before;
    }

    void copy_face(std::uint32_t i, std::uint32_t f, Action action) {
        ++counts_.faces_whole;
        const FaceList& list = loads_[i].boundary->faces;
        const FaceList::Face& face = list.faces[f];
        out_.begin_face(oriented(i, f, action), {i, f});
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            loop_.clear();
            for (const Corner& c : list.loop(l)) loop_.push_back(loads_[i].loaded.corner(c));
            if (action == Action::flip) reverse_loop<D>(loop_);
            out_.add_loop(loop_);
        }
    }

    struct DirectedEdge {
        PointId from;
        PointId to;
        PlaneId plane;
        Action action;
    };

    Kernel<D> kernel_;
    KernelClip<D> clip_;
    PointInterner<D> points_;
    FaceMerger<D> merger_;
    FaceCrossing<D> crossing_;
    BooleanFunction function_;
    const OperationOptions* options_;
    std::vector<Load> loads_;
    std::vector<Cut> cuts_;
    std::vector<Pierce> pierces_;
    LabelForest labels_{0};
    std::vector<FilterOperand<KernelFacet<D>>> facets_;
    std::unique_ptr<BoundaryFilter<KernelClip<D>>> filter_;
    std::vector<std::pair<KernelFacet<D>, Action>> pieces_;
    std::vector<DirectedEdge> edges_;
    std::vector<Corner> loop_;
    FaceList out_;
    OperationCounts counts_;
    std::size_t input_points_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

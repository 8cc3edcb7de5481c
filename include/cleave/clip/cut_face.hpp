// SPDX-License-Identifier: Apache-2.0
/// Cutting a face (a polygon with holes, several polygons, touching loops) into convex facets along lines of its edges.
///
/// The algorithm knows points, planes and three operations on them (`FaceClip`), so it serves values and indices alike.
/// It is binary partition one dimension down, on edges instead of facets:
///
/// 1. If every vertex has one edge in and one out, and no vertex is reflex, each loop is a convex facet.
/// 2. Otherwise take the plane h of an edge at a reflex or shared vertex, and cut everything by it. Edges go to the
///    minus or plus part; an edge that crosses h is divided at the meet of the face, its own plane and h.
/// 3. The boundary of the two parts *on* h is not cut out of edges but swept: walking along h, the two bits (inside
/// just
///    below h, inside just above h) change where an edge leaves h to that side, and both change where one crosses h.
///    Stretches with the lower bit set are edges of the minus part, with the upper bit of the plus part.
///
/// Step 3 uses no edge that lies in h: those follow from the rest. This is what makes degenerate input harmless: slits
/// and bridges run twice, collinear overlaps and vertices that touch an edge need no case of their own. (The two bits
/// are the tags of Laidlaw, Trumbore and Hughes 1986 and of Eberly's polysolids, one dimension down.)
///
/// There is no universe box: parts are bounded by their own edges from the start. Every cut is along an edge of the
/// face, so every new vertex is the meet of the face's plane and the planes of two of its edges, and numbers stay as
/// short as the input makes them. A part never meets the line of h again, so the depth is at most the number of lines.
#ifndef CLEAVE_CLIP_CUT_FACE_HPP
#define CLEAVE_CLIP_CUT_FACE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/sign.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

// clang-format off
/// What cutting a face asks of a model:
///
/// | expression                    | result | meaning                                                               |
/// |-------------------------------|--------|-----------------------------------------------------------------------|
/// | `m.side(h, p)`                | `Sign` | the side of plane h on which p lies                                   |
/// | `m.compare(p, q)`             | `Sign` | a total order of points that is an order along every line             |
/// | `m.cross(h, face, edge, a, b)`| point  | where h crosses the edge from a to b, which lies on `face` and `edge` |
/// | `m.flip_plane(h)`             | plane  | the same plane, other orientation                                     |
template <class M>
concept FaceClip = requires(M& m, const typename M::plane_type& h, const typename M::point_type& p) {
    requires std::copyable<typename M::plane_type>;
    requires std::copyable<typename M::point_type>;
    { m.side(h, p) } -> std::same_as<Sign>;
    { m.compare(p, p) } -> std::same_as<Sign>;
    { m.cross(h, h, h, p, p) } -> std::convertible_to<typename M::point_type>;
    { m.flip_plane(h) } -> std::convertible_to<typename M::plane_type>;
};
// clang-format on

/// Takes the loops of one face and cuts it.
template <FaceClip M>
class FaceCutter {
public:
    using point_type = typename M::point_type;
    using plane_type = typename M::plane_type;

    /// Starts a face on the given plane.
    FaceCutter(M& model, plane_type face) : model_(&model), face_(std::move(face)) {}

    /// Adds a loop of corners `c`, each a `c.point` and the plane `c.edge` of the edge from there to the next corner: a
    /// plane other than the face's, with the face locally on its minus side. The face is on the left of the way round
    /// as seen from outside, so holes run clockwise. Edges of length zero are ignored.
    template <class Corners>
    void add_loop(const Corners& corners) {
        const auto old = static_cast<Index>(points_.size());
        const std::size_t n = std::size(corners);
        for (std::size_t i = 0; i < n; ++i) {
            if (model_->compare(corners[i].point, corners[i + 1 == n ? 0 : i + 1].point) == Sign::zero) continue;
            const Index at = add_point(corners[i].point);
            input_.push_back({at, at + 1, add_plane(corners[i].edge), false});
        }
        if (points_.size() == old) return;
        input_.back().end = old;
        ++loops_;
    }

    /// Cuts the face and calls `emit(corners)` with a span of (point, edge plane) pairs for each convex facet: its
    /// loop, in outward order. Vertices in the middle of a side are kept where no cut went along that side. Requires:
    /// the loops are the whole boundary of a set of points of the plane, and their edges do not cross (they may touch,
    /// and may run twice, there and back). Call it once. Cost: n side tests and comparisons for one convex loop, which
    /// is not cut. Otherwise O(n log n) comparisons, and about 7 n side tests for each level of cuts; there are log n
    /// levels on ordinary input, and n at worst.
    template <class Emit>
    void cut(Emit&& emit) {
        std::vector<std::vector<Edge>> stack;
        if (loops_ == 1 && is_convex(input_)) {
            link(input_);
            emit_loops(input_, emit);
        } else {
            unify_points();
            cancel_bridges();
            stack.push_back(std::move(input_));
        }
        while (!stack.empty()) {
            const std::vector<Edge> part = std::move(stack.back());
            stack.pop_back();
            if (part.empty()) continue;
            link(part);
            find_doubtful(part);
            if (doubtful_.empty()) {
                emit_loops(part, emit);
            } else if (const Edge* cutter = choose_cutter(part); cutter != nullptr) {
                std::vector<Edge> minus;
                std::vector<Edge> plus;
                divide(part, *cutter, minus, plus);
                stack.push_back(std::move(plus));
                stack.push_back(std::move(minus));
            }
        }
    }

private:
    /// An index into `points_` or `planes_`.
    using Index = std::uint32_t;
    static constexpr Index none = std::numeric_limits<Index>::max();
    static constexpr std::size_t candidates = 5;
    static constexpr std::size_t useless = std::numeric_limits<std::size_t>::max();

    struct Edge {
        Index begin;
        Index end;
        Index plane;
        bool swept;  // made by a sweep along its line: no other edge of the part overlaps it
    };

    /// A place on the line of a cut where the two bits change.
    struct Event {
        Index point;
        unsigned bits;  // 1: inside just below, 2: inside just above
    };

    Index add_point(const point_type& p) {
        points_.push_back(p);
        return static_cast<Index>(points_.size() - 1);
    }
    Index add_plane(const plane_type& h) {
        planes_.push_back(h);
        return static_cast<Index>(planes_.size() - 1);
    }

    /// Sorts the points and gives equal ones one index, so that from here on sameness and order are those of integers.
    void unify_points() {
        std::vector<Index> order(points_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
        std::sort(order.begin(), order.end(),
                  [this](Index a, Index b) { return model_->compare(points_[a], points_[b]) == Sign::minus; });
        std::vector<Index> rank(points_.size());
        std::vector<point_type> distinct;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || model_->compare(points_[order[i - 1]], points_[order[i]]) != Sign::zero) {
                distinct.push_back(points_[order[i]]);
            }
            rank[order[i]] = static_cast<Index>(distinct.size() - 1);
        }
        points_ = std::move(distinct);
        sorted_ = static_cast<Index>(points_.size());
        for (Edge& e : input_) {
            e.begin = rank[e.begin];
            e.end = rank[e.end];
        }
    }

    /// Drops edges that run there and back, such as the bridges by which a polygon's outline reaches its holes. The
    /// cuts would do it too, at the price of some cuts along bridges.
    void cancel_bridges() {
        const auto key = [](const Edge& e) { return std::pair(std::min(e.begin, e.end), std::max(e.begin, e.end)); };
        std::vector<Index> order(input_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
        std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return key(input_[i]) < key(input_[j]); });
        std::vector<Index> open;  // edges alike so far, all in one direction
        for (const Index i : order) {
            const Edge& e = input_[i];
            if (!open.empty() && key(input_[open.back()]) != key(e)) open.clear();
            if (!open.empty() && input_[open.back()].begin == e.end) {
                input_[open.back()].begin = none;
                open.pop_back();
                input_[i].begin = none;
            } else {
                open.push_back(i);
            }
        }
        std::erase_if(input_, [](const Edge& e) { return e.begin == none; });
    }

    [[nodiscard]] bool before(Index a, Index b) const {
        if (a < sorted_ && b < sorted_) return a < b;
        return a != b && model_->compare(points_[a], points_[b]) == Sign::minus;
    }

    /// Fills the tables of the part's vertices: the edge that starts there, and how many end and start.
    void link(const std::vector<Edge>& part) {
        outgoing_.resize(points_.size(), none);
        degrees_.resize(points_.size());
        signs_.resize(points_.size());
        for (const Edge& e : part) degrees_[e.begin] = degrees_[e.end] = {0, 0};
        for (std::size_t i = 0; i < part.size(); ++i) {
            outgoing_[part[i].begin] = static_cast<Index>(i);
            ++degrees_[part[i].begin].second;
            ++degrees_[part[i].end].first;
        }
    }

    [[nodiscard]] bool is_shared(Index p) const { return degrees_[p] != std::pair<std::uint32_t, std::uint32_t>(1, 1); }

    /// Whether the way turns right, or right back, from one edge into the next.
    [[nodiscard]] bool is_reflex(const Edge& in, const Edge& out) const {
        switch (model_->side(planes_[in.plane], points_[out.end])) {
            case Sign::minus:
                return false;
            case Sign::plus:
                return true;
            case Sign::zero:
                break;
        }
        return before(in.begin, in.end) != before(out.begin, out.end);
    }

    /// Whether a single loop, given in order, is convex: it never turns right, and runs round once (it goes up and down
    /// once in the order of points).
    [[nodiscard]] bool is_convex(const std::vector<Edge>& loop) const {
        std::size_t reversals = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Edge& e = loop[i];
            const Edge& next = loop[i + 1 == loop.size() ? 0 : i + 1];
            if (is_reflex(e, next)) return false;
            if (before(e.begin, e.end) != before(next.begin, next.end)) ++reversals;
        }
        return reversals == 2;
    }

    /// Lists the edges at reflex and shared vertices.
    void find_doubtful(const std::vector<Edge>& part) {
        doubtful_.clear();
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Edge& e = part[i];
            if (is_shared(e.begin) || is_shared(e.end)) {
                doubtful_.push_back(static_cast<Index>(i));
            }
            if (!is_shared(e.end) && is_reflex(e, part[outgoing_[e.end]])) {
                doubtful_.push_back(static_cast<Index>(i));
                doubtful_.push_back(outgoing_[e.end]);
            }
        }
    }

    /// The edge whose line is to cut the part: among some doubtful ones the one that divides the fewest others, since
    /// every edge divided is a facet more; and of these the most balanced, for the sake of depth.
    const Edge* choose_cutter(const std::vector<Edge>& part) {
        const Edge* best = nullptr;
        std::size_t best_cost = useless;
        // Spread over the loops; more are looked at only while none is of use. An odd step, since the list is made of
        // pairs and would otherwise show only one side of each corner.
        const std::size_t step = (doubtful_.size() / candidates) | 1U;
        for (std::size_t start = 0; start < step && best == nullptr; ++start) {
            for (std::size_t i = start; i < doubtful_.size(); i += step) {
                const Edge& e = part[doubtful_[i]];
                const std::size_t cost = cost_of(part, e);
                if (cost < best_cost) {
                    best = &e;
                    best_cost = cost;
                }
            }
        }
        // Lines that have everything inside, each with its edges swept, do not meet in a reflex or shared vertex.
        CLEAVE_ASSERT(best != nullptr);
        return best;
    }

    /// Fewer is better; `useless` where cutting by the edge would change nothing.
    [[nodiscard]] std::size_t cost_of(const std::vector<Edge>& part, const Edge& e) {
        take_signs(part, e);
        std::size_t minus = 0;
        std::size_t plus = 0;
        std::size_t crossing = 0;
        for (const Edge& f : part) {
            const Sign a = signs_[f.begin];
            const Sign b = signs_[f.end];
            if (a * b == Sign::minus)
                ++crossing;
            else if (a == Sign::minus || b == Sign::minus)
                ++minus;
            else if (a == Sign::plus || b == Sign::plus)
                ++plus;
        }
        if (plus == 0 && crossing == 0) return e.swept ? useless : useless - 1;  // at best it tidies up its line
        return (part.size() + 1) * crossing + (minus < plus ? plus - minus : minus - plus);
    }

    void take_signs(const std::vector<Edge>& part, const Edge& cutter) {
        const plane_type& h = planes_[cutter.plane];
        for (const Edge& e : part) signs_[e.begin] = model_->side(h, points_[e.begin]);
        for (const Edge& e : part) {
            // Only in loops that were not given with the face on their left.
            if (degrees_[e.end].second == 0) signs_[e.end] = model_->side(h, points_[e.end]);
        }
    }

    void divide(const std::vector<Edge>& part, const Edge& cutter, std::vector<Edge>& minus, std::vector<Edge>& plus) {
        take_signs(part, cutter);
        events_.clear();
        renamed_from_ = static_cast<Index>(points_.size());
        struct Crossing {
            Edge edge;
            Index point;
        };
        std::vector<Crossing> crossings;
        for (const Edge& e : part) {
            const Sign a = signs_[e.begin];
            const Sign b = signs_[e.end];
            if (a == Sign::zero && b == Sign::zero) continue;  // on the line: the sweep makes it anew
            if (a * b == Sign::minus) {
                const Index x = add_point(
                    model_->cross(planes_[cutter.plane], face_, planes_[e.plane], points_[e.begin], points_[e.end]));
                events_.push_back({x, 3});
                crossings.push_back({e, x});
                continue;
            }
            const bool below = a == Sign::minus || b == Sign::minus;
            (below ? minus : plus).push_back(e);
            if (a == Sign::zero) events_.push_back({e.begin, below ? 1U : 2U});
            if (b == Sign::zero) events_.push_back({e.end, below ? 1U : 2U});
        }
        merge_events();
        for (const Crossing& c : crossings) {
            // A vertex that touches this edge on the line has the same place: the older index is the point's.
            const Index x = renamed_[c.point - renamed_from_];
            const bool upward = signs_[c.edge.begin] == Sign::minus;
            (upward ? minus : plus).push_back({c.edge.begin, x, c.edge.plane, c.edge.swept});
            (upward ? plus : minus).push_back({x, c.edge.end, c.edge.plane, c.edge.swept});
        }
        sweep(cutter, minus, plus);
    }

    /// Sorts the events along the line and adds up those at one place. New points get the name of an old one there.
    void merge_events() {
        std::sort(events_.begin(), events_.end(), [this](const Event& a, const Event& b) {
            if (a.point == b.point) return false;
            return before(a.point, b.point) || (!before(b.point, a.point) && a.point < b.point);
        });
        renamed_.assign(points_.size() - renamed_from_, none);
        std::size_t n = 0;
        for (const Event& e : events_) {
            const bool repeated = n != 0 && !before(events_[n - 1].point, e.point);
            const Index name = repeated ? events_[n - 1].point : e.point;
            if (e.point >= renamed_from_) renamed_[e.point - renamed_from_] = name;
            if (repeated) {
                events_[n - 1].bits ^= e.bits;
            } else {
                events_[n++] = e;
            }
        }
        events_.resize(n);
    }

    /// Turns the bits along the line into edges of the two parts. The cutter has the minus part on its left.
    void sweep(const Edge& cutter, std::vector<Edge>& minus, std::vector<Edge>& plus) {
        const bool ascending = before(cutter.begin, cutter.end);
        const Index plane = cutter.plane;
        const Index flipped = add_plane(model_->flip_plane(planes_[plane]));
        Index minus_from = none;
        Index plus_from = none;
        const auto toggle = [](Index& from, Index at, bool forward, Index h, std::vector<Edge>& edges) {
            if (from == none) {
                from = at;
                return;
            }
            edges.push_back(forward ? Edge{from, at, h, true} : Edge{at, from, h, true});
            from = none;
        };
        for (const Event& e : events_) {
            if ((e.bits & 1U) != 0) toggle(minus_from, e.point, ascending, plane, minus);
            if ((e.bits & 2U) != 0) toggle(plus_from, e.point, !ascending, flipped, plus);
        }
        CLEAVE_ASSERT(minus_from == none && plus_from == none);  // loops are closed, and the sweep keeps them so
    }

    template <class Emit>
    void emit_loops(const std::vector<Edge>& part, Emit&& emit) {
        for (const Edge& first : part) {
            if (degrees_[first.begin].second == 0) continue;  // of a loop that is out already
            corners_.clear();
            for (const Edge* e = &first; degrees_[e->begin].second != 0; e = &part[outgoing_[e->end]]) {
                degrees_[e->begin].second = 0;
                corners_.emplace_back(points_[e->begin], planes_[e->plane]);
            }
            emit(std::span<const std::pair<point_type, plane_type>>(corners_));
        }
    }

    M* model_;
    plane_type face_;
    std::vector<point_type> points_;
    std::vector<plane_type> planes_;
    std::vector<Edge> input_;
    std::size_t loops_ = 0;
    Index sorted_ = 0;  // points before this one have indices in the model's order

    // Scratch, indexed by point and valid for the vertices of the part at hand.
    std::vector<Index> outgoing_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> degrees_;  // edges that end, edges that start
    std::vector<Sign> signs_;

    std::vector<Index> doubtful_;
    std::vector<Event> events_;
    std::vector<Index> renamed_;
    Index renamed_from_ = 0;  // points from here on are of the cut at hand
    std::vector<std::pair<point_type, plane_type>> corners_;
};

CLEAVE_END_NAMESPACE

#endif

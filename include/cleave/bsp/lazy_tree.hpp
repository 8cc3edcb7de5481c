// SPDX-License-Identifier: Apache-2.0
/// A BSP tree that is built only where something reaches it, and the filter that sends facets through it.
///
/// The tree of a closed boundary answers, for a facet of another operand, which parts lie outside, inside, or on the
/// boundary (facing the same way or the opposite way). A subtree is built when the first piece or point arrives; a
/// piece whose box meets no facet below a node is not split further but located by one of its points. Leaf labels are
/// never guessed: a cut that carries no facet (a structural cut) is only made where both sides receive facets.
///
/// Thibault and Naylor, "Set operations on polyhedra using binary space partitioning trees", SIGGRAPH 1987.
#ifndef CLEAVE_BSP_LAZY_TREE_HPP
#define CLEAVE_BSP_LAZY_TREE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/concepts.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Where a piece of one operand's boundary lies with respect to another operand: in its exterior, in its interior, or
/// on its boundary facing the same or the opposite way.
enum class Coverage : std::uint8_t { outside, inside, same, opposite };

/// The splits of one facet: a binary tree whose leaves are the pieces. Children are created together.
template <class Facet>
struct PieceTree {
    struct Piece {
        Facet facet;
        std::uint32_t children = 0;  ///< index of the minus child, the plus child follows; 0: a leaf
        Coverage coverage = Coverage::outside;
    };
    std::vector<Piece> pieces;

    void reset(const Facet& f) {
        pieces.clear();
        pieces.push_back({f, 0, Coverage::outside});
    }
};

/// What a tree had to do.
struct LazyTreeCounts {
    std::uint64_t nodes = 0;         ///< cuts made
    std::uint64_t facet_splits = 0;  ///< facets of the tree's own boundary split while building
    std::uint64_t piece_splits = 0;  ///< facets of other operands split while filtering
    std::uint64_t located = 0;       ///< pieces decided by one point
};

/// The lazily built tree of one closed boundary. The model is used by reference and must outlive the tree.
/// Requires of the facets: together they are the whole boundary of a regular set, each facing outward.
template <Clip M>
class LazyTree {
public:
    using Facet = typename M::facet_type;
    using Plane = typename M::plane_type;

    /// `everywhere`: whether a point belongs to the set when there is no facet at all.
    LazyTree(M& model, std::vector<Facet> facets, bool everywhere) : model_(&model) {
        nodes_.push_back({});
        if (facets.empty())
            nodes_[0].state = everywhere ? State::inside : State::outside;
        else
            set_pending(0, std::move(facets));
    }

    [[nodiscard]] const LazyTreeCounts& counts() const noexcept { return counts_; }

    /// Splits the leaf `piece` of `pieces` as needed and gives each leaf below it its coverage.
    void classify(PieceTree<Facet>& pieces, std::uint32_t piece_index = 0) {
        work_.clear();
        work_.push_back({piece_index, 0});
        while (!work_.empty()) {
            const auto [piece, node] = work_.back();
            work_.pop_back();
            step(pieces, piece, node);
        }
    }

    /// Whether a point that lies on no facet belongs to the set.
    template <class Point>
    bool contains(const Point& p) requires LocatingClip<M> {
        return locate(p, 0);
    }

private:
    enum class State : std::uint8_t { pending, cut, outside, inside };

    struct NoBox {};
    template <class Model>
    struct BoxOf {
        using type = NoBox;
    };
    template <BoundedClip Model>
    struct BoxOf<Model> {
        using type = typename Model::box_type;
    };

    struct Node {
        State state = State::pending;
        std::optional<Plane> plane;
        std::uint32_t minus = 0;        // the plus child follows
        std::vector<Facet> facets;      // pending: all; cut: those on the plane
        typename BoxOf<M>::type box{};  // of every facet below
    };

    struct Task {
        std::uint32_t piece;
        std::uint32_t node;
    };

    /// Lists this short are cut by facets; longer ones by structural planes where the model knows a good one.
    static constexpr std::size_t structural_above = 24;
    static constexpr std::size_t pivot_candidates = 4;

    void set_pending(std::uint32_t node, std::vector<Facet> facets) {
        Node& n = nodes_[node];
        n.state = State::pending;
        if constexpr (BoundedClip<M>) {
            n.box = model_->box(facets.front());
            for (const Facet& f : facets) n.box = model_->hull(n.box, model_->box(f));
        }
        n.facets = std::move(facets);
    }

    void step(PieceTree<Facet>& pieces, std::uint32_t piece, std::uint32_t node) {
        for (;;) {
            if (nodes_[node].state == State::outside || nodes_[node].state == State::inside) {
                settle(pieces, piece, nodes_[node].state == State::inside);
                return;
            }
            if constexpr (BoundedClip<M> && LocatingClip<M>) {
                const Facet& f = pieces.pieces[piece].facet;
                if (model_->disjoint(model_->box(f), nodes_[node].box)) {
                    ++counts_.located;
                    settle(pieces, piece, locate(model_->witness(f), node));
                    return;
                }
            }
            expand(node);
            const Plane& h = *nodes_[node].plane;
            switch (model_->side(h, pieces.pieces[piece].facet)) {
                case FacetSide::minus:
                    node = nodes_[node].minus;
                    break;
                case FacetSide::plus:
                    node = nodes_[node].minus + 1;
                    break;
                case FacetSide::crossing: {
                    ++counts_.piece_splits;
                    const std::uint32_t children = divide(pieces, piece, h);
                    work_.push_back({children + 1, nodes_[node].minus + 1});
                    piece = children;
                    node = nodes_[node].minus;
                    break;
                }
                case FacetSide::on_same:
                case FacetSide::on_opposite:
                    cover(pieces, piece, node);
                    return;
            }
        }
    }

    static void settle(PieceTree<Facet>& pieces, std::uint32_t piece, bool inside) {
        pieces.pieces[piece].coverage = inside ? Coverage::inside : Coverage::outside;
    }

    std::uint32_t divide(PieceTree<Facet>& pieces, std::uint32_t piece, const Plane& h) {
        const Facet facet = pieces.pieces[piece].facet;
        Split<Facet> parts = model_->split(h, facet);
        const auto children = static_cast<std::uint32_t>(pieces.pieces.size());
        pieces.pieces[piece].children = children;
        pieces.pieces.push_back({std::move(*parts.minus), 0, Coverage::outside});
        pieces.pieces.push_back({std::move(*parts.plus), 0, Coverage::outside});
        return children;
    }

    /// The piece lies in the node's plane. What the node's facets cover is same or opposite; the rest has the same
    /// label on both of its sides, so it is sent down one of them.
    void cover(PieceTree<Facet>& pieces, std::uint32_t piece, std::uint32_t node) {
        remainder_.assign(1, piece);
        for (std::size_t g = 0; g < nodes_[node].facets.size() && !remainder_.empty(); ++g) {
            const Facet facet = nodes_[node].facets[g];
            const auto ridges = model_->ridges(facet);
            next_.clear();
            for (std::uint32_t part : remainder_) {
                if constexpr (BoundedClip<M>) {
                    if (model_->disjoint(model_->box(pieces.pieces[part].facet), model_->box(facet))) {
                        next_.push_back(part);
                        continue;
                    }
                }
                if (clip_to(pieces, part, ridges))
                    pieces.pieces[part].coverage =
                        model_->side(model_->plane_of(facet), pieces.pieces[part].facet) == FacetSide::on_same
                            ? Coverage::same
                            : Coverage::opposite;
            }
            remainder_.swap(next_);
        }
        const std::uint32_t minus = nodes_[node].minus;
        const bool minus_is_leaf = nodes_[minus].state == State::outside || nodes_[minus].state == State::inside;
        for (const std::uint32_t part : remainder_) work_.push_back({part, minus_is_leaf ? minus : minus + 1});
    }

    /// Cuts `part` by the ridge planes; the outer parts go to `next_`. Returns whether an inner part remains, which
    /// `part` then is.
    template <class Ridges>
    bool clip_to(PieceTree<Facet>& pieces, std::uint32_t& part, const Ridges& ridges) {
        for (const Plane& e : ridges) {
            switch (model_->side(e, pieces.pieces[part].facet)) {
                case FacetSide::crossing: {
                    ++counts_.piece_splits;
                    const std::uint32_t children = divide(pieces, part, e);
                    next_.push_back(children + 1);
                    part = children;
                    break;
                }
                case FacetSide::plus:
                    next_.push_back(part);
                    return false;
                default:
                    break;
            }
        }
        return true;
    }

    template <class Point>
    bool locate(const Point& p, std::uint32_t node) {
        for (;;) {
            switch (nodes_[node].state) {
                case State::outside:
                    return false;
                case State::inside:
                    return true;
                case State::pending:
                    expand(node);
                    break;
                case State::cut:
                    break;
            }
            // On the cut but on no facet: both sides agree near p, and both children reach p.
            node = nodes_[node].minus + (model_->side(*nodes_[node].plane, p) == Sign::plus ? 1U : 0U);
        }
    }

    void expand(std::uint32_t node) {
        if (nodes_[node].state != State::pending) return;
        ++counts_.nodes;
        std::vector<Facet> facets = std::move(nodes_[node].facets);
        const Plane h = choose(facets);
        std::vector<Facet> minus;
        std::vector<Facet> plus;
        std::vector<Facet> on;
        for (Facet& f : facets) {
            switch (model_->side(h, f)) {
                case FacetSide::minus:
                    minus.push_back(std::move(f));
                    break;
                case FacetSide::plus:
                    plus.push_back(std::move(f));
                    break;
                case FacetSide::crossing: {
                    ++counts_.facet_splits;
                    Split<Facet> parts = model_->split(h, f);
                    minus.push_back(std::move(*parts.minus));
                    plus.push_back(std::move(*parts.plus));
                    break;
                }
                default:
                    on.push_back(std::move(f));
                    break;
            }
        }
        // With nothing on the cut both sides hold facets; otherwise the first facet on it colours an empty side.
        CLEAVE_ASSERT(!on.empty() || (!minus.empty() && !plus.empty()));
        const bool same = !on.empty() && model_->side(h, on.front()) == FacetSide::on_same;
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        nodes_.emplace_back();
        nodes_[node].state = State::cut;
        nodes_[node].plane = h;
        nodes_[node].minus = children;
        nodes_[node].facets = std::move(on);
        fill(children, std::move(minus), same);
        fill(children + 1, std::move(plus), !same);
    }

    void fill(std::uint32_t node, std::vector<Facet> facets, bool inside_if_empty) {
        if (facets.empty())
            nodes_[node].state = inside_if_empty ? State::inside : State::outside;
        else
            set_pending(node, std::move(facets));
    }

    Plane choose(const std::vector<Facet>& facets) {
        if constexpr (ProposingClip<M>) {
            if (facets.size() > structural_above)
                if (std::optional<Plane> h = model_->propose(std::span<const Facet>(facets))) return *h;
        }
        if (facets.size() == 1) return model_->plane_of(facets.front());
        const std::size_t n = facets.size();
        const std::size_t candidates = n < pivot_candidates ? n : pivot_candidates;
        std::size_t best = 0;
        std::size_t best_cost = ~std::size_t(0);
        for (std::size_t c = 0; c < candidates; ++c) {
            const std::size_t at = c * n / candidates;
            const Plane h = model_->plane_of(facets[at]);
            std::size_t minus = 0;
            std::size_t plus = 0;
            std::size_t crossing = 0;
            for (const Facet& f : facets) {
                switch (model_->side(h, f)) {
                    case FacetSide::minus:
                        ++minus;
                        break;
                    case FacetSide::plus:
                        ++plus;
                        break;
                    case FacetSide::crossing:
                        ++crossing;
                        break;
                    default:
                        break;
                }
            }
            const std::size_t cost = 8 * crossing + (minus > plus ? minus - plus : plus - minus);
            if (cost < best_cost) {
                best_cost = cost;
                best = at;
            }
        }
        return model_->plane_of(facets[best]);
    }

    M* model_;
    std::vector<Node> nodes_;
    std::vector<Task> work_;
    std::vector<std::uint32_t> remainder_, next_;
    LazyTreeCounts counts_;
};

CLEAVE_END_NAMESPACE

#endif

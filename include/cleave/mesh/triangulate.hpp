// SPDX-License-Identifier: Apache-2.0
/// Triangulation of polygon sets with holes in every degenerate position, by one plane sweep with exact predicates.
///
/// Source: [Garey-Johnson-Preparata-Tarjan-1978] for the cut into monotone pieces and their triangulation by a stack of
/// reflex vertices; as in [Hertel-Mehlhorn-1983] both happen in the same sweep, so no decomposition is stored.
///
/// The sweep goes through the vertices in lexicographic order, which acts like an infinitesimal shear: no two vertices
/// are ever level. Its status is the list of *slabs*, the connected parts of the interior on the sweep line, each
/// between a lower and an upper edge. A slab carries one monotone *piece*, or two where its rightmost vertex is a merge
/// vertex whose diagonal to the right is still owed. At a vertex v the slabs that touch v end at it, lose v from their
/// lower or upper edge, or are split by it; the edges that leave v to the right open and continue slabs:
///
///             upper edge of T ____                ____ r_k
///                                 \   slab T     /
///     closed slabs  --- lower/upper ---  v  --- lower/upper ---  new slabs
///                                 /   slab B     \.
///             lower edge of B ____                ---- r_1
///
/// A piece's stack holds a chain along which no strictly convex corner is left. A triangle is cut only off a strictly
/// convex corner; a vertex on the opposite chain sees the whole stack strictly from one side. Hence no triangle has
/// zero area and collinear vertices stay on the stack until a vertex off their line takes them: every vertex is used.
#ifndef CLEAVE_MESH_TRIANGULATE_HPP
#define CLEAVE_MESH_TRIANGULATE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/sign.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Three vertex indices, counter-clockwise.
using IndexTriangle = std::array<std::uint32_t, 3>;

namespace detail {

/// A sequence of slab ids in blocks, so that an insertion among many moves few: O(sqrt n) with a tiny constant.
class SlabList {
public:
    struct Position {
        std::size_t block = 0;
        std::size_t offset = 0;
    };

    void clear() {
        for (std::vector<std::uint32_t>& block : blocks_) block.clear();
        if (blocks_.empty()) blocks_.emplace_back();
        blocks_.resize(1);
    }

    [[nodiscard]] bool empty() const { return blocks_.size() == 1 && blocks_[0].empty(); }
    [[nodiscard]] bool at_end(Position p) const { return p.block == blocks_.size(); }
    [[nodiscard]] std::uint32_t at(Position p) const { return blocks_[p.block][p.offset]; }
    void set(Position p, std::uint32_t id) { blocks_[p.block][p.offset] = id; }

    [[nodiscard]] Position next(Position p) const { return normal({p.block, p.offset + 1}); }

    /// The first position whose slab is not below, where `below` holds for a prefix of the sequence.
    template <class Below>
    [[nodiscard]] Position lower_bound(Below&& below) const {
        const auto block = std::partition_point(blocks_.begin(), blocks_.end() - 1,
                                                [&](const auto& b) { return b.empty() || below(b.back()); });
        const auto offset = std::partition_point(block->begin(), block->end(), below);
        return normal(
            {static_cast<std::size_t>(block - blocks_.begin()), static_cast<std::size_t>(offset - block->begin())});
    }

    /// Removes the slab at p; the result is the position of its successor.
    Position erase(Position p) {
        std::vector<std::uint32_t>& block = blocks_[p.block];
        block.erase(block.begin() + static_cast<std::ptrdiff_t>(p.offset));
        if (block.empty() && blocks_.size() > 1) {
            blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(p.block));
            p.offset = 0;
        }
        return normal(p);
    }

    /// Inserts before p; the result is the position after the new slab.
    Position insert(Position p, std::uint32_t id) {
        if (at_end(p)) p = {blocks_.size() - 1, blocks_.back().size()};
        std::vector<std::uint32_t>& block = blocks_[p.block];
        block.insert(block.begin() + static_cast<std::ptrdiff_t>(p.offset), id);
        ++p.offset;
        if (block.size() == block_limit) {
            constexpr auto half = static_cast<std::ptrdiff_t>(block_limit / 2);
            std::vector<std::uint32_t> tail(block.begin() + half, block.end());
            block.erase(block.begin() + half, block.end());
            blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(p.block) + 1, std::move(tail));
            if (p.offset > block_limit / 2) p = {p.block + 1, p.offset - block_limit / 2};
        }
        return normal(p);
    }

private:
    static constexpr std::size_t block_limit = 512;

    /// Past the end of a block means the start of the next one; past the last block means the end.
    [[nodiscard]] Position normal(Position p) const {
        return p.block < blocks_.size() && p.offset >= blocks_[p.block].size() ? Position{p.block + 1, 0} : p;
    }

    std::vector<std::vector<std::uint32_t>> blocks_;
};

}  // namespace detail

/// Triangulates polygon sets one after another, keeping its buffers. Not for two threads at once.
class Triangulator {
public:
    /// Triangulates the set bounded by loops of vertex indices, its interior on their left (outer loops
    /// counter-clockwise, holes clockwise, in any number and nesting). Loop i is `corners[first[i]]` to
    /// `corners[first[i + 1] - 1]`.
    ///
    /// Requires: `orient(i, j, k)` is the exact sign of the turn i, j, k (plus: counter-clockwise) and `less(i, j)` the
    /// lexicographic order of the points. Vertices that compare equal are taken as one, the least index standing for
    /// all. Loops may touch themselves and each other in vertices, run along each other in opposite directions (such a
    /// pair of edges bounds nothing, as in a hole tied to its outer loop by a bridge) and have collinear corners. A
    /// vertex in the interior of an edge splits it. Edges must not cross elsewhere. Ensures: on success, triangles
    /// appended to `out` have strictly positive area and together are the set; every edge is an edge of one triangle
    /// (after the splits above) and every vertex in the set is used. A set without area has no triangles. Returns:
    /// false, with `out` as it was, where crossing or wrongly turned loops were noticed. Such input is always noticed
    /// where the loops wind negatively around some point; loops that wind twice may be covered twice instead. Cost: O(n
    /// log n) calls of `less` and `orient`.
    template <class Orient, class Less>
    [[nodiscard]] bool triangulate(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> first,
                                   Orient&& orient, Less&& less, std::vector<IndexTriangle>& out) {
        const std::size_t start = out.size();
        if (first.size() == 2 && few(corners.subspan(first[0], first[1] - first[0]), orient, less, out)) return true;
        Sweep<std::remove_reference_t<Orient>> sweep{*this, orient, out};
        number_vertices(corners, first, less);
        status_.clear();
        slabs_.clear();
        pieces_.clear();
        nodes_.clear();
        for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
            if (!sweep.visit(v)) {
                out.resize(start);
                return false;
            }
        }
        if (!status_.empty()) out.resize(start);
        return status_.empty();
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;

    enum class Chain : std::uint8_t { lower, upper };

    /// An edge that leaves its left vertex; `sign` is +1 where the interior is above it, -1 where it is below.
    struct Edge {
        std::uint32_t right;
        std::int32_t sign;
        std::uint32_t next;
    };
    /// The part of the interior between two edges on the sweep line. `low == high` unless a merge vertex is pending.
    struct Slab {
        std::uint32_t lower_left, lower_right;
        std::uint32_t upper_left, upper_right;
        std::uint32_t low, high;
    };
    /// A monotone piece: the stack of its vertices that still need triangles. All but the bottom one are on `chain`.
    struct Piece {
        std::uint32_t top;
        Chain chain;
    };
    struct Node {
        std::uint32_t vertex;
        std::uint32_t below;
    };

    /// Triangles and convex quadrilaterals, the bulk of most meshes. False means that it is not such a polygon.
    template <class Orient, class Less>
    static bool few(std::span<const std::uint32_t> loop, Orient& orient, Less& less, std::vector<IndexTriangle>& out) {
        if (loop.size() == 3) {
            if (orient(loop[0], loop[1], loop[2]) != Sign::plus) return false;
            out.push_back({loop[0], loop[1], loop[2]});
            return true;
        }
        if (loop.size() != 4) return false;
        // Starting at the least corner makes the diagonal independent of where the caller's loop starts.
        std::size_t s = 0;
        for (std::size_t i = 1; i < 4; ++i) {
            if (less(loop[i], loop[s])) s = i;
        }
        const std::array<std::uint32_t, 4> q{loop[s], loop[(s + 1) % 4], loop[(s + 2) % 4], loop[(s + 3) % 4]};
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t a = q[i], b = q[i + 1], c = q[i + 2], d = q[(i + 3) % 4];
            if (orient(a, b, c) == Sign::plus && orient(a, c, d) == Sign::plus) {
                out.push_back({a, b, c});
                out.push_back({a, c, d});
                return true;
            }
        }
        return false;
    }

    /// Sorts the vertices and hangs each edge on its left vertex. From here on vertices are ranks in sweep order.
    template <class Less>
    void number_vertices(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> first, Less& less) {
        order_.resize(corners.size());
        std::iota(order_.begin(), order_.end(), std::uint32_t{0});
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return corners[a] != corners[b] && less(corners[a], corners[b]);
        });
        rank_.resize(corners.size());
        vertices_.clear();
        for (const std::uint32_t position : order_) {
            const std::uint32_t v = corners[position];
            if (vertices_.empty() || (vertices_.back() != v && less(vertices_.back(), v))) {
                vertices_.push_back(v);
            } else {
                vertices_.back() = std::min(vertices_.back(), v);
            }
            rank_[position] = static_cast<std::uint32_t>(vertices_.size() - 1);
        }
        edges_.clear();
        first_edge_.assign(vertices_.size(), none);
        for (std::size_t loop = 0; loop + 1 < first.size(); ++loop) {
            for (std::uint32_t i = first[loop]; i < first[loop + 1]; ++i) {
                const std::uint32_t from = rank_[i];
                const std::uint32_t to = rank_[i + 1 == first[loop + 1] ? first[loop] : i + 1];
                if (from < to) add_edge(from, to, +1);
                if (to < from) add_edge(to, from, -1);
            }
        }
    }

    void add_edge(std::uint32_t left, std::uint32_t right, std::int32_t sign) {
        edges_.push_back({right, sign, first_edge_[left]});
        first_edge_[left] = static_cast<std::uint32_t>(edges_.size() - 1);
    }

    /// One run of the sweep over the buffers of its owner.
    template <class Orient>
    struct Sweep {
        Triangulator& t;
        Orient& orient;
        std::vector<IndexTriangle>& out;

        [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
            return orient(t.vertices_[a], t.vertices_[b], t.vertices_[c]);
        }
        /// Where v is, seen from an edge: plus is above.
        [[nodiscard]] Sign above(std::uint32_t left, std::uint32_t right, std::uint32_t v) const {
            return v == right ? Sign::zero : turn(left, right, v);
        }

        [[nodiscard]] bool visit(std::uint32_t v) {
            // 1. The slabs that touch v are neighbours in the status.
            const auto begin = t.status_.lower_bound([&](std::uint32_t id) {
                return above(t.slabs_[id].upper_left, t.slabs_[id].upper_right, v) == Sign::plus;
            });
            std::uint32_t low = none, high = none;  // pieces left open below and above v
            Slab below{}, beyond{};                 // the slabs they are in: B and T of the drawing
            std::size_t touched = 0;
            auto end = begin;
            for (; !t.status_.at_end(end); end = t.status_.next(end), ++touched) {
                const Slab s = t.slabs_[t.status_.at(end)];
                const Sign to_lower = above(s.lower_left, s.lower_right, v);
                if (to_lower == Sign::minus) break;
                // All but the first slab were found by walking, so their upper edge has not been looked at yet.
                const Sign to_upper = above(s.upper_left, s.upper_right, v);
                if (to_upper == Sign::plus) return false;
                if (to_lower == Sign::zero) pass(s.lower_right, +1, v);
                if (to_upper == Sign::zero) pass(s.upper_right, -1, v);
                if (to_lower == Sign::plus && to_upper == Sign::minus) {
                    if (touched != 0) return false;
                    split(s, v, low, high);
                    below = beyond = s;
                } else if (to_lower == Sign::plus) {
                    if (touched != 0 || (s.low != s.high && !append(s.high, v, Chain::upper, true)) ||
                        !append(s.low, v, Chain::upper, false)) {
                        return false;
                    }
                    low = s.low;
                    below = s;
                } else if (to_upper == Sign::minus) {
                    if (high != none || (s.low != s.high && !append(s.low, v, Chain::lower, true)) ||
                        !append(s.high, v, Chain::lower, false)) {
                        return false;
                    }
                    high = s.high;
                    beyond = s;
                } else {
                    if (high != none || !append(s.low, v, Chain::upper, true)) return false;
                    if (s.low != s.high && !append(s.high, v, Chain::upper, true)) return false;
                }
            }
            // 2. Edges to the right, bottom to top.
            if (!collect(v)) return false;
            const auto& rays = t.rays_;
            // 3. The slabs to the right of v.
            auto& fresh = t.fresh_;
            fresh.clear();
            if (rays.empty()) {
                if ((low == none) != (high == none)) return false;
                if (low != none) {
                    fresh.push_back({below.lower_left, below.lower_right, beyond.upper_left, beyond.upper_right,  //
                                     low, high});
                }
            } else {
                std::size_t i = 0;
                if (low != none) {
                    if (rays[0].sign > 0) return false;
                    fresh.push_back({below.lower_left, below.lower_right, v, rays[0].right, low, low});
                    i = 1;
                }
                for (; i + 1 < rays.size(); i += 2) {
                    if (rays[i].sign < 0 || rays[i + 1].sign > 0) return false;
                    const std::uint32_t piece = new_piece(v);
                    fresh.push_back({v, rays[i].right, v, rays[i + 1].right, piece, piece});
                }
                if ((i < rays.size()) != (high != none)) return false;
                if (high != none) {
                    if (rays[i].sign < 0) return false;
                    fresh.push_back({v, rays[i].right, beyond.upper_left, beyond.upper_right, high, high});
                }
            }
            replace(begin, touched);
            return true;
        }

        /// An edge that ends at v is done; one that goes on through v continues as an edge of v.
        void pass(std::uint32_t right, std::int32_t sign, std::uint32_t v) {
            if (right != v) t.add_edge(v, right, sign);
        }

        /// v lies inside slab s: a diagonal from the slab's rightmost vertex h separates what is below from what is
        /// above. Where h is a merge vertex the two pieces exist already; else one of them starts with that diagonal.
        void split(const Slab& s, std::uint32_t v, std::uint32_t& low, std::uint32_t& high) {
            low = s.low;
            high = s.high;
            if (low == high) {
                const std::uint32_t fresh = new_piece(t.nodes_[t.pieces_[low].top].vertex);
                (t.pieces_[low].chain == Chain::lower ? low : high) = fresh;
            }
            // Neither can fail: both vertices go onto the chain that the stack is on, or onto an empty one.
            (void)append(low, v, Chain::upper, false);
            (void)append(high, v, Chain::lower, false);
        }

        [[nodiscard]] std::uint32_t push(std::uint32_t v, std::uint32_t below) {
            t.nodes_.push_back({v, below});
            return static_cast<std::uint32_t>(t.nodes_.size() - 1);
        }

        [[nodiscard]] std::uint32_t new_piece(std::uint32_t v) {
            t.pieces_.push_back({push(v, none), Chain::lower});
            return static_cast<std::uint32_t>(t.pieces_.size() - 1);
        }

        void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            out.push_back({t.vertices_[a], t.vertices_[b], t.vertices_[c]});
        }

        /// Continues a piece with v on one of its chains; `last` closes the piece, v being the end of both chains.
        /// False where the whole stack should be visible from v and is not.
        [[nodiscard]] bool append(std::uint32_t id, std::uint32_t v, Chain chain, bool last) {
            Piece& piece = t.pieces_[id];
            std::uint32_t top = piece.top;
            const auto vertex = [&](std::uint32_t node) { return t.nodes_[node].vertex; };
            const auto below = [&](std::uint32_t node) { return t.nodes_[node].below; };
            if (!last && (chain == piece.chain || below(top) == none)) {
                const Sign convex = chain == Chain::lower ? Sign::plus : Sign::minus;
                while (below(top) != none && turn(vertex(below(top)), vertex(top), v) == convex) {
                    if (chain == Chain::lower) {
                        emit(vertex(below(top)), vertex(top), v);
                    } else {
                        emit(vertex(top), vertex(below(top)), v);
                    }
                    top = below(top);
                }
                piece = {push(v, top), chain};
                return true;
            }
            const Sign visible = piece.chain == Chain::lower ? Sign::plus : Sign::minus;
            for (std::uint32_t node = top; below(node) != none; node = below(node)) {
                if (turn(vertex(below(node)), vertex(node), v) != visible) return false;
                if (piece.chain == Chain::lower) {
                    emit(vertex(below(node)), vertex(node), v);
                } else {
                    emit(vertex(node), vertex(below(node)), v);
                }
            }
            const std::uint32_t bottom = push(vertex(top), none);
            piece = {push(v, bottom), chain};
            return true;
        }

        /// Fills `rays_` with the edges that leave v to the right. Where several run in one direction, with ends
        /// c_1, c_2, ... away from v, the stretch to c_1 stays here with the sum of all signs, and the stretch from
        /// c_i to c_i+1 is handed to c_i with the sum of those that reach so far: linear, however they overlap.
        [[nodiscard]] bool collect(std::uint32_t v) {
            auto& rays = t.rays_;
            rays.clear();
            for (std::uint32_t e = t.first_edge_[v]; e != none; e = t.edges_[e].next) rays.push_back(t.edges_[e]);
            if (rays.size() == 1) return rays[0].sign == 1 || rays[0].sign == -1;
            std::sort(rays.begin(), rays.end(), [&](const Edge& a, const Edge& b) {
                if (a.right == b.right) return false;
                const Sign s = turn(v, a.right, b.right);
                return s == Sign::plus || (s == Sign::zero && a.right < b.right);
            });
            std::size_t kept = 0;
            for (std::size_t i = 0; i < rays.size();) {
                std::size_t j = i + 1;
                while (j < rays.size() &&
                       (rays[j].right == rays[i].right || turn(v, rays[i].right, rays[j].right) == Sign::zero)) {
                    ++j;
                }
                for (std::size_t k = j - 1; k > i; --k) {
                    rays[k - 1].sign += rays[k].sign;
                    if (rays[k].right != rays[k - 1].right && rays[k].sign != 0) {
                        t.add_edge(rays[k - 1].right, rays[k].right, rays[k].sign);
                    }
                }
                if (rays[i].sign < -1 || rays[i].sign > 1) return false;
                if (rays[i].sign != 0) rays[kept++] = rays[i];
                i = j;
            }
            rays.resize(kept);
            return true;
        }

        /// Puts the fresh slabs in place of the touched ones; the common case, one for one, moves nothing.
        void replace(detail::SlabList::Position at, std::size_t touched) {
            std::size_t i = 0;
            for (; i < t.fresh_.size() && i < touched; ++i, at = t.status_.next(at)) {
                t.slabs_[t.status_.at(at)] = t.fresh_[i];
            }
            for (std::size_t k = i; k < touched; ++k) at = t.status_.erase(at);
            for (; i < t.fresh_.size(); ++i) {
                t.slabs_.push_back(t.fresh_[i]);
                at = t.status_.insert(at, static_cast<std::uint32_t>(t.slabs_.size() - 1));
            }
        }
    };

    std::vector<std::uint32_t> order_, rank_, vertices_, first_edge_;
    std::vector<Edge> edges_, rays_;
    std::vector<Slab> slabs_, fresh_;
    std::vector<Piece> pieces_;
    std::vector<Node> nodes_;
    detail::SlabList status_;
};

/// The same for a single set: its triangles, or nullopt where the loops cross or turn the wrong way.
template <class Orient, class Less>
[[nodiscard]] std::optional<std::vector<IndexTriangle>> triangulate(std::span<const std::uint32_t> corners,
                                                                    std::span<const std::uint32_t> first,
                                                                    Orient&& orient, Less&& less) {
    Triangulator triangulator;
    std::vector<IndexTriangle> triangles;
    if (!triangulator.triangulate(corners, first, orient, less, triangles)) return std::nullopt;
    return triangles;
}

CLEAVE_END_NAMESPACE

#endif

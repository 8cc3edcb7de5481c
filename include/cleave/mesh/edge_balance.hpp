// SPDX-License-Identifier: Apache-2.0
/// Closedness: do the edges of a mesh cancel out, each against its opposite, or at least along their line?
///
/// Nearly every mesh is balanced edge by edge with its own indices, which `EdgeBuckets` find out. Only where it is not
/// are equal points taken as one, and only edges that are unbalanced even then are compared along their lines.
#ifndef CLEAVE_MESH_EDGE_BALANCE_HPP
#define CLEAVE_MESH_EDGE_BALANCE_HPP

#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/mesh/edge_buckets.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/point_tests.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// An undirected edge, low < high, with its uses in each direction.
struct EdgeUse {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t up;    // uses low -> high
    std::uint32_t down;  // uses high -> low
};

/// Calls `f(from, to, face)` for every directed edge between different points, `point(corner)` naming the points.
template <class T, class Point, class F>
void for_each_edge(const PolygonMesh<T>& mesh, Point&& point, F&& f) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
        const auto face = mesh.face(i);
        if (face.empty()) continue;
        std::uint32_t from = point(face.back());
        for (const std::uint32_t corner : face) {
            const std::uint32_t to = point(corner);
            if (from != to) f(from, to, static_cast<std::uint32_t>(i));
            from = to;
        }
    }
}

/// The edges used more often in one direction than in the other, sorted.
/// Cost: O(corners); a bucket for each point, sorted where a point has many edges.
template <class T, class Point>
[[nodiscard]] std::vector<EdgeUse> unbalanced_edges(const PolygonMesh<T>& mesh, Point&& point) {
    std::vector<std::uint32_t> start(mesh.points.size() + 1, 0);
    for_each_edge(mesh, point, [&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++start[std::min(a, b) + 1]; });
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    // Bucket of the lower point: the higher point, and in the lowest bit the direction.
    std::vector<std::uint64_t> bucket(start.back());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for_each_edge(mesh, point, [&](std::uint32_t a, std::uint32_t b, std::uint32_t) {
        bucket[next[std::min(a, b)]++] = (std::uint64_t{std::max(a, b)} << 1) | (a < b ? 0U : 1U);
    });
    std::vector<EdgeUse> result;
    for (std::uint32_t low = 0; low + 1 < start.size(); ++low) {
        const auto begin = bucket.begin() + start[low], end = bucket.begin() + start[low + 1];
        std::sort(begin, end);
        for (auto at = begin; at != end;) {
            EdgeUse edge{low, static_cast<std::uint32_t>(*at >> 1), 0, 0};
            for (; at != end && *at >> 1 == edge.high; ++at) ++((*at & 1) == 0 ? edge.up : edge.down);
            if (edge.up != edge.down) result.push_back(edge);
        }
    }
    return result;
}

/// A point as integers over a positive common weight, the last component.
[[nodiscard]] inline std::array<WideInteger, 4> homogeneous(const std::array<double, 3>& p) {
    const std::array<DoubleParts, 3> parts{decompose(p[0]), decompose(p[1]), decompose(p[2])};
    const int least = std::min({0, parts[0].exponent, parts[1].exponent, parts[2].exponent});
    std::array<WideInteger, 4> result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = WideInteger::scaled(parts[i].mantissa, static_cast<std::size_t>(parts[i].exponent - least));
    }
    result[3] = WideInteger::scaled(1, static_cast<std::size_t>(-least));
    return result;
}

template <class T>
[[nodiscard]] std::array<WideInteger, 4> homogeneous(const std::array<T, 3>& p) {
    std::array<Fraction, 3> f;
    for (std::size_t i = 0; i < 3; ++i) f[i] = number_traits<T>::to_fraction(p[i]);
    std::array<WideInteger, 4> result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = WideInteger(f[i].num) * f[(i + 1) % 3].den;
        result[i] *= f[(i + 2) % 3].den;
    }
    result[3] = WideInteger(f[0].den) * f[1].den;
    result[3] *= f[2].den;
    return result;
}

/// A hash of the line through two different points: equal for equal lines, whichever points they come from. It is that
/// of the line's Plücker coordinates, primitive and with a positive first component.
template <class T>
[[nodiscard]] std::size_t line_hash(const std::array<T, 3>& p, const std::array<T, 3>& q) {
    const std::array<WideInteger, 4> a = homogeneous(p);
    const std::array<WideInteger, 4> b = homogeneous(q);
    std::array<WideInteger, 6> line;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        line[i] = b[i] * a[3];
        sub_product(line[i], a[i], b[3]);
        line[i + 3] = a[j] * b[k];
        sub_product(line[i + 3], a[k], b[j]);
    }
    WideInteger divisor;
    for (const WideInteger& x : line) divisor = gcd(divisor, x);
    const auto leading = std::find_if(line.begin(), line.end(), [](const WideInteger& x) { return !x.is_zero(); });
    if (leading->sign() == Sign::minus) divisor.negate();
    std::size_t hash = 0;
    for (const WideInteger& x : line) hash = hash * 0x9e3779b97f4a7c15U + exact_divide(x, divisor).hash();
    return hash;
}

/// Compares edges along their lines.
template <class T>
class LineBalance {
public:
    explicit LineBalance(const PolygonMesh<T>& mesh) : points_(mesh.points), tests_(mesh.points) {}

    /// For each edge, whether the uses of all edges cancel out along the whole of it.
    [[nodiscard]] std::vector<bool> cancelled(const std::vector<EdgeUse>& edges) {
        std::vector<bool> result(edges.size(), false);
        std::vector<std::pair<std::size_t, std::uint32_t>> keyed;
        keyed.reserve(edges.size());
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            keyed.emplace_back(line_hash(points_[edges[e].low], points_[edges[e].high]), e);
        }
        std::sort(keyed.begin(), keyed.end());
        std::vector<std::uint32_t> same_hash, group, rest;
        for (std::size_t i = 0; i < keyed.size();) {
            same_hash.clear();
            const std::size_t hash = keyed[i].first;
            for (; i < keyed.size() && keyed[i].first == hash; ++i) same_hash.push_back(keyed[i].second);
            // Equal hashes are equal lines, all but certainly; exactness wants to know.
            while (!same_hash.empty()) {
                const EdgeUse& first = edges[same_hash[0]];
                group.clear();
                rest.clear();
                for (const std::uint32_t e : same_hash) {
                    const bool on_line = e == same_hash[0] || (tests_.collinear(first.low, first.high, edges[e].low) &&
                                                               tests_.collinear(first.low, first.high, edges[e].high));
                    (on_line ? group : rest).push_back(e);
                }
                if (group.size() > 1) sum_along_line(edges, group, result);
                same_hash.swap(rest);
            }
        }
        return result;
    }

private:
    /// The uses as a function on the line, by sorting ends: an edge is cancelled where it is zero all along the edge.
    void sum_along_line(const std::vector<EdgeUse>& edges, const std::vector<std::uint32_t>& group,
                        std::vector<bool>& result) {
        const auto &p = points_[edges[group[0]].low], &q = points_[edges[group[0]].high];
        std::size_t axis = 0;
        while (p[axis] == q[axis]) ++axis;  // the points differ, and the line is their own
        const auto at = [&](std::uint32_t point) -> const T& { return points_[point][axis]; };
        std::vector<std::uint32_t> ends;
        for (const std::uint32_t e : group) {
            ends.push_back(edges[e].low);
            ends.push_back(edges[e].high);
        }
        std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); });
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());  // points are welded: equal means same index
        const auto place = [&](std::uint32_t point) {
            return static_cast<std::size_t>(
                std::lower_bound(ends.begin(), ends.end(), point,
                                 [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); }) -
                ends.begin());
        };
        std::vector<std::int64_t> uses(ends.size(), 0);  // first differences, then the uses right of each end
        for (const std::uint32_t e : group) {
            const EdgeUse& edge = edges[e];
            const std::int64_t net = std::int64_t{edge.up} - std::int64_t{edge.down};
            uses[place(edge.low)] += net;  // right for both directions of the edge along the line
            uses[place(edge.high)] -= net;
        }
        std::vector<std::size_t> open_before(ends.size() + 1, 0);  // stretches with uses left, in front of each end
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            sum += uses[i];
            open_before[i + 1] = open_before[i] + (sum != 0 ? 1 : 0);
        }
        for (const std::uint32_t e : group) {
            const std::size_t a = place(edges[e].low), b = place(edges[e].high);
            result[e] = open_before[std::min(a, b)] == open_before[std::max(a, b)];
        }
    }

    std::span<const std::array<T, 3>> points_;
    PointTests<T> tests_;
};

}  // namespace detail

/// Whether edges cancel out, each against opposite ones, with the mesh's own indices.
[[nodiscard]] inline bool are_edges_balanced(const EdgeBuckets& buckets, std::size_t point_count,
                                             ExecutorRef executor) {
    constexpr std::size_t grain = std::size_t(1) << 13U;
    return reduce_chunks(
        executor, point_count, grain, true,
        [&](std::size_t begin, std::size_t end) { return buckets.balanced(begin, end); },
        [](bool a, bool b) { return a && b; });
}

/// Fills the report's lists of edges. Requires: finite points, and every corner refers to one.
/// Cost: O(n); some microseconds for each edge that is not balanced by itself.
template <class T>
void check_welded_edges(const PolygonMesh<T>& mesh, MeshReport& report) {
    const std::vector<std::uint32_t> first_equal = first_equal_points<T>(mesh.points);
    const auto welded = [&](std::uint32_t corner) { return first_equal[corner]; };
    const std::vector<detail::EdgeUse> edges = detail::unbalanced_edges(mesh, welded);
    if (edges.empty()) return;
    const std::vector<bool> cancelled = detail::LineBalance<T>(mesh).cancelled(edges);

    std::vector<std::uint32_t> face(edges.size(), 0xffffffffU);
    detail::for_each_edge(mesh, welded, [&](std::uint32_t a, std::uint32_t b, std::uint32_t f) {
        const std::pair<std::uint32_t, std::uint32_t> wanted = std::minmax(a, b);
        const auto found = std::lower_bound(edges.begin(), edges.end(), wanted, [](const auto& edge, const auto& key) {
            return std::tie(edge.low, edge.high) < std::tie(key.first, key.second);
        });
        if (found == edges.end() || found->low != wanted.first || found->high != wanted.second) return;
        std::uint32_t& first = face[static_cast<std::size_t>(found - edges.begin())];
        first = std::min(first, f);
    });
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const detail::EdgeUse& edge = edges[e];
        const bool upward = edge.up > edge.down;
        const EdgeDefect defect{upward ? edge.low : edge.high, upward ? edge.high : edge.low,
                                upward ? edge.up : edge.down, upward ? edge.down : edge.up, face[e]};
        if (cancelled[e]) {
            report.t_junctions.push_back(defect);
        } else if (edge.up + edge.down == 1) {
            report.open_edges.push_back(defect);
        } else if (edge.up + edge.down == 2) {
            report.misoriented_edges.push_back(defect);
        } else {
            report.unbalanced_edges.push_back(defect);
        }
    }
    const auto order = [](const EdgeDefect& a, const EdgeDefect& b) {
        return std::tie(a.from, a.to) < std::tie(b.from, b.to);
    };
    for (auto* list : {&report.t_junctions, &report.open_edges, &report.misoriented_edges, &report.unbalanced_edges}) {
        std::sort(list->begin(), list->end(), order);
    }
}

/// The same. Cost: less for a mesh whose edges are balanced with its own indices.
template <class T>
void check_edges(const PolygonMesh<T>& mesh, MeshReport& report) {
    EdgeBuckets buckets;
    if (buckets.gather(mesh) && are_edges_balanced(buckets, mesh.points.size(), {})) return;
    check_welded_edges(mesh, report);
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// `EdgeBuckets`: the edges of a mesh sorted by their lower points, to see whether they cancel out.
#ifndef CLEAVE_MESH_EDGE_BUCKETS_HPP
#define CLEAVE_MESH_EDGE_BUCKETS_HPP

#include <cleave/mesh/polygon_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// For each point of a mesh the higher ends of its edges. Buckets can be looked at in any order or at once.
class EdgeBuckets {
public:
    /// Returns: whether every corner refers to a point; nothing else may be asked if one does not.
    /// Requires: `first` spans the corners. Cost: two passes over the corners.
    template <class T>
    [[nodiscard]] bool gather(const PolygonMesh<T>& mesh) {
        const std::size_t points = mesh.points.size();
        end_.assign(points, 0);
        if (!count(mesh)) return false;
        std::uint32_t sum = 0;
        for (std::uint32_t& e : end_) {
            const std::uint32_t size = e;
            e = sum;
            sum += size;
        }
        // Buckets are read in blocks, beyond the end of the last one.
        ends_ = std::make_unique_for_overwrite<std::uint32_t[]>(mesh.corners.size() + widest);
        std::fill_n(ends_.get() + mesh.corners.size(), widest, 0U);
        const auto add = [this](std::uint32_t from, std::uint32_t to) {
            ends_[end_[std::min(from, to)]++] = std::max(from, to) << 1U | (from < to ? 0U : 1U);
        };
        for_each_face(
            mesh,
            [&](const std::uint32_t* c) {
                const Turned t(c);
                const std::uint32_t at = end_[t.low];
                end_[t.low] += 2;
                ends_[at] = t.next << 1U;
                ends_[at + 1] = t.last << 1U | 1U;
                add(t.next, t.last);
                return true;
            },
            [&](std::span<const std::uint32_t> face) {
                for (std::size_t k = 0; k < face.size(); ++k) add(face[k], face[k + 1 == face.size() ? 0 : k + 1]);
                return true;
            });
        return true;
    }

    /// The points that faces use, in the order of their first corners.
    [[nodiscard]] std::span<const std::uint32_t> used_points() const noexcept { return used_; }

    /// Whether every edge whose lower point is in [begin, end) is used as often in one direction as in the other. False
    /// may mean that an edge joins a point to itself, or that there are more than 2^31 points.
    /// Cost: 10 ns a point of at most eight edges; n log n for more than 16.
    [[nodiscard]] bool balanced(std::size_t begin, std::size_t end) const {
        if (end_.size() > std::size_t(1) << 31U) return false;
        std::uint32_t off = 0;
        std::uint32_t first = begin == 0 ? 0 : end_[begin - 1];
        for (std::size_t p = begin; p < end; ++p) {
            const std::uint32_t n = end_[p] - first;
            const std::uint32_t* const bucket = ends_.get() + first;
            if (n <= 8)
                off |= imbalance<8>(bucket, n);
            else if (n <= widest)
                off |= imbalance<widest>(bucket, n);
            else
                off |= balanced_by_sorting({bucket, n}) ? 0U : 1U;
            first = end_[p];
        }
        return off == 0;
    }

private:
    static constexpr std::size_t widest = 16;

    /// A triangle from its lowest point on: two of its edges go into one bucket.
    struct Turned {
        explicit Turned(const std::uint32_t* c)
            : low(std::min({c[0], c[1], c[2]})),
              next(c[0] == low   ? c[1]
                   : c[1] == low ? c[2]
                                 : c[0]),
              last(c[0] == low   ? c[2]
                   : c[1] == low ? c[0]
                                 : c[1]) {}

        std::uint32_t low, next, last;
    };

    /// Calls `triangle(corners)` or `polygon(corners)` for each face until one returns false. Returns: whether none
    /// did.
    template <class T, class Triangle, class Polygon>
    static bool for_each_face(const PolygonMesh<T>& mesh, Triangle&& triangle, Polygon&& polygon) {
        const std::uint32_t* c = mesh.corners.data();
        for (std::size_t i = 0; i < mesh.face_count(); ++i) {
            const std::size_t n = mesh.first[i + 1] - mesh.first[i];
            if (n == 3 ? !triangle(c) : !polygon(std::span<const std::uint32_t>(c, n))) return false;
            c += n;
        }
        return true;
    }

    /// Counts the edges of each bucket, and finds the points that are used.
    template <class T>
    [[nodiscard]] bool count(const PolygonMesh<T>& mesh) {
        const std::size_t points = mesh.points.size();
        std::vector<char> seen(points, 0);
        used_.resize(points + 1);  // what is no first use is written to the place after the last one
        std::size_t used = 0;
        const auto use = [&](std::uint32_t p) {
            used_[used] = p;
            used += seen[p] == 0 ? 1U : 0U;
            seen[p] = 1;
        };
        const bool exist = for_each_face(
            mesh,
            [&](const std::uint32_t* c) {
                if (std::max({c[0], c[1], c[2]}) >= points) return false;
                use(c[0]);
                use(c[1]);
                use(c[2]);
                const Turned t(c);
                end_[t.low] += 2;
                ++end_[std::min(t.next, t.last)];
                return true;
            },
            [&](std::span<const std::uint32_t> face) {
                for (const std::uint32_t p : face) {
                    if (p >= points) return false;
                    use(p);
                }
                for (std::size_t k = 0; k < face.size(); ++k)
                    ++end_[std::min(face[k], face[k + 1 == face.size() ? 0 : k + 1])];
                return true;
            });
        used_.resize(used);
        return exist;
    }

#ifdef __GNUC__
    // Left to themselves compilers find other loops to vectorise, to no avail.
    using Four = std::uint32_t __attribute__((vector_size(16)));
#else
    /// Four numbers at once; a comparison gives all ones for true.
    struct Four {
        std::uint32_t at[4];
        template <class F>
        static Four of(F&& f) {
            return {{f(0), f(1), f(2), f(3)}};
        }
        std::uint32_t operator[](int i) const { return at[i]; }
        friend Four operator==(const Four& a, std::uint32_t b) {
            return of([&](int i) { return a.at[i] == b ? ~0U : 0U; });
        }
        friend Four operator-(const Four& a, const Four& b) {
            return of([&](int i) { return a.at[i] - b.at[i]; });
        }
        friend Four& operator+=(Four& a, const Four& b) {
            return a = of([&](int i) { return a.at[i] + b.at[i]; });
        }
    };
#endif

    /// Not 0 where an entry is not as frequent as its opposite. Compares all with all: branches that nobody can predict
    /// cost more. Requires: n <= Width, and `Width` entries that may be read.
    template <std::size_t Width>
    static std::uint32_t imbalance(const std::uint32_t* bucket, std::uint32_t n) {
        constexpr std::size_t blocks = Width / 4;
        Four x[blocks];
        Four difference[blocks]{};
        std::memcpy(x, bucket, sizeof x);
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::size_t b = 0; b < blocks; ++b)
                difference[b] += Four(x[b] == (bucket[j] ^ 1U)) - Four(x[b] == bucket[j]);
        std::array<std::uint32_t, Width> each;
        std::memcpy(each.data(), difference, sizeof difference);
        std::uint32_t off = 0;
        for (std::uint32_t k = 0; k < n; ++k) off |= each[k];
        return off;
    }

    static bool balanced_by_sorting(std::span<const std::uint32_t> bucket) {
        std::vector<std::uint32_t> sorted(bucket.begin(), bucket.end());
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 0; i < sorted.size();) {
            const std::uint32_t high = sorted[i] >> 1U;
            std::size_t up = 0;
            std::size_t down = 0;
            for (; i < sorted.size() && sorted[i] >> 1U == high; ++i) ++((sorted[i] & 1U) == 0 ? up : down);
            if (up != down) return false;
        }
        return true;
    }

    std::vector<std::uint32_t> used_;
    std::vector<std::uint32_t> end_;         // by point: the end of its bucket, which begins where the one before ends
    std::unique_ptr<std::uint32_t[]> ends_;  // the higher point of each edge, and in the lowest bit its direction
};

CLEAVE_END_NAMESPACE

#endif

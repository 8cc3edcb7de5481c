// SPDX-License-Identifier: Apache-2.0
/// Welding: points at equal coordinates become one point.
///
/// Equality is exact; nothing that merely lies close is merged. 0.0 and -0.0 are the same coordinate.
#ifndef CLEAVE_MESH_WELD_HPP
#define CLEAVE_MESH_WELD_HPP

#include <cleave/mesh/polygon_mesh.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// A double near a coordinate that is the same for equal coordinates: what points are hashed by.
[[nodiscard]] inline double weld_key(double x) noexcept {
    return x;
}
template <class T>
[[nodiscard]] double weld_key(const T& x) {
    return to_double(x);
}

/// 44 bits.
[[nodiscard]] inline std::uint64_t weld_hash(const std::array<double, 3>& key) noexcept {
    std::uint64_t h = 0;
    for (const double x : key) {
        h ^= std::bit_cast<std::uint64_t>(x + 0.0);  // -0.0 + 0.0 is 0.0
        h *= 0x9e3779b97f4a7c15U;
        h ^= h >> 32;
    }
    return h * 0xd6e8feb86659fd93U >> 20;
}

/// Hashes of points, most of each: what is not in it was not put into it. No point is looked at twice.
class WeldMarks {
public:
    /// Requires: no more than `most` are put into it.
    explicit WeldMarks(std::size_t most) : table_(std::bit_ceil(2 * most + 1), 0) {}

    /// Returns: false, and puts nothing into it, where there is such a hash already.
    bool insert(std::uint64_t hash) {
        const std::size_t at = find(hash);
        const bool is_new = table_[at] == 0;
        table_[at] = mark(hash);
        return is_new;
    }

    [[nodiscard]] bool contains(std::uint64_t hash) const { return table_[find(hash)] != 0; }

private:
    static std::uint32_t mark(std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 12U) | 1U; }

    [[nodiscard]] std::size_t find(std::uint64_t hash) const {
        const std::size_t mask = table_.size() - 1;
        std::size_t at = static_cast<std::size_t>(hash) & mask;
        while (table_[at] != 0 && table_[at] != mark(hash)) at = (at + 1) & mask;
        return at;
    }

    std::vector<std::uint32_t> table_;
};

}  // namespace detail

/// For each point the least index of a point equal to it; a point that is not finite stands for itself.
/// Cost: O(n) expected; one hash table of at most 4n indices.
template <class T>
[[nodiscard]] std::vector<std::uint32_t> first_equal_points(std::span<const std::array<T, 3>> points) {
    constexpr std::uint32_t empty = 0xffffffffU;
    std::vector<std::uint32_t> result(points.size());
    std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), empty);
    const std::size_t mask = table.size() - 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const auto& p = points[i];
        const std::array<double, 3> key{detail::weld_key(p[0]), detail::weld_key(p[1]), detail::weld_key(p[2])};
        result[i] = index;
        if constexpr (std::is_floating_point_v<T>) {
            // NaN equals nothing, so a thousand of them would make a thousand entries in one place of the table.
            if (!(std::isfinite(key[0]) && std::isfinite(key[1]) && std::isfinite(key[2]))) continue;
        }
        for (std::size_t at = static_cast<std::size_t>(detail::weld_hash(key)) & mask;; at = (at + 1) & mask) {
            if (table[at] == empty) {
                table[at] = index;
                break;
            }
            if (points[table[at]] == p) {
                result[i] = table[at];
                break;
            }
        }
    }
    return result;
}

/// True only where no two points are equal; false may mean that two look alike. Finds out sooner than
/// `first_equal_points` that there is nothing to merge. Cost: O(n) expected, 6 ns a point of doubles.
template <class T>
[[nodiscard]] bool are_surely_distinct(std::span<const std::array<T, 3>> points) {
    detail::WeldMarks marks(points.size());
    for (const std::array<T, 3>& p : points)
        if (!marks.insert(detail::weld_hash({detail::weld_key(p[0]), detail::weld_key(p[1]), detail::weld_key(p[2])})))
            return false;
    return true;
}

/// The mesh with equal points merged. The points keep the order of their first occurrences, faces keep theirs.
/// Requires: every corner refers to a point.
template <class T>
[[nodiscard]] PolygonMesh<T> weld(const PolygonMesh<T>& mesh) {
    const std::vector<std::uint32_t> first = first_equal_points<T>(mesh.points);
    PolygonMesh<T> result;
    std::vector<std::uint32_t> renumbered(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        if (first[i] == i) {
            renumbered[i] = static_cast<std::uint32_t>(result.points.size());
            result.points.push_back(mesh.points[i]);
        } else {
            renumbered[i] = renumbered[first[i]];
        }
    }
    result.first = mesh.first;
    result.corners.reserve(mesh.corners.size());
    for (const std::uint32_t corner : mesh.corners) {
        CLEAVE_REQUIRES(corner < renumbered.size());
        result.corners.push_back(renumbered[corner]);
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Tables that give equal planes and equal points equal numbers, so that identity is a comparison of integers.
///
/// These are the plain tables for a user's number type. Ids count from 0 in the order of first appearance, so they
/// depend on nothing but the sequence of calls.
#ifndef CLEAVE_GEOMETRY_INTERNING_HPP
#define CLEAVE_GEOMETRY_INTERNING_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/canonical.hpp>
#include <cleave/geometry/handles.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Numbers vectors of K integers by value.
template <std::size_t K>
class InternedVectors {
public:
    using Key = std::array<Integer, K>;

    /// The number of the vector, a new one if it has none yet.
    std::uint32_t intern(const Key& key) {
        return index_.try_emplace(key, static_cast<std::uint32_t>(index_.size())).first->second;
    }

    /// The number of the vector, if it has one.
    [[nodiscard]] std::optional<std::uint32_t> find(const Key& key) const {
        const auto found = index_.find(key);
        return found == index_.end() ? std::nullopt : std::optional<std::uint32_t>(found->second);
    }

    [[nodiscard]] std::size_t size() const noexcept { return index_.size(); }

private:
    struct Hash {
        std::size_t operator()(const Key& key) const noexcept {
            std::uint64_t h = K;
            for (const Integer& x : key) h = (h ^ x.hash()) * 0x9e3779b97f4a7c15ULL + (h >> 29U);
            return static_cast<std::size_t>(h);
        }
    };

    std::unordered_map<Key, std::uint32_t, Hash> index_;
};

/// Interned planes: `intern` gives 2k + s, where k numbers the unoriented plane and s = 1 means that it faces against
/// its canonical direction. Coincident planes agree in k, oriented planes that are equal in the whole id.
template <int D, ExactRing N>
class InternedPlanes {
public:
    /// Cost: D + 1 gcds and a hash look-up.
    PlaneId intern(const Plane<D, N>& h) {
        const CanonicalPlane<D> c = canonical(h);
        const std::uint32_t k = index_.intern(c.coefficients);
        if (k == planes_.size()) planes_.push_back(Plane<D, N>(detail::numbers_of<N>(c.coefficients)));
        return 2 * k + (c.is_flipped ? 1U : 0U);
    }

    /// The plane with primitive coefficients.
    [[nodiscard]] Plane<D, N> plane(PlaneId id) const {
        CLEAVE_REQUIRES(unoriented(id) < planes_.size());
        const Plane<D, N>& h = planes_[unoriented(id)];
        return is_flipped(id) ? flip(h) : h;
    }

    /// Number of unoriented planes.
    [[nodiscard]] std::size_t size() const noexcept { return planes_.size(); }

private:
    InternedVectors<std::size_t(D) + 1> index_;
    std::vector<Plane<D, N>> planes_;
};

/// Interned points: equal places have equal ids, whichever planes made them.
template <int D, ExactRing N>
class InternedPoints {
public:
    /// Cost: D + 1 gcds and a hash look-up.
    PointId intern(const Point<D, N>& p) {
        const std::array<Integer, std::size_t(D) + 1> key = primitive_integers(p.homogeneous());
        const std::uint32_t id = index_.intern(key);
        if (id == points_.size()) points_.push_back(Point<D, N>(detail::numbers_of<N>(key)));
        return id;
    }

    /// The point with primitive coordinates.
    [[nodiscard]] const Point<D, N>& point(PointId id) const {
        CLEAVE_REQUIRES(id < points_.size());
        return points_[id];
    }

    [[nodiscard]] std::size_t size() const noexcept { return points_.size(); }

private:
    InternedVectors<std::size_t(D) + 1> index_;
    std::vector<Point<D, N>> points_;
};

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Identity of points: one representative for all kernel points at the same place.
#ifndef CLEAVE_GEOMETRY_POINT_INTERNER_HPP
#define CLEAVE_GEOMETRY_POINT_INTERNER_HPP

#include <cleave/geometry/kernel.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Maps points to representatives by a hash, compared exactly on a hit: the names of a point (which planes it was made
/// from) are many, its coordinates are one. In 3-D the hash is that of the correctly rounded coordinates, which equal
/// points have in common and which are wanted anyway; where many points round alike, and elsewhere, that of the affine
/// coordinates modulo 2^61-1.
template <int D>
class PointInterner {
public:
    explicit PointInterner(Kernel<D>& kernel) : kernel_(&kernel) {}

    /// The representative of p: the first point interned at its place.
    PointId operator()(PointId p) {
        if (p >= representative_.size()) representative_.resize(kernel_->point_count(), no_id);
        if (representative_[p] != no_id) return representative_[p];
        if (kernel_->point(p).kind != PointRecord<D>::Kind::meet) return representative_[p] = by_place(p);
        // The two facets at an edge nearly always name a point on it by the same planes: look the name up first.
        const PointId named = named_like(p);
        return representative_[p] = named == p ? by_place(p) : representative_[named];
    }

    /// The same for a point that is hardly the second under its planes: its place is looked up at once.
    PointId by_place_alone(PointId p) {
        if (p >= representative_.size()) representative_.resize(kernel_->point_count(), no_id);
        return representative_[p] = by_place(p);
    }

private:
    struct Entry {
        std::uint64_t hash;
        PointId point;
    };

    static constexpr std::size_t first_size = 64;

    /// The point interned first under the same planes, in any order; p itself where it is the first.
    PointId named_like(PointId p) {
        if (2 * (names_used_ + 1) > names_.size()) grow_names();
        const std::array<std::uint32_t, D> planes = sorted_planes(p);
        std::size_t at = name_hash(planes) & (names_.size() - 1);
        while (names_[at] != no_id && sorted_planes(names_[at]) != planes) at = (at + 1) & (names_.size() - 1);
        if (names_[at] != no_id) return names_[at];
        ++names_used_;
        return names_[at] = p;
    }

    [[nodiscard]] std::array<std::uint32_t, D> sorted_planes(PointId p) const {
        std::array<std::uint32_t, D> planes = kernel_->point(p).planes;
        for (std::size_t i = 1; i < D; ++i)
            for (std::size_t j = i; j > 0 && planes[j] < planes[j - 1]; --j) std::swap(planes[j], planes[j - 1]);
        return planes;
    }

    static std::size_t name_hash(const std::array<std::uint32_t, D>& planes) noexcept {
        std::uint64_t h = 0x9e3779b97f4a7c15ULL;
        for (const std::uint32_t k : planes) h = (h ^ k) * 0xff51afd7ed558ccdULL;
        return std::size_t(h ^ (h >> 32U));
    }

    void grow_names() {
        const std::vector<PointId> old = std::move(names_);
        names_.assign(old.empty() ? first_size : 2 * old.size(), no_id);
        for (const PointId p : old) {
            if (p == no_id) continue;
            std::size_t at = name_hash(sorted_planes(p)) & (names_.size() - 1);
            while (names_[at] != no_id) at = (at + 1) & (names_.size() - 1);
            names_[at] = p;
        }
    }

    /// So many points that round alike are compared before residues tell others apart.
    static constexpr int alike = 8;

    PointId by_place(PointId p) {
        if (2 * (entries_.size() + 1) > slots_.size()) grow();
        if constexpr (D == 3) {
            if (!kernel_->is_infinite(p)) {
                if (const PointId found = find(p, hash_of_rounded(p), alike); found != no_id) return found;
            }
        }
        return find(p, hash_of_residues(p), std::numeric_limits<int>::max());
    }

    /// The point interned first at p's place under this hash; p itself where it is the first and becomes that; `no_id`
    /// after `most` others.
    PointId find(PointId p, std::uint64_t h, int most) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = std::size_t(h) & mask;
        for (; slots_[at] != no_id; at = (at + 1) & mask) {
            const Entry& e = entries_[slots_[at]];
            if (e.hash != h) continue;
            if (kernel_->same(e.point, p)) return e.point;
            if (--most == 0) return no_id;
        }
        slots_[at] = static_cast<std::uint32_t>(entries_.size());
        entries_.push_back({h, p});
        return p;
    }

    static void mix(std::uint64_t& h, std::uint64_t x) noexcept {
        h ^= x;
        h *= 0xff51afd7ed558ccdULL;
        h ^= h >> 29U;
    }

    std::uint64_t hash_of_rounded(PointId p) {
        kernel_->refine(p);
        std::uint64_t h = 0x9e3779b97f4a7c15ULL;
        for (const double x : kernel_->point(p).approximation) mix(h, std::bit_cast<std::uint64_t>(x + 0.0));
        return h;
    }

    std::uint64_t hash_of_residues(PointId p) {
        std::uint64_t h = 0x2545f4914f6cdd1dULL;
        const auto r = kernel_->residues(p);
        if (!r) return h;  // a weight divisible by the prime: rare, and compared exactly like the rest
        for (const Mod61& x : *r) mix(h, x.value());
        return h;
    }

    void grow() {
        slots_.assign(slots_.empty() ? first_size : 2 * slots_.size(), no_id);
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            std::size_t at = std::size_t(entries_[i].hash) & (slots_.size() - 1);
            while (slots_[at] != no_id) at = (at + 1) & (slots_.size() - 1);
            slots_[at] = static_cast<std::uint32_t>(i);
        }
    }

    Kernel<D>* kernel_;
    std::vector<PointId> representative_;
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> slots_;
    std::vector<PointId> names_;
    std::size_t names_used_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Identity of points: one representative for all kernel points at the same place.
#ifndef CLEAVE_GEOMETRY_POINT_INTERNER_HPP
#define CLEAVE_GEOMETRY_POINT_INTERNER_HPP

#include <cleave/geometry/kernel.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Maps points to representatives by a hash of their affine coordinates modulo 2^61-1, compared exactly on a hit: the
/// names of a point (which planes it was made from) are many, its coordinates are one.
template <int D>
class PointInterner {
public:
    explicit PointInterner(Kernel<D>& kernel) : kernel_(&kernel) {}

    /// The representative of p: the first point interned at its place.
    PointId operator()(PointId p) {
        if (p >= representative_.size()) representative_.resize(kernel_->point_count(), no_id);
        if (representative_[p] != no_id) return representative_[p];
        const std::uint64_t h = hash(p);
        if (2 * (entries_.size() + 1) > slots_.size()) grow();
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = std::size_t(h) & mask;
        for (; slots_[at] != no_id; at = (at + 1) & mask) {
            const Entry& e = entries_[slots_[at]];
            if (e.hash == h && kernel_->same(e.point, p)) return representative_[p] = e.point;
        }
        slots_[at] = static_cast<std::uint32_t>(entries_.size());
        entries_.push_back({h, p});
        return representative_[p] = p;
    }

private:
    struct Entry {
        std::uint64_t hash;
        PointId point;
    };

    std::uint64_t hash(PointId p) {
        const auto r = kernel_->residues(p);
        std::uint64_t h = 0x2545f4914f6cdd1dULL;
        if (!r) return h;  // a weight divisible by the prime: rare, and compared exactly like the rest
        for (const Mod61& x : *r) {
            h ^= x.value();
            h *= 0xff51afd7ed558ccdULL;
            h ^= h >> 29U;
        }
        return h;
    }

    void grow() {
        slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), no_id);
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
};

CLEAVE_END_NAMESPACE

#endif

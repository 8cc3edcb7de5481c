// SPDX-License-Identifier: Apache-2.0
/// The points where edges of one operand cross faces of another, by the names of both.
#ifndef CLEAVE_SETOP_CROSSING_TABLE_HPP
#define CLEAVE_SETOP_CROSSING_TABLE_HPP

#include <cleave/geometry/handles.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A hash table from an edge and a face to a point: open addressing, at most half full.
class CrossingTable {
public:
    struct Key {
        std::uint64_t edge = 0;
        std::uint64_t face = 0;

        friend bool operator==(const Key&, const Key&) = default;
    };

    /// The point of this crossing, `no_id` for one that is new. Valid until the next call.
    [[nodiscard]] PointId& operator[](const Key& key) {
        if (2 * (used_ + 1) > entries_.size()) grow();
        Entry& e = entries_[place(key)];
        if (!e.used) {
            e = {key, no_id, true};
            ++used_;
        }
        return e.point;
    }

    [[nodiscard]] std::size_t size() const noexcept { return used_; }

private:
    struct Entry {
        Key key;
        PointId point = no_id;
        bool used = false;
    };

    static constexpr std::size_t first_size = 32;

    /// Where the key is, or where it goes.
    [[nodiscard]] std::size_t place(const Key& key) const {
        std::uint64_t h = key.edge * 0x9e3779b97f4a7c15ULL;
        h = (h ^ (h >> 29U) ^ key.face) * 0xff51afd7ed558ccdULL;
        std::size_t at = std::size_t(h ^ (h >> 32U)) & (entries_.size() - 1);
        while (entries_[at].used && entries_[at].key != key) at = (at + 1) & (entries_.size() - 1);
        return at;
    }

    void grow() {
        const std::vector<Entry> old = std::move(entries_);
        entries_.assign(old.empty() ? first_size : 2 * old.size(), Entry{});
        for (const Entry& e : old)
            if (e.used) entries_[place(e.key)] = e;
    }

    std::vector<Entry> entries_;
    std::size_t used_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

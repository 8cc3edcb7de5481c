// SPDX-License-Identifier: Apache-2.0
/// Sets of things that turn out to be the same in some respect: union-find.
#ifndef CLEAVE_BASE_DISJOINT_SETS_HPP
#define CLEAVE_BASE_DISJOINT_SETS_HPP

#include <cleave/base/config.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The numbers 0 ... n - 1, each in a set of its own at first [Tarjan-1975]. The least number of a set names it, so the
/// order in which sets were joined leaves no trace.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

    /// The least number in a's set. Cost: amortised logarithmic.
    [[nodiscard]] std::uint32_t find(std::uint32_t a) {
        while (parent_[a] != a) {
            parent_[a] = parent_[parent_[a]];
            a = parent_[a];
        }
        return a;
    }

    /// Makes one set of a's and b's.
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t x = find(a);
        const std::uint32_t y = find(b);
        if (x < y)
            parent_[y] = x;
        else
            parent_[x] = y;
    }

private:
    std::vector<std::uint32_t> parent_;
};

CLEAVE_END_NAMESPACE

#endif

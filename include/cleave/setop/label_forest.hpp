// SPDX-License-Identifier: Apache-2.0
/// Which operands contain which points, found out along edges instead of point by point.
#ifndef CLEAVE_SETOP_LABEL_FOREST_HPP
#define CLEAVE_SETOP_LABEL_FOREST_HPP

#include <cleave/base/boolean_function.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Sets of points whose labels are known relative to each other: a union-find whose links carry the exclusive or of two
/// labels [Tarjan-1975]. A label has a bit for each operand; what is learnt of one point's bits holds,
/// with the links' differences, for all points of its set.
template <class LabelBits = BooleanFunction::Bits>
class BasicLabelForest {
public:
    using Bits = LabelBits;

    explicit BasicLabelForest(std::size_t size) : parent_(size), to_parent_(size, 0), known_(size, 0), value_(size, 0) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    /// The labels of a and b differ in exactly these bits. Requires: that agrees with all that was said before.
    void join(std::uint32_t a, std::uint32_t b, Bits difference) {
        const auto [root_a, to_a] = find(a);
        const auto [root_b, to_b] = find(b);
        if (root_a == root_b) {
            if (Bits(to_a ^ to_b) != difference) consistent_ = false;
            return;
        }
        // The smaller index becomes the root: the order of joins leaves no trace.
        const std::uint32_t root = root_a < root_b ? root_a : root_b;
        const std::uint32_t child = root_a < root_b ? root_b : root_a;
        parent_[child] = root;
        to_parent_[child] = Bits(to_a ^ to_b ^ difference);
        const Bits both = Bits(known_[root] & known_[child]);
        if (((value_[root] ^ value_[child] ^ to_parent_[child]) & both) != 0) consistent_ = false;
        value_[root] = Bits(value_[root] | ((value_[child] ^ to_parent_[child]) & known_[child] & ~known_[root]));
        known_[root] = Bits(known_[root] | known_[child]);
    }

    /// The bits `which` of point a's label are those of `value`.
    void learn(std::uint32_t a, Bits which, Bits value) {
        const auto [root, difference] = find(a);
        if (((value_[root] ^ value ^ difference) & which & known_[root]) != 0) consistent_ = false;
        value_[root] = Bits(value_[root] | ((value ^ difference) & which & ~known_[root]));
        known_[root] = Bits(known_[root] | which);
    }

    /// Whether nothing that was said contradicts what was said before. What contradicts has no effect.
    [[nodiscard]] bool is_consistent() const noexcept { return consistent_; }

    /// The bits of a's label that are known.
    [[nodiscard]] Bits known(std::uint32_t a) { return known_[find(a).first]; }

    /// The label of a; bits that are not known are 0.
    [[nodiscard]] Bits label(std::uint32_t a) {
        const auto [root, difference] = find(a);
        return Bits((value_[root] ^ difference) & known_[root]);
    }

private:
    /// The root of a's set and the difference of a's label from the root's.
    std::pair<std::uint32_t, Bits> find(std::uint32_t a) {
        Bits difference = 0;
        while (parent_[a] != a) {
            const std::uint32_t up = parent_[a];
            to_parent_[a] = Bits(to_parent_[a] ^ to_parent_[up]);  // 0 for a root
            parent_[a] = parent_[up];
            difference = Bits(difference ^ to_parent_[a]);
            a = parent_[a];
        }
        return {a, difference};
    }

    std::vector<std::uint32_t> parent_;
    std::vector<Bits> to_parent_;
    std::vector<Bits> known_, value_;  // of roots
    bool consistent_ = true;
};

using LabelForest = BasicLabelForest<>;

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// A region as a tree that is asked about points.
#ifndef CLEAVE_TESTS_SUPPORT_TREE_SET_HPP
#define CLEAVE_TESTS_SUPPORT_TREE_SET_HPP

#include <cleave/bsp/classify.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/trim.hpp>
#include <cleave/clip/polytope_clip.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/region/tree.hpp>

#include <array>
#include <cstddef>

namespace support {

/// A set as a tree over a kernel, asked about points.
template <int D>
class TreeSet {
public:
    explicit TreeSet(const cleave::Region<D>& region)
        : model_(kernel_), tree_(cleave::tree_of_boundary(region.boundary(), kernel_)) {}

    /// Merged with another set, collapsed and trimmed.
    TreeSet(cleave::Operation operation, const cleave::Region<D>& a, const cleave::Region<D>& b) : TreeSet(a) {
        const cleave::PlaneTree<cleave::PlaneId> other = cleave::tree_of_boundary(b.boundary(), kernel_);
        tree_ =
            cleave::trim(model_, cleave::collapse(cleave::merge(model_, tree_, other, cleave::BooleanRule(operation))));
    }

    /// Nodes and leaves.
    [[nodiscard]] std::size_t size() const { return tree_.node_count() + tree_.leaf_count(); }

    [[nodiscard]] cleave::Location at(const std::array<cleave::Rational, std::size_t(D)>& x) {
        return cleave::classify(model_, tree_, cleave::add_point<cleave::Rational, std::size_t(D)>(kernel_, x));
    }
    [[nodiscard]] bool inside(const std::array<cleave::Rational, std::size_t(D)>& x) {
        return at(x) == cleave::Location::inside;
    }
    [[nodiscard]] bool outside(const std::array<cleave::Rational, std::size_t(D)>& x) {
        return at(x) == cleave::Location::outside;
    }
    [[nodiscard]] bool on(const std::array<cleave::Rational, std::size_t(D)>& x) {
        return at(x) == cleave::Location::boundary;
    }

private:
    cleave::Kernel<D> kernel_;
    cleave::PolytopeClip<D> model_;
    cleave::PlaneTree<cleave::PlaneId> tree_;
};

}  // namespace support

#endif

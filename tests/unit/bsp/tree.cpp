// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/tree.hpp>

#include "support/catch.hpp"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace {

using cleave::Branch;
using cleave::ChildSide;
using Tree = cleave::PlaneTree<int, std::string>;

Tree leaf(const char* label) {
    return Tree(std::string(label));
}

/// Cut k divides what lies at or below cuts k - 1, ..., 0, so the depth is n.
template <class Plane>
cleave::PlaneTree<Plane> chain(std::size_t n, bool on_minus) {
    cleave::PlaneTree<Plane> tree(true);
    for (std::size_t k = 0; k < n; ++k) {
        cleave::PlaneTree<Plane> other(false);
        tree = on_minus ? cleave::PlaneTree<Plane>(Plane(k), std::move(tree), std::move(other))
                        : cleave::PlaneTree<Plane>(Plane(k), std::move(other), std::move(tree));
    }
    return tree;
}

}  // namespace

TEST_CASE("tree: the default is one leaf with the default label") {
    const cleave::PlaneTree<int> empty;
    CHECK(empty.is_single_leaf());
    CHECK(empty.node_count() == 0);
    CHECK(empty.leaf_count() == 1);
    CHECK_FALSE(empty.label(empty.root()));
    CHECK(cleave::PlaneTree<int>(true).label(empty.root()));
    CHECK(cleave::PlaneTree<int>(true) != empty);
}

TEST_CASE("tree: a composed tree has its cuts and labels in their places") {
    const Tree t(1, Tree(2, leaf("a"), leaf("b")), Tree(3, leaf("c"), Tree(4, leaf("d"), leaf("e"))));
    CHECK(t.node_count() == 4);
    CHECK(t.leaf_count() == 5);
    CHECK_FALSE(t.is_single_leaf());
    CHECK(t.cut(t.root()) == 1);
    CHECK(t.cut(t.minus(t.root())) == 2);
    CHECK(t.label(t.minus(t.minus(t.root()))) == "a");
    CHECK(t.label(t.plus(t.minus(t.root()))) == "b");
    CHECK(t.cut(t.plus(t.root())) == 3);
    CHECK(t.label(t.child(t.plus(t.root()), ChildSide::minus)) == "c");
    const Branch four = t.child(t.plus(t.root()), ChildSide::plus);
    CHECK(t.cut(four) == 4);
    CHECK(t.label(t.minus(four)) == "d");
    CHECK(t.label(t.plus(four)) == "e");
    CHECK(t.nodes().size() == 4);
    CHECK(t.leaves().size() == 5);
}

TEST_CASE("tree: equality is that of shape, cuts and labels, not of numbering") {
    const Tree t(1, Tree(2, leaf("a"), leaf("b")), leaf("c"));
    CHECK(t == Tree(1, Tree(2, leaf("a"), leaf("b")), leaf("c")));
    CHECK(t != Tree(1, leaf("c"), Tree(2, leaf("a"), leaf("b"))));
    CHECK(t != Tree(1, Tree(9, leaf("a"), leaf("b")), leaf("c")));
    CHECK(t != Tree(1, Tree(2, leaf("a"), leaf("x")), leaf("c")));
    CHECK(t != leaf("a"));

    cleave::TreeParts<int, std::string> parts;  // the same tree, numbered backwards
    const Branch c = parts.add_leaf("c");
    const Branch b = parts.add_leaf("b");
    const Branch a = parts.add_leaf("a");
    const Branch below = parts.add_node(2);
    const Branch top = parts.add_node(1);
    parts.nodes[below.index()].minus = a;
    parts.nodes[below.index()].plus = b;
    parts.nodes[top.index()].child(ChildSide::minus) = below;
    parts.nodes[top.index()].child(ChildSide::plus) = c;
    parts.root = top;
    CHECK(Tree(parts) == t);
    CHECK(Tree(parts).root() != t.minus(t.root()));
}

TEST_CASE("tree: a copy is independent of its original") {
    Tree t(1, leaf("a"), leaf("b"));
    const Tree copy = t;
    t.set_label(t.minus(t.root()), "z");
    CHECK(t.label(t.minus(t.root())) == "z");
    CHECK(copy.label(copy.minus(copy.root())) == "a");
    const Tree moved = std::move(t);
    CHECK(moved == Tree(1, leaf("z"), leaf("b")));
}

TEST_CASE("tree: planes need neither a default value nor a comparison") {
    struct Odd {
        explicit Odd(std::size_t v) : value(v) {}
        std::size_t value;
    };
    static_assert(!std::is_default_constructible_v<Odd>);
    const cleave::PlaneTree<Odd> t(Odd(7), cleave::PlaneTree<Odd>(true), cleave::PlaneTree<Odd>(false));
    CHECK(t.cut(t.root()).value == 7);
    static_assert(std::is_nothrow_move_constructible_v<cleave::PlaneTree<Odd>>);
}

TEST_CASE("tree: a branch tells nodes, leaves and nothing apart") {
    CHECK(Branch().is_none());
    CHECK_FALSE(Branch().is_node());
    CHECK_FALSE(Branch().is_leaf());
    CHECK(Branch::node(5).is_node());
    CHECK_FALSE(Branch::node(5).is_leaf());
    CHECK(Branch::leaf(5).is_leaf());
    CHECK_FALSE(Branch::leaf(5).is_none());
    CHECK(Branch::node(5) != Branch::leaf(5));
    CHECK(Branch::leaf(5).index() == 5);
    CHECK(Branch::leaf(Branch::limit - 1).is_leaf());
    CHECK(Branch::node(Branch::limit - 1).index() == Branch::limit - 1);
    CHECK(~ChildSide::minus == ChildSide::plus);
    CHECK(~ChildSide::plus == ChildSide::minus);
}

TEST_CASE("tree: depth 100,000 is built, compared, copied and destroyed without recursion") {
    // Planes on the heap, so that destroying them is real work.
    struct Heap {
        explicit Heap(std::size_t v) : value(std::make_shared<std::size_t>(v)) {}
        std::shared_ptr<std::size_t> value;
        bool operator==(const Heap& other) const { return *value == *other.value; }
    };
    const bool on_minus = GENERATE(true, false);
    const cleave::PlaneTree<Heap> t = chain<Heap>(100'000, on_minus);
    CHECK(t.node_count() == 100'000);
    CHECK(t.leaf_count() == 100'001);
    cleave::PlaneTree<Heap> copy = t;
    CHECK(copy == t);
    Branch at = copy.root();
    while (at.is_node()) at = on_minus ? copy.minus(at) : copy.plus(at);
    copy.set_label(at, false);
    CHECK(copy != t);
}

TEST_CASE("tree: asking a leaf for its cut breaks the contract") {
#if CLEAVE_CONTRACTS >= 1
    const Tree t(1, leaf("a"), leaf("b"));
    CHECK_THROWS_AS(t.cut(t.minus(t.root())), cleave::ContractViolation);
    CHECK_THROWS_AS(t.label(t.root()), cleave::ContractViolation);
    CHECK_THROWS_AS(t.label(Branch::leaf(2)), cleave::ContractViolation);
    CHECK_THROWS_AS(t.node(Branch()), cleave::ContractViolation);
#else
    CLEAVE_SKIP("contracts are off");
#endif
}

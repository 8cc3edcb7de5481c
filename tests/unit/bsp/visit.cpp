// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/visit.hpp>

#include "support/catch.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using cleave::Branch;
using cleave::ChildSide;
using cleave::Step;
using cleave::Walk;
using Tree = cleave::PlaneTree<char, char>;

Tree leaf(char label) {
    return Tree(label);
}

/// Cuts are capital letters, leaves small ones; in order from minus to plus: a P b R c Q d S e.
Tree sample() {
    return Tree('R', Tree('P', leaf('a'), leaf('b')), Tree('Q', leaf('c'), Tree('S', leaf('d'), leaf('e'))));
}

char name(const Tree& t, Branch b) {
    return b.is_node() ? t.cut(b) : t.label(b);
}

ChildSide minus_first(Branch /*node*/) {
    return ChildSide::minus;
}

}  // namespace

TEST_CASE("visit: preorder gives parents before children, minus before plus") {
    const Tree t = sample();
    std::string seen;
    CHECK(cleave::visit_preorder(t, [&](Branch b) { seen += name(t, b); }));
    CHECK(seen == "RPabQcSde");
}

TEST_CASE("visit: postorder gives children before parents") {
    const Tree t = sample();
    std::string seen;
    CHECK(cleave::visit_postorder(t, [&](Branch b) { seen += name(t, b); }));
    CHECK(seen == "abPcdeSQR");
}

TEST_CASE("visit: across space the order is that of the side chosen at each node") {
    const Tree t = sample();
    std::string seen;
    CHECK(cleave::visit_across(t, minus_first, [&](Branch b) { seen += name(t, b); }));
    CHECK(seen == "aPbRcQdSe");
    seen.clear();
    cleave::visit_across(
        t, [](Branch) { return ChildSide::plus; }, [&](Branch b) { seen += name(t, b); });
    CHECK(seen == "eSdQcRbPa");
    seen.clear();
    cleave::visit_across(
        t, [&](Branch b) { return t.cut(b) == 'R' ? ChildSide::plus : ChildSide::minus; },
        [&](Branch b) { seen += name(t, b); });
    CHECK(seen == "cQdSeRaPb");
}

TEST_CASE("visit: a walk that is stopped says so and goes no further") {
    const Tree t = sample();
    std::string seen;
    const auto until = [&](char last) {
        return [&seen, &t, last](Branch b) {
            seen += name(t, b);
            return name(t, b) == last ? Walk::stop : Walk::proceed;
        };
    };
    CHECK_FALSE(cleave::visit_preorder(t, until('Q')));
    CHECK(seen == "RPabQ");
    seen.clear();
    CHECK_FALSE(cleave::visit_preorder(t, until('b')));
    CHECK(seen == "RPab");
    seen.clear();
    CHECK_FALSE(cleave::visit_postorder(t, until('P')));
    CHECK(seen == "abP");
    seen.clear();
    CHECK_FALSE(cleave::visit_across(t, minus_first, until('R')));
    CHECK(seen == "aPbR");
    seen.clear();
    CHECK(cleave::visit_across(t, minus_first, until('x')));
}

TEST_CASE("visit: a skipped node keeps its children to itself") {
    const Tree t = sample();
    std::string seen;
    const auto skip = [&](char at) {
        return [&seen, &t, at](Branch b) {
            seen += name(t, b);
            return name(t, b) == at ? Walk::skip : Walk::proceed;
        };
    };
    CHECK(cleave::visit_preorder(t, skip('Q')));
    CHECK(seen == "RPabQ");
    seen.clear();
    CHECK(cleave::visit_preorder(t, skip('P')));
    CHECK(seen == "RPQcSde");
    seen.clear();
    CHECK(cleave::visit_across(t, minus_first, skip('Q')));
    CHECK(seen == "aPbRcQ");
    seen.clear();
    CHECK(cleave::visit_across(t, minus_first, skip('R')));
    CHECK(seen == "aPbR");
    seen.clear();
    CHECK(cleave::visit_postorder(t, skip('P')));
    CHECK(seen == "abPcdeSQR");
}

TEST_CASE("visit: the path names the cuts above a branch and the sides taken") {
    const Tree t = sample();
    std::vector<std::string> paths;
    const auto record = [&](Branch b, std::span<const Step> path) {
        std::string text;
        for (const Step& s : path) {
            text += t.cut(s.node);
            text += s.side == ChildSide::minus ? '-' : '+';
        }
        paths.push_back(text + name(t, b));
    };
    cleave::visit_preorder(t, record);
    CHECK(paths ==
          std::vector<std::string>{"R", "R-P", "R-P-a", "R-P+b", "R+Q", "R+Q-c", "R+Q+S", "R+Q+S-d", "R+Q+S+e"});
    paths.clear();
    cleave::visit_postorder(t, record);
    CHECK(paths ==
          std::vector<std::string>{"R-P-a", "R-P+b", "R-P", "R+Q-c", "R+Q+S-d", "R+Q+S+e", "R+Q+S", "R+Q", "R"});
    paths.clear();
    cleave::visit_across(
        t, [](Branch) { return ChildSide::plus; }, record);
    CHECK(paths ==
          std::vector<std::string>{"R+Q+S+e", "R+Q+S", "R+Q+S-d", "R+Q", "R+Q-c", "R", "R-P+b", "R-P", "R-P-a"});
}

TEST_CASE("visit: a single leaf is visited once") {
    const Tree t = leaf('a');
    std::string seen;
    CHECK(cleave::visit_preorder(t, [&](Branch b) { seen += name(t, b); }));
    CHECK(cleave::visit_postorder(t, [&](Branch b) { seen += name(t, b); }));
    CHECK(cleave::visit_across(t, minus_first, [&](Branch b) { seen += name(t, b); }));
    CHECK(seen == "aaa");
    CHECK_FALSE(cleave::visit_preorder(t, [](Branch) { return Walk::stop; }));
}

TEST_CASE("visit: depth 100,000 is walked without recursion") {
    constexpr std::size_t depth = 100'000;
    cleave::PlaneTree<std::size_t> t(true);
    for (std::size_t k = 0; k < depth; ++k) {
        cleave::PlaneTree<std::size_t> other(false);
        t = k % 2 == 0 ? cleave::PlaneTree<std::size_t>(k, std::move(t), std::move(other))
                       : cleave::PlaneTree<std::size_t>(k, std::move(other), std::move(t));
    }
    std::size_t visits = 0;
    std::size_t deepest = 0;
    const auto count = [&](Branch, std::span<const Step> path) {
        ++visits;
        deepest = path.size() > deepest ? path.size() : deepest;
    };
    cleave::visit_preorder(t, count);
    CHECK(visits == 2 * depth + 1);
    CHECK(deepest == depth);
    cleave::visit_postorder(t, count);
    CHECK(visits == 2 * (2 * depth + 1));
    cleave::visit_across(t, minus_first, count);
    CHECK(visits == 3 * (2 * depth + 1));
}

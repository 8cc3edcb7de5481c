// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/facet_tree.hpp>

#include "support/catch.hpp"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

std::string joined(std::span<const std::string> facets) {
    std::string text;
    for (const std::string& f : facets) text += f;
    return text;
}

}  // namespace

TEST_CASE("facet tree: each node has its own facets of either orientation") {
    cleave::NodeFacets<std::string> kept;
    CHECK(kept.node_count() == 0);
    CHECK(kept.all().empty());
    kept.add_node({"a", "b"}, {});
    kept.add_node({}, {});
    kept.add_node({}, {"c"});
    kept.add_node({"d"}, {"e", "f"});
    REQUIRE(kept.node_count() == 4);
    CHECK(joined(kept.same(cleave::Branch::node(0))) == "ab");
    CHECK(joined(kept.opposite(cleave::Branch::node(0))).empty());
    CHECK(joined(kept.same(cleave::Branch::node(1))).empty());
    CHECK(joined(kept.opposite(cleave::Branch::node(1))).empty());
    CHECK(joined(kept.same(cleave::Branch::node(2))).empty());
    CHECK(joined(kept.opposite(cleave::Branch::node(2))) == "c");
    CHECK(joined(kept.same(cleave::Branch::node(3))) == "d");
    CHECK(joined(kept.opposite(cleave::Branch::node(3))) == "ef");
    CHECK(joined(kept.all()) == "abcdef");
}

TEST_CASE("facet tree: facets are moved in, not copied") {
    cleave::NodeFacets<std::unique_ptr<int>> kept;
    std::vector<std::unique_ptr<int>> same;
    same.push_back(std::make_unique<int>(7));
    const int* address = same.front().get();
    kept.add_node(std::move(same), {});
    CHECK(kept.same(cleave::Branch::node(0)).front().get() == address);
}

TEST_CASE("facet tree: asking for a node without facets breaks the contract") {
#if CLEAVE_CONTRACTS >= 1
    cleave::NodeFacets<std::string> kept;
    kept.add_node({"a"}, {"b"});
    CHECK_THROWS_AS(kept.same(cleave::Branch::node(1)), cleave::ContractViolation);
#else
    CLEAVE_SKIP("contracts are off");
#endif
}

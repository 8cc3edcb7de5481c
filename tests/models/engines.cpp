// SPDX-License-Identifier: Apache-2.0
/// Pairs of real meshes by all engines: tree merging and the localised engine give the set that the boundary filter
/// gives.
#include <cleave/mesh/to_region.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/setop/engines.hpp>

#include "support/catch.hpp"
#include "support/model_pairs.hpp"

#include <cstddef>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Models with more faces than that are left out: to merge the trees of two of these takes seconds.
constexpr std::size_t most_faces = 1300;

void check_pair(const Model& one, const Model& two) {
    INFO(one.name << " and " << two.name);
    const Region<3> a = to_region(one.mesh);
    const Region<3> b = to_region(placed(one.mesh, two.mesh));
    std::vector<std::string> results;
    for (const Operation operation : all_operations) {
        INFO(to_text(operation));
        results.push_back(canonical(apply(Engine::boundary_filter, operation, a, b)));
        CHECK(canonical(apply(Engine::tree_merge, operation, a, b)) == results.back());
        CHECK(canonical(apply(Engine::localised, operation, a, b)) == results.back());
    }
    // The four sets are different ones: both boundaries contribute to each.
    for (std::size_t i = 0; i < results.size(); ++i)
        for (std::size_t j = i + 1; j < results.size(); ++j) CHECK(results[i] != results[j]);
}

}  // namespace

TEST_CASE("pairs of real meshes: all engines give the same sets") {
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set");
    // CLEAVE_ALL_PAIRS=1: every pair; otherwise each model with the next two in size.
    const std::vector<Model> models = models_up_to(*models_dir(), all_pairs() ? most_faces : scaled(most_faces));
    REQUIRE(models.size() > 3);
    for_each_pair(models, check_pair);
}

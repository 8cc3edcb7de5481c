// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/edge_buckets.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/property.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using namespace cleave;
using support::property;

namespace {

bool balanced(const Mesh& mesh) {
    EdgeBuckets buckets;
    return buckets.gather(mesh) && buckets.balanced(0, mesh.points.size());
}

/// A double cone over a ring of n points: the two tips have n faces each.
Mesh double_cone(std::uint32_t n) {
    Mesh mesh;
    mesh.points.resize(n + 2);  // where they are does not matter here
    for (std::uint32_t i = 0; i < n; ++i) {
        mesh.add_face({0, 2 + i, 2 + (i + 1) % n});
        mesh.add_face({2 + (i + 1) % n, 2 + i, 1});
    }
    return mesh;
}

}  // namespace

TEST_CASE("edge_buckets: closed meshes are balanced, whatever their degrees") {
    CHECK(balanced(meshes::cube()));
    CHECK(balanced(meshes::pentomino()));
    CHECK(balanced(Mesh()));
    for (const std::uint32_t n : {3U, 4U, 5U, 8U, 9U, 16U, 17U, 100U}) {
        Mesh mesh = double_cone(n);
        CHECK(balanced(mesh));
        std::swap(mesh.corners[0], mesh.corners[1]);
        CHECK_FALSE(balanced(mesh));
        EdgeBuckets buckets;  // the tip of that face is off as well
        REQUIRE(buckets.gather(mesh));
        CHECK_FALSE(buckets.balanced(0, 1));
        mesh = double_cone(n);
        mesh.corners.resize(mesh.corners.size() - 3);
        mesh.first.pop_back();
        CHECK_FALSE(balanced(mesh));
    }
}

TEST_CASE("edge_buckets: a part of the points is asked about alone") {
    Mesh mesh = double_cone(40);
    mesh.add_face({39, 40, 41});  // edges with the lower points 39 and 40
    EdgeBuckets buckets;
    REQUIRE(buckets.gather(mesh));
    CHECK(buckets.balanced(0, 39));
    CHECK_FALSE(buckets.balanced(39, 40));
    CHECK_FALSE(buckets.balanced(40, 41));
    CHECK(buckets.balanced(41, 42));
}

TEST_CASE("edge_buckets: a corner that refers to no point") {
    Mesh mesh = meshes::cube();
    mesh.corners[7] = 8;
    EdgeBuckets buckets;
    CHECK_FALSE(buckets.gather(mesh));
    mesh = double_cone(5);
    mesh.corners[7] = 7;
    CHECK_FALSE(buckets.gather(mesh));
}

TEST_CASE("edge_buckets: the used points come in the order of their first corners") {
    Mesh mesh;
    mesh.points.resize(9);
    mesh.add_face({7, 2, 5});
    mesh.add_face({2, 7, 3, 5});
    mesh.add_face({0, 0});
    EdgeBuckets buckets;
    REQUIRE(buckets.gather(mesh));
    const auto used = buckets.used_points();
    CHECK(std::vector<std::uint32_t>(used.begin(), used.end()) == std::vector<std::uint32_t>{7, 2, 5, 3, 0});
}

TEST_CASE("edge_buckets: agrees with counting every edge") {
    property("faces of a few points, in pairs that cancel out or nearly", [] {
        Mesh mesh;
        mesh.points.resize(6);
        std::vector<std::vector<std::uint32_t>> faces;
        for (int i = support::draw_int(0, 12); i > 0; --i) {
            std::vector<std::uint32_t> face;
            for (int k = support::draw_int(1, 6); k > 0; --k)
                face.push_back(static_cast<std::uint32_t>(support::draw_int(0, 6)));
            faces.push_back(face);
            std::reverse(face.begin(), face.end());
            if (support::draw_int(0, 10) != 0) faces.push_back(face);
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
        bool has_point_edge = false;
        for (const auto& face : faces) {
            mesh.add_face(face);
            for (std::size_t k = 0; k < face.size(); ++k) {
                const std::uint32_t a = face[k];
                const std::uint32_t b = face[(k + 1) % face.size()];
                has_point_edge = has_point_edge || a == b;
                if (a != b) uses[std::minmax(a, b)] += a < b ? 1 : -1;
            }
        }
        const bool expected = std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
        RC_ASSERT(balanced(mesh) == expected || (has_point_edge && expected));
    });
}

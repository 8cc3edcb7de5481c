// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/face_pairs.hpp>
//
#include <cleave/execution/thread_pool.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

/// n^3 cubes of side 1 at random places of a grid, so that many of their faces touch; in triangles or squares.
Region<3> cubes(Dice& dice, int n, bool triangles, double shift) {
    Mesh mesh;
    for (int i = 0; i < n * n * n; ++i) {
        const Mesh cube = meshes::cube();
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        const std::array<double, 3> at{4.0 * (i % n) + dice.between(0, 1), 4.0 * (i / n % n) + dice.between(0, 1),
                                       4.0 * (i / n / n) + shift};
        for (const auto& p : cube.points) mesh.points.push_back({p[0] + at[0], p[1] + at[1], p[2] + at[2]});
        for (std::size_t f = 0; f < cube.face_count(); ++f) {
            const auto face = cube.face(f);
            for (std::size_t c = 1; c + 1 < face.size(); ++c) {
                if (triangles) {
                    mesh.add_face({first + face[0], first + face[c], first + face[c + 1]});
                } else if (c == 1) {
                    std::vector<std::uint32_t> corners;
                    for (const std::uint32_t corner : face) corners.push_back(first + corner);
                    mesh.add_face(corners);
                }
            }
        }
    }
    return to_region(mesh);
}

std::vector<FacePair> by_force(SurfaceOperands& operands, FaceContact& contact) {
    const auto box = [&](std::uint32_t i, std::uint32_t f) {
        Bounds<3> all;
        const Boundary<3>& b = operands.boundary(i);
        for (const Corner& c : b.faces.corners_of(f))
            all.include(b.points[c.point].approximation, b.points[c.point].error);
        return all;
    };
    std::vector<FacePair> pairs;
    for (std::uint32_t j = 1; j < operands.count(); ++j)
        for (std::uint32_t i = 0; i < j; ++i)
            for (std::uint32_t f = 0; f < operands.boundary(i).faces.faces.size(); ++f)
                for (std::uint32_t g = 0; g < operands.boundary(j).faces.faces.size(); ++g)
                    if (!box(i, f).disjoint(box(j, g)) && contact.reach(i, f, j, g))
                        pairs.push_back({i, j, f, g, contact.signs()});
    return pairs;
}

bool same(const std::vector<FacePair>& a, std::span<const FacePair> b) {
    if (a.size() != b.size()) return false;
    for (std::size_t n = 0; n < a.size(); ++n)
        if (a[n].i != b[n].i || a[n].j != b[n].j || a[n].f != b[n].f || a[n].g != b[n].g || a[n].signs != b[n].signs)
            return false;
    return true;
}

}  // namespace

TEST_CASE("face pairs: what neither boxes nor planes keep apart, in order, with the sides of all corners") {
    Dice dice(21);
    for (int n = 0; n < 24; ++n) {
        std::vector<Region<3>> regions;
        for (int k = 0; k < 2 + n % 3; ++k)
            regions.push_back(cubes(dice, 1 + n % 2, dice.between(0, 1) == 0, 0.5 * dice.between(0, 2)));
        std::vector<const Boundary<3>*> boundaries;
        for (const Region<3>& r : regions) boundaries.push_back(&r.surface());
        SurfaceOperands operands(boundaries);
        FaceContact contact(operands);
        const std::vector<FacePair> expected = by_force(operands, contact);
        CHECK(same(expected, FacePairs(operands, contact, {}, nullptr).pairs()));
        const ThreadPool pool(3);
        CHECK(same(expected, FacePairs(operands, contact, pool, nullptr).pairs()));
    }
}

TEST_CASE("face pairs: many faces, in pieces on several threads") {
    Dice dice(22);
    const Region<3> a = cubes(dice, 9, true, 0);
    const Region<3> b = cubes(dice, 9, true, 0.5);
    const std::array<const Boundary<3>*, 2> boundaries{&a.surface(), &b.surface()};
    SurfaceOperands operands(boundaries);
    FaceContact contact(operands);
    const FacePairs one(operands, contact, {}, nullptr);
    CHECK(one.pairs().size() > 10000);
    CHECK(one.box_pair_count() >= one.pairs().size());
    for (const std::size_t threads : {2U, 5U}) {
        const ThreadPool pool(threads);
        const FacePairs several(operands, contact, pool, nullptr);
        CHECK(same({one.pairs().begin(), one.pairs().end()}, several.pairs()));
        CHECK(several.box_pair_count() == one.box_pair_count());
        for (const std::uint32_t i : {0U, 1U})
            CHECK(std::equal(one.near(i).begin(), one.near(i).end(), several.near(i).begin(), several.near(i).end()));
    }
}

TEST_CASE("face pairs: solids that are tiny beside the distance between them") {
    Dice dice(24);
    // Far away, so that all of the cubes fall into a few floats.
    const auto with_far_cube = [](Region<3> near) {
        Mesh mesh = to_mesh(near);
        const Mesh cube = meshes::cube();
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const auto& p : cube.points) mesh.points.push_back({p[0] + 0x1p40, p[1] + 0x1p40, p[2] - 0x1p40});
        for (std::size_t f = 0; f < cube.face_count(); ++f) {
            std::vector<std::uint32_t> corners;
            for (const std::uint32_t corner : cube.face(f)) corners.push_back(first + corner);
            mesh.add_face(corners);
        }
        return to_region(mesh);
    };
    for (const double shift : {0.0, 0.5}) {
        const Region<3> a = with_far_cube(cubes(dice, 4, true, 0));
        const Region<3> b = with_far_cube(cubes(dice, 4, true, shift));
        const std::array<const Boundary<3>*, 2> boundaries{&a.surface(), &b.surface()};
        SurfaceOperands operands(boundaries);
        FaceContact contact(operands);
        const std::vector<FacePair> expected = by_force(operands, contact);
        CHECK(expected.size() > 100);
        const FacePairs found(operands, contact, {}, nullptr);
        CHECK(same(expected, found.pairs()));
        // Each face was compared with few others.
        CHECK(found.box_pair_count() < 20 * a.surface().faces.faces.size());
        const ThreadPool pool(3);
        CHECK(same(expected, FacePairs(operands, contact, pool, nullptr).pairs()));
    }
}

TEST_CASE("face pairs: a stop that was requested ends them") {
    Dice dice(23);
    const Region<3> a = cubes(dice, 2, true, 0);
    const std::array<const Boundary<3>*, 2> boundaries{&a.surface(), &a.surface()};
    SurfaceOperands operands(boundaries);
    FaceContact contact(operands);
    std::stop_source source;
    const ProgressReporter progress(source.get_token());
    CHECK_NOTHROW(FacePairs(operands, contact, {}, &progress));
    source.request_stop();
    CHECK_THROWS_AS(FacePairs(operands, contact, {}, &progress), Cancelled);
}

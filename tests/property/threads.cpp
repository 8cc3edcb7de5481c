// SPDX-License-Identifier: Apache-2.0
// What several threads make of an operation: the same bytes as one. And one region for several threads at once.
#include <cleave/execution/thread_pool.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/apply.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

/// A sphere of quadrilateral strips, each quadrilateral cut in two: 2 n (n - 1) triangles. Large enough to be shared
/// among threads.
Mesh sphere(std::uint32_t n, std::array<double, 3> centre) {
    const double pi = 3.14159265358979;
    Mesh mesh;
    const auto at = [&](double up, double round) {
        mesh.points.push_back({centre[0] + std::sin(up) * std::cos(round), centre[1] + std::sin(up) * std::sin(round),
                               centre[2] + std::cos(up)});
    };
    at(0, 0);
    for (std::uint32_t i = 1; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) at(pi * i / n, 2 * pi * j / n);
    at(pi, 0);
    const auto ring = [n](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * n + j % n; };
    for (std::uint32_t j = 0; j < n; ++j) {
        mesh.add_face({0, ring(1, j), ring(1, j + 1)});
        for (std::uint32_t i = 1; i + 1 < n; ++i) {
            mesh.add_face({ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)});
            mesh.add_face({ring(i, j), ring(i + 1, j + 1), ring(i, j + 1)});
        }
        mesh.add_face({ring(n - 1, j), ring(n, 0), ring(n - 1, j + 1)});
    }
    return mesh;
}

bool same(const Boundary<3>& a, const Boundary<3>& b) {
    if (a.points.size() != b.points.size() || a.faces.faces.size() != b.faces.faces.size()) return false;
    for (std::size_t p = 0; p < a.points.size(); ++p) {
        const PointRecord<3>& x = a.points[p];
        const PointRecord<3>& y = b.points[p];
        if (x.approximation != y.approximation || x.error != y.error || x.planes != y.planes || x.exact != y.exact ||
            x.kind != y.kind || x.rounded != y.rounded)
            return false;
    }
    for (std::size_t f = 0; f < a.faces.faces.size(); ++f) {
        const FaceList::Face& x = a.faces.faces[f];
        const FaceList::Face& y = b.faces.faces[f];
        if (x.plane != y.plane || x.first_loop != y.first_loop || x.loop_count != y.loop_count || x.source != y.source)
            return false;
    }
    return a.faces.loop_first == b.faces.loop_first && a.faces.corners == b.faces.corners &&
           a.bounds.lo == b.bounds.lo && a.bounds.hi == b.bounds.hi && a.is_complete == b.is_complete &&
           a.is_conforming == b.is_conforming && a.planes.size() == b.planes.size();
}

template <class T>
bool same(const ExportedMesh<T>& a, const ExportedMesh<T>& b) {
    return a.mesh == b.mesh && a.sources == b.sources && a.rounding.points_merged == b.rounding.points_merged &&
           a.rounding.faces_vanished == b.rounding.faces_vanished;
}

constexpr std::array<std::size_t, 4> thread_counts{1, 2, 3, 7};
constexpr std::uint32_t rings = 96;  // 18,240 triangles: several chunks of every stage

}  // namespace

TEST_CASE("threads: regions, results and meshes are the same for every number of threads") {
    const Mesh a = sphere(rings, {0, 0, 0});
    const Mesh b = sphere(rings, {0.51, 0.23, 0.31});
    const Region<3> x = to_region(a);
    const Region<3> y = to_region(b);
    for (const Operation op : {Operation::union_, Operation::symmetric_difference}) {
        const Region<3> z = apply(op, x, y);
        const ExportedMesh<double> mesh = to_exported_mesh(z);
        CHECK(validate(mesh.mesh).is_closed());
        for (const std::size_t threads : thread_counts) {
            const ThreadPool pool(threads);
            ToRegionOptions options;
            options.executor = pool;
            const Region<3> p = to_region(a, options);
            const Region<3> q = to_region(b, options);
            CHECK(same(p.surface(), x.surface()));
            CHECK(same(q.surface(), y.surface()));
            OperationOptions operation;
            operation.executor = pool;
            const Region<3> r = apply(op, p, q, operation);
            CHECK(same(r.surface(), z.surface()));
            CHECK(same(to_exported_mesh(r, {pool}), mesh));
        }
    }
}

TEST_CASE("threads: exact export, and of a boundary that does not conform") {
    const Region<3> x = to_region(sphere(rings / 3, {0, 0, 0}));
    const Region<3> y = to_region(sphere(rings / 3, {0.51, 0.23, 0.31}));
    const Region<3> z = x - y;
    Boundary<3> any = z.boundary();
    any.is_conforming = false;  // nobody says that it does
    const Region<3> unknown(std::move(any));
    const ExportedMesh<Rational> exact = to_exported_rational_mesh(z);
    const ExportedMesh<double> rounded = to_exported_mesh(unknown);
    for (const std::size_t threads : thread_counts) {
        const ThreadPool pool(threads);
        CHECK(same(to_exported_rational_mesh(z, {pool}), exact));
        CHECK(same(to_exported_mesh(unknown, {pool}), rounded));
    }
}

TEST_CASE("threads: every kind of mesh gives the same region or the same message") {
    std::vector<Mesh> cases;
    const Mesh round = sphere(rings, {1, 2, 3});
    cases.push_back(meshes::soup(round));  // points to weld
    Mesh squares;                          // larger faces: cubes in a row
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Mesh cube = meshes::cube();
        const auto first = static_cast<std::uint32_t>(squares.points.size());
        for (const auto& p : cube.points) squares.points.push_back({p[0] + 2 * i, p[1], p[2]});
        for (std::size_t f = 0; f < cube.face_count(); ++f) {
            std::vector<std::uint32_t> face;
            for (const std::uint32_t c : cube.face(f)) face.push_back(first + c);
            squares.add_face(face);
        }
    }
    cases.push_back(squares);
    cases.push_back(round);
    cases.back().points.push_back({9, 9, 9});  // used by no face
    cases.push_back(round);
    cases.back().corners[3000] = 1000000;
    cases.push_back(round);
    cases.back().points[500][1] = std::nan("");
    cases.push_back(round);
    cases.back().points[500] = cases.back().points[501];
    cases.push_back(round);
    std::swap(cases.back().corners[3000], cases.back().corners[3001]);
    cases.push_back(round);
    for (std::size_t f = 0; f < round.face_count(); ++f)
        std::swap(cases.back().corners[3 * f], cases.back().corners[3 * f + 1]);
    const auto outcome = [](const Mesh& mesh, ExecutorRef executor, Boundary<3>& boundary) {
        ToRegionOptions options;
        options.executor = executor;
        try {
            boundary = to_region(mesh, options).surface();
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (const Mesh& mesh : cases) {
        Boundary<3> expected;
        const std::string message = outcome(mesh, {}, expected);
        for (const std::size_t threads : thread_counts) {
            const ThreadPool pool(threads);
            Boundary<3> found;
            CHECK(outcome(mesh, pool, found) == message);
            CHECK(same(found, expected));
        }
    }
}

TEST_CASE("threads: one region for several threads at once") {
    const Region<3> x = to_region(sphere(rings / 3, {0, 0, 0}));
    const Region<3> y = to_region(sphere(rings / 3, {0.51, 0.23, 0.31}));
    const Region<3> z = x | y;
    const Mesh mesh = to_mesh(z);
    constexpr std::size_t users = 4;
    std::array<Mesh, users> found;
    std::array<std::size_t, users> planes{};
    std::array<bool, users> measured{};
    {
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < users; ++i)
            threads.emplace_back([&, i] {
                // All ask for the planes at once, which are made for the first of them.
                planes[i] = z.boundary().planes.size();
                measured[i] = measure(x).has_value();
                const Region<3> copy = x;
                found[i] = to_mesh(copy | y);
            });
        for (std::thread& thread : threads) thread.join();
    }
    for (std::size_t i = 0; i < users; ++i) {
        CHECK(found[i] == mesh);
        CHECK(planes[i] == z.boundary().planes.size());
        CHECK(measured[i]);
    }
}

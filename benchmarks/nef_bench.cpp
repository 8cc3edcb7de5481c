// SPDX-License-Identifier: Apache-2.0
// CGAL's Nef polyhedra beside cleave, on the same pairs in one run: for each pair, cleave's prepare + operate and Nef's
// conversion + union, arrays in memory to a result in memory. Both answers are checked against each other: the exact
// volumes must be equal. `ratio` is Nef's time over cleave's.
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "solids.hpp"

namespace {

using namespace cleave;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Exact::Point_3>;
using Nef = CGAL::Nef_polyhedron_3<Exact>;

Surface surface(const Mesh& mesh) {
    std::vector<Exact::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    Surface s;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, s);
    return s;
}

Rational volume(const Nef& nef) {
    Surface s;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, s, true);
    Rational six(0);
    for (const auto f : s.faces()) {
        std::array<std::array<Rational, 3>, 3> corner;
        std::size_t i = 0;
        for (const auto v : CGAL::vertices_around_face(s.halfedge(f), s)) {
            for (int c = 0; c < 3; ++c) {
                std::ostringstream text;  // CGAL's exact number need not be GMP's type: p/q text carries it over
                text << CGAL::exact(s.point(v)[c]);
                corner[i][std::size_t(c)] = parse_number<Rational>(text.str());
            }
            ++i;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const Rational minor(corner[1][(c + 1) % 3] * corner[2][(c + 2) % 3] -
                                 corner[1][(c + 2) % 3] * corner[2][(c + 1) % 3]);
            six += corner[0][c] * minor;
        }
    }
    return six / 6;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void beside_nef(benchmark::State& state, const Mesh& first, const Mesh& second, bool compare_exactly) {
    double ours = 0;
    double theirs = 0;
    for (auto _ : state) {
        auto start = std::chrono::steady_clock::now();
        const Region<3> result = to_region(first) | to_region(second);
        ours += seconds_since(start);
        const Surface a = surface(first);
        const Surface b = surface(second);
        start = std::chrono::steady_clock::now();
        const Nef nef = Nef(a) + Nef(b);
        theirs += seconds_since(start);
        state.SetIterationTime(seconds_since(start));
        if (compare_exactly && volume(nef) != *measure(result)) {
            state.SkipWithError("the volumes differ");
            return;
        }
        if (!compare_exactly) {
            const Fraction exact = number_traits<Rational>::to_fraction(volume(nef));
            if (Mod61(exact.num) / Mod61(exact.den) != *measure_modulo(result)) {
                state.SkipWithError("the volumes differ modulo 2^61-1");
                return;
            }
        }
    }
    const auto n = static_cast<double>(state.iterations());
    state.counters["cleave_s"] = ours / n;
    state.counters["nef_s"] = theirs / n;
    state.counters["ratio"] = theirs / ours;
}

void models(benchmark::State& state, const char* one, const char* two) {
    const std::optional<Mesh> a = solids::model(one);
    const std::optional<Mesh> b = solids::model(two);
    if (!a || !b) {
        state.SkipWithError("CLEAVE_MODELS_DIR has no such models");
        return;
    }
    beside_nef(state, *a, std::string(one) == two ? solids::rotated(*b) : *b, a->face_count() <= 1300);
}

void cubes(benchmark::State& state) {
    beside_nef(state, solids::cube(0, 0, 0, 1), solids::cube(0.25, 0.5, 0.75, 1), true);
}

void spheres(benchmark::State& state) {
    beside_nef(state, solids::sphere(8, 0), solids::sphere(8, 0.5), true);
}

BENCHMARK(cubes)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(spheres)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1);

const bool registered = [] {
    if (std::getenv("CLEAVE_SMOKE") != nullptr) return false;
    const std::pair<const char*, const char*> pairs[] = {{"part_346", "joint_446"},
                                                         {"anchor_1k", "rotor_1k"},
                                                         {"spot_6k", "spot_6k"},
                                                         {"rocker_arm_20k", "rocker_arm_20k"}};
    for (const auto& p : pairs)
        benchmark::RegisterBenchmark((std::string(p.first) + "_" + p.second).c_str(), models, p.first, p.second)
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    return true;
}();

}  // namespace

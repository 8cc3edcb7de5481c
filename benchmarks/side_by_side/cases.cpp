// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <unordered_map>

#include "../solids.hpp"

namespace side_by_side {
namespace {

using Point = std::array<double, 3>;

/// The icosahedron, its triangles cut in four `levels` times, every corner moved onto the unit sphere.
Arrays icosphere(unsigned levels) {
    const double t = (1 + std::sqrt(5.0)) / 2;
    Arrays s{{{-1, t, 0},
              {1, t, 0},
              {-1, -t, 0},
              {1, -t, 0},
              {0, -1, t},
              {0, 1, t},
              {0, -1, -t},
              {0, 1, -t},
              {t, 0, -1},
              {t, 0, 1},
              {-t, 0, -1},
              {-t, 0, 1}},
             {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
              3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1}};
    const auto unit = [](Point p) {
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        return Point{p[0] / length, p[1] / length, p[2] / length};
    };
    for (Point& p : s.points) p = unit(p);
    for (unsigned level = 0; level < levels; ++level) {
        std::unordered_map<std::uint64_t, std::uint32_t> middles;
        const auto middle = [&](std::uint64_t a, std::uint64_t b) {
            const auto [at, is_new] =
                middles.try_emplace(std::min(a, b) << 32U | std::max(a, b), std::uint32_t(s.points.size()));
            const Point p = s.points[a];
            const Point q = s.points[b];
            if (is_new) s.points.push_back(unit({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}));
            return at->second;
        };
        std::vector<std::uint32_t> corners;
        corners.reserve(4 * s.corners.size());
        for (std::size_t i = 0; i < s.corners.size(); i += 3) {
            const std::uint32_t a = s.corners[i];
            const std::uint32_t b = s.corners[i + 1];
            const std::uint32_t c = s.corners[i + 2];
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            corners.insert(corners.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        s.corners = std::move(corners);
    }
    return s;
}

Arrays arrays(const cleave::Mesh& mesh) {
    return {mesh.points, mesh.corners};
}

Arrays moved(Arrays s, Point by) {
    for (Point& p : s.points)
        for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
    return s;
}

std::pair<Point, Point> box(const Arrays& s) {
    std::pair<Point, Point> b{s.points.front(), s.points.front()};
    for (const Point& p : s.points)
        for (std::size_t i = 0; i < 3; ++i) {
            b.first[i] = std::min(b.first[i], p[i]);
            b.second[i] = std::max(b.second[i], p[i]);
        }
    return b;
}

/// Turned about the middle of its box: about z, then about y, by the angle of this cosine and sine.
Arrays turned(Arrays s, double c, double d) {
    const auto [lo, hi] = box(s);
    const Point o{(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2};
    for (Point& p : s.points) {
        const double x = (p[0] - o[0]) * c - (p[1] - o[1]) * d;
        const double y = (p[0] - o[0]) * d + (p[1] - o[1]) * c;
        const double z = p[2] - o[2];
        p = {x * c + z * d + o[0], y + o[1], z * c - x * d + o[2]};
    }
    return s;
}

/// 3-4-5: the angle whose cosine and sine are rational, by which no two planes of a model turn into each other.
Arrays turned_345(const Arrays& s) {
    return turned(s, 0.6, 0.8);
}

/// The same surface with points, faces and the corners of faces in another order.
Arrays shuffled(const Arrays& s) {
    std::mt19937_64 draw(20240607);  // std::shuffle may differ from one library to another; the generator may not
    const auto order = [&](std::size_t n) {
        std::vector<std::uint32_t> o(n);
        for (std::size_t i = 0; i < n; ++i) {
            o[i] = static_cast<std::uint32_t>(i);
            std::swap(o[i], o[draw() % (i + 1)]);
        }
        return o;
    };
    const std::vector<std::uint32_t> place = order(s.points.size());
    Arrays out;
    out.points.resize(s.points.size());
    for (std::size_t i = 0; i < place.size(); ++i) out.points[place[i]] = s.points[i];
    for (const std::uint32_t f : order(s.face_count())) {
        const std::size_t start = draw() % 3;
        for (std::size_t c = 0; c < 3; ++c) out.corners.push_back(place[s.corners[3 * f + (start + c) % 3]]);
    }
    return out;
}

/// n^3 cubes of side 1 with gaps of 1 between them.
Arrays cubes(unsigned n) {
    Arrays out;
    for (unsigned i = 0; i < n * n * n; ++i) {
        const cleave::Mesh cube = solids::cube(2.0 * (i % n), 2.0 * (i / n % n), 2.0 * (i / n / n), 1);
        const auto first = static_cast<std::uint32_t>(out.points.size());
        out.points.insert(out.points.end(), cube.points.begin(), cube.points.end());
        for (const std::uint32_t corner : cube.corners) out.corners.push_back(first + corner);
    }
    return out;
}

bool has_model(const std::string& name) {
    const char* folder = std::getenv("CLEAVE_MODELS_DIR");
    return folder != nullptr && std::filesystem::exists(std::filesystem::path(folder) / (name + ".off"));
}

constexpr Point offset{0.51, 0.23, 0.31};

std::pair<Arrays, Arrays> with(Arrays first, Arrays second) {
    return {std::move(first), std::move(second)};
}

}  // namespace

std::vector<Case> cases(bool tiny, std::vector<std::string>& missing) {
    std::vector<Case> list;
    const auto add = [&](std::string name, std::function<std::pair<Arrays, Arrays>()> make) {
        list.push_back({std::move(name), Operation::union_, std::move(make)});
    };
    const auto faces = [](unsigned levels) { return "_" + std::to_string(20U << (2 * levels)); };
    const unsigned medium = tiny ? 1 : 5;  // 20,480 faces
    const unsigned large = tiny ? 1 : 6;   // 81,920

    for (const unsigned n : tiny ? std::vector<unsigned>{1} : std::vector<unsigned>{3, 5, 6, 7, 8})
        add("offset" + faces(n), [n] { return with(icosphere(n), moved(icosphere(n), offset)); });
    add("offset_shuffled" + faces(large),
        [=] { return with(shuffled(icosphere(large)), shuffled(moved(icosphere(large), offset))); });
    for (const unsigned n : tiny ? std::vector<unsigned>{1} : std::vector<unsigned>{5, 6})
        add("rotated" + faces(n), [n] { return with(icosphere(n), turned_345(icosphere(n))); });
    add("identical" + faces(medium), [=] { return with(icosphere(medium), icosphere(medium)); });
    for (const char* angle : {"1e-9", "1e-13", "1e-15"})
        add("rotated_" + std::string(angle) + faces(medium), [=] {
            const double a = std::stod(angle);
            return with(icosphere(medium), turned(icosphere(medium), std::cos(a), std::sin(a)));
        });
    add("cube_sphere" + faces(large),
        [=] { return with(arrays(solids::cube(-0.8, -0.8, -0.8, 1.6)), icosphere(large)); });
    add("cube_minus_cube", [] {
        const Arrays cube = arrays(solids::cube(0, 0, 0, 1));
        return with(cube, turned_345(cube));
    });
    list.back().operation = Operation::difference;
    const unsigned n = tiny ? 2 : 12;
    const std::string count = "_" + std::to_string(n * n * n);
    add("cubes_coplanar" + count, [n] { return with(cubes(n), moved(cubes(n), {0.5, 0, 0})); });
    add("cubes_shifted" + count, [n] { return with(cubes(n), moved(cubes(n), offset)); });
    if (tiny) return list;

    for (const char* model : {"rocker_arm_20k", "fandisk_13k", "armadillo_100k", "koala_100k", "thingi_73416_77k"}) {
        if (!has_model(model)) {
            missing.emplace_back(model);
            continue;
        }
        const auto read = [=] { return arrays(*solids::model(model)); };
        add(std::string(model) + "_rotated", [=] {
            const Arrays a = read();
            return with(a, turned_345(a));
        });
        add(std::string(model) + "_shifted", [=] {
            const Arrays a = read();
            const auto [lo, hi] = box(a);
            return with(a, moved(a, {(hi[0] - lo[0]) / 3, (hi[1] - lo[1]) / 5, (hi[2] - lo[2]) / 7}));
        });
    }
    return list;
}

}  // namespace side_by_side

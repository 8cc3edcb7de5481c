// SPDX-License-Identifier: Apache-2.0
/// The main job: the exact union and difference of two solids of more than 5,000 faces each, made here.
///
/// Writes union.off and difference.off, and four_operations.png with the four operations side by side. Prints volumes:
/// those of the operands as fractions, those of the results as fractions where they are short and with 40 digits
/// always.
#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>

#include "support/render.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace cleave;

/// Rounds to a multiple of 1/512: the same solid on every machine, and volumes that are short fractions.
double on_grid(double x) {
    return std::round(x * 512) / 512;
}

/// A closed surface over the torus [0, 1)^2, `around` x `across` quadrilaterals in two triangles each. Going round once
/// ends `shift` places further across.
template <class Surface>
Mesh torus_like(std::uint32_t around, std::uint32_t across, std::uint32_t shift, Surface&& surface) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::array<double, 3> p = surface(double(i) / around, double(j) / across);
            mesh.points.push_back({on_grid(p[0]), on_grid(p[1]), on_grid(p[2])});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return i == around ? (j + shift) % across : i * across + j % across;
    };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.add_face({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// A ring with a square section that turns by a right angle on its way round.
Mesh twisted_ring() {
    constexpr double turn = 2 * std::numbers::pi;
    return torus_like(104, 28, 7, [](double s, double t) {
        const double side = 4 * t - std::floor(4 * t);
        const double corner = turn * std::floor(4 * t) / 4 + turn * s / 4;
        const double next = corner + turn / 4;
        const double u = (1 - side) * std::cos(corner) + side * std::cos(next);
        const double v = (1 - side) * std::sin(corner) + side * std::sin(next);
        const double r = 1.6 + 0.62 * u;
        return std::array<double, 3>{r * std::cos(turn * s), r * std::sin(turn * s), 0.62 * v};
    });
}

/// A ball with twelve gentle bumps round its waist.
Mesh bumpy_ball() {
    constexpr std::uint32_t rings = 38;
    constexpr std::uint32_t slices = 76;
    Mesh mesh;
    const auto add = [&](double theta, double phi) {
        const double r = 1.22 + 0.1 * std::sin(theta) * std::sin(theta) * std::cos(12 * phi);
        mesh.points.push_back({on_grid(1.35 + r * std::sin(theta) * std::cos(phi)),
                               on_grid(-0.35 + r * std::sin(theta) * std::sin(phi)),
                               on_grid(0.3 + r * std::cos(theta))});
    };
    add(0, 0);
    for (std::uint32_t i = 1; i < rings; ++i)
        for (std::uint32_t j = 0; j < slices; ++j) add(std::numbers::pi * i / rings, 2 * std::numbers::pi * j / slices);
    add(std::numbers::pi, 0);
    const auto at = [](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * slices + j % slices; };
    const auto last = static_cast<std::uint32_t>(mesh.points.size() - 1);
    for (std::uint32_t j = 0; j < slices; ++j) {
        mesh.add_face({0, at(1, j), at(1, j + 1)});
        for (std::uint32_t i = 1; i + 1 < rings; ++i) {
            mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.add_face({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        mesh.add_face({at(rings - 1, j + 1), at(rings - 1, j), last});
    }
    return mesh;
}

void print_volume(const char* name, const Region<3>& region) {
    const std::string exact = to_text(*measure(region));
    std::printf("%-20s %6zu faces, volume %s\n", name, region.face_count(), measure_digits(region, 40)->c_str());
    if (exact.size() <= 60)
        std::printf("%-20s %s %s\n", "", "      exactly", exact.c_str());
    else
        std::printf("%-20s %s %s...%s, %zu characters\n", "", "      exactly", exact.substr(0, 12).c_str(),
                    exact.substr(exact.size() - 12).c_str(), exact.size());
}

picture::Body coloured(const Region<3>& region) {
    const ExportedMesh<double> exported = to_exported_mesh(region);
    std::vector<std::uint32_t> operands;
    for (const Source& source : exported.sources) operands.push_back(source.operand);
    return picture::body(exported.mesh, operands);
}

int run() {
    const Region<3> a = to_region(twisted_ring());
    const Region<3> b = to_region(bumpy_ball());
    print_volume("twisted ring", a);
    print_volume("bumpy ball", b);

    const auto start = std::chrono::steady_clock::now();
    const Region<3> any = a | b;
    const Region<3> only_a = a - b;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const Region<3> both = a & b;
    const Region<3> odd = a ^ b;
    print_volume("union", any);
    print_volume("difference", only_a);
    print_volume("intersection", both);
    const bool right = *measure(a) + *measure(b) == *measure(any) + *measure(both);
    std::printf("|A| + |B| = |A or B| + |A and B|: %s\n", right ? "exactly" : "NO");

    write_mesh("union.off", to_mesh(any));
    write_mesh("difference.off", to_mesh(only_a));
    std::printf("wrote union.off and difference.off\n");
    picture::View view;
    view.panel_width = 300;
    view.panel_height = 270;
    view.elevation = 35;
    picture::write_png("four_operations.png",
                       picture::render({{coloured(any)}, {coloured(both)}, {coloured(only_a)}, {coloured(odd)}}, view));
    std::printf("drew four_operations.png: union, intersection, difference, symmetric difference\n");
    std::fprintf(stderr, "union and difference took %.3f s\n", seconds.count());
    return right ? 0 : 1;
}

}  // namespace

int main() {
    try {
        return run();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

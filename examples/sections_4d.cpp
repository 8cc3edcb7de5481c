// SPDX-License-Identifier: Apache-2.0
// A solid in four dimensions: the 24-cell, with a duct drilled through it. Its exact measure, what bounds it, and a
// picture of its cross-sections at five heights, sections.png.
#include <cleave.hpp>

#include "support/render.hpp"

#include <cstddef>
#include <cstdio>
#include <iostream>
#include <vector>

using namespace cleave;

namespace {

/// The points with two coordinates of +-1 and two of 0: the vertices of the regular 24-cell.
std::vector<std::array<Rational, 4>> cell_vertices() {
    std::vector<std::array<Rational, 4>> points;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            for (const int x : {-1, 1})
                for (const int y : {-1, 1}) {
                    std::array<Rational, 4> p{0, 0, 0, 0};
                    p[i] = x;
                    p[j] = y;
                    points.push_back(p);
                }
    return points;
}

}  // namespace

int main() {
    // [solid]
    const Region<4> cell = convex_hull<4>(cell_vertices());
    const Rational r(1, 3);
    const Region<2> profile = box<2>({-r, -r}, {r, r});
    const auto tilt = rational_rotation<4, Integer>(0, 3, 3, 1);
    const Region<4> duct = transform(tilt, extrude(extrude(profile)));  // without end, both ways
    const Region<4> solid = cell - duct;
    // [/solid]
    std::cout << "24-cell: " << facet_planes(cell).size() << " facets, " << vertices(cell).size()
              << " vertices, measure " << *measure(cell) << '\n';
    std::cout << "with a duct: measure " << *measure(solid) << ", taken away " << *measure(cell & duct) << '\n';

    std::vector<picture::Scene> scenes;
    for (const Rational& height : {Rational(-3, 4), Rational(-1, 4), Rational(0), Rational(1, 4), Rational(3, 4)}) {
        const Region<3> slice = section(solid, 3, height);
        std::cout << "at w = " << height << ": volume " << *measure(slice) << ", " << slice.face_count() << " faces\n";
        scenes.push_back(
            {{to_mesh(slice), {picture::operand_colours[scenes.size() % picture::operand_colours.size()]}}});
    }
    picture::View view;
    view.elevation = 48;
    view.panel_width = 320;
    view.panel_height = 320;
    picture::write_png("sections.png", picture::render(scenes, view));
    return equal(solid | (cell & duct), cell) ? 0 : 1;
}

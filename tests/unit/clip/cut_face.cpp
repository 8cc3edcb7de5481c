// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/cut_face.hpp>

#include "support/catch.hpp"

#include <cleave/base/contract.hpp>
#include <cleave/number/sign.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

/// A plane of its own in small integers, indices for points and lines as in an engine: the algorithm sees nothing else.
class Paper {
public:
    using point_type = std::size_t;
    using plane_type = std::int64_t;  // index of a line, negative: flipped; 0: the paper

    struct Corner {
        point_type point;
        plane_type edge;
    };

    std::size_t sides = 0;
    std::size_t crossings = 0;

    point_type point(std::int64_t x, std::int64_t y, std::int64_t w = 1) {
        const std::int64_t g = std::gcd(std::gcd(x, y), w) * (w < 0 ? -1 : 1);
        points_.push_back({x / g, y / g, w / g});
        return points_.size() - 1;
    }

    Sign side(plane_type line, point_type p) {
        ++sides;
        const auto& h = lines_[std::size_t(line < 0 ? -line : line)];
        const auto& q = points_[p];
        const Sign s = sign_of_value(h[0] * q[0] + h[1] * q[1] + h[2] * q[2]);
        return line < 0 ? -s : s;
    }

    Sign compare(point_type a, point_type b) const {
        const auto& p = points_[a];
        const auto& q = points_[b];
        const Sign s = sign_of_value(p[0] * q[2] - q[0] * p[2]);
        return s != Sign::zero ? s : sign_of_value(p[1] * q[2] - q[1] * p[2]);
    }

    point_type cross(plane_type line, plane_type face, plane_type edge, point_type a, point_type b) {
        ++crossings;
        CHECK(face == 0);
        CHECK(side(line, a) * side(line, b) == Sign::minus);
        CHECK(side(edge, a) == Sign::zero);
        CHECK(side(edge, b) == Sign::zero);
        sides -= 4;
        const auto& g = lines_[std::size_t(line < 0 ? -line : line)];
        const auto& h = lines_[std::size_t(edge < 0 ? -edge : edge)];
        return point(g[1] * h[2] - g[2] * h[1], g[2] * h[0] - g[0] * h[2], g[0] * h[1] - g[1] * h[0]);
    }

    plane_type flip_plane(plane_type line) const { return -line; }

    /// The corners of a loop, with the line of each edge: the left side is inside.
    std::vector<Corner> loop(const std::vector<std::pair<int, int>>& corners) {
        std::vector<Corner> result;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto [x, y] = corners[i];
            const auto [u, v] = corners[(i + 1) % corners.size()];
            lines_.push_back({v - y, x - u, std::int64_t(y) * u - std::int64_t(x) * v});
            result.push_back({point(x, y), static_cast<plane_type>(lines_.size() - 1)});
        }
        return result;
    }

    /// Twice the area of a facet; it must be an integer here.
    std::int64_t area(std::span<const std::pair<point_type, plane_type>> corners) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& p = points_[corners[i].first];
            const auto& q = points_[corners[(i + 1) % corners.size()].first];
            CHECK(p[2] == 1);
            sum += p[0] * q[1] - p[1] * q[0];
        }
        return sum;
    }

private:
    std::vector<std::array<std::int64_t, 3>> points_;
    std::vector<std::array<std::int64_t, 3>> lines_{{0, 0, 0}};
};

static_assert(FaceClip<Paper>);

struct Result {
    std::size_t facets = 0;
    std::int64_t area = 0;
    std::vector<std::vector<std::size_t>> points;
};

Result cut(Paper& paper, const std::vector<std::vector<std::pair<int, int>>>& loops) {
    FaceCutter<Paper> cutter(paper, 0);
    for (const auto& loop : loops) cutter.add_loop(paper.loop(loop));
    Result result;
    cutter.cut([&](std::span<const std::pair<std::size_t, std::int64_t>> corners) {
        ++result.facets;
        result.area += paper.area(corners);
        auto& points = result.points.emplace_back();
        for (const auto& [p, edge] : corners) points.push_back(p);
    });
    return result;
}

/// A regular-looking convex polygon with 4 n corners.
std::vector<std::pair<int, int>> round_polygon(int n) {
    std::vector<std::pair<int, int>> corners;
    int x = 0;
    int y = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
        for (int i = 0; i < n; ++i) {
            corners.emplace_back(x, y);
            const int a = n - i;
            const int b = i;
            x += quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
            y += quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
        }
    }
    return corners;
}

}  // namespace

TEST_CASE("cut face: one convex loop costs one side test a corner") {
    Paper paper;
    const auto corners = round_polygon(250);
    const Result r = cut(paper, {corners});
    CHECK(r.facets == 1);
    CHECK(r.points[0].size() == 1000);
    CHECK(paper.sides == 1000);
    CHECK(paper.crossings == 0);
}

TEST_CASE("cut face: one cut turns a comb into a bar and its teeth") {
    // A bar with 200 teeth upward: 400 reflex corners, all cured by one cut.
    std::vector<std::pair<int, int>> comb{{0, 0}, {800, 0}};
    for (int i = 199; i >= 0; --i) {
        comb.emplace_back(4 * i + 4, 2);
        comb.emplace_back(4 * i + 3, 2);
        comb.emplace_back(4 * i + 3, 9);
        comb.emplace_back(4 * i + 1, 9);
        comb.emplace_back(4 * i + 1, 2);
    }
    comb.emplace_back(0, 2);
    Paper paper;
    const Result r = cut(paper, {comb});
    CHECK(r.area == 2 * (800 * 2 + 200 * 2 * 7));
    CHECK(r.facets == 201);
    CHECK(paper.sides <= comb.size() * 10);
}

TEST_CASE("cut face: a grid of holes") {
    std::vector<std::vector<std::pair<int, int>>> loops{{{0, 0}, {61, 0}, {61, 61}, {0, 61}}};
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            const int x = 3 * i + 1;
            const int y = 3 * j + 1;
            loops.push_back({{x, y}, {x, y + 2}, {x + 2, y + 2}, {x + 2, y}});
        }
    }
    Paper paper;
    const Result r = cut(paper, loops);
    CHECK(r.area == 2 * (61 * 61 - 400 * 4));
    CHECK(r.facets <= 1000);
    CHECK(paper.sides <= 4 * 401 * 150);
}

TEST_CASE("cut face: the same loops give the same facets") {
    const std::vector<std::vector<std::pair<int, int>>> loops{
        {{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {4, 6}, {6, 2}}, {{6, 2}, {7, 3}, {7, 1}}};
    Paper a;
    Paper b;
    CHECK(cut(a, loops).points == cut(b, loops).points);
}

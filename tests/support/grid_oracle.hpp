// SPDX-License-Identifier: Apache-2.0
/// The integer-grid oracle: sets of grid cells as bit sets, whose Boolean operations are those of words, and the same
/// sets as regions. Random cell sets touch themselves in vertices and edges wherever they can.
#ifndef CLEAVE_TESTS_SUPPORT_GRID_ORACLE_HPP
#define CLEAVE_TESTS_SUPPORT_GRID_ORACLE_HPP

#include "support/region_checker.hpp"

#include <cleave/mesh/to_region.hpp>
#include <cleave/region/make.hpp>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace support {

/// How a cell set is turned into a boundary. All choices describe the same set.
struct GridStyle {
    Rational unit = 1;              ///< the side of a cell; 1/3 makes every coordinate a true fraction
    bool join_at_vertices = false;  ///< D = 2: loops turn so that they run through vertices where two cells touch
    bool straighten = false;        ///< D = 2: leave out vertices in the middle of a side
    bool triangles = false;         ///< D = 3: two triangles for each square, diagonals alternating
};

/// A set of cells of an S x ... x S grid; cell (i, j, ...) is [i, i+1] x [j, j+1] x ... in units.
template <int D, int S>
class Cells {
public:
    static constexpr std::size_t dimension = std::size_t(D);
    static constexpr std::size_t count = D == 1 ? S : (D == 2 ? S * S : S * S * S);
    using Bits = std::bitset<count>;
    using Index = std::array<int, dimension>;

    Bits bits;

    [[nodiscard]] static std::size_t number(const Index& cell) {
        std::size_t n = 0;
        for (std::size_t i = dimension; i-- > 0;) n = n * std::size_t(S) + std::size_t(cell[i]);
        return n;
    }

    [[nodiscard]] static Index index(std::size_t n) {
        Index cell;
        for (std::size_t i = 0; i < dimension; ++i, n /= std::size_t(S)) cell[i] = int(n % std::size_t(S));
        return cell;
    }

    /// Also for cells outside the grid, which belong to no set.
    [[nodiscard]] bool has(const Index& cell) const {
        for (const int i : cell)
            if (i < 0 || i >= S) return false;
        return bits[number(cell)];
    }

    [[nodiscard]] cleave::Region<D> region(const GridStyle& style = {}) const {
        if constexpr (D == 1) {
            std::vector<std::pair<Rational, Rational>> list;
            for (int i = 0; i < S; ++i)
                if (has({i})) list.push_back({Rational(i * style.unit), Rational((i + 1) * style.unit)});
            return cleave::intervals<Rational>(list);
        } else if constexpr (D == 2) {
            return cleave::polygons<Rational>(loops(style));
        } else {
            return cleave::to_region(mesh(style));
        }
    }

    /// Throws: Defect unless the region is this set (or, if `complemented`, its complement): every cell's centre, a
    /// ring of centres around the grid, and the measure.
    void verify(const cleave::Region<D>& region, const GridStyle& style, bool complemented = false) const {
        const ExactRegion<D> exact(region);
        Index cell;
        cell.fill(-1);
        for (;;) {
            Coordinates<D> centre;
            for (std::size_t i = 0; i < dimension; ++i) centre[i] = (Rational(cell[i]) + Rational(1) / 2) * style.unit;
            const Where expected = has(cell) != complemented ? Where::inside : Where::outside;
            if (exact.locate(centre) != expected) throw Defect("grid oracle: a cell is on the wrong side");
            std::size_t i = 0;
            for (; i < dimension && cell[i] == S; ++i) cell[i] = -1;
            if (i == dimension) break;
            ++cell[i];
        }
        if (complemented) return;
        Rational expected(int(bits.count()));
        for (std::size_t i = 0; i < dimension; ++i) expected *= style.unit;
        if (exact.measure() != expected) throw Defect("grid oracle: wrong measure");
    }

private:
    using Lattice = std::array<int, 2>;

    /// The boundary's unit steps with the set on their left, linked into loops.
    [[nodiscard]] std::vector<std::vector<Coordinates<2>>> loops(const GridStyle& style) const requires(D == 2) {
        std::multimap<Lattice, Lattice> steps;  // from a vertex to the next
        for (int i = 0; i < S; ++i) {
            for (int j = 0; j < S; ++j) {
                if (!has({i, j})) continue;
                if (!has({i, j - 1})) steps.insert({{i, j}, {i + 1, j}});
                if (!has({i + 1, j})) steps.insert({{i + 1, j}, {i + 1, j + 1}});
                if (!has({i, j + 1})) steps.insert({{i + 1, j + 1}, {i, j + 1}});
                if (!has({i - 1, j})) steps.insert({{i, j + 1}, {i, j}});
            }
        }
        std::vector<std::vector<Coordinates<2>>> result;
        while (!steps.empty()) {
            std::vector<Lattice> loop{steps.begin()->first};
            Lattice at = steps.begin()->second;
            steps.erase(steps.begin());
            while (at != loop.front() || steps.count(at) > 1) {
                const Lattice before = loop.back();
                loop.push_back(at);
                auto [first, last] = steps.equal_range(at);
                if (first == last) break;
                auto chosen = first;
                for (auto i = first; i != last; ++i) {
                    const int left =
                        (at[0] - before[0]) * (i->second[1] - at[1]) - (at[1] - before[1]) * (i->second[0] - at[0]);
                    if ((left > 0) != style.join_at_vertices) chosen = i;
                }
                at = chosen->second;
                steps.erase(chosen);
            }
            if (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
            result.push_back(scaled(style, loop));
        }
        return result;
    }

    [[nodiscard]] static std::vector<Coordinates<2>> scaled(const GridStyle& style, const std::vector<Lattice>& loop) {
        std::vector<Coordinates<2>> out;
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Lattice& a = loop[(i + n - 1) % n];
            const Lattice& p = loop[i];
            const Lattice& b = loop[(i + 1) % n];
            const bool straight = (p[0] - a[0]) * (b[1] - p[1]) == (p[1] - a[1]) * (b[0] - p[0]);
            if (!(straight && style.straighten))
                out.push_back({Rational(p[0] * style.unit), Rational(p[1] * style.unit)});
        }
        return out;
    }

    [[nodiscard]] cleave::RationalMesh mesh(const GridStyle& style) const requires(D == 3) {
        cleave::RationalMesh mesh;
        std::map<std::array<int, 3>, std::uint32_t> vertices;
        const auto vertex = [&](const std::array<int, 3>& p) {
            const auto [at, is_new] = vertices.try_emplace(p, std::uint32_t(mesh.points.size()));
            if (is_new)
                mesh.points.push_back(
                    {Rational(p[0] * style.unit), Rational(p[1] * style.unit), Rational(p[2] * style.unit)});
            return at->second;
        };
        for (std::size_t n = 0; n < count; ++n) {
            if (!bits[n]) continue;
            const Index cell = index(n);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (const int up : {0, 1}) {
                    Index neighbour = cell;
                    neighbour[axis] += up == 1 ? 1 : -1;
                    if (has(neighbour)) continue;
                    std::array<std::uint32_t, 4> face{};
                    for (std::size_t c = 0; c < 4; ++c) {
                        Index p = cell;
                        p[axis] += up;
                        // Counter-clockwise as seen along the negative axis: 00, 10, 11, 01.
                        p[(axis + 1) % 3] += c == 1 || c == 2 ? 1 : 0;
                        p[(axis + 2) % 3] += c == 2 || c == 3 ? 1 : 0;
                        face[up == 1 ? c : 3 - c] = vertex(p);
                    }
                    if (!style.triangles) {
                        mesh.add_face(face);
                    } else {
                        const std::size_t turn = n % 2;
                        for (const std::size_t k : {turn, turn + 2})
                            mesh.add_face({face[k % 4], face[(k + 1) % 4], face[(k + 2) % 4]});
                    }
                }
            }
        }
        return mesh;
    }
};

}  // namespace support

#endif

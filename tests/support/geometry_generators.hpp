// SPDX-License-Identifier: Apache-2.0
/// Random points, planes and maps for properties, with small integers so that coincidences are common.
#ifndef CLEAVE_TESTS_SUPPORT_GEOMETRY_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_GEOMETRY_GENERATORS_HPP

#include "support/property.hpp"

#include <cleave/geometry/affine_map.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <cstddef>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace generators {

// Compiled once, in geometry_generators.cpp: integers from which points, planes and maps over any number are made.

/// The homogeneous coordinates of `count` points, one point after the other. Early cases have few different ones.
[[nodiscard]] std::vector<int> draw_points(std::size_t count, std::size_t dimension);

/// The same of two different points in the plane, and of three points in space that are not on a line.
[[nodiscard]] std::vector<int> draw_segment();
[[nodiscard]] std::vector<int> draw_triangle();

/// The coefficients of a plane: not all but the last are zero.
[[nodiscard]] std::vector<int> draw_plane(std::size_t dimension);

/// The rows of a map, row by row, and its weight. Many are singular.
[[nodiscard]] std::vector<int> draw_map(std::size_t dimension);

/// Writes numbers as (1, 2 : 3), the last one apart.
void show_homogeneous(std::ostream& out, std::span<const cleave::Fraction> numbers);

template <std::size_t Size, class N>
void show_homogeneous(std::ostream& out, const std::array<N, Size>& numbers) {
    std::array<cleave::Fraction, Size> fractions;
    for (std::size_t i = 0; i < Size; ++i) fractions[i] = cleave::number_traits<N>::to_fraction(numbers[i]);
    show_homogeneous(out, std::span<const cleave::Fraction>(fractions));
}

/// The point number `index` of those drawn.
template <int D, class N>
[[nodiscard]] cleave::Point<D, N> point(const std::vector<int>& drawn, std::size_t index = 0) {
    typename cleave::Point<D, N>::Homogeneous h;
    for (std::size_t i = 0; i <= std::size_t(D); ++i) h[i] = N(drawn[index * (std::size_t(D) + 1) + i]);
    return cleave::Point<D, N>(std::move(h));
}

}  // namespace generators

namespace support {

template <int D, class N>
struct Drawn<cleave::Point<D, N>> {
    static cleave::Point<D, N> draw() { return generators::point<D, N>(generators::draw_points(1, std::size_t(D))); }
    static void show(std::ostream& out, const cleave::Point<D, N>& p) {
        generators::show_homogeneous(out << "point ", p.homogeneous());
    }
};

template <int D, class N>
struct Drawn<cleave::Plane<D, N>> {
    static cleave::Plane<D, N> draw() {
        const std::vector<int> drawn = generators::draw_plane(std::size_t(D));
        typename cleave::Plane<D, N>::Coefficients c;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) c[i] = N(drawn[i]);
        return cleave::Plane<D, N>(std::move(c));
    }
    static void show(std::ostream& out, const cleave::Plane<D, N>& h) {
        generators::show_homogeneous(out << "plane ", h.coefficients());
    }
};

template <int D, class N>
struct Drawn<cleave::AffineMap<D, N>> {
    static cleave::AffineMap<D, N> draw() {
        const std::vector<int> drawn = generators::draw_map(std::size_t(D));
        auto m = cleave::identity_matrix<D + 1, N>();
        for (int i = 0; i < D; ++i) {
            for (int j = 0; j <= D; ++j) m(i, j) = N(drawn[std::size_t(i * (D + 1) + j)]);
        }
        m(D, D) = N(drawn.back());
        return cleave::AffineMap<D, N>(std::move(m));
    }
    static void show(std::ostream& out, const cleave::AffineMap<D, N>& map) {
        out << "map";
        for (const auto& row : map.homogeneous().row) generators::show_homogeneous(out << " ", row);
    }
};

}  // namespace support

#endif

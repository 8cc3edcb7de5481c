// SPDX-License-Identifier: Apache-2.0
/// Random facets for properties, with small integers so that cuts often go through vertices and along edges.
#ifndef CLEAVE_TESTS_SUPPORT_FACET_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_FACET_GENERATORS_HPP

#include "support/geometry_generators.hpp"

#include <cleave/clip/clip_3d.hpp>
#include <cleave/clip/facet.hpp>
#include <cleave/clip/make_facet.hpp>

#include <ostream>
#include <utility>
#include <vector>

namespace generators {

template <class Facet>
void show_vertices(std::ostream& out, const Facet& f) {
    out << "facet";
    for (const auto& p : cleave::vertices(f)) show_homogeneous(out << " ", p.homogeneous());
}

}  // namespace generators

namespace support {

template <class N>
struct Drawn<cleave::Facet<1, N>> {
    static cleave::Facet<1, N> draw() {
        const auto p = support::draw<cleave::Point<1, N>>();
        return cleave::make_facet(p, draw_bool() ? cleave::Sign::plus : cleave::Sign::minus);
    }
    static void show(std::ostream& out, const cleave::Facet<1, N>& f) {
        generators::show_homogeneous(out << "facet ", f.plane.coefficients());
    }
};

template <class N>
struct Drawn<cleave::Facet<2, N>> {
    static cleave::Facet<2, N> draw() {
        const std::vector<int> ends = generators::draw_segment();
        return *cleave::make_facet(generators::point<2, N>(ends, 0), generators::point<2, N>(ends, 1));
    }
    static void show(std::ostream& out, const cleave::Facet<2, N>& f) { generators::show_vertices(out, f); }
};

/// A triangle, and what a few cuts leave of it: up to seven corners, edge planes of all kinds.
template <class N>
struct Drawn<cleave::Facet<3, N>> {
    static cleave::Facet<3, N> draw() {
        const std::vector<int> drawn = generators::draw_triangle();
        std::vector<cleave::Point<3, N>> corners;
        for (std::size_t i = 0; i < 3; ++i) corners.push_back(generators::point<3, N>(drawn, i));
        cleave::Facet<3, N> f = *cleave::make_facet(corners);
        for (const auto& h : draw_vector<cleave::Plane<3, N>>(draw_index(5))) {
            cleave::Split<cleave::Facet<3, N>> s = cleave::split(h, f);
            if (s.side == cleave::FacetSide::crossing) f = std::move(*s.minus);
        }
        return f;
    }
    static void show(std::ostream& out, const cleave::Facet<3, N>& f) { generators::show_vertices(out, f); }
};

}  // namespace support

#endif

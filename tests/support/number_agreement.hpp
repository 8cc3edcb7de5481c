// SPDX-License-Identifier: Apache-2.0
/// The teaching form of an operation: the boundary filter over `ClipModel<D, N>`, on the same random parts as a
/// `Region`'s. Whatever number is used, the measure of what is kept must be the same rational.
#ifndef CLEAVE_TESTS_SUPPORT_NUMBER_AGREEMENT_HPP
#define CLEAVE_TESTS_SUPPORT_NUMBER_AGREEMENT_HPP

#include "support/region_generators.hpp"

#include <cleave/clip/clip_model.hpp>
#include <cleave/clip/make_facet.hpp>
#include <cleave/setop/boundary_filter.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace support {

/// The boundary of a part as outward loops of integer points; none for a degenerate part.
template <int D>
[[nodiscard]] std::vector<std::vector<std::array<int, std::size_t(D)>>> outward_loops(const Part<D>& part) {
    using Point = std::array<int, std::size_t(D)>;
    std::vector<std::vector<Point>> loops;
    Point lo = part.points[0];
    Point hi = part.points[1];
    for (std::size_t i = 0; i < std::size_t(D) && part.is_box; ++i) {
        if (lo[i] == hi[i]) return loops;
        if (lo[i] > hi[i]) std::swap(lo[i], hi[i]);
    }
    auto v = part.points;
    if (!part.is_box) {
        const int s = sign(orientation<D>(part.vertices()));
        if (s == 0) return loops;
        if (s < 0) std::swap(v[0], v[1]);
    }
    if constexpr (D == 1) {
        if (part.is_box) v = {lo, hi};
        loops = {{v[0]}, {v[1]}};
    } else if constexpr (D == 2) {
        std::vector<Point> outline = {v[0], v[1], v[2]};
        if (part.is_box) outline = {lo, {hi[0], lo[1]}, hi, {lo[0], hi[1]}};
        for (std::size_t i = 0; i < outline.size(); ++i)
            loops.push_back({outline[i], outline[(i + 1) % outline.size()]});
    } else if (part.is_box) {
        const auto corner = [&](std::size_t bits) {
            Point p;
            for (std::size_t i = 0; i < 3; ++i) p[i] = ((bits >> i) & 1U) != 0 ? hi[i] : lo[i];
            return p;
        };
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = std::size_t(1) << ((axis + 1) % 3);
            const std::size_t w = std::size_t(1) << ((axis + 2) % 3);
            const std::size_t top = std::size_t(1) << axis;
            loops.push_back({corner(0), corner(w), corner(u + w), corner(u)});
            loops.push_back({corner(top), corner(top + u), corner(top + u + w), corner(top + w)});
        }
    } else {
        loops = {{v[0], v[2], v[1]}, {v[0], v[1], v[3]}, {v[1], v[2], v[3]}, {v[0], v[3], v[2]}};
    }
    return loops;
}

template <int D, class N>
[[nodiscard]] cleave::FilterOperand<cleave::Facet<D, N>> filter_operand(const Solid<D>& solid) {
    cleave::FilterOperand<cleave::Facet<D, N>> operand;
    for (const auto& loop : outward_loops(solid.parts.front())) {
        std::vector<cleave::Point<D, N>> points;
        for (const auto& p : loop) points.push_back(cleave::make_point<N>(p));
        if constexpr (D == 1)
            operand.facets.push_back(
                cleave::make_facet(points[0], operand.facets.empty() ? cleave::Sign::minus : cleave::Sign::plus));
        else if constexpr (D == 2)
            operand.facets.push_back(*cleave::make_facet(points[0], points[1]));
        else
            operand.facets.push_back(*cleave::make_facet(points));
    }
    if (solid.complemented) {
        operand.value_at_infinity = true;
        for (auto& f : operand.facets) f = cleave::flip(f);
    }
    return operand;
}

/// The signed measure of the cone from the origin over a facet.
template <int D, class N>
[[nodiscard]] Rational cone(const cleave::Facet<D, N>& facet) {
    std::vector<Coordinates<D>> p;
    for (const cleave::Point<D, N>& v : cleave::vertices(facet)) {
        p.emplace_back();
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            const cleave::Fraction x = cleave::number_traits<N>::to_fraction(v[i]);
            const cleave::Fraction w = cleave::number_traits<N>::to_fraction(v.weight());
            p.back()[i] = Rational(rational(x.num, x.den) / rational(w.num, w.den));
        }
    }
    if constexpr (D == 1) {
        const cleave::Sign outside = cleave::number_traits<N>::sign(facet.plane[0]);
        return outside == cleave::Sign::plus ? p[0][0] : Rational(-p[0][0]);
    } else if constexpr (D == 2) {
        return Rational((p[0][0] * p[1][1] - p[0][1] * p[1][0]) / 2);
    } else {
        Rational sum(0);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += dot(p[0], cross(p[i], p[i + 1])) / 6;
        return sum;
    }
}

/// Evaluates in both ways and throws Defect where they differ. Requires: one part a solid.
template <int D, class N>
void check_agreement(const cleave::BooleanFunction& function, const std::vector<Solid<D>>& solids) {
    using Facet = cleave::Facet<D, N>;
    std::vector<cleave::FilterOperand<Facet>> operands;
    std::vector<cleave::Region<D>> regions;
    for (const Solid<D>& s : solids) {
        operands.push_back(filter_operand<D, N>(s));
        regions.push_back(s.region());
    }
    cleave::ClipModel<D, N> model;
    cleave::BoundaryFilter<cleave::ClipModel<D, N>> filter(model, operands, function);
    Rational sum(0);
    filter.run([&](std::size_t, std::size_t, cleave::Action action, const Facet& piece, bool) {
        if (!is_valid(piece)) throw Defect("a piece is no facet");
        sum += cone(action == cleave::Action::flip ? cleave::flip(piece) : piece);
    });
    const cleave::Region<D> result = checked_evaluate<D, Rational>(function, regions);
    if (result.boundary().value_at_infinity != filter.value_at_infinity()) throw Defect("the infinities differ");
    const Rational expected = result.is_bounded() ? ExactRegion<D>(result).measure()
                                                  : Rational(-ExactRegion<D>(cleave::Region<D>(~result)).measure());
    if (sum != expected) throw Defect("the measures differ");
}

/// A solid of one part, perhaps complemented.
template <int D>
[[nodiscard]] Solid<D> draw_convex_solid() {
    const auto part = draw<Part<D>>();
    return {{part}, draw_choice({4, 1}) == 1};
}

/// The four operations on two solids, and "at least two" and parity of three.
template <int D, class N>
void law_of_agreement(std::size_t cases) {
    law("dimension " + std::to_string(D), cases, [] {
        std::vector<Solid<D>> three;
        for (int i = 0; i < 3; ++i) three.push_back(draw_convex_solid<D>());
        const std::vector<Solid<D>> two = {three[0], three[1]};
        for (const cleave::Operation operation : cleave::all_operations)
            check_agreement<D, N>(cleave::BooleanFunction::from(operation, 2), two);
        check_agreement<D, N>(cleave::BooleanFunction::at_least(2, 3), three);
        check_agreement<D, N>(cleave::BooleanFunction::symmetric_difference(3), three);
    });
}

}  // namespace support

#endif

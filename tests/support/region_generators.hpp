// SPDX-License-Identifier: Apache-2.0
/// Random solids for properties: unions of boxes and simplices with corners at small integers, so that coincident
/// planes, touching corners and equal operands are common; now and then a complement. A solid knows which points it
/// contains without any region being built.
#ifndef CLEAVE_TESTS_SUPPORT_REGION_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_REGION_GENERATORS_HPP

#include "support/property.hpp"
#include "support/region_checker.hpp"

#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace support {

/// The determinant of the vectors from p[0] to the other points.
template <int D>
[[nodiscard]] Rational orientation(const std::array<Coordinates<D>, std::size_t(D) + 1>& p) {
    std::array<Coordinates<D>, std::size_t(D)> e;
    for (std::size_t i = 0; i < std::size_t(D); ++i) e[i] = subtract(p[i + 1], p[0]);
    if constexpr (D == 1) return e[0][0];
    if constexpr (D == 2) return Rational(e[0][0] * e[1][1] - e[0][1] * e[1][0]);
    if constexpr (D == 3) return dot(e[0], cross(e[1], e[2]));
}

/// Where p lies with respect to the convex hull of D + 1 points, which may be degenerate (then everything is outside).
template <int D>
[[nodiscard]] Where locate_in_simplex(const std::array<Coordinates<D>, std::size_t(D) + 1>& vertices,
                                      const Coordinates<D>& p) {
    const int whole = sign(orientation<D>(vertices));
    if (whole == 0) return Where::outside;
    Where where = Where::inside;
    for (std::size_t i = 0; i <= std::size_t(D); ++i) {
        auto replaced = vertices;
        replaced[i] = p;
        const int s = sign(orientation<D>(replaced));
        if (s == -whole) return Where::outside;
        if (s == 0) where = Where::boundary;
    }
    return where;
}

/// A box between two corners or the simplex of D + 1 vertices.
template <int D>
struct Part {
    static constexpr std::size_t dimension = std::size_t(D);

    bool is_box = true;
    std::array<std::array<int, dimension>, dimension + 1> points{};  // a box uses the first two

    [[nodiscard]] Coordinates<D> point(std::size_t i) const {
        Coordinates<D> p;
        for (std::size_t j = 0; j < dimension; ++j) p[j] = points[i][j];
        return p;
    }

    [[nodiscard]] std::array<Coordinates<D>, dimension + 1> vertices() const {
        std::array<Coordinates<D>, dimension + 1> v;
        for (std::size_t i = 0; i <= dimension; ++i) v[i] = point(i);
        return v;
    }

    [[nodiscard]] cleave::Region<D> region() const {
        return is_box ? cleave::box<D>(point(0), point(1)) : cleave::simplex<D>(vertices());
    }

    [[nodiscard]] Where locate(const Coordinates<D>& p) const {
        if (!is_box) return locate_in_simplex<D>(vertices(), p);
        Where where = Where::inside;
        for (std::size_t i = 0; i < dimension; ++i) {
            const int lo = std::min(points[0][i], points[1][i]);
            const int hi = std::max(points[0][i], points[1][i]);
            if (lo == hi || p[i] < lo || p[i] > hi) return Where::outside;
            if (p[i] == lo || p[i] == hi) where = Where::boundary;
        }
        return where;
    }

    friend std::ostream& operator<<(std::ostream& out, const Part& part) {
        out << (part.is_box ? "box" : "simplex");
        for (std::size_t i = 0; i < (part.is_box ? 2 : dimension + 1); ++i) {
            out << (i == 0 ? "(" : ", ");
            for (std::size_t j = 0; j < dimension; ++j) out << (j == 0 ? "{" : ",") << part.points[i][j];
            out << "}";
        }
        return out << ")";
    }
};

/// The union of parts, or its complement.
template <int D>
struct Solid {
    std::vector<Part<D>> parts;
    bool complemented = false;

    [[nodiscard]] cleave::Region<D> region() const {
        cleave::Region<D> sum = cleave::Region<D>::empty();
        for (const Part<D>& part : parts) sum = checked(cleave::Operation::union_, sum, part.region());
        return complemented ? ~sum : sum;
    }

    /// Where p lies; `boundary` means "on the boundary of a part", which may be inside the union.
    [[nodiscard]] Where locate(const Coordinates<D>& p) const {
        Where where = complemented ? Where::inside : Where::outside;
        for (const Part<D>& part : parts) {
            const Where w = part.locate(p);
            if (w == Where::boundary) return w;
            if (w == Where::inside) where = complemented ? Where::outside : Where::inside;
        }
        return where;
    }

    friend std::ostream& operator<<(std::ostream& out, const Solid& solid) {
        out << (solid.complemented ? "~(" : "(");
        for (std::size_t i = 0; i < solid.parts.size(); ++i) out << (i == 0 ? "" : " | ") << solid.parts[i];
        return out << ")";
    }
};

/// A bounded solid, for laws about measures.
template <int D>
struct BoundedSolid : Solid<D> {};

/// Rational points near and between the integers that the solids are made of.
template <int D>
struct ProbePoint {
    Coordinates<D> x;

    friend std::ostream& operator<<(std::ostream& out, const ProbePoint& p) {
        for (std::size_t i = 0; i < std::size_t(D); ++i) out << (i == 0 ? "(" : ", ") << cleave::to_text(p.x[i]);
        return out << ")";
    }
};

template <int D>
struct Drawn<Part<D>> {
    static Part<D> draw() {
        Part<D> part;
        part.is_box = draw_bool();
        const std::vector<int> drawn = draw_crowded_ints(part.points.size() * Part<D>::dimension, 0, 5);
        auto next = drawn.begin();
        for (auto& p : part.points)
            for (int& x : p) x = *next++;
        return part;
    }
};

template <int D>
struct Drawn<BoundedSolid<D>> {
    static BoundedSolid<D> draw() { return {{draw_vector<Part<D>>(draw_choice({1, 10, 6, 2})), false}}; }
};

template <int D>
struct Drawn<Solid<D>> {
    static Solid<D> draw() {
        Solid<D> solid = support::draw<BoundedSolid<D>>();
        solid.complemented = draw_choice({4, 1}) == 1;
        return solid;
    }
};

template <int D>
struct Drawn<ProbePoint<D>> {
    static ProbePoint<D> draw() {
        const std::vector<int> numerators = draw_ints(std::size_t(D), -6, 36);
        const int denominator = draw_int(6, 8);
        ProbePoint<D> p;
        for (std::size_t i = 0; i < std::size_t(D); ++i) p.x[i] = Rational(numerators[i]) / denominator;
        return p;
    }
};

}  // namespace support

#endif

// SPDX-License-Identifier: Apache-2.0
/// Regions from coordinates: intervals (D = 1) and polygons with holes (D = 2). Polyhedra come from meshes.
#ifndef CLEAVE_REGION_MAKE_HPP
#define CLEAVE_REGION_MAKE_HPP

#include <cleave/base/error.hpp>
#include <cleave/number/traits.hpp>
#include <cleave/region/build.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Coordinates that describe no region: a loop that is no polygon, a polygon that runs the wrong way round.
class ShapeError : public Error {
public:
    using Error::Error;
};

/// Adds a point with exact coordinates to a kernel, as doubles where they are doubles.
template <int D>
PointId add_point(Kernel<D>& kernel, const std::array<Fraction, D>& x) {
    std::array<double, D> doubles{};
    bool exact = true;
    for (std::size_t i = 0; i < D; ++i) {
        doubles[i] = ratio_to_double(x[i].num, x[i].den);
        const bool power = x[i].den.trailing_zeros() + 1 == x[i].den.bit_length();
        const std::size_t significant = x[i].num.is_zero() ? 0 : x[i].num.bit_length() - x[i].num.trailing_zeros();
        // Subnormals keep fewer bits; leave them to the integers.
        exact = exact && power && significant <= 53 && std::isfinite(doubles[i]) &&
                (x[i].num.is_zero() || std::abs(doubles[i]) >= 0x1p-1000);
    }
    if (exact) return kernel.add_point(doubles);
    Homogeneous<D> h;
    h[D] = Integer(1);
    for (const Fraction& c : x) h[D] = exact_divide(h[D], gcd(h[D], c.den)) * c.den;
    for (std::size_t i = 0; i < D; ++i) h[i] = x[i].num * exact_divide(h[D], x[i].den);
    return kernel.add_point(std::move(h));
}

/// The same for any number type.
template <class N, std::size_t D>
PointId add_point(Kernel<int(D)>& kernel, const std::array<N, D>& x) {
    if constexpr (std::is_same_v<N, double>) {
        for (const double c : x)
            if (!std::isfinite(c)) throw NumberError("a coordinate is not a finite number");
        return kernel.add_point(x);
    } else {
        std::array<Fraction, D> fractions;
        for (std::size_t i = 0; i < D; ++i) fractions[i] = number_traits<N>::to_fraction(x[i]);
        return add_point<int(D)>(kernel, fractions);
    }
}

/// The union of closed intervals [a, b]; they may overlap, touch and come in any order. Ends given in reverse are
/// exchanged; an interval without length adds nothing. Sources count intervals.
template <class N = Rational>
[[nodiscard]] Region<1, N> intervals(std::span<const std::pair<N, N>> list) {
    Kernel<1> kernel;
    PointInterner<1> points(kernel);
    struct End {
        PointId point;
        int change;
        std::uint32_t index;
    };
    std::vector<End> ends;
    for (std::uint32_t i = 0; i < list.size(); ++i) {
        const PointId a = points(add_point<N, 1>(kernel, {list[i].first}));
        const PointId b = points(add_point<N, 1>(kernel, {list[i].second}));
        const Sign order = kernel.compare(0, a, b);
        if (order == Sign::zero) continue;
        ends.push_back({order == Sign::minus ? a : b, 1, i});
        ends.push_back({order == Sign::minus ? b : a, -1, i});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [&](const End& x, const End& y) { return kernel.compare(0, x.point, y.point) == Sign::minus; });
    FaceList faces;
    int depth = 0;
    for (std::size_t i = 0; i < ends.size();) {
        const int before = depth;
        std::size_t j = i;
        for (; j < ends.size() && ends[j].point == ends[i].point; ++j) depth += ends[j].change;
        if ((before == 0) != (depth == 0)) {
            // The canonical plane faces the positive direction: outward at an upper end.
            PlaneId plane = *kernel.join(std::span<const PointId, 1>(&ends[i].point, 1)) & ~1U;
            if (before == 0) plane = flipped(plane);
            kernel.note_incidence(ends[i].point, unoriented(plane));
            const Corner corner{ends[i].point, no_id};
            faces.begin_face(plane, {0, ends[i].index});
            faces.add_loop({&corner, 1});
        }
        i = j;
    }
    return Region<1, N>(freeze(kernel, faces, false, points));
}

/// The same for a braced list: `intervals({{0, 1}, {2, 3}})`.
template <class N = Rational>
[[nodiscard]] Region<1, N> intervals(std::initializer_list<std::pair<N, N>> list) {
    return intervals<N>(std::span<const std::pair<N, N>>(list.begin(), list.size()));
}

/// The set on the left of closed loops of points: outer loops counter-clockwise, holes clockwise.
/// Requires: loops cross neither themselves nor each other (they may touch in points). Sources count edges.
/// Throws: ShapeError if a loop has fewer than three different points or the loops together run clockwise.
template <class N = Rational>
[[nodiscard]] Region<2, N> polygons(std::span<const std::vector<std::array<N, 2>>> loops) {
    Kernel<2> kernel;
    PointInterner<2> points(kernel);
    PolygonBuilder builder(kernel);
    std::uint32_t edge = 0;
    using Field = typename number_traits<Rational>::field_type;
    Field area(0);
    for (std::size_t l = 0; l < loops.size(); ++l) {
        std::vector<PointId> ids;
        for (const std::array<N, 2>& x : loops[l]) {
            const PointId p = points(add_point<N, 2>(kernel, x));
            if (ids.empty() || ids.back() != p) ids.push_back(p);
        }
        while (ids.size() > 1 && ids.front() == ids.back()) ids.pop_back();
        std::vector<PointId> different = ids;
        std::sort(different.begin(), different.end());
        different.erase(std::unique(different.begin(), different.end()), different.end());
        if (different.size() < 3)
            throw ShapeError("loop " + std::to_string(l) + " has fewer than three different points; leave it out");
        for (std::size_t i = 0; i < ids.size(); ++i, ++edge) {
            const PointId q = ids[i + 1 == ids.size() ? 0 : i + 1];
            builder.add(ids[i], q, {0, edge});
            const Homogeneous<2> a = kernel.coordinates(ids[i]);
            const Homogeneous<2> b = kernel.coordinates(q);
            area += number_traits<Rational>::from_fraction(Integer(a[0] * b[1] - a[1] * b[0]), Integer(a[2] * b[2]));
        }
    }
    if (!loops.empty() && number_traits<Rational>::sign(area) != Sign::plus)
        throw ShapeError(
            "the loops run clockwise or enclose no area: give outer loops counter-clockwise, holes clockwise");
    return Region<2, N>(freeze(kernel, builder.finish(), false, points));
}

/// One loop: `polygon<Rational>({{0, 0}, {1, 0}, {0, 1}})`.
template <class N = Rational>
[[nodiscard]] Region<2, N> polygon(const std::vector<std::array<N, 2>>& loop) {
    return polygons<N>(std::span<const std::vector<std::array<N, 2>>>(&loop, 1));
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Oriented lines in any dimension, and what planes cut from them: problems along a line become problems in D = 1.
#ifndef CLEAVE_GEOMETRY_LINE_HPP
#define CLEAVE_GEOMETRY_LINE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <cstddef>
#include <optional>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// The points origin + t * direction. The parameter t is the coordinate of a one-dimensional space of its own.
template <int D, ExactRing N>
class Line {
public:
    static constexpr int dimension = D;
    using number_type = N;

    /// Requires: the direction is not zero.
    Line(Point<D, N> origin, Vector<D, N> direction) : origin_(std::move(origin)), direction_(std::move(direction)) {
        CLEAVE_REQUIRES(!is_zero(direction_));
    }

    /// t = 0.
    [[nodiscard]] const Point<D, N>& origin() const noexcept { return origin_; }
    /// The way from t = 0 to t = 1.
    [[nodiscard]] const Vector<D, N>& direction() const noexcept { return direction_; }

private:
    Point<D, N> origin_;
    Vector<D, N> direction_;
};

/// The line through two points, from a towards b: t = 0 at a and t = W_a W_b at b, the product of the weights (1 for
/// points of weight 1). Returns: nullopt where the points are equal.
template <int D, ExactRing N>
[[nodiscard]] std::optional<Line<D, N>> line_through(const Point<D, N>& a, const Point<D, N>& b) {
    Vector<D, N> direction;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        direction[i] = determinant_of_two<N>(b[i], a[i], b.weight(), a.weight());
    }
    if (is_zero(direction)) return std::nullopt;
    return Line<D, N>(a, std::move(direction));
}

/// The point with the given parameter, itself a point of a one-dimensional space (so that it may be a ratio).
template <int D, ExactRing N>
[[nodiscard]] Point<D, N> point_at(const Line<D, N>& line, const Point<1, N>& t) {
    const N weight(line.origin().weight() * t.weight());
    const N along(line.origin().weight() * t[0]);
    typename Point<D, N>::Homogeneous h;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        N x(line.origin()[i] * t.weight());
        add_product(x, along, line.direction()[i]);
        h[i] = std::move(x);
    }
    h[D] = weight;
    return Point<D, N>(std::move(h));
}

/// What an oriented plane cuts from a line: the plane of the one-dimensional parameter space whose minus side is the
/// part of the line on the minus side of h. So the trace of a half-space is a half-line with its orientation kept.
/// Returns: nullopt where the line is parallel to h (then `side(h, line.origin())` says where all of it lies).
template <int D, ExactRing N>
[[nodiscard]] std::optional<Plane<1, N>> trace(const Line<D, N>& line, const Plane<D, N>& h) {
    // h(o + t v) * W = (n.X + c W) + t W (n.v), and W > 0.
    const N slope(dot(h.normal(), line.direction()));
    if (number_traits<N>::sign(slope) == Sign::zero) return std::nullopt;
    const N scaled_slope(slope * line.origin().weight());
    const N value(dot(h.coefficients(), line.origin().homogeneous()));
    return Plane<1, N>(Vector<2, N>{scaled_slope, value});
}

/// The one common point of a line and a plane. Returns: nullopt where they are parallel.
template <int D, ExactRing N>
[[nodiscard]] std::optional<Point<D, N>> meet(const Line<D, N>& line, const Plane<D, N>& h) {
    const std::optional<Plane<1, N>> t = trace(line, h);
    if (!t) return std::nullopt;
    return point_at(line, Point<1, N>(Vector<2, N>{N(-t->offset()), (*t)[0]}));
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Points in homogeneous coordinates, so that a ring is enough: (X_0, ..., X_{D-1}, W) with W > 0 is the point X / W.
#ifndef CLEAVE_GEOMETRY_POINT_HPP
#define CLEAVE_GEOMETRY_POINT_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/coordinates.hpp>

#include <array>
#include <cstddef>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A point of D-dimensional space. The homogeneous coordinates are one of many equal descriptions: they are fixed up
/// to a positive factor, and `==` compares the points, not the descriptions. The weight is positive.
template <int D, ExactRing N>
requires(D >= 1) class Point {
public:
    static constexpr int dimension = D;
    using number_type = N;
    using field_type = typename number_traits<N>::field_type;
    using Homogeneous = Vector<D + 1, N>;

    /// The origin.
    Point() {
        for (N& x : homogeneous_) x = N(0);
        homogeneous_[D] = N(1);
    }

    /// The point X / W from (X, W). A negative weight is made positive by changing all signs.
    /// Requires: the weight is not zero.
    explicit Point(Homogeneous homogeneous) : homogeneous_(std::move(homogeneous)) {
        const Sign weight_sign = number_traits<N>::sign(weight());
        CLEAVE_REQUIRES(weight_sign != Sign::zero);
        if (weight_sign == Sign::minus) negate_in_place(homogeneous_);
    }

    /// (X_0, ..., X_{D-1}, W).
    [[nodiscard]] const Homogeneous& homogeneous() const noexcept { return homogeneous_; }
    /// X_i, the coordinate times the weight.
    [[nodiscard]] const N& operator[](std::size_t i) const { return homogeneous_[i]; }
    /// W > 0.
    [[nodiscard]] const N& weight() const noexcept { return homogeneous_[D]; }

    /// The coordinate X_i / W. Cost: a division in the field.
    [[nodiscard]] field_type coordinate(std::size_t i) const {
        CLEAVE_REQUIRES(i < std::size_t(D));
        return ratio(homogeneous_[i], weight());
    }

    /// All coordinates.
    [[nodiscard]] Vector<D, field_type> coordinates() const {
        Vector<D, field_type> x;
        for (std::size_t i = 0; i < std::size_t(D); ++i) x[i] = coordinate(i);
        return x;
    }

    /// The same place. Cost: 2 D products where the descriptions differ.
    friend bool operator==(const Point& a, const Point& b) {
        return proportionality(a.homogeneous_, b.homogeneous_) == Sign::plus;
    }

private:
    Homogeneous homogeneous_;
};

/// The point with the given coordinates, of any exact kind: `make_point<Integer>(1, 2.5, Rational(1, 3))`.
/// Throws: NumberError where a coordinate is not finite or does not fit N.
template <ExactRing N, Coordinate... X>
[[nodiscard]] Point<static_cast<int>(sizeof...(X)), N> make_point(const X&... x) {
    CommonDenominator<N, sizeof...(X)> c = over_common_denominator<N>(x...);
    typename Point<static_cast<int>(sizeof...(X)), N>::Homogeneous h;
    for (std::size_t i = 0; i < sizeof...(X); ++i) h[i] = std::move(c.numerators[i]);
    h[sizeof...(X)] = std::move(c.denominator);
    return Point<static_cast<int>(sizeof...(X)), N>(std::move(h));
}

/// The same from an array of coordinates.
template <ExactRing N, Coordinate X, std::size_t K>
[[nodiscard]] Point<static_cast<int>(K), N> make_point(const std::array<X, K>& x) {
    return [&x]<std::size_t... I>(std::index_sequence<I...>) {
        return make_point<N>(x[I]...);
    }
    (std::make_index_sequence<K>());
}

/// Compares one coordinate. Returns: minus where a's is smaller, zero, or plus where it is larger. Cost: 2 products.
template <int D, ExactRing N>
[[nodiscard]] Sign compare_coordinate(const Point<D, N>& a, const Point<D, N>& b, std::size_t axis) {
    // Not the sign of a difference: the two products may be wider than N, and comparing them is all that is needed.
    if (a.weight() == b.weight())
        return a[axis] < b[axis] ? Sign::minus : (b[axis] < a[axis] ? Sign::plus : Sign::zero);
    return number_traits<N>::sign(determinant_of_two<N>(a[axis], b[axis], a.weight(), b.weight()));
}

/// The lexicographic order of places: by coordinate 0, then 1, and so on. Along any line this is an order of the line.
/// Returns: minus where a comes first, zero for equal points, plus. Cost: 2 products for each equal coordinate and 2.
template <int D, ExactRing N>
[[nodiscard]] Sign compare(const Point<D, N>& a, const Point<D, N>& b) {
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        const Sign s = compare_coordinate(a, b, i);
        if (s != Sign::zero) return s;
    }
    return Sign::zero;
}

CLEAVE_END_NAMESPACE

#endif

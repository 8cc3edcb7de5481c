// SPDX-License-Identifier: Apache-2.0
/// Polyhedra with all their vertices exactly on a sphere, and polygons with theirs on a circle.
///
/// A rational t gives the rational point ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) of the unit circle, the stereographic
/// image of t. Two such points, (c, s) for the latitude and (C, S) for the longitude, give (c C, c S, s) on the unit
/// sphere. Nothing is rounded, so the volume of the result is an exact rational that approaches the ball's.
#ifndef CLEAVE_SHAPE_SPHERE_HPP
#define CLEAVE_SHAPE_SPHERE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/rational_point.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Points of the unit circle, counter-clockwise from (1, 0), in nearly equal steps (a few per cent apart). A quarter
/// turn maps the set to itself.
/// Requires: count is a multiple of 4 between 4 and 2^20. Bits: numerators and denominators have about
/// 2 log2(count) + 4.
[[nodiscard]] inline std::vector<RationalPoint<2>> circle_points(std::uint32_t count) {
    CLEAVE_REQUIRES(count >= 4 && count <= (1U << 20U) && count % 4 == 0);
    const std::int64_t n = count / 4;
    const std::int64_t scale = std::int64_t(1) << (std::bit_width(std::uint64_t(n)) + 3);
    std::vector<RationalPoint<2>> points(count);
    for (std::int64_t k = 0; k < n; ++k) {
        // tan(x pi / 4) for x = k / n is 3x / (4 - x^2) within 5 per cent, and equal to it at 0 and 1; here as the
        // nearest multiple of 1 / scale.
        const std::int64_t num = 3 * k * n;
        const std::int64_t den = 4 * n * n - k * k;
        const std::int64_t t = (2 * num * scale + den) / (2 * den);
        const Integer radius(scale * scale + t * t);
        RationalPoint<2> p{number_traits<Rational>::from_fraction(Integer(scale * scale - t * t), radius),
                           number_traits<Rational>::from_fraction(Integer(2 * t * scale), radius)};
        for (std::int64_t at = k; at < 4 * n; at += n) {
            points[std::size_t(at)] = p;
            p = {Rational(-p[1]), p[0]};  // a quarter turn
        }
    }
    return points;
}

/// A convex polygon with `count` corners exactly on the circle of the given centre and radius, count rounded up to a
/// multiple of 4 (at least 4). A negative radius counts as its absolute value; radius 0 gives the empty set.
/// Throws: NumberError for a coordinate that is infinite or NaN.
template <class N = Rational>
[[nodiscard]] Region<2, N> disc(const std::array<N, 2>& centre, const std::type_identity_t<N>& radius,
                                std::uint32_t count = 32) {
    const RationalPoint<2> m = to_rational_point(centre);
    const Rational r = to_rational(radius);
    if (r == 0) return Region<2, N>::empty();
    std::vector<RationalPoint<2>> loop = circle_points(count < 4 ? 4 : (count + 3) / 4 * 4);
    for (RationalPoint<2>& p : loop)
        for (std::size_t i = 0; i < 2; ++i) p[i] = Rational(m[i] + r * p[i]);
    return Region<2, N>(polygon<Rational>(loop));
}

/// How finely a sphere is divided.
struct SphereOptions {
    std::uint32_t slices = 32;  ///< meridians; rounded up to a multiple of 4, at least 4
    std::uint32_t stacks = 16;  ///< bands between the poles; rounded up to an even number, at least 2

    /// The least division with at least `count` faces and twice as many slices as stacks.
    [[nodiscard]] static constexpr SphereOptions with_faces(std::uint32_t count) noexcept {
        std::uint32_t stacks = 2;
        while (std::uint64_t(2) * stacks * stacks < count) stacks += 2;
        return {2 * stacks, stacks};
    }
};

/// A convex polyhedron with all vertices exactly on the sphere of the given centre and radius: slices * stacks faces,
/// triangles at the poles (0, 0, +-radius), plane trapezoids elsewhere (both pairs of corners are mirror images in the
/// plane of the slice, so no trapezoid is warped), slices * (stacks - 1) + 2 vertices. A negative radius counts as its
/// absolute value; radius 0 gives the empty set.
/// Throws: NumberError for a coordinate that is infinite or NaN.
template <class N = Rational>
[[nodiscard]] Region<3, N> sphere(const std::array<N, 3>& centre, const std::type_identity_t<N>& radius,
                                  const SphereOptions& options = {}) {
    const RationalPoint<3> m = to_rational_point(centre);
    Rational r = to_rational(radius);
    if (r == 0) return Region<3, N>::empty();
    if (r < 0) r = Rational(-r);
    const std::uint32_t slices = options.slices < 4 ? 4 : (options.slices + 3) / 4 * 4;
    const std::uint32_t stacks = options.stacks < 2 ? 2 : (options.stacks + 1) / 2 * 2;
    const std::vector<RationalPoint<2>> around = circle_points(slices);
    const std::vector<RationalPoint<2>> upwards = circle_points(2 * stacks);  // the first quarter is used
    RationalMesh mesh;
    const auto add = [&](const Rational& x, const Rational& y, const Rational& z) {
        mesh.points.push_back({Rational(m[0] + r * x), Rational(m[1] + r * y), Rational(m[2] + r * z)});
    };
    add(0, 0, -1);
    for (std::uint32_t band = 1; band < stacks; ++band) {
        const bool north = band >= stacks / 2;
        const RationalPoint<2>& latitude = upwards[north ? band - stacks / 2 : stacks / 2 - band];
        const Rational height(north ? latitude[1] : Rational(-latitude[1]));
        for (const RationalPoint<2>& p : around)
            add(Rational(latitude[0] * p[0]), Rational(latitude[0] * p[1]), height);
    }
    add(0, 0, 1);
    const auto top = static_cast<std::uint32_t>(mesh.points.size() - 1);
    const auto vertex = [&](std::uint32_t band, std::uint32_t slice) {
        return 1 + (band - 1) * slices + slice % slices;
    };
    for (std::uint32_t s = 0; s < slices; ++s) mesh.add_face({0, vertex(1, s + 1), vertex(1, s)});
    for (std::uint32_t b = 1; b + 1 < stacks; ++b)
        for (std::uint32_t s = 0; s < slices; ++s)
            mesh.add_face({vertex(b, s), vertex(b, s + 1), vertex(b + 1, s + 1), vertex(b + 1, s)});
    for (std::uint32_t s = 0; s < slices; ++s) mesh.add_face({vertex(stacks - 1, s), vertex(stacks - 1, s + 1), top});
    return to_region<N>(mesh);
}

CLEAVE_END_NAMESPACE

#endif

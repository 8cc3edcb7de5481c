// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/kernel.hpp>
//
#include <cleave/number/rational.hpp>
#include <cleave/number/traits.hpp>

#include "support/catch.hpp"
#include "support/kernel_planes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

std::array<Rational, 3> rationals(Kernel<3>& kernel, PointId p) {
    const Homogeneous<3> x = kernel.coordinates(p);
    std::array<Rational, 3> r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = number_traits<Rational>::from_fraction(x[i], x[3]);
    return r;
}

/// The side by rational arithmetic alone.
Sign side_by_rationals(Kernel<3>& kernel, PlaneId h, PointId p) {
    const auto& n = kernel.planes.exact(unoriented(h));
    const std::array<Rational, 3> x = rationals(kernel, p);
    Rational sum = number_traits<Rational>::from_integer(n[3]);
    for (std::size_t i = 0; i < 3; ++i) sum += number_traits<Rational>::from_integer(n[i]) * x[i];
    const Sign s = number_traits<Rational>::sign(sum);
    return is_flipped(h) ? -s : s;
}

/// Whether the approximation keeps its promise.
bool error_bound_holds(Kernel<3>& kernel, PointId p) {
    const PointRecord<3> record = kernel.point(p);
    if (!(record.error < std::numeric_limits<double>::infinity())) return true;
    const std::array<Rational, 3> x = rationals(kernel, p);
    for (std::size_t i = 0; i < 3; ++i) {
        Rational off = x[i] - number_traits<Rational>::from_double(record.approximation[i]);
        if (off < 0) off = -off;
        if (off > number_traits<Rational>::from_double(record.error)) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("kernel: sides of input points, crossing points and meets agree with rationals") {
    std::mt19937 random(7);
    std::size_t zeros = 0;
    std::size_t crossings = 0;
    for (std::size_t round = 0; round < scaled(400); ++round) {
        Kernel<3> kernel;
        // Small integers, so that planes through points and parallel planes are frequent; every other round is scaled
        // by an inexact factor, so that coordinates are full doubles.
        const double scale = round % 2 == 0 ? 1.0 : 0.1;
        std::uniform_int_distribution<int> coordinate(-2, 2);
        std::vector<PointId> points;
        for (int i = 0; i < 6; ++i)
            points.push_back(kernel.add_point(
                Doubles<3>{scale * coordinate(random), scale * coordinate(random), scale * coordinate(random)}));
        std::vector<PlaneId> planes;
        for (std::size_t i = 0; i + 2 < points.size(); ++i) {
            const std::array<PointId, 3> through{points[i], points[i + 1], points[i + 2]};
            if (const auto h = kernel.join(std::span<const PointId, 3>(through))) planes.push_back(*h);
        }
        for (int i = 0; i < 3; ++i) {
            const int a = coordinate(random);
            const int b = coordinate(random);
            planes.push_back(plane_of(kernel, a, b, 1, coordinate(random)));
        }
        std::vector<PointId> all = points;
        for (std::size_t i = 0; i + 2 < planes.size(); ++i) {
            const auto& n0 = kernel.planes.exact(unoriented(planes[i]));
            const auto& n1 = kernel.planes.exact(unoriented(planes[i + 1]));
            const auto& n2 = kernel.planes.exact(unoriented(planes[i + 2]));
            RowsView<3, 4, Integer> rows{{&n0, &n1, &n2}};
            if (!minors<WideInteger>(rows)[3].is_zero())
                all.push_back(
                    kernel.add_meet({unoriented(planes[i]), unoriented(planes[i + 1]), unoriented(planes[i + 2])}));
        }
        // A segment that lies on two planes, crossed by a third.
        const std::array<PointId, 3> first{points[0], points[1], points[2]};
        const std::array<PointId, 3> second{points[0], points[1], points[3]};
        const auto f = kernel.join(std::span<const PointId, 3>(first));
        const auto e = kernel.join(std::span<const PointId, 3>(second));
        if (f && e && unoriented(*f) != unoriented(*e))
            for (const PlaneId h : planes)
                if (kernel.side(h, points[0]) * kernel.side(h, points[1]) == Sign::minus) {
                    const PointId x = kernel.cross(h, points[0], points[1], {unoriented(*f), unoriented(*e)});
                    REQUIRE(error_bound_holds(kernel, x));
                    all.push_back(x);
                    ++crossings;
                }
        for (const PlaneId h : planes)
            for (const PointId p : all) {
                const Sign expected = side_by_rationals(kernel, h, p);
                REQUIRE(kernel.side(h, p) == expected);
                REQUIRE(kernel.side(flipped(h), p) == -expected);
                zeros += expected == Sign::zero ? 1U : 0U;
            }
        for (const PointId p : all)
            for (const PointId q : all)
                for (int axis = 0; axis < 3; ++axis) {
                    const auto i = std::size_t(axis);
                    const Rational a = rationals(kernel, p)[i];
                    const Rational b = rationals(kernel, q)[i];
                    REQUIRE(kernel.compare(axis, p, q) == (a < b ? Sign::minus : (b < a ? Sign::plus : Sign::zero)));
                }
        for (const PointId p : all) {
            kernel.refine(p);
            REQUIRE(error_bound_holds(kernel, p));
        }
    }
    CHECK(zeros > 100);
    CHECK(crossings > 20);
}

TEST_CASE("kernel: a plane that misses a point by less than any double can tell fails the filter and is still right") {
    Kernel<3> kernel;
    // z = 2^-200 above the plane z = 0 tilted by 2^-300: the filter's bound is far larger than the distance.
    Homogeneous<3> x;
    x[0] = Integer::scaled(1, 200);
    x[1] = Integer::scaled(1, 200);
    x[2] = Integer(1);
    x[3] = Integer::scaled(1, 200);
    const PointId p = kernel.add_point(x);  // (1, 1, 2^-200)
    const PlaneId below = kernel.planes.intern({Integer(-1), Integer(1), Integer(1), Integer(0)});
    const std::uint64_t failures = kernel.counts().filter_failures;
    CHECK(kernel.side(below, p) == Sign::plus);  // 2^-200 > 0
    CHECK(kernel.side(flipped(below), p) == Sign::minus);
    CHECK(kernel.counts().filter_failures == failures + 2);
    CHECK(kernel.counts().exact_tests == 2);
}

TEST_CASE("kernel: the first approximation fails, the refined one decides") {
    Kernel<3> kernel;
    // Two nearly parallel planes make a crossing point whose interpolated position is poor.
    const PointId a = kernel.add_point(Doubles<3>{0, 0, -1});
    const PointId b = kernel.add_point(Doubles<3>{0x1p60, 0, 1});
    const PlaneId f = plane_of(kernel, 0, 1, 0, 0);
    const std::array<Homogeneous<3>, 3> through{kernel.coordinates(a), kernel.coordinates(b),
                                                Homogeneous<3>{Integer(0), Integer(1), Integer(0), Integer(0)}};
    const PlaneId e = *kernel.join(through);
    const PlaneId h = plane_of(kernel, 0, 0, 3, -1);  // z = 1/3: x = 2/3 * 2^60, not a double
    const PointId x = kernel.cross(h, a, b, {unoriented(f), unoriented(e)});
    CHECK(error_bound_holds(kernel, x));
    const double before = kernel.point(x).error;
    kernel.refine(x);
    CHECK(kernel.point(x).error < before);
    CHECK(error_bound_holds(kernel, x));
    CHECK(kernel.counts().exact_points == 1);
}

TEST_CASE("kernel: a point is on the planes it was made from without any arithmetic") {
    Kernel<3> kernel;
    const PlaneId a = plane_of(kernel, 1, 2, 3, 4);
    const PlaneId b = plane_of(kernel, 2, -1, 1, 0);
    const PlaneId c = plane_of(kernel, 1, 1, -7, 3);
    const PointId p = kernel.add_meet({unoriented(a), unoriented(b), unoriented(c)});
    for (const PlaneId h : {a, b, c}) CHECK(kernel.side(h, p) == Sign::zero);
    CHECK(kernel.counts().by_identity == 3);
    CHECK(kernel.counts().exact_points == 0);
}

TEST_CASE("kernel: coordinates from 1e-300 to 1e300 in one comparison are exact") {
    Kernel<3> kernel;
    const PointId tiny = kernel.add_point(Doubles<3>{1e-300, 1e300, 0});
    const PointId huge = kernel.add_point(Doubles<3>{1e300, -1e-300, 1});
    const PointId origin = kernel.add_point(Doubles<3>{0, 0, 0});
    const std::array<PointId, 3> through{tiny, huge, origin};
    const auto h = kernel.join(std::span<const PointId, 3>(through));
    REQUIRE(h.has_value());
    for (const PointId p : through) CHECK(kernel.side(*h, p) == Sign::zero);
    const PointId beside = kernel.add_point(Doubles<3>{1e-300, 1e300, 1e-300});
    CHECK(kernel.side(*h, beside) == side_by_rationals(kernel, *h, beside));
    CHECK(kernel.side(*h, beside) != Sign::zero);
    CHECK(kernel.compare(0, tiny, huge) == Sign::minus);
}

TEST_CASE("kernel: residues are those of the affine coordinates") {
    Kernel<3> kernel;
    const PointId p = kernel.add_point(Doubles<3>{0.5, -3, 0x1p-70});
    const auto r = kernel.residues(p);
    REQUIRE(r.has_value());
    CHECK((*r)[0] * Mod61(2) == Mod61(1));
    CHECK((*r)[1] == Mod61(0) - Mod61(3));
    CHECK((*r)[2] * Mod61(std::uint64_t(1) << 9) == Mod61(1));  // 2^61 = 1, so 2^-70 = 2^-9
    // The same point as a meet, and as integers with a common factor.
    const PointId q = kernel.add_point(Homogeneous<3>{Integer(10), Integer(-60), Integer(0), Integer(20)});
    const PointId m =
        kernel.add_meet({unoriented(plane_of(kernel, 2, 0, 0, -1)), unoriented(plane_of(kernel, 0, 1, 0, 3)),
                         unoriented(plane_of(kernel, 0, 0, 1, 0))});
    CHECK(*kernel.residues(q) == *kernel.residues(m));
    CHECK(kernel.same(q, m));
}

TEST_CASE("kernel: a weight divisible by the prime is reduced before it is given up") {
    Kernel<3> kernel;
    const Integer p61 = Integer::scaled(1, 61) - Integer(1);
    // (p, 2p, 3p) / p is (1, 2, 3).
    const PointId reducible = kernel.add_point(Homogeneous<3>{p61, p61 * Integer(2), p61 * Integer(3), p61});
    REQUIRE(kernel.residues(reducible).has_value());
    CHECK((*kernel.residues(reducible))[2] == Mod61(3));
    const PointId not_reducible = kernel.add_point(Homogeneous<3>{Integer(1), Integer(0), Integer(0), p61});
    CHECK_FALSE(kernel.residues(not_reducible).has_value());
    CHECK(kernel.same(not_reducible,
                      kernel.add_point(Homogeneous<3>{Integer(2), Integer(0), Integer(0), p61 * Integer(2)})));
}

TEST_CASE("kernel: join needs points that span a plane") {
    Kernel<3> kernel;
    const std::array<PointId, 3> line{kernel.add_point(Doubles<3>{0, 0, 0}), kernel.add_point(Doubles<3>{1, 2, 3}),
                                      kernel.add_point(Doubles<3>{2, 4, 6})};
    CHECK_FALSE(kernel.join(std::span<const PointId, 3>(line)).has_value());
    const std::array<PointId, 3> up{kernel.add_point(Doubles<3>{0, 0, 5}), kernel.add_point(Doubles<3>{1, 0, 5}),
                                    kernel.add_point(Doubles<3>{0, 1, 5})};
    const auto h = kernel.join(std::span<const PointId, 3>(up));
    REQUIRE(h.has_value());
    CHECK(kernel.side(*h, kernel.add_point(Doubles<3>{0, 0, 6})) == Sign::plus);  // counter-clockwise seen from above
    CHECK(kernel.side(*h, kernel.add_point(Doubles<3>{0, 0, 4})) == Sign::minus);
}

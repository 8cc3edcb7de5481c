// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/rounded_meet.hpp>
//
#include <cleave/geometry/kernel.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

using namespace cleave;
using support::Dice;

namespace {

/// The kernel's planes as pairs of doubles.
std::array<DoubleDoublePlane, 3> rows(Kernel<3>& kernel, const std::array<std::uint32_t, 3>& planes) {
    std::array<DoubleDoublePlane, 3> out;
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t i = 0; i < 4; ++i)
            out[n][i] = {kernel.planes.approximation(planes[n])[i], kernel.planes.tail(planes[n])[i]};
    return out;
}

/// The correctly rounded coordinates of the exact meet.
std::array<double, 3> rounded_exactly(Kernel<3>& kernel, const std::array<std::uint32_t, 3>& planes) {
    const Homogeneous<3> x = kernel.meet(planes);
    return {ratio_to_double(x[0], x[3]), ratio_to_double(x[1], x[3]), ratio_to_double(x[2], x[3])};
}

std::array<double, 3> draw(Dice& dice, double scale) {
    std::array<double, 3> p{};
    for (double& x : p) x = scale * double(dice.between(-(1 << 29), 1 << 29)) + double(dice.between(-9, 9));
    return p;
}

}  // namespace

TEST_CASE("rounded meet: random planes give the rounded exact coordinates, and it hardly ever abstains") {
    Dice dice(3);
    int abstained = 0;
    int meets = 0;
    for (int n = 0; n < 3000; ++n) {
        Kernel<3> kernel;
        std::array<std::uint32_t, 3> planes{};
        for (std::uint32_t& k : planes) {
            const std::array<PointId, 3> p{kernel.add_point(draw(dice, 0x1p-31)), kernel.add_point(draw(dice, 0x1p-31)),
                                           kernel.add_point(draw(dice, 0x1p-31))};
            k = unoriented(kernel.join(std::span<const PointId, 3>(p)).value());
        }
        const std::optional<std::array<double, 3>> x = rounded_meet(rows(kernel, planes));
        ++meets;
        if (!x) {
            ++abstained;
            continue;
        }
        CHECK(*x == rounded_exactly(kernel, planes));
        // The kernel takes it, and says so.
        const PointId p = kernel.add_meet(planes);
        kernel.refine(p);
        CHECK(kernel.point(p).approximation == *x);
        CHECK(kernel.counts().exact_points == 0);
    }
    CHECK(abstained * 1000 <= meets);
}

TEST_CASE("rounded meet: small integers, with coordinates that are zero, halves and ties") {
    Dice dice(4);
    int abstained = 0;
    int decided = 0;
    for (int n = 0; n < 5000; ++n) {
        Kernel<3> kernel;
        std::array<std::uint32_t, 3> planes{};
        for (std::uint32_t& k : planes) {
            std::array<Integer, 4> c;
            do
                for (Integer& x : c) x = Integer(dice.between(-3, 3));
            while (c[0].is_zero() && c[1].is_zero() && c[2].is_zero());
            k = unoriented(kernel.planes.intern(c));
        }
        RowsView<3, 4, Integer> view{};
        for (std::size_t i = 0; i < 3; ++i) view.row[i] = &kernel.planes.exact(planes[i]);
        if (minors<WideInteger>(view)[3].is_zero()) {
            CHECK_FALSE(rounded_meet(rows(kernel, planes)));  // no point, and it must not invent one
            continue;
        }
        const std::optional<std::array<double, 3>> x = rounded_meet(rows(kernel, planes));
        x ? ++decided : ++abstained;
        if (x) CHECK(*x == rounded_exactly(kernel, planes));
        const PointId p = kernel.add_meet(planes);
        kernel.refine(p);
        CHECK(kernel.point(p).approximation == rounded_exactly(kernel, planes));
    }
    CHECK(decided > 0);
    CHECK(abstained > 0);  // a coordinate that may be zero
}

TEST_CASE("rounded meet: what two doubles do not tell is left to integers") {
    // x = 1 + 2^-53 + 2^-200 lies just above the middle between two doubles.
    Kernel<3> kernel;
    Integer one = Integer::scaled(1, 200);
    one += Integer::scaled(1, 147);
    one += Integer(1);
    const std::array<std::uint32_t, 3> planes{
        unoriented(kernel.planes.intern({Integer::scaled(1, 200), Integer(0), Integer(0), -one})),
        unoriented(kernel.planes.intern({Integer(0), Integer(1), Integer(0), Integer(-5)})),
        unoriented(kernel.planes.intern({Integer(0), Integer(0), Integer(1), Integer(-7)}))};
    CHECK_FALSE(rounded_meet(rows(kernel, planes)));
    const PointId p = kernel.add_meet(planes);
    kernel.refine(p);
    CHECK(kernel.point(p).approximation == std::array<double, 3>{1 + 0x1p-52, 5, 7});
    // Nearly parallel planes: the determinant is -1, of products of 2^120.
    const Integer large = Integer::scaled(1, 60);
    const std::array<std::uint32_t, 3> thin{
        unoriented(kernel.planes.intern({large, large + Integer(1), Integer(0), Integer(3)})),
        unoriented(kernel.planes.intern({large + Integer(1), large + Integer(2), Integer(0), Integer(5)})), planes[2]};
    CHECK_FALSE(rounded_meet(rows(kernel, thin)));
    const PointId q = kernel.add_meet(thin);
    kernel.refine(q);
    CHECK(kernel.point(q).approximation == rounded_exactly(kernel, thin));
    // Out of range: no doubles stand for a plane so far away, and the kernel does not ask for any.
    const std::array<std::uint32_t, 3> far{
        unoriented(kernel.planes.intern({Integer(1), Integer(0), Integer(0), Integer::scaled(-3, 920)})), planes[1],
        planes[2]};
    const PointId r = kernel.add_meet(far);
    kernel.refine(r);
    CHECK(kernel.point(r).approximation == std::array<double, 3>{0x3p920, 5, 7});
    std::array<DoubleDoublePlane, 3> large_rows = rows(kernel, thin);
    large_rows[0][3].hi = 0x1p251;
    CHECK_FALSE(rounded_meet(large_rows));
}

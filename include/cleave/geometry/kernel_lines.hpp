// SPDX-License-Identifier: Apache-2.0
/// Lines on a plane, given by a second plane: direction, order of points along them, turning, identity.
#ifndef CLEAVE_GEOMETRY_KERNEL_LINES_HPP
#define CLEAVE_GEOMETRY_KERNEL_LINES_HPP

#include <cleave/geometry/kernel.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A direction along a line: the sign of its coordinate on one axis, which is not zero.
struct AxisDirection {
    int axis = -1;
    Sign sign = Sign::zero;
};

/// The axis on which plane k's normal is longest, as far as doubles tell; the entry there is not zero.
template <int D>
[[nodiscard]] int dominant_axis(const Kernel<D>& kernel, std::uint32_t k) {
    const auto& a = kernel.planes.approximation(k);
    const auto& n = kernel.planes.exact(k);
    int best = -1;
    for (int i = 0; i < D; ++i) {
        const auto at = std::size_t(i);
        if (n[at].is_zero()) continue;
        if (best < 0 || std::abs(a[at]) > std::abs(a[std::size_t(best)])) best = i;
    }
    return best;
}

/// The direction in which a facet's boundary runs along the meet of its plane f and the edge plane e (facet on the
/// minus side of e): n_f x n_e for D = 3, n_f turned left for D = 2 (e is not used). The axis is the one on which the
/// direction is longest, as far as doubles tell. Requires for D = 3: f and e cross.
template <int D>
AxisDirection edge_direction(const Kernel<D>& kernel, PlaneId f, PlaneId e) {
    static_assert(D == 2 || D == 3);
    const auto& table = kernel.planes;
    std::array<int, D> order{};
    std::array<double, D> size{};
    const auto& a = table.approximation(unoriented(f));
    for (std::size_t i = 0; i < D; ++i) {
        order[i] = int(i);
        if constexpr (D == 2) {
            size[i] = std::abs(a[1 - i]);
        } else {
            const auto& b = table.approximation(unoriented(e));
            size[i] = std::abs(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
        }
    }
    for (std::size_t i = 0; i < D; ++i)  // longest first; NaN compares false and stays put
        for (std::size_t j = i; j > 0 && size[std::size_t(order[j])] > size[std::size_t(order[j - 1])]; --j)
            std::swap(order[j], order[j - 1]);
    const auto& n = table.exact(unoriented(f));
    for (const int axis : order) {
        const auto i = std::size_t(axis);
        Sign s = Sign::zero;
        if constexpr (D == 2) {
            s = i == 0 ? -n[1].sign() : n[0].sign();
        } else {
            const auto& m = table.exact(unoriented(e));
            WideInteger x(n[(i + 1) % 3] * WideInteger(m[(i + 2) % 3]));
            sub_product(x, n[(i + 2) % 3], m[(i + 1) % 3]);
            s = x.sign();
            if (is_flipped(e)) s = -s;
        }
        if (is_flipped(f)) s = -s;
        if (s != Sign::zero) return {axis, s};
    }
    CLEAVE_ASSERT(D == 2);  // unreachable: crossing planes have a direction
    return {};
}

/// D = 3: the direction from p to q, on the axis where it is longest as far as doubles tell. Requires: p and q differ.
inline AxisDirection direction_between(Kernel<3>& kernel, PointId p, PointId q) {
    const auto& x = kernel.point(p).approximation;
    const auto& y = kernel.point(q).approximation;
    std::array<int, 3> axes{0, 1, 2};
    const auto size = [&](int axis) { return std::abs(y[std::size_t(axis)] - x[std::size_t(axis)]); };
    if (size(1) > size(0)) std::swap(axes[0], axes[1]);
    if (size(2) > size(axes[0])) std::swap(axes[0], axes[2]);
    for (const int axis : axes)
        if (const Sign s = kernel.compare(axis, q, p); s != Sign::zero) return {axis, s};
    CLEAVE_ASSERT(false);  // they differ on some axis
    return {};
}

/// D = 3: the turn from direction n_f x n_a to direction n_f x n_b as seen from the plus side of f:
/// plus = to the left. It is the sign of det(n_f, n_a, n_b).
inline Sign turn(const Kernel<3>& kernel, PlaneId f, PlaneId a, PlaneId b) {
    const auto& x = kernel.planes.exact(unoriented(f));
    const auto& y = kernel.planes.exact(unoriented(a));
    const auto& z = kernel.planes.exact(unoriented(b));
    WideInteger det;
    for (std::size_t i = 0; i < 3; ++i) {
        WideInteger minor(y[(i + 1) % 3] * WideInteger(z[(i + 2) % 3]));
        sub_product(minor, y[(i + 2) % 3], z[(i + 1) % 3]);
        add_product(det, x[i], minor);
    }
    const Sign s = det.sign();
    return (is_flipped(f) != is_flipped(a)) != is_flipped(b) ? -s : s;
}

/// D = 3: orients the plane e through the edge from u to v of a face on plane f so that the face (on the edge's left)
/// lies on its minus side. Requires: f and e cross in the line uv.
inline PlaneId orient_edge(Kernel<3>& kernel, PlaneId f, PlaneId e, PointId u, PointId v) {
    const AxisDirection d = edge_direction(kernel, f, e);
    const bool along = kernel.compare(d.axis, v, u) == d.sign;
    return along ? e : flipped(e);
}

/// The line f /\ e within the plane f, modulo 2^61-1 and up to a factor: the member of the pencil of planes through the
/// line that lacks one coordinate. Equal lines have proportional residues; others only by chance.
template <int D>
std::array<Mod61, D + 1> line_residues(const Kernel<D>& kernel, PlaneId f, PlaneId e) {
    const auto& a = kernel.planes.residues(unoriented(f));
    const auto& b = kernel.planes.residues(unoriented(e));
    std::size_t drop = 0;
    while (drop < D && a[drop].is_zero()) ++drop;
    std::array<Mod61, D + 1> r{};
    if (drop == D) return r;
    for (std::size_t i = 0; i <= D; ++i)
        if (i != drop) r[i] = b[i] * a[drop] - a[i] * b[drop];
    return r;
}

/// A hash that is equal for proportional residues. Cost: an inversion, about half a microsecond.
template <std::size_t K>
std::uint64_t projective_hash(const std::array<Mod61, K>& r) {
    std::uint64_t key = 0x243f6a8885a308d3ULL;
    Mod61 scale(0);
    for (const Mod61& x : r) {
        if (scale.is_zero() && !x.is_zero()) scale = x.inverse();
        key ^= (x * scale).value();
        key *= 0xff51afd7ed558ccdULL;
        key ^= key >> 29U;
    }
    return key;
}

/// Whether the residues are proportional. Cheaper than two hashes.
template <std::size_t K>
bool proportional(const std::array<Mod61, K>& a, const std::array<Mod61, K>& b) {
    std::size_t pivot = 0;
    while (pivot < K && a[pivot].is_zero()) ++pivot;
    if (pivot == K) return true;  // nothing is known: the exact test decides
    for (std::size_t i = 0; i < K; ++i)
        if (!(a[i] * b[pivot] == b[i] * a[pivot])) return false;
    return true;
}

CLEAVE_END_NAMESPACE

#endif

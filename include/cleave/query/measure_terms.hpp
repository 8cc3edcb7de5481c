// SPDX-License-Identifier: Apache-2.0
/// The measure of a bounded region as a sum of fractions, one for each boundary element: the divergence theorem, with
/// no term that needs a square root.
#ifndef CLEAVE_QUERY_MEASURE_TERMS_HPP
#define CLEAVE_QUERY_MEASURE_TERMS_HPP

#include <cleave/query/cone_simplices.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/build.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The tetrahedra over the origin whose bases fan out from a loop's first corner.
template <class At, class Term>
void fan_terms(std::span<const Corner> loop, const At& at, Term& term) {
    if (loop.size() < 3) return;
    const Homogeneous<3> p = at(loop[0]);
    Homogeneous<3> q = at(loop[1]);
    for (std::size_t corner = 2; corner < loop.size(); ++corner) {
        Homogeneous<3> r = at(loop[corner]);
        Integer det;
        for (std::size_t i = 0; i < 3; ++i) {
            Integer minor(q[(i + 1) % 3] * r[(i + 2) % 3]);
            sub_product(minor, q[(i + 2) % 3], r[(i + 1) % 3]);
            add_product(det, p[i], minor);
        }
        if (!det.is_zero()) term(det, Integer(p[3] * q[3] * r[3] * Integer(6)));
        q = std::move(r);
    }
}

}  // namespace detail

/// Calls `term(numerator, denominator)` with fractions whose sum is the D-dimensional measure. Denominators are
/// positive or negative, never zero; fractions are not reduced.
///
/// D = 1: the coordinate of each end, plus at upper ends. D = 2: (x_p y_q - y_p x_q) / 2 for each segment pq. D = 3,
/// for a face on n.x + c = 0 with n_k != 0: its height over the origin times its area is -c / n_k times its area
/// projected along axis k, which is the sum over its edges pq of (u_p v_q - v_p u_q) / 2; a third of that is its
/// pyramid. A loop whose corners are all doubles is summed up as tetrahedra with the origin instead, det(p, q, r) / 6,
/// whose denominators are powers of two but for a 3: untouched parts of a mesh then cost next to nothing.
template <int D, class Term>
void measure_terms(Kernel<D>& kernel, const Boundary<D>& boundary, const LoadedBoundary<D>& loaded, Term&& term) {
    const FaceList& list = boundary.faces;
    const auto at = [&](const Corner& corner) { return kernel.coordinates(loaded.first_point + corner.point); };
    for (const FaceList::Face& face : list.faces) {
        [[maybe_unused]] const PlaneId plane = loaded.plane(face.plane);
        if constexpr (D == 1) {
            Homogeneous<1> x = at(list.loop(face.first_loop)[0]);
            if (is_flipped(plane)) x[0].negate();
            term(x[0], x[1]);
        } else if constexpr (D == 2) {
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const Homogeneous<2> p = at(list.loop(l)[0]);
                const Homogeneous<2> q = at(list.loop(l)[1]);
                Integer cross(p[0] * q[1]);
                sub_product(cross, p[1], q[0]);
                term(cross, Integer((p[2] * q[2]) << 1));
            }
        } else if constexpr (D >= 4) {
            cone_simplices(kernel, boundary, loaded, face, [&](const std::array<Homogeneous<D>, D>& x, Integer volume) {
                Integer denominator(1);
                for (std::size_t i = 0; i < std::size_t(D); ++i) denominator *= x[i][D] * Integer(int(i) + 1);
                term(volume, denominator);
            });
        } else {
            const auto& n = kernel.planes.exact(unoriented(plane));
            if (n[3].is_zero()) continue;  // the pyramid over the face is flat
            const auto k = std::size_t(dominant_axis(kernel, unoriented(plane)));
            const std::size_t u = (k + 1) % 3;
            const std::size_t v = (k + 2) % 3;
            const Integer c = -n[3];
            const Integer six_n = Integer(6) * n[k];
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::span<const Corner> loop = list.loop(l);
                const bool doubles = std::all_of(loop.begin(), loop.end(), [&](const Corner& corner) {
                    return kernel.point(loaded.first_point + corner.point).is_of_doubles();
                });
                if (doubles) {
                    detail::fan_terms(loop, at, term);
                    continue;
                }
                Homogeneous<3> p = at(loop.back());
                for (const Corner& corner : loop) {
                    Homogeneous<3> q = at(corner);
                    Integer cross(p[u] * q[v]);
                    sub_product(cross, p[v], q[u]);
                    if (!cross.is_zero()) term(Integer(cross * c), Integer(p[3] * q[3] * six_n));
                    p = std::move(q);
                }
            }
        }
    }
}

CLEAVE_END_NAMESPACE

#endif

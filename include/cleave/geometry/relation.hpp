// SPDX-License-Identifier: Apache-2.0
/// How two oriented planes lie to each other, in any dimension.
#ifndef CLEAVE_GEOMETRY_RELATION_HPP
#define CLEAVE_GEOMETRY_RELATION_HPP

#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/plane_relation.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// The relation of g to h.
///
/// | normals           | whole coefficient vectors | result         |
/// |-------------------|---------------------------|----------------|
/// | not proportional  |                           | `crossing`     |
/// | positive multiple | positive multiple         | `same`         |
/// | positive multiple | not proportional          | `parallel`     |
/// | negative multiple | negative multiple         | `opposite`     |
/// | negative multiple | not proportional          | `antiparallel` |
///
/// The orientation is read off the normals alone: the offsets have their own signs (x = 1 and x = -1 with equal normals
/// are parallel, not antiparallel), and they say nothing about planes that are not parallel (x = 0 and y = 0 have equal
/// offsets). In D = 1 all planes are parallel.
/// Cost: at most 4 D products; mostly signs alone decide.
template <class R = void, int D, ExactRing N>
[[nodiscard]] PlaneRelation relation(const Plane<D, N>& h, const Plane<D, N>& g) {
    using T = number_traits<N>;
    switch (proportionality<R>(h.coefficients(), g.coefficients())) {
        case Sign::plus:
            return PlaneRelation::same;
        case Sign::minus:
            return PlaneRelation::opposite;
        case Sign::zero:
            break;
    }
    // Signs of the normals are looked at before the normals are copied.
    const std::size_t k = first_nonzero(h.coefficients());
    const Sign direction = T::sign(h[k]) * T::sign(g[k]);
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        if (T::sign(g[i]) != T::sign(h[i]) * direction) return PlaneRelation::crossing;
    }
    if (proportionality<R>(h.normal(), g.normal()) == Sign::zero) return PlaneRelation::crossing;
    return direction == Sign::plus ? PlaneRelation::parallel : PlaneRelation::antiparallel;
}

CLEAVE_END_NAMESPACE

#endif

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
/// Cost: at most 2 D products; mostly signs alone decide.
template <class R = void, int D, ExactRing N>
[[nodiscard]] PlaneRelation relation(const Plane<D, N>& h, const Plane<D, N>& g) {
    const Sign direction = proportionality<R>(h.normal(), g.normal());
    if (direction == Sign::zero) return PlaneRelation::crossing;
    const bool coincident = proportionality<R>(h.coefficients(), g.coefficients()) == direction;
    if (direction == Sign::plus) return coincident ? PlaneRelation::same : PlaneRelation::parallel;
    return coincident ? PlaneRelation::opposite : PlaneRelation::antiparallel;
}

CLEAVE_END_NAMESPACE

#endif

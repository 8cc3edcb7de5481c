// SPDX-License-Identifier: Apache-2.0
/// How two oriented planes can lie to each other: the enumeration alone, so that code which only passes the answer on
/// (trees, models) need not see any number. The computation is in geometry/relation.hpp.
#ifndef CLEAVE_GEOMETRY_PLANE_RELATION_HPP
#define CLEAVE_GEOMETRY_PLANE_RELATION_HPP

#include <cleave/base/config.hpp>

#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// How two oriented planes lie to each other. `same` and `opposite` are coincident planes, co- and anti-oriented;
/// `parallel` and `antiparallel` have no common point and normals of equal or contrary direction.
enum class PlaneRelation : std::uint8_t { crossing, same, opposite, parallel, antiparallel };

/// The relation after one of the two planes has been flipped.
[[nodiscard]] constexpr PlaneRelation flip(PlaneRelation r) noexcept {
    switch (r) {
        case PlaneRelation::crossing:
            return PlaneRelation::crossing;
        case PlaneRelation::same:
            return PlaneRelation::opposite;
        case PlaneRelation::opposite:
            return PlaneRelation::same;
        case PlaneRelation::parallel:
            return PlaneRelation::antiparallel;
        case PlaneRelation::antiparallel:
            return PlaneRelation::parallel;
    }
    return r;
}

/// Whether two planes in this relation are one set of points.
[[nodiscard]] constexpr bool is_coincident(PlaneRelation r) noexcept {
    return r == PlaneRelation::same || r == PlaneRelation::opposite;
}

CLEAVE_END_NAMESPACE

#endif

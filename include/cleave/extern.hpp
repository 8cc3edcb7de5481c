// SPDX-License-Identifier: Apache-2.0
/// Everything in cleave, with the usual instantiations compiled in one translation unit instead of in each.
///
/// For programs of many source files: include this header in place of <cleave.hpp>, and write one source file
///
///     #define CLEAVE_INSTANTIATE
///     #include <cleave/extern.hpp>
///
/// Functions on regions in 1, 2 and 3 dimensions, over the default number and over meshes of doubles and rationals, are
/// then declared `extern template` everywhere else: an operation costs a call there and no compiling. Other number
/// types are instantiated where they are used, as ever. Without that one file, the linker misses these functions.
#ifndef CLEAVE_EXTERN_HPP
#define CLEAVE_EXTERN_HPP

#include <cleave/algebra.hpp>
#include <cleave/base.hpp>
#include <cleave/bsp.hpp>
#include <cleave/clip.hpp>
#include <cleave/execution.hpp>
#include <cleave/geometry.hpp>
#include <cleave/io.hpp>
#include <cleave/mesh.hpp>
#include <cleave/number.hpp>
#include <cleave/query.hpp>
#include <cleave/region.hpp>
#include <cleave/setop.hpp>
#include <cleave/shape.hpp>

#if defined(CLEAVE_INSTANTIATE)
#define CLEAVE_EXTERN
#else
#define CLEAVE_EXTERN extern
#endif

// What is there for every dimension.
#define CLEAVE_EXTERN_REGIONS(D)                                                                                       \
    CLEAVE_EXTERN template Region<D> complement<D, Rational>(const Region<D>&);                                        \
    CLEAVE_EXTERN template Region<D> evaluate<D, Rational>(const BooleanFunction&, std::span<const Region<D>>,         \
                                                           const OperationOptions&);                                   \
    CLEAVE_EXTERN template Region<D> apply<D, Rational>(Operation, const Region<D>&, const Region<D>&,                 \
                                                        const OperationOptions&);                                      \
    CLEAVE_EXTERN template Region<D> evaluate<D, Rational>(Engine, const BooleanFunction&, std::span<const Region<D>>, \
                                                           const OperationOptions&);                                   \
    CLEAVE_EXTERN template std::string canonical<D, Rational>(const Region<D>&);                                       \
    CLEAVE_EXTERN template bool equal<D, Rational>(const Region<D>&, const Region<D>&);                                \
    CLEAVE_EXTERN template Region<D> transform<D, Rational, Integer>(const AffineMap<D, Integer>&, const Region<D>&);  \
    CLEAVE_EXTERN template Region<D> transform<D, Rational, Rational>(const AffineMap<D, Rational>&,                   \
                                                                      const Region<D>&);                               \
    CLEAVE_EXTERN template std::optional<Rational> measure<D, Rational>(const Region<D>&);                             \
    CLEAVE_EXTERN template std::optional<Modular<first_prime>> measure_modulo<first_prime, D, Rational>(               \
        const Region<D>&);                                                                                             \
    CLEAVE_EXTERN template std::optional<Modular<second_prime>> measure_modulo<second_prime, D, Rational>(             \
        const Region<D>&);                                                                                             \
    CLEAVE_EXTERN template std::optional<std::string> measure_digits<D, Rational>(const Region<D>&, int);              \
    CLEAVE_EXTERN template std::optional<Fraction> measure_fraction<D, Rational>(const Region<D>&, std::size_t);       \
    CLEAVE_EXTERN template Region<D> box<D, Rational>(const std::array<Rational, D>&, const std::array<Rational, D>&); \
    CLEAVE_EXTERN template Region<D> simplex<D, Rational>(const std::array<std::array<Rational, D>, D + 1>&);          \
    CLEAVE_EXTERN template Region<D> convex_hull<D, Rational>(std::span<const std::array<Rational, D>>);

// What is there for meshes of each coordinate type.
#define CLEAVE_EXTERN_MESHES(T)                                                                                       \
    CLEAVE_EXTERN template MeshReport validate<T>(const PolygonMesh<T>&, ExecutorRef);                                \
    CLEAVE_EXTERN template MeshReport require_valid<T>(const PolygonMesh<T>&, Strictness, const MeshOrigin*);         \
    CLEAVE_EXTERN template PolygonMesh<T> weld<T>(const PolygonMesh<T>&);                                             \
    CLEAVE_EXTERN template Region<3> to_region<Rational, T>(const PolygonMesh<T>&, const ToRegionOptions&);           \
    CLEAVE_EXTERN template Region<3> resolve<Rational, T>(const PolygonMesh<T>&, WindingRule, const ResolveOptions&); \
    CLEAVE_EXTERN template std::vector<SelfContact> find_self_intersections<T>(const PolygonMesh<T>&,                 \
                                                                               const SelfIntersectionOptions&);       \
    CLEAVE_EXTERN template PolygonMesh<T> read_off<T>(std::string_view, const std::string&, MeshOrigin*);             \
    CLEAVE_EXTERN template PolygonMesh<T> read_obj<T>(std::string_view, const std::string&, MeshOrigin*);             \
    CLEAVE_EXTERN template PolygonMesh<T> read_stl<T>(std::string_view, const std::string&, MeshOrigin*);             \
    CLEAVE_EXTERN template PolygonMesh<T> read_mesh<T>(const std::filesystem::path&, MeshOrigin*);                    \
    CLEAVE_EXTERN template std::string write_off<T>(const PolygonMesh<T>&);                                           \
    CLEAVE_EXTERN template std::string write_obj<T>(const PolygonMesh<T>&);                                           \
    CLEAVE_EXTERN template std::string write_stl<T>(const PolygonMesh<T>&, StlKind, StlRounding*);                    \
    CLEAVE_EXTERN template StlRounding write_mesh<T>(const std::filesystem::path&, const PolygonMesh<T>&);

CLEAVE_BEGIN_NAMESPACE

CLEAVE_EXTERN_REGIONS(1)
CLEAVE_EXTERN_REGIONS(2)
CLEAVE_EXTERN_REGIONS(3)
CLEAVE_EXTERN_MESHES(double)
CLEAVE_EXTERN_MESHES(Rational)

CLEAVE_EXTERN template Region<1> intervals<Rational>(std::span<const std::pair<Rational, Rational>>);
CLEAVE_EXTERN template Region<2> polygons<Rational>(std::span<const std::vector<std::array<Rational, 2>>>);
CLEAVE_EXTERN template Region<2> resolve<Rational>(std::span<const std::vector<std::array<Rational, 2>>>, WindingRule,
                                                   ProgressReporter*);
CLEAVE_EXTERN template Region<2> disc<Rational>(const std::array<Rational, 2>&, const Rational&, std::uint32_t);
CLEAVE_EXTERN template Region<3> sphere<Rational>(const std::array<Rational, 3>&, const Rational&,
                                                  const SphereOptions&);
CLEAVE_EXTERN template Region<3> prism<Rational>(const Region<2>&, const Rational&, const Rational&);
CLEAVE_EXTERN template ExportedMesh<double> to_exported_mesh<Rational>(const Region<3>&, const ToMeshOptions&);
CLEAVE_EXTERN template ExportedMesh<Rational> to_exported_rational_mesh<Rational>(const Region<3>&,
                                                                                  const ToMeshOptions&);
CLEAVE_EXTERN template Connectivity connectivity<Rational>(const Region<3>&);
CLEAVE_EXTERN template std::vector<Region<3>> components<Rational>(const Region<3>&);

CLEAVE_END_NAMESPACE

#undef CLEAVE_EXTERN_MESHES
#undef CLEAVE_EXTERN_REGIONS
#undef CLEAVE_EXTERN

#endif

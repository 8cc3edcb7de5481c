// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/apply.hpp>

#include <utility>

#include "engine.hpp"

namespace side_by_side {
namespace {

cleave::Operation of(Operation operation) {
    switch (operation) {
        case Operation::union_:
            return cleave::Operation::union_;
        case Operation::intersection:
            return cleave::Operation::intersection;
        case Operation::difference:
            return cleave::Operation::difference;
    }
    return {};
}

/// A region from arrays, with the copy into a mesh that a program with arrays of its own has to make.
cleave::Region<3> region(const Arrays& arrays) {
    cleave::Mesh mesh;
    mesh.points = arrays.points;
    mesh.corners = arrays.corners;
    mesh.first.resize(arrays.face_count() + 1);
    for (std::size_t f = 0; f < mesh.first.size(); ++f) mesh.first[f] = static_cast<std::uint32_t>(3 * f);
    return cleave::to_region(mesh);
}

Arrays run(Operation operation, const Arrays& first, const Arrays& second, Stages& stages) {
    const double start = processor_seconds();
    const cleave::Region<3> a = region(first);
    const cleave::Region<3> b = region(second);
    const double prepared = processor_seconds();
    const cleave::Region<3> result = cleave::apply(of(operation), a, b);
    const double operated = processor_seconds();
    cleave::Mesh mesh = cleave::to_mesh(result);  // triangles only, so its corners are the array
    Arrays arrays{std::move(mesh.points), std::move(mesh.corners)};
    stages = {prepared - start, operated - prepared, processor_seconds() - operated};
    return arrays;
}

/// |A| + |B| = |A or B| + |A and B|, or |A| = |A - B| + |A and B|, modulo 2^61-1.
bool adds_up_exactly(Operation operation, const Arrays& first, const Arrays& second) {
    const cleave::Region<3> a = region(first);
    const cleave::Region<3> b = region(second);
    const auto parts =
        *measure_modulo(apply(of(operation), a, b)) + *measure_modulo(apply(cleave::Operation::intersection, a, b));
    return operation == Operation::difference ? parts == *measure_modulo(a)
                                              : parts == *measure_modulo(a) + *measure_modulo(b);
}

}  // namespace

Engine cleave_engine() {
    return {"cleave", "to_region twice, apply, to_mesh; exact, then rounded correctly", run, adds_up_exactly, true, 0};
}

}  // namespace side_by_side

// SPDX-License-Identifier: Apache-2.0
// Corefinement with each of CGAL's two usual kernels, and Nef polyhedra. Wherever there is a choice, the faster one was
// taken: surfaces are built face by face (not by way of a polygon soup), results overwrite the first operand.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/version.h>

#include <stdexcept>

#include "engine.hpp"

namespace side_by_side {
namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
namespace PMP = CGAL::Polygon_mesh_processing;

template <class Kernel>
using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;

template <class Kernel>
Surface<Kernel> surface(const Arrays& arrays) {
    using Mesh = Surface<Kernel>;
    using Vertex = typename Mesh::Vertex_index;
    Mesh mesh;
    const auto faces = static_cast<typename Mesh::size_type>(arrays.face_count());
    mesh.reserve(static_cast<typename Mesh::size_type>(arrays.points.size()), faces + faces / 2, faces);
    for (const auto& p : arrays.points) mesh.add_vertex(typename Kernel::Point_3(p[0], p[1], p[2]));
    for (std::size_t i = 0; i < arrays.corners.size(); i += 3)
        if (mesh.add_face(Vertex(arrays.corners[i]), Vertex(arrays.corners[i + 1]), Vertex(arrays.corners[i + 2])) ==
            Mesh::null_face())
            throw std::runtime_error("the operand is no manifold surface");
    return mesh;
}

/// Exact points are rounded by CGAL::to_double, which makes no promise to round correctly.
template <class Kernel>
Arrays arrays(const Surface<Kernel>& mesh) {
    Arrays out;
    std::vector<std::uint32_t> index(mesh.num_vertices());  // removed ones included
    out.points.reserve(mesh.number_of_vertices());
    out.corners.reserve(3 * mesh.number_of_faces());
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        index[v] = static_cast<std::uint32_t>(out.points.size());
        out.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (const auto f : mesh.faces()) {
        const auto start = mesh.halfedge(f);
        auto h = start;
        do {
            out.corners.push_back(index[mesh.target(h)]);
            h = mesh.next(h);
        } while (h != start);
    }
    return out;
}

template <class Kernel>
Arrays corefine(Operation operation, const Arrays& first, const Arrays& second, Stages&) {
    Surface<Kernel> a = surface<Kernel>(first);
    Surface<Kernel> b = surface<Kernel>(second);
    bool has_result = false;
    switch (operation) {
        case Operation::union_:
            has_result = PMP::corefine_and_compute_union(a, b, a);
            break;
        case Operation::intersection:
            has_result = PMP::corefine_and_compute_intersection(a, b, a);
            break;
        case Operation::difference:
            has_result = PMP::corefine_and_compute_difference(a, b, a);
            break;
    }
    if (!has_result) throw std::runtime_error("the result is no manifold surface, which corefinement refuses");
    return arrays<Kernel>(a);
}

Arrays nef(Operation operation, const Arrays& first, const Arrays& second, Stages&) {
    using Nef = CGAL::Nef_polyhedron_3<Exact>;
    const Nef a(surface<Exact>(first));
    const Nef b(surface<Exact>(second));
    const Nef result = operation == Operation::union_ ? a + b : operation == Operation::intersection ? a * b : a - b;
    Surface<Exact> mesh;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(result, mesh, true);
    return arrays<Exact>(mesh);
}

}  // namespace

std::vector<Engine> cgal_engines() {
    const std::string version = "CGAL " CGAL_VERSION_STR ", ";
    return {{"EPICK", version + "corefinement, inexact constructions", corefine<Inexact>, nullptr, false, 0},
            {"EPECK", version + "corefinement, exact constructions", corefine<Exact>, nullptr, false, 0},
            {"Nef", version + "Nef polyhedra", nef, nullptr, false, 21000}};
}

}  // namespace side_by_side

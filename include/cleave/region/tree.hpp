// SPDX-License-Identifier: Apache-2.0
/// From a region to its tree and back.
#ifndef CLEAVE_REGION_TREE_HPP
#define CLEAVE_REGION_TREE_HPP

#include <cleave/bsp/bsp_tree.hpp>
#include <cleave/bsp/build.hpp>
#include <cleave/bsp/tree_boundary.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/far_point.hpp>
#include <cleave/region/polytope_faces.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The tree of a boundary, in a kernel.
template <int D>
[[nodiscard]] PlaneTree<PlaneId> tree_of_boundary(const Boundary<D>& boundary, Kernel<D>& kernel) {
    if constexpr (D <= 3) {
        KernelClip<D> clip(kernel);
        PointInterner<D> points(kernel);
        LoadedFacets<D> loaded = make_facets(boundary, load(boundary, kernel), clip, points);
        return build(clip, std::move(loaded.facets), Structural<>{}, boundary.value_at_infinity);
    } else {
        PolytopeClip<D> clip(kernel);
        LoadedPolytopes<D> loaded = load_polytopes(boundary, clip);
        return build(clip, std::move(loaded.facets), Structural<>{}, boundary.value_at_infinity);
    }
}

/// The faces of a tree's set: coplanar pieces are merged to polygons (D = 2, 3) or listed together (D >= 4).
/// `source(k)` is the source of faces on the unoriented plane k; faces come in the order of sources, then planes.
/// Requires: no cell of the tree is empty.
template <int D, class SourceOf>
[[nodiscard]] FaceList faces_of_tree(PolytopeClip<D>& clip, PointInterner<D>& points, const PlaneTree<PlaneId>& tree,
                                     SourceOf&& source) {
    std::vector<PolytopeFacet<D>> facets = boundary(clip, tree);
    const auto key = [&](const PolytopeFacet<D>& f) {
        const Source s = source(unoriented(f.plane));
        return std::array<std::uint32_t, 3>{s.operand, s.face, f.plane};
    };
    std::stable_sort(facets.begin(), facets.end(),
                     [&](const PolytopeFacet<D>& a, const PolytopeFacet<D>& b) { return key(a) < key(b); });
    FaceList out;
    FaceMerger<D> merger(clip.kernel(), points);
    std::vector<Corner> loop;
    for (std::size_t i = 0; i < facets.size();) {
        const PlaneId plane = facets[i].plane;
        merger.begin(plane);
        for (; i < facets.size() && facets[i].plane == plane; ++i) {
            loop.clear();
            append_loop(clip.kernel(), plane, clip.body(facets[i]), loop);
            merger.add(loop);
        }
        merger.finish(out, source(unoriented(plane)));
    }
    return out;
}

/// The tree of a region, with cuts as planes of N. No cell of it is empty. Cost: see `build`.
template <int D, class N>
[[nodiscard]] BspTree<D, N> to_tree(const Region<D, N>& region) {
    Kernel<D> kernel;
    TreeParts<PlaneId> from = tree_of_boundary(region.boundary(), kernel).parts();
    TreeParts<Plane<D, N>> to;
    to.root = from.root;
    to.leaves = std::move(from.leaves);
    for (const TreeNode<PlaneId>& node : from.nodes) {
        typename Plane<D, N>::Coefficients c;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) {
            c[i] = number_traits<N>::from_integer(kernel.planes.exact(unoriented(node.cut))[i]);
            if (is_flipped(node.cut)) c[i] = N(-c[i]);
        }
        to.nodes.push_back({Plane<D, N>(std::move(c)), node.minus, node.plus});
    }
    return BspTree<D, N>(std::move(to));
}

/// The region of a tree. Any tree will do: parts that no point can reach are left out first.
/// Sources count the nodes of the tree. Cost: a cell for each branch, see `boundary`.
template <int D, ExactRing N>
[[nodiscard]] Region<D> to_region(const BspTree<D, N>& tree) {
    Kernel<D> kernel;
    PolytopeClip<D> clip(kernel);
    PointInterner<D> points(kernel);
    TreeParts<PlaneId> parts;
    parts.root = tree.root();
    parts.leaves.assign(tree.leaves().begin(), tree.leaves().end());
    std::vector<std::uint32_t> first_node;
    for (const TreeNode<Plane<D, N>>& node : tree.nodes()) {
        const PlaneId h = kernel.planes.intern(make_plane<Integer>(node.cut.coefficients()).coefficients());
        first_node.resize(kernel.planes.size(), no_id);
        if (first_node[unoriented(h)] == no_id)
            first_node[unoriented(h)] = static_cast<std::uint32_t>(parts.nodes.size());
        parts.nodes.push_back({h, node.minus, node.plus});
    }
    const PlaneTree<PlaneId> clean = restricted(clip, PlaneTree<PlaneId>(std::move(parts)), clip.universe());
    const FaceList faces = faces_of_tree(clip, points, clean, [&](std::uint32_t k) {
        return Source{0, first_node[k]};
    });
    return Region<D>(freeze(kernel, faces, value_at_far_point(kernel.planes, clean), points));
}

CLEAVE_END_NAMESPACE

#endif

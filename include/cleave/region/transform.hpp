// SPDX-License-Identifier: Apache-2.0
/// Images of regions under affine maps, reflections included.
#ifndef CLEAVE_REGION_TRANSFORM_HPP
#define CLEAVE_REGION_TRANSFORM_HPP

#include <cleave/base/error.hpp>
#include <cleave/geometry/affine_map.hpp>
#include <cleave/geometry/canonical.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/region.hpp>
#include <cleave/region/tree.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The same map over integers.
template <int D, ExactRing M>
[[nodiscard]] AffineMap<D, Integer> integer_map(const AffineMap<D, M>& map) {
    constexpr std::size_t n = std::size_t(D) + 1;
    Vector<D * D + 2 * D + 1, M> entries;
    for (std::size_t i = 0; i < n * n; ++i) entries[i] = map.homogeneous()(int(i / n), int(i % n));
    const auto integers = primitive_integers(entries);
    Matrix<D + 1, D + 1, Integer> m;
    for (std::size_t i = 0; i < n * n; ++i) m(int(i / n), int(i % n)) = integers[i];
    return AffineMap<D, Integer>(std::move(m));
}

/// The image of a boundary without infinite points. Planes and points are mapped one by one and faces stay what they
/// are: a meet of planes is the meet of their images, so no coordinates of it are needed.
template <int D>
class BoundaryImage {
public:
    BoundaryImage(const Boundary<D>& boundary, const AffineMap<D, Integer>& map)
        : boundary_(&boundary), map_(&map), plane_map_(map), from_(load(boundary, source_)) {}

    [[nodiscard]] Boundary<D> build() {
        const bool mirrored = map_->orientation() == Sign::minus;
        for (std::uint32_t k = 0; k < boundary_->planes.size(); ++k) {
            const Plane<D, Integer> h = plane_map_(Plane<D, Integer>(boundary_->planes.exact(k)));
            planes_.push_back(kernel_.planes.intern(primitive_integers(h.coefficients())));
        }
        for (PointId p = 0; p < boundary_->points.size(); ++p) points_.push_back(image_of_point(p));
        const FaceList& list = boundary_->faces;
        FaceList out;
        std::vector<Corner> loop;
        for (std::uint32_t f = 0; f < list.faces.size(); ++f) {
            const FaceList::Face& face = list.faces[f];
            out.begin_face(image_of_plane(face.plane), {0, f});
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                loop.clear();
                for (const Corner& c : list.loop(l)) loop.push_back({points_[c.point], image_of_edge(c.edge)});
                if (mirrored) reverse_loop<D>(loop);
                out.add_loop(loop);
            }
        }
        bool far = boundary_->value_at_infinity;
        // A half-line's two infinities differ, and a reflection exchanges them.
        if (D == 1 && mirrored && list.faces.size() % 2 != 0) far = !far;
        Boundary<D> image = freeze(kernel_, out, far, [](PointId p) { return p; });
        image.is_conforming = boundary_->is_conforming;
        return image;
    }

private:
    [[nodiscard]] PlaneId image_of_plane(PlaneId h) const { return planes_[unoriented(h)] ^ (h & 1U); }

    [[nodiscard]] PlaneId image_of_edge(PlaneId h) const {
        if (h == no_id) return no_id;
        // D >= 4: an incidence, without orientation.
        return D >= 4 ? image_of_plane(h) & ~1U : image_of_plane(h);
    }

    PointId image_of_point(PointId p) {
        const PointRecord<D>& r = boundary_->points[p];
        if (r.kind == PointRecord<D>::Kind::meet) {
            std::array<std::uint32_t, std::size_t(D)> through{};
            for (std::size_t i = 0; i < std::size_t(D); ++i) through[i] = unoriented(planes_[r.planes[i]]);
            return kernel_.add_meet(through);
        }
        const Point<D, Integer> x = (*map_)(Point<D, Integer>(source_.coordinates(from_.first_point + p)));
        std::array<Fraction, std::size_t(D)> coordinates;
        for (std::size_t i = 0; i < std::size_t(D); ++i)
            coordinates[i] = make_fraction(x.homogeneous()[i], x.homogeneous()[std::size_t(D)]);
        const PointId q = add_point<D>(kernel_, coordinates);
        for (const std::uint32_t k : r.planes)
            if (k != no_id) kernel_.note_incidence(q, unoriented(planes_[k]));
        return q;
    }

    const Boundary<D>* boundary_;
    const AffineMap<D, Integer>* map_;
    PlaneMap<D, Integer> plane_map_;
    Kernel<D> source_;
    LoadedBoundary<D> from_;
    Kernel<D> kernel_;
    std::vector<PlaneId> planes_;  // of the boundary's unoriented planes
    std::vector<PointId> points_;
};

}  // namespace detail

/// The image of a region under an affine map over any exact numbers; a reflection gives the mirror image, as much a
/// region as any. Numbers grow by those of the map each time: compose maps first, then apply them once.
/// Returns: the set of all map(x) with x in the region; faces in the region's order, source (0, face).
/// Throws: ShapeError for a singular map, whose images have no interior.
/// Cost: linear with a bounded boundary; otherwise by way of a tree, whose cuts are mapped.
template <int D, class N, ExactRing M>
[[nodiscard]] Region<D, N> transform(const AffineMap<D, M>& map, const Region<D, N>& region) {
    const AffineMap<D, Integer> exact = detail::integer_map(map);
    if (exact.orientation() == Sign::zero)
        throw ShapeError("the map is singular, so images have no interior: use a map with a determinant other than 0");
    if (region.has_bounded_boundary()) return Region<D, N>(detail::BoundaryImage<D>(region.boundary(), exact).build());
    const PlaneMap<D, Integer> plane_map(exact);
    const BspTree<D, Integer> tree = to_tree(Region<D, Integer>(region));
    TreeParts<Plane<D, Integer>> parts;
    parts.root = tree.root();
    parts.leaves.assign(tree.leaves().begin(), tree.leaves().end());
    for (const TreeNode<Plane<D, Integer>>& node : tree.nodes())
        parts.nodes.push_back({plane_map(node.cut), node.minus, node.plus});
    return Region<D, N>(to_region(BspTree<D, Integer>(std::move(parts))));
}

CLEAVE_END_NAMESPACE

#endif

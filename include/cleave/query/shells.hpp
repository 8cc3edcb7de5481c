// SPDX-License-Identifier: Apache-2.0
/// The connected surfaces of a 3-D boundary, connected where they bound the same piece of the interior.
///
/// Two faces belong to one shell where they meet in an edge and bound the same wedge of the interior there: of four
/// faces at an edge, two and two. Faces that meet in a point alone are not connected by it. Moved a little into the
/// interior, each shell is a closed surface without contacts, which splits space into two: an *outer* shell has the
/// interior inside itself, a *void* has it outside. So every bounded component of the interior has exactly one outer
/// shell, and one void for each cavity in it.
#ifndef CLEAVE_QUERY_SHELLS_HPP
#define CLEAVE_QUERY_SHELLS_HPP

#include <cleave/query/boundary_edges.hpp>
#include <cleave/query/contacts.hpp>
#include <cleave/query/face_contours.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The shells of one boundary. Holds the kernel that its edges refer to.
/// Cost: O(n log n) for n edges, plus what exact contacts ask for.
class Shells {
public:
    /// Requires: faces do not cross each other (the boundary of a regular set). Otherwise shells are unspecified.
    explicit Shells(const Boundary<3>& boundary) {
        load_edges(boundary);
        std::optional<Boundary<3>> cut = ContactCutter(kernel_, boundary, *edges_, *boxes_).cut();
        if (cut) {
            kernel_ = Kernel<3>();
            load_edges(*cut);
        }
        parent_.resize(edges_->size());
        std::iota(parent_.begin(), parent_.end(), 0U);
        FaceContours contours(kernel_, *edges_);
        for (std::size_t f = 0; f < edges_->face_count(); ++f)
            contours.connect(f, [&](std::uint32_t e, std::uint32_t g) { join(e, g); });
        edges_->for_each_group([&](std::span<const std::uint32_t> group) { connect_around(group); });
        number();
    }

    [[nodiscard]] std::size_t count() const noexcept { return count_; }

    /// Whether as many faces run along each piece of edge in one direction as in the other.
    [[nodiscard]] bool is_closed() const noexcept { return closed_; }

    /// The shell of edge e of `edges()`, from 0 in the order of the faces.
    [[nodiscard]] std::uint32_t of_edge(std::size_t e) const { return shell_[e]; }

    [[nodiscard]] const BoundaryEdges& edges() const noexcept { return *edges_; }
    [[nodiscard]] const FaceBoxes& boxes() const noexcept { return *boxes_; }
    [[nodiscard]] Kernel<3>& kernel() noexcept { return kernel_; }

private:
    /// A half-plane from an edge into a face. Seen along the edge, rays are ordered by `plane`'s normals, which are a
    /// quarter turn on from them.
    struct Ray {
        PlaneId plane;
        std::uint32_t edge;
        bool opens;  // counter-clockwise of it lies the interior
        int part;    // as in FaceContours
    };

    void load_edges(const Boundary<3>& boundary) {
        loaded_ = load(boundary, kernel_);
        edges_ = std::make_unique<const BoundaryEdges>(kernel_, boundary, loaded_);
        boxes_ = std::make_unique<const FaceBoxes>(kernel_, *edges_);
    }

    std::uint32_t root(std::uint32_t e) {
        while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
        return e;
    }

    void join(std::uint32_t e, std::uint32_t g) {
        const std::uint32_t a = root(e);
        const std::uint32_t b = root(g);
        parent_[std::max(a, b)] = std::min(a, b);  // a root is the least edge of its shell
    }

    void connect_around(std::span<const std::uint32_t> group) {
        const PointId from = std::min((*edges_)[group[0]].from, (*edges_)[group[0]].to);
        std::size_t forward = 0;
        for (const std::uint32_t e : group) forward += (*edges_)[e].from == from ? 1U : 0U;
        closed_ = closed_ && 2 * forward == group.size();
        if (group.size() == 2 && forward == 1) return join(group[0], group[1]);
        sort_around(group, from);
        join_sectors(std::span<const Ray>(rays_), [&](std::uint32_t e, std::uint32_t g) { join(e, g); });
    }

    /// Sorts the faces of a group counter-clockwise around the edge, looking against its direction from `from`.
    ///
    /// The face with normal n on the left of direction d extends along n x d; turning it counter-clockwise about d
    /// moves it towards n, out of the set. So a face that runs forward closes a wedge of the interior, one that runs
    /// backward (normal -n in the same frame) opens one.
    void sort_around(std::span<const std::uint32_t> group, PointId from) {
        const BoundaryEdge& any = (*edges_)[group[0]];
        const PointId to = any.from == from ? any.to : any.from;
        int axis = 0;
        while (axis < 2 && kernel_.compare(axis, from, to) == Sign::zero) ++axis;
        const Sign ahead = kernel_.compare(axis, to, from);
        rays_.clear();
        for (const std::uint32_t e : group) {
            const PlaneId plane = edges_->plane((*edges_)[e].face);
            const bool forward = (*edges_)[e].from == from;
            rays_.push_back({forward ? plane : flipped(plane), e, !forward, 0});
        }
        const auto turn_about_edge = [&](PlaneId a, PlaneId b) {
            const Sign s = normals_cross(a, b, axis);
            return ahead == Sign::plus ? s : -s;
        };
        const PlaneId reference = rays_.front().plane;
        for (Ray& r : rays_) {
            const Sign left = turn_about_edge(reference, r.plane);
            if (left == Sign::zero)
                r.part = r.plane == reference ? 0 : 2;
            else
                r.part = left == Sign::plus ? 1 : 3;
        }
        std::sort(rays_.begin(), rays_.end(), [&](const Ray& a, const Ray& b) {
            if (a.part != b.part) return a.part < b.part;
            const Sign s = turn_about_edge(a.plane, b.plane);
            if (s != Sign::zero) return s == Sign::plus;
            return a.opens != b.opens ? b.opens : a.edge < b.edge;
        });
    }

    /// The sign of one coordinate of the cross product of two oriented normals.
    [[nodiscard]] Sign normals_cross(PlaneId a, PlaneId b, int axis) const {
        const auto& m = kernel_.planes.exact(unoriented(a));
        const auto& n = kernel_.planes.exact(unoriented(b));
        const auto i = std::size_t((axis + 1) % 3);
        const auto j = std::size_t((axis + 2) % 3);
        WideInteger x(m[i] * WideInteger(n[j]));
        sub_product(x, m[j], n[i]);
        return is_flipped(a) == is_flipped(b) ? x.sign() : -x.sign();
    }

    void number() {
        shell_.assign(parent_.size(), no_id);
        for (std::uint32_t e = 0; e < parent_.size(); ++e) {
            const std::uint32_t r = root(e);
            if (shell_[r] == no_id) shell_[r] = static_cast<std::uint32_t>(count_++);
            shell_[e] = shell_[r];
        }
    }

    Kernel<3> kernel_;
    LoadedBoundary<3> loaded_;
    std::unique_ptr<const BoundaryEdges> edges_;
    std::unique_ptr<const FaceBoxes> boxes_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> shell_;
    std::vector<Ray> rays_;
    std::size_t count_ = 0;
    bool closed_ = true;
};

CLEAVE_END_NAMESPACE

#endif

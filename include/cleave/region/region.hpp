// SPDX-License-Identifier: Apache-2.0
/// `Region<D, N>`: a regular set as a value.
#ifndef CLEAVE_REGION_REGION_HPP
#define CLEAVE_REGION_REGION_HPP

#include <cleave/number/rational.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/complete.hpp>

#include <cstddef>
#include <memory>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A regular set in dimension D (the closure of its interior, with a boundary of finitely many flat faces), bounded or
/// not. Empty and full are ordinary values.
///
/// `N` is the interface's number type: what coordinates and measures are given in. Inside, planes are primitive
/// integers and points are doubles or names of planes, whatever N is, so results do not depend on it.
///
/// Copies share the boundary and cost a reference count. A const region may be used from many threads at once.
template <int D, class N = Rational>
class Region {
public:
    static constexpr int dimension = D;
    using number_type = N;

    /// The empty set.
    Region() : Region(empty()) {}

    /// A region from a finished boundary. Requires: faces are closed and face outward, and `value_at_infinity` fits.
    explicit Region(Boundary<D> boundary) : shared_(std::make_shared<const SharedBoundary<D>>(std::move(boundary))) {}

    /// The same set with another interface number type. Cost: none.
    template <class M>
    explicit Region(const Region<D, M>& other) : shared_(other.shared_boundary()) {}

    /// The empty set.
    [[nodiscard]] static Region empty() { return Region(constant(false)); }
    /// All of space.
    [[nodiscard]] static Region full() { return Region(constant(true)); }

    [[nodiscard]] bool is_empty() const noexcept { return face_count() == 0 && !surface().value_at_infinity; }
    [[nodiscard]] bool is_full() const noexcept { return face_count() == 0 && surface().value_at_infinity; }
    /// Whether the set lies in some box.
    [[nodiscard]] bool is_bounded() const noexcept { return surface().is_bounded(); }
    /// Whether its boundary does: so do those of bounded sets and of their complements.
    [[nodiscard]] bool has_bounded_boundary() const noexcept { return surface().is_finite; }

    [[nodiscard]] std::size_t face_count() const noexcept { return surface().faces.faces.size(); }

    /// The boundary. Cost: none but the first time, when planes that nothing has asked for yet are made.
    [[nodiscard]] const Boundary<D>& boundary() const { return shared_->complete(); }
    /// The boundary as it is stored: faces and edges may lack planes (`Boundary::is_complete`). Cost: none.
    [[nodiscard]] const Boundary<D>& surface() const noexcept { return shared_->given(); }
    [[nodiscard]] const std::shared_ptr<const SharedBoundary<D>>& shared_boundary() const noexcept { return shared_; }

private:
    explicit Region(std::shared_ptr<const SharedBoundary<D>> shared) : shared_(std::move(shared)) {}

    static const std::shared_ptr<const SharedBoundary<D>>& constant(bool value) {
        static const std::shared_ptr<const SharedBoundary<D>> values[2] = {make_constant(false), make_constant(true)};
        return values[value ? 1 : 0];
    }

    static std::shared_ptr<const SharedBoundary<D>> make_constant(bool value) {
        Boundary<D> b;
        b.value_at_infinity = value;
        b.is_conforming = true;
        return std::make_shared<const SharedBoundary<D>>(std::move(b));
    }

    std::shared_ptr<const SharedBoundary<D>> shared_;
};

/// The closure of the complement. Cost: linear.
template <int D, class N>
[[nodiscard]] Region<D, N> complement(const Region<D, N>& a) {
    Boundary<D> b = a.surface();
    b.value_at_infinity = !b.value_at_infinity;
    std::vector<Corner> loop;
    for (FaceList::Face& face : b.faces.faces) {
        if (face.plane != no_id) face.plane = flipped(face.plane);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            const std::uint32_t first = b.faces.loop_first[l];
            const std::uint32_t last = b.faces.loop_first[l + 1];
            loop.assign(b.faces.corners.begin() + first, b.faces.corners.begin() + last);
            reverse_loop<D>(loop);
            std::copy(loop.begin(), loop.end(), b.faces.corners.begin() + first);
        }
    }
    return Region<D, N>(std::move(b));
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// Cells for the toy space: axis-parallel boxes, without end where a coordinate is `beyond` every plane. With them the
/// algorithms that carry cells run where there are no numbers but 64-bit integers and no kernel.
#ifndef CLEAVE_TESTS_SUPPORT_TOY_CELLS_HPP
#define CLEAVE_TESTS_SUPPORT_TOY_CELLS_HPP

#include "support/toy_space.hpp"

#include <array>
#include <cstddef>
#include <ostream>

namespace toy {

/// Greater than every position of a plane.
inline constexpr Integer beyond = Integer(1) << 40;

/// The box [low, high], low < high along every axis.
template <std::size_t D>
struct Cell {
    std::array<Integer, D> low{};
    std::array<Integer, D> high{};

    friend bool operator==(const Cell&, const Cell&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Cell& c) {
        for (std::size_t i = 0; i < D; ++i) out << "[" << c.low[i] << "," << c.high[i] << "]";
        return out;
    }
};

/// The toy space as a model of CellClip.
template <std::size_t D>
class CellSpace : public Space<D> {
public:
    using cell_type = Cell<D>;

    [[nodiscard]] cell_type universe() const {
        cell_type c;
        c.low.fill(-beyond);
        c.high.fill(beyond);
        return c;
    }

    [[nodiscard]] cleave::FacetSide cell_side(const Plane& h, const cell_type& c) const {
        using cleave::FacetSide;
        if (c.low[h.axis] < h.at && h.at < c.high[h.axis]) return FacetSide::crossing;
        return (c.high[h.axis] <= h.at) == (h.outside == cleave::Sign::plus) ? FacetSide::minus : FacetSide::plus;
    }

    [[nodiscard]] cleave::CellSplit<cell_type, Facet<D>> split_cell(const Plane& h, const cell_type& c) const {
        cleave::CellSplit<cell_type, Facet<D>> s;
        s.side = cell_side(h, c);
        if (s.side != cleave::FacetSide::crossing) return s;
        cell_type below = c;
        cell_type above = c;
        below.high[h.axis] = h.at;
        above.low[h.axis] = h.at;
        s.lid = Facet<D>{h, c.low, c.high};
        s.lid->low[h.axis] = h.at;
        s.lid->high[h.axis] = h.at;
        const bool below_is_minus = h.outside == cleave::Sign::plus;
        s.minus = below_is_minus ? below : above;
        s.plus = below_is_minus ? above : below;
        return s;
    }
};

static_assert(cleave::CellClip<CellSpace<1>> && cleave::CellClip<CellSpace<2>> && cleave::CellClip<CellSpace<3>>);
static_assert(!cleave::CellClip<Space<2>>);

}  // namespace toy

#endif

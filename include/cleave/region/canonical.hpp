// SPDX-License-Identifier: Apache-2.0
/// The canonical form: a text that depends on the set alone, whatever engine, order of operations or number type made
/// it. Equal sets have equal bytes, different sets different ones.
///
/// A set is its boundary and one bit, the value at the far point. The boundary is, for each oriented plane, a set in
/// that plane; projected along the first axis that the plane's normal has, it is a set of one dimension less, and so on
/// down to the line, where a set is its sorted ends. Nothing has to be put together for that: a face given in pieces is
/// the *sum* of the pieces, the boundary of a sum is the sum of the boundaries, and what inner walls contribute
/// cancels, so every level is a sum of signed convex pieces on one flat and only the ends on lines are ever sorted and
/// added up. Any way of cutting faces up gives the same result, T-junctions, holes, pinched loops and unbounded faces
/// included.
#ifndef CLEAVE_REGION_CANONICAL_HPP
#define CLEAVE_REGION_CANONICAL_HPP

#include <cleave/region/polytope_faces.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Writes the canonical form of one boundary.
template <int D>
class CanonicalWriter {
public:
    explicit CanonicalWriter(const Boundary<D>& boundary) : boundary_(&boundary), clip_(kernel_) {
        loaded_ = load(boundary, kernel_);
    }

    std::string run() {
        std::string out = "dimension " + std::to_string(D) + (boundary_->value_at_infinity ? " far 1" : " far 0");
        // Facets with the same oriented plane, by its coefficients.
        std::map<Row, std::vector<std::uint32_t>> by_plane;
        for (std::uint32_t f = 0; f < boundary_->faces.faces.size(); ++f)
            by_plane[row_of(loaded_.plane(boundary_->faces.faces[f].plane))].push_back(f);
        for (const auto& [row, faces] : by_plane) {
            Flat flat;
            flat.push(row);
            const std::string inner = write_faces(flat, faces);
            if (!inner.empty()) out.append("\n(").append(text_of(row, {})).append(inner).append(")");
        }
        return out.append("\n");
    }

private:
    /// n_1, ..., n_D, c and the factor of R in the offset.
    using Row = std::array<Integer, D + 2>;

    /// A flat given by planes, each with an axis that the ones after it are free of: those axes are projected away.
    struct Flat {
        std::vector<std::pair<Row, std::size_t>> planes;
        std::array<bool, D> dropped{};

        void push(const Row& row) {
            std::size_t axis = 0;
            while (row[axis].is_zero()) ++axis;
            planes.emplace_back(row, axis);
            dropped[axis] = true;
        }

        /// The trace of a plane on the flat in the remaining coordinates, same orientation, primitive.
        [[nodiscard]] Row trace(Row row) const {
            for (const auto& [h, axis] : planes) {
                if (row[axis].is_zero()) continue;
                const Integer factor = row[axis];
                const bool negative = h[axis].sign() == Sign::minus;
                for (std::size_t i = 0; i < row.size(); ++i) {
                    WideInteger x(WideInteger(row[i]) * WideInteger(h[axis]));
                    sub_product(x, h[i], factor);
                    row[i] = Integer(negative ? -x : x);
                }
            }
            make_primitive(row);
            return row;
        }

        [[nodiscard]] int last_axis() const {
            int axis = 0;
            while (dropped[std::size_t(axis)]) ++axis;
            return axis;
        }
    };

    /// A convex piece of a flat, counted with a sign.
    struct Piece {
        int sign;
        Polytope body;
    };

    static void make_primitive(Row& row) {
        Integer divisor;
        for (const Integer& x : row)
            if (!x.is_zero()) divisor = divisor.is_zero() ? abs(x) : gcd(divisor, x);
        if (divisor.is_zero() || divisor == Integer(1)) return;
        for (Integer& x : row)
            if (!x.is_zero()) x = exact_divide(x, divisor);
    }

    [[nodiscard]] Row row_of(PlaneId h) const {
        Row row;
        const auto& c = kernel_.planes.exact(unoriented(h));
        std::copy(c.begin(), c.end(), row.begin());
        row[D + 1] = Integer(kernel_.planes.reach(unoriented(h)));
        if (is_flipped(h))
            for (Integer& x : row) x.negate();
        return row;
    }

    /// Turns a row so that its first entry is positive. Returns the sign it had.
    static int orient(Row& row) {
        std::size_t i = 0;
        while (row[i].is_zero()) ++i;
        if (row[i].sign() == Sign::plus) return 1;
        for (Integer& x : row) x.negate();
        return -1;
    }

    /// The entries of a row in the axes that are left. (Appending throughout: for a literal plus a temporary string,
    /// g++ 12 warns of copies that never happen.)
    static std::string text_of(const Row& row, const std::array<bool, D>& dropped) {
        std::string out;
        for (std::size_t i = 0; i < D; ++i)
            if (!dropped[i]) out.append(out.empty() ? "" : " ").append(row[i].to_string());
        out.append("|").append(row[D].to_string());
        if (!row[D + 1].is_zero()) out.append("|").append(row[D + 1].to_string());
        return out;
    }

    std::string write_faces(const Flat& flat, const std::vector<std::uint32_t>& faces) {
        const FaceList& list = boundary_->faces;
        if constexpr (D == 1) {
            int count = 0;
            for (const std::uint32_t f : faces) count += int(list.faces[f].loop_count);
            return count == 0 ? std::string() : std::string("*").append(std::to_string(count));
        } else if constexpr (D == 2) {
            std::vector<std::pair<PointId, int>> ends;
            for_each_loop(faces, [&](std::span<const Corner> loop) {
                add_segment(ends, flat, loop[0].point + loaded_.first_point, loop[1].point + loaded_.first_point, 1);
            });
            return write_ends(flat, ends);
        } else if constexpr (D == 3) {
            std::map<Row, std::vector<std::pair<PointId, int>>> lines;
            std::map<Row, Flat> flats;
            for_each_loop(faces, [&](std::span<const Corner> loop) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    Row row = flat.trace(row_of(loaded_.plane(loop[i].edge)));
                    const int sign = orient(row);
                    auto [at, added] = flats.try_emplace(row, flat);
                    if (added) at->second.push(row);
                    add_segment(lines[row], at->second, loop[i].point + loaded_.first_point,
                                loop[i + 1 == loop.size() ? 0 : i + 1].point + loaded_.first_point, sign);
                }
            });
            std::string out;
            for (auto& [row, ends] : lines) {
                const std::string inner = write_ends(flats.at(row), ends);
                if (!inner.empty()) out.append("(").append(text_of(row, flat.dropped)).append(inner).append(")");
            }
            return out;
        } else {
            std::vector<Piece> pieces;
            for_each_loop(faces, [&](std::span<const Corner> loop) {
                pieces.push_back({1, polytope_of(clip_, loop, loaded_)});
            });
            return write_pieces(flat, std::move(pieces));
        }
    }

    template <class F>
    void for_each_loop(const std::vector<std::uint32_t>& faces, F&& f) const {
        for (const std::uint32_t i : faces) {
            const FaceList::Face& face = boundary_->faces.faces[i];
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l)
                f(boundary_->faces.loop(l));
        }
    }

    /// The sum of pieces of the flat, which has a dimension above 1 left: by the planes of their faces.
    std::string write_pieces(const Flat& flat, std::vector<Piece> pieces) {
        std::map<Row, std::vector<Piece>> by_trace;
        for (const Piece& piece : pieces)
            for (const PolytopeFace& face : largest_faces(piece.body)) {
                std::size_t off = 0;
                while (piece.body.has(off, face.plane)) ++off;
                const bool inside_below = kernel_.side(2 * face.plane, piece.body.points[off]) == Sign::minus;
                Row row = flat.trace(row_of(2 * face.plane));
                const int sign = orient(row) * (inside_below ? 1 : -1);
                by_trace[row].push_back({piece.sign * sign, subpolytope(piece.body, face.vertices)});
            }
        std::string out;
        for (auto& [row, faces] : by_trace) {
            Flat inner = flat;
            inner.push(row);
            std::string text;
            if (inner.planes.size() + 1 == std::size_t(D)) {
                std::vector<std::pair<PointId, int>> ends;
                for (const Piece& p : faces) add_segment(ends, inner, p.body.points[0], p.body.points[1], p.sign);
                text = write_ends(inner, ends);
            } else {
                text = write_pieces(inner, std::move(faces));
            }
            if (!text.empty()) out.append("(").append(text_of(row, flat.dropped)).append(text).append(")");
        }
        return out;
    }

    /// A segment counts once more between its ends: -1 at the lower one, +1 at the upper one, outward as every facet.
    void add_segment(std::vector<std::pair<PointId, int>>& ends, const Flat& flat, PointId p, PointId q, int sign) {
        if (kernel_.compare(flat.last_axis(), p, q) == Sign::plus) std::swap(p, q);
        ends.emplace_back(p, -sign);
        ends.emplace_back(q, sign);
    }

    std::string write_ends(const Flat& flat, std::vector<std::pair<PointId, int>>& ends) {
        const int axis = flat.last_axis();
        std::stable_sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) {
            return kernel_.compare(axis, a.first, b.first) == Sign::minus;
        });
        std::string out;
        for (std::size_t i = 0; i < ends.size();) {
            int sum = 0;
            const PointId p = ends[i].first;
            for (; i < ends.size() && kernel_.compare(axis, p, ends[i].first) == Sign::zero; ++i) sum += ends[i].second;
            if (sum == 0) continue;
            out.append(out.empty() ? ":" : ",").append(position(axis, p)).append(sum > 0 ? "+" : "-");
            if (sum != 1 && sum != -1) out.append(std::to_string(sum > 0 ? sum : -sum));
        }
        return out;
    }

    /// A coordinate as p/q, or as an infinite one: the line that it lies on tells the rest.
    std::string position(int axis, PointId p) {
        const auto i = std::size_t(axis);
        if (const auto* reach = kernel_.reach(p)) {
            const Sign s = (*reach)[i].sign();
            if (s != Sign::zero) return s == Sign::plus ? "inf" : "-inf";
        }
        const Homogeneous<D>& x = kernel_.exact(p);
        const Fraction f = make_fraction(x[i], x[D]);
        std::string text = f.num.to_string();
        if (f.den != Integer(1)) text.append("/").append(f.den.to_string());
        return text;
    }

    const Boundary<D>* boundary_;
    Kernel<D> kernel_;
    PolytopeClip<D> clip_;
    LoadedBoundary<D> loaded_;
};

}  // namespace detail

/// The canonical form of a set; see the head of this file. A text for people to read and programs to compare or hash.
/// Cost: every vertex is computed exactly; sorting of planes, lines and ends. D >= 4: for each facet all its faces.
template <int D, class N>
[[nodiscard]] std::string canonical(const Region<D, N>& region) {
    return detail::CanonicalWriter<D>(region.boundary()).run();
}

CLEAVE_END_NAMESPACE

#endif

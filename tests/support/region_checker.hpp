// SPDX-License-Identifier: Apache-2.0
/// Checker objects for regions: everything a stored boundary promises, verified in rational arithmetic after every
/// operation of a test, and the proof that operands were left alone.
#ifndef CLEAVE_TESTS_SUPPORT_REGION_CHECKER_HPP
#define CLEAVE_TESTS_SUPPORT_REGION_CHECKER_HPP

#include "support/exact_region.hpp"

#include <cleave/extern.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace support {

/// Every bit that a boundary holds, as text: two dumps are equal exactly if nothing was touched.
template <int D>
[[nodiscard]] std::string dump(const cleave::Boundary<D>& b) {
    std::string out = b.value_at_infinity ? "cobounded" : "bounded";
    const auto number = [&out](double x) {
        char text[40];
        std::snprintf(text, sizeof text, " %a", x);
        out += text;
    };
    const auto word = [&out](const std::string& text) { out += " " + text; };
    for (std::uint32_t k = 0; k < b.planes.size(); ++k) {
        out += "\nplane";
        for (std::size_t i = 0; i <= std::size_t(D); ++i) {
            word(cleave::to_text(b.planes.exact(k)[i]));
            number(b.planes.approximation(k)[i]);
            word(std::to_string(b.planes.residues(k)[i].value()));
        }
        word(std::to_string(b.planes.axis(k)));
        number(b.planes.axis_position(k));
    }
    for (const cleave::PointRecord<D>& r : b.points) {
        out += "\npoint";
        for (const double x : r.approximation) number(x);
        number(r.error);
        for (const std::uint32_t k : r.planes) word(std::to_string(k));
        word(std::to_string(r.exact));
        word(std::to_string(int(r.kind)));
        word(std::to_string(int(r.rounded)));
    }
    for (const auto& e : b.exact) {
        out += "\nexact";
        for (const cleave::Integer& x : e) word(cleave::to_text(x));
    }
    for (const auto& f : b.faces.faces) {
        out += "\nface";
        for (const std::uint32_t x : {f.plane, f.first_loop, f.loop_count, f.source.operand, f.source.face})
            word(std::to_string(x));
    }
    out += "\nloops";
    for (const std::uint32_t x : b.faces.loop_first) word(std::to_string(x));
    for (const cleave::Corner& c : b.faces.corners) word(std::to_string(c.point) + "/" + std::to_string(c.edge));
    out += "\nbounds";
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        number(b.bounds.lo[i]);
        number(b.bounds.hi[i]);
    }
    return out;
}

/// Verifies one boundary. `verify` throws Defect with the first promise that does not hold.
template <int D>
class RegionChecker {
public:
    static constexpr std::size_t dimension = std::size_t(D);
    using Point = Coordinates<D>;

    template <class N>
    explicit RegionChecker(const cleave::Region<D, N>& region)
        : b_(&region.boundary()), surface_(&region.surface()), exact_(region) {}

    [[nodiscard]] const ExactRegion<D>& exact() const { return exact_; }

    /// Indices, planes, points, loops, closedness.
    void verify_structure() const {
        verify_indices();
        verify_planes();
        verify_points();
        for (std::size_t f = 0; f < b_->faces.faces.size(); ++f) verify_face(f);
        verify_closed();
        if constexpr (D == 3) {
            if (surface_->is_conforming) verify_conforming();
        }
    }

    /// That edges match from end to end, as the stored boundary says, and that no two points are one.
    void verify_conforming() const requires(D == 3) {
        std::map<std::pair<cleave::PointId, cleave::PointId>, int> balance;
        for (std::size_t l = 0; l + 1 < surface_->faces.loop_first.size(); ++l) {
            const auto loop = surface_->faces.loop(l);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const cleave::PointId p = loop[i].point;
                const cleave::PointId q = loop[i + 1 == loop.size() ? 0 : i + 1].point;
                require(p != q, "an edge without length");
                balance[std::minmax(p, q)] += p < q ? 1 : -1;
            }
        }
        for (const auto& [ends, b] : balance) require(b == 0, "an edge of a conforming boundary has no opposite");
        std::set<Point> places;
        for (const auto& r : surface_->points) places.insert(ExactRegion<D>::coordinates(*surface_, r));
        require(places.size() == surface_->points.size(), "two points of a conforming boundary are one");
    }

    /// That every face has the set below it and not above it, and lies on no other face.
    void verify_sides() const {
        for (std::size_t f = 0; f < exact_.faces().size(); ++f) verify_sides_of(f);
    }

    void verify() const {
        verify_structure();
        verify_sides();
    }

    /// That nothing was constructed from constructed things: every plane of the region is an operand's, or (for edges
    /// only) perpendicular to an axis at a position that is a double; every point that is not a meet of planes is an
    /// operand's point; hence numbers are no longer than the operands' own.
    void verify_names(std::span<const cleave::Boundary<D>* const> operands) const {
        std::set<Coefficients<D>> face_planes;
        std::set<Coefficients<D>> planes;
        std::set<Point> points;
        std::size_t bits = 0;
        for (const cleave::Boundary<D>* o : operands) {
            for (const auto& f : o->faces.faces)
                face_planes.insert(ExactRegion<D>::coefficients(*o, 2 * cleave::unoriented(f.plane)));
            for (std::uint32_t k = 0; k < o->planes.size(); ++k) planes.insert(ExactRegion<D>::coefficients(*o, 2 * k));
            for (const auto& r : o->points) points.insert(ExactRegion<D>::coordinates(*o, r));
            bits = std::max({bits, o->planes.bits().first, o->planes.bits().second});
        }
        for (const auto& f : b_->faces.faces)
            require(face_planes.count(ExactRegion<D>::coefficients(*b_, 2 * cleave::unoriented(f.plane))) == 1,
                    "a face lies in no plane of an operand's face");
        for (std::uint32_t k = 0; k < b_->planes.size(); ++k) {
            if (planes.count(ExactRegion<D>::coefficients(*b_, 2 * k)) == 1) {
                for (const cleave::Integer& x : b_->planes.exact(k))
                    require(x.bit_length() <= bits, "a plane is longer than the operands' planes");
            } else {
                require(!std::isnan(b_->planes.axis_position(k)), "a plane is neither an operand's nor axis-parallel");
            }
        }
        for (const auto& r : b_->points)
            if (r.kind != cleave::PointRecord<D>::Kind::meet)
                require(points.count(ExactRegion<D>::coordinates(*b_, r)) == 1,
                        "a point given by coordinates is no point of an operand");
    }

private:
    static void require(bool condition, const std::string& message) {
        if (!condition) throw Defect(message);
    }

    void verify_indices() const {
        const cleave::FaceList& list = b_->faces;
        require(
            !list.loop_first.empty() && list.loop_first.front() == 0 && list.loop_first.back() == list.corners.size(),
            "loops do not cover the corners");
        std::uint32_t next = 0;
        for (const auto& f : list.faces) {
            require(f.first_loop == next && f.loop_count > 0, "a face's loops do not follow the previous face's");
            next += f.loop_count;
            require(next < list.loop_first.size(), "a face's loops are out of range");
            require(cleave::unoriented(f.plane) < b_->planes.size(), "a face's plane is out of range");
            for (std::uint32_t l = f.first_loop; l < next; ++l) {
                const std::size_t size = list.loop(l).size();
                require(D == 3 ? size >= 3 : size == dimension, "a loop has too few or too many corners");
                for (const cleave::Corner& c : list.loop(l)) {
                    require(c.point < b_->points.size(), "a corner's point is out of range");
                    require(D == 1 ? c.edge == cleave::no_id : cleave::unoriented(c.edge) < b_->planes.size(),
                            "a corner's edge plane is out of range");
                }
            }
        }
        require(next + 1 == list.loop_first.size(), "a loop belongs to no face");
    }

    void verify_planes() const {
        std::set<Coefficients<D>> seen;
        for (std::uint32_t k = 0; k < b_->planes.size(); ++k) {
            const auto& c = b_->planes.exact(k);
            cleave::Integer divisor(0);
            for (const cleave::Integer& x : c) divisor = gcd(divisor, x);
            require(divisor == cleave::Integer(1), "a plane is not primitive");
            std::size_t first = 0;
            while (first < dimension && c[first].is_zero()) ++first;
            require(first < dimension, "a plane has no normal");
            require(c[first].sign() == cleave::Sign::plus, "a plane is not canonical");
            require(seen.insert(ExactRegion<D>::coefficients(*b_, 2 * k)).second, "a plane is stored twice");
        }
    }

    void verify_points() const {
        std::set<Point> seen;
        for (std::size_t p = 0; p < b_->points.size(); ++p) {
            const cleave::PointRecord<D>& r = b_->points[p];
            const Point& x = exact_.points()[p];
            require(seen.insert(x).second, "two points at the same place");
            for (const std::uint32_t k : r.planes) {
                if (k == cleave::no_id) continue;
                require(k < b_->planes.size(), "a point's plane is out of range");
                require(value<D>(ExactRegion<D>::coefficients(*b_, 2 * k), x) == 0, "a point is not on its plane");
            }
            verify_approximation(r, x);
            if (r.exact != cleave::no_id) {
                const auto& e = b_->exact.at(r.exact);
                require(e[dimension].sign() == cleave::Sign::plus, "a weight is not positive");
                for (std::size_t i = 0; i < dimension; ++i)
                    require(rational(e[i], e[dimension]) == x[i], "a point's exact coordinates are not on its planes");
            }
        }
    }

    void verify_approximation(const cleave::PointRecord<D>& r, const Point& x) const {
        using Traits = cleave::number_traits<Rational>;
        const bool known = std::isfinite(r.error);
        for (std::size_t i = 0; i < dimension; ++i) {
            const double lo = b_->bounds.lo[i];
            const double hi = b_->bounds.hi[i];
            require((std::isinf(lo) || Traits::from_double(lo) <= x[i]) &&
                        (std::isinf(hi) || Traits::from_double(hi) >= x[i]),
                    "the bounds do not contain a point");
            if (r.rounded)
                require(r.approximation[i] == Traits::to_double(x[i]), "a coordinate is not rounded correctly");
            if (!known) continue;
            const Rational off = x[i] - Traits::from_double(r.approximation[i]);
            const Rational error = Traits::from_double(r.error);
            require(off <= error && -off <= error, "a point is farther from its approximation than its error says");
        }
        require(known || r.rounded, "a stored point has no approximation");
    }

    void verify_face(std::size_t f) const {
        const auto& face = b_->faces.faces[f];
        const Coefficients<D>& plane = exact_.faces()[f].plane;
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            const std::span<const cleave::Corner> loop = b_->faces.loop(l);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Point& p = exact_.points()[loop[i].point];
                require(value<D>(plane, p) == 0, "a corner is not on its face's plane");
                if constexpr (D == 1) continue;
                const Point& q = exact_.points()[loop[i + 1 == loop.size() ? 0 : i + 1].point];
                require(p != q, "an edge has no length");
                verify_ridge(plane, ExactRegion<D>::coefficients(*b_, loop[i].edge), p, q);
            }
        }
        if constexpr (D == 2) {
            // The set is on the left of the segment: its normal is the direction turned clockwise.
            for (const auto& s : exact_.faces()[f].loops) {
                const Point d = subtract(s[1], s[0]);
                require(plane[0] * d[1] - plane[1] * d[0] > 0, "a segment runs against its line");
            }
        }
    }

    /// The edge plane e of corner p, q the next one.
    static void verify_ridge(const Coefficients<D>& plane, const Coefficients<D>& e, const Point& p, const Point& q) {
        require(value<D>(e, p) == 0, "an edge plane does not contain its corner");
        if constexpr (D == 2) {
            require(value<D>(e, q) < 0, "the other end of a segment is not on the minus side of an end's line");
        } else if constexpr (D == 3) {
            require(value<D>(e, q) == 0, "an edge plane does not contain its edge");
            const Point left = cross(normal<3>(plane), subtract(q, p));
            require(dot(normal<3>(e), left) < 0, "an edge plane has its face on the wrong side, or is the face's own");
        }
    }

    void verify_closed() const {
        if constexpr (D == 1) {
            std::map<Rational, int> ends;
            for (const ExactFace<1>& f : exact_.faces())
                require(ends.emplace(f.loops[0][0][0], sign(f.plane[0])).second, "two ends in one place");
            bool inside = exact_.value_at_infinity();
            for (const auto& [x, outwards] : ends) {
                require((outwards > 0) == inside, "an end faces the wrong way");
                inside = !inside;
            }
            require(inside == exact_.value_at_infinity(), "the two infinities differ");
        } else if constexpr (D == 2) {
            std::map<Point, int> balance;
            for (const ExactFace<2>& f : exact_.faces())
                for (const auto& s : f.loops) {
                    ++balance[s[0]];
                    --balance[s[1]];
                }
            for (const auto& [p, b] : balance) require(b == 0, "as many segments must end as start in a point");
        } else {
            verify_balanced_lines();
        }
    }

    /// On every line the edges of all faces, counted with their direction, cancel over every stretch: that is, as many
    /// start as end in each of its points, whatever T-junctions there are.
    void verify_balanced_lines() const requires(D == 3) {
        std::map<std::array<Rational, 6>, std::map<Rational, int>> lines;
        for (const ExactFace<3>& f : exact_.faces()) {
            for (const auto& loop : f.loops) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    const Point& p = loop[i];
                    Point d = subtract(loop[i + 1 == loop.size() ? 0 : i + 1], p);
                    std::size_t axis = 0;
                    while (d[axis] == 0) ++axis;
                    const Rational scale = d[axis];
                    for (Rational& x : d) x /= scale;
                    const Point foot = along(p, Rational(-p[axis]), d);
                    auto& line = lines[{d[0], d[1], d[2], foot[0], foot[1], foot[2]}];
                    ++line[p[axis]];
                    --line[loop[i + 1 == loop.size() ? 0 : i + 1][axis]];
                }
            }
        }
        for (const auto& [line, balance] : lines)
            for (const auto& [at, b] : balance) require(b == 0, "the edges along a line do not cancel");
    }

    void verify_sides_of(std::size_t f) const {
        for (int attempt = 0; attempt < 40; ++attempt) {
            const std::optional<Point> p = exact_.sample(f, attempt);
            if (!p) continue;
            const std::optional<bool> above = exact_.value_above(f, *p);
            if (!above) continue;
            require(!*above, "a face does not face outward");
            return;
        }
        throw Defect("a face is covered by others");
    }

    const cleave::Boundary<D>* b_;
    const cleave::Boundary<D>* surface_;
    ExactRegion<D> exact_;
};

/// Verifies everything that can be verified of a region alone, and returns it.
template <int D, class N>
const cleave::Region<D, N>& verified(const cleave::Region<D, N>& region) {
    RegionChecker<D>(region).verify();
    return region;
}

/// Evaluates with all checks: the result, its names, and that the operands were not touched.
template <int D, class N>
[[nodiscard]] cleave::Region<D, N> checked_evaluate(const cleave::BooleanFunction& function,
                                                    const std::vector<cleave::Region<D, N>>& operands,
                                                    const cleave::OperationOptions& options = {}) {
    std::vector<std::string> before;
    std::vector<const cleave::Boundary<D>*> boundaries;
    for (const auto& r : operands) {
        before.push_back(dump(r.boundary()));
        boundaries.push_back(&r.boundary());
    }
    const cleave::Region<D, N> result =
        cleave::evaluate<D, N>(function, std::span<const cleave::Region<D, N>>(operands), options);
    const RegionChecker<D> checker(result);
    checker.verify();
    checker.verify_names(boundaries);
    for (std::size_t i = 0; i < operands.size(); ++i)
        if (dump(operands[i].boundary()) != before[i]) throw Defect("an operand was changed");
    return result;
}

/// The same for one of the four operations.
template <int D, class N>
[[nodiscard]] cleave::Region<D, N> checked(cleave::Operation operation, const cleave::Region<D, N>& a,
                                           const cleave::Region<D, N>& b) {
    return checked_evaluate<D, N>(cleave::BooleanFunction::from(operation, 2), {a, b});
}

/// Whether two regions are the same set: their symmetric difference, checked, is empty.
template <int D, class N>
[[nodiscard]] bool equal_sets(const cleave::Region<D, N>& a, const cleave::Region<D, N>& b) {
    return checked(cleave::Operation::symmetric_difference, a, b).is_empty();
}

// Compiled once, in checkers.cpp.
#if defined(CLEAVE_INSTANTIATE_CHECKERS)
#define CLEAVE_CHECKERS_EXTERN
#else
#define CLEAVE_CHECKERS_EXTERN extern
#endif
#define CLEAVE_CHECKERS(D)                                                                                       \
    CLEAVE_CHECKERS_EXTERN template std::string dump<D>(const cleave::Boundary<D>&);                             \
    CLEAVE_CHECKERS_EXTERN template const cleave::Region<D>& verified<D, Rational>(const cleave::Region<D>&);    \
    CLEAVE_CHECKERS_EXTERN template cleave::Region<D> checked_evaluate<D, Rational>(                             \
        const cleave::BooleanFunction&, const std::vector<cleave::Region<D>>&, const cleave::OperationOptions&); \
    CLEAVE_CHECKERS_EXTERN template cleave::Region<D> checked<D, Rational>(                                      \
        cleave::Operation, const cleave::Region<D>&, const cleave::Region<D>&);                                  \
    CLEAVE_CHECKERS_EXTERN template bool equal_sets<D, Rational>(const cleave::Region<D>&, const cleave::Region<D>&);
CLEAVE_CHECKERS(1)
CLEAVE_CHECKERS(2)
CLEAVE_CHECKERS(3)
#undef CLEAVE_CHECKERS
#undef CLEAVE_CHECKERS_EXTERN

}  // namespace support

#endif

// SPDX-License-Identifier: Apache-2.0
/// The indexed exact kernel: interned planes and lazily exact points, with filtered predicates.
///
/// A point is an input point (D doubles, or homogeneous integers) or the meet of D planes. It carries a double
/// approximation with a proven absolute error bound; predicates try, in this order, identity ("this point was made from
/// this plane"), the floating-point filter, a refined approximation (the point is computed exactly once), and the exact
/// sign. Constructed points never define planes, so no number grows beyond the bound of the input planes.
///
/// Points at infinity are meets with planes of the *infimaximal frame* (`PlaneTable::frame`), x_i = R and x_i = -R with
/// R larger than every number: their homogeneous coordinates are a + b R with integers a and b, and a weight without R
/// [Mehlhorn-Seel-2003]. Every sign is that of the factor of R, or where it is zero of the rest; no filter decides.
#ifndef CLEAVE_GEOMETRY_KERNEL_HPP
#define CLEAVE_GEOMETRY_KERNEL_HPP

#include <cleave/algebra/minors.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/geometry/grid_meet.hpp>
#include <cleave/geometry/handles.hpp>
#include <cleave/geometry/plane_table.hpp>
#include <cleave/geometry/point_record.hpp>
#include <cleave/geometry/residues.hpp>
#include <cleave/geometry/rounded_meet.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/filter.hpp>
#include <cleave/number/sign.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// See the head of this file. Not thread-safe: each operation has its own.
template <int D>
class Kernel {
public:
    static constexpr int dimension = D;
    using Record = PointRecord<D>;
    using Exact = Homogeneous<D>;
    using Residues = std::array<Mod61, D>;
    /// The factors of R in the homogeneous coordinates of a point.
    using Reach = std::array<Integer, D>;

    PlaneTable<D> planes;

    [[nodiscard]] std::size_t point_count() const noexcept { return points_.size(); }
    [[nodiscard]] const Record& point(PointId p) const { return points_[p]; }
    [[nodiscard]] const KernelCounts& counts() const noexcept { return counts_; }
    void reserve_points(std::size_t n) { points_.reserve(n); }

    /// An input point given by doubles. Requires: all finite.
    PointId add_point(const std::array<double, D>& x) {
        Record r;
        r.approximation = x;
        for (double& c : r.approximation) c += 0.0;  // one zero
        return push(r);
    }

    /// An input point given by homogeneous integers. Requires: positive weight.
    PointId add_point(Exact x) {
        CLEAVE_REQUIRES(x[D].sign() == Sign::plus);
        Record r;
        r.kind = Record::Kind::integers;
        r.exact = store(std::move(x));
        approximate(r);
        return push(r);
    }

    /// A copy of another kernel's (or boundary's) record; `planes` must be this kernel's.
    PointId add_record(Record r, const Exact* exact) {
        r.exact = exact != nullptr ? store(*exact) : no_id;
        return push(r);
    }

    /// The meet of D planes, of which it is known that they meet in one point; computed when needed.
    PointId add_meet(const std::array<std::uint32_t, D>& through) {
        Record r;
        r.kind = Record::Kind::meet;
        r.rounded = false;
        r.planes = through;
        r.error = std::numeric_limits<double>::infinity();
        place_on_axes(r);
        return push(r);
    }

    /// Notes that an input point lies on plane k, so that later side tests against k are free. Keeps the first D.
    void note_incidence(PointId p, std::uint32_t k) {
        Record& r = points_[p];
        if (r.kind == Record::Kind::meet) return;
        for (std::uint32_t& slot : r.planes) {
            if (slot == k) return;
            if (slot == no_id) {
                slot = k;
                return;
            }
        }
    }

    /// The side of plane h on which p lies. Cost: about 5 ns where the filter decides.
    Sign side(PlaneId h, PointId p) {
        const Sign s = side_of_canonical(unoriented(h), p);
        return is_flipped(h) ? -s : s;
    }

    /// The point where the segment from a to b crosses h, on the D-1 further planes `line` (unoriented) whose meet is
    /// the line ab. Requires: a and b lie on opposite open sides of h, both on `line`.
    PointId cross(PlaneId h, PointId a, PointId b, const std::array<std::uint32_t, D - 1>& line) {
        Record r;
        r.kind = Record::Kind::meet;
        r.rounded = false;
        for (std::size_t i = 0; i + 1 < D; ++i) r.planes[i] = line[i];
        r.planes[D - 1] = unoriented(h);
        if (!place_on_axes(r)) interpolate(unoriented(h), points_[a], points_[b], r);
        return push(r);
    }

    /// Whether p lies on the frame, that is, some coordinate is infinite.
    [[nodiscard]] bool is_infinite(PointId p) const {
        const Record& r = points_[p];
        if (!planes.has_frame() || r.kind != Record::Kind::meet) return false;
        for (const std::uint32_t k : r.planes)
            if (planes.reach(k) != 0) return true;
        return false;
    }

    /// The factors of R in the coordinates of `exact(p)`; null for a finite point. Valid until the next point.
    const Reach* reach(PointId p) {
        if (!is_infinite(p)) return nullptr;
        exact(p);
        return &reaches_.at(points_[p].exact);
    }

    /// The exact coordinates of p, not reduced. Computed once for a meet and kept.
    const Exact& exact(PointId p) {
        Record& r = points_[p];
        if (r.exact == no_id) {
            r.exact = store(r.is_of_doubles() ? homogeneous_of<D>(r.approximation) : meet(r.planes));
            if (!r.is_of_doubles()) ++counts_.exact_points;
            if (is_infinite(p)) reaches_.emplace(r.exact, meet_reach(r.planes));
        }
        return exact_[r.exact];
    }

    /// Makes the approximation of p the correctly rounded value of each coordinate.
    void refine(PointId p) {
        if (points_[p].rounded || round_meet(p)) return;
        exact(p);
        if (is_infinite(p))
            points_[p].rounded = true;  // the error stays infinite
        else
            approximate(points_[p]);
    }

    /// The order of coordinate `axis` of p and q.
    Sign compare(int axis, PointId p, PointId q) {
        if (p == q) return Sign::zero;
        const auto i = std::size_t(axis);
        for (int attempt = 0; attempt < 2; ++attempt) {
            const Record& a = points_[p];
            const Record& b = points_[q];
            const double difference = a.approximation[i] - b.approximation[i];
            if (a.is_of_doubles() && b.is_of_doubles())
                return sign_of_value(int(a.approximation[i] > b.approximation[i]) -
                                     int(a.approximation[i] < b.approximation[i]));
            const double bound = (a.error + b.error) * (1 + 0x1p-50) + std::abs(difference) * 0x1p-52 + 0x1p-1000;
            if constexpr (!filtering::always_fails) {
                if (difference > bound) return Sign::plus;
                if (-difference > bound) return Sign::minus;
            }
            if (attempt == 0) {
                if (a.rounded && b.rounded) break;
                refine(p);
                refine(q);
            }
        }
        exact(p);
        exact(q);
        const Exact& x = exact_[points_[p].exact];
        const Exact& y = exact_[points_[q].exact];
        if (const Sign s = compare_reach(i, p, q); s != Sign::zero) return s;
        return (WideInteger(x[i]) * WideInteger(y[D]) - WideInteger(y[i]) * WideInteger(x[D])).sign();
    }

    /// Whether p and q are the same point of space.
    bool same(PointId p, PointId q) {
        if (p == q) return true;
        for (int i = 0; i < D; ++i)
            if (compare(i, p, q) != Sign::zero) return false;
        return true;
    }

    /// Affine coordinates modulo 2^61-1; nullopt where the weight of the point in lowest terms is divisible by it.
    std::optional<Residues> residues(PointId p) {
        Residues x;
        const Record& r = points_[p];
        if (r.is_of_doubles()) {
            for (std::size_t i = 0; i < D; ++i) x[i] = residue_of(r.approximation[i]);
            return x;
        }
        std::array<Mod61, D + 1> h;
        if (r.kind == Record::Kind::meet && r.exact == no_id) {
            std::array<std::array<Mod61, D + 1>, D> m;
            for (std::size_t i = 0; i < D; ++i) m[i] = planes.residues(r.planes[i]);
            h = residue_minors(m);
        } else {
            const Exact& e = exact(p);
            for (std::size_t i = 0; i <= D; ++i) h[i] = Mod61(e[i].modulo_61());
            if (const Reach* b = reach(p))
                for (std::size_t i = 0; i < D; ++i) h[i] += Mod61((*b)[i].modulo_61()) * planes.reach_residue();
        }
        if (h[D].value() == 0) {
            if (is_infinite(p)) return std::nullopt;
            Exact e = exact(p);
            Integer g = e[D];
            for (std::size_t i = 0; i < D; ++i) g = gcd(g, e[i]);
            for (std::size_t i = 0; i <= D; ++i) h[i] = Mod61(exact_divide(e[i], g).modulo_61());
            if (h[D].value() == 0) return std::nullopt;
        }
        const Mod61 w = h[D].inverse();
        for (std::size_t i = 0; i < D; ++i) x[i] = h[i] * w;
        return x;
    }

    /// The meet of D planes of the table. Requires: they meet in one point.
    Exact meet(const std::array<std::uint32_t, D>& through) const {
        RowsView<D, D + 1, Integer> rows{};
        for (std::size_t i = 0; i < D; ++i) rows.row[i] = &planes.exact(through[i]);
        const auto v = minors<WideInteger>(rows);
        CLEAVE_ASSERT(v[D].sign() != Sign::zero);
        Exact e;
        const bool negate = v[D].sign() == Sign::minus;
        for (std::size_t i = 0; i <= D; ++i) e[i] = Integer(negate ? -v[i] : v[i]);
        return e;
    }

    /// The factors of R in what `meet` gives: minors are linear in the column of offsets, and it holds all the R.
    Reach meet_reach(const std::array<std::uint32_t, D>& through) const {
        std::array<std::array<Integer, D + 1>, D> rows;
        RowsView<D, D + 1, Integer> view{};
        for (std::size_t i = 0; i < D; ++i) {
            rows[i] = planes.exact(through[i]);
            rows[i][D] = Integer(planes.reach(through[i]));
            view.row[i] = &rows[i];
        }
        const auto v = minors<WideInteger>(view);
        Reach b;
        for (std::size_t i = 0; i < D; ++i) b[i] = Integer(v[D].sign() == Sign::minus ? -v[i] : v[i]);
        return b;
    }

    /// The plane through D points, plus side by the order of the points (outward-ordered points face outward); nullopt
    /// where they do not span a plane.
    std::optional<PlaneId> join(std::span<const PointId, D> through) {
        std::array<Exact, D> points;
        for (std::size_t i = 0; i < D; ++i) points[i] = coordinates(through[i]);
        return join(points);
    }

    /// The same for homogeneous coordinates; a weight of zero is a direction.
    std::optional<PlaneId> join(const std::array<Exact, D>& points) {
        RowsView<D, D + 1, Integer> rows{};
        for (std::size_t i = 0; i < D; ++i) rows.row[i] = &points[i];
        const auto v = minors<WideInteger>(rows);
        typename PlaneTable<D>::Coefficients c;
        bool flat = true;
        constexpr bool negate = (D + 1) % 2 != 0;
        for (std::size_t i = 0; i <= D; ++i) {
            c[i] = Integer(v[i]);
            if constexpr (negate) c[i].negate();
            if (i < D && !c[i].is_zero()) flat = false;
        }
        if (flat) return std::nullopt;
        return planes.intern(std::move(c));
    }

    /// A copy of the exact coordinates of p; not kept for points whose approximation is exact.
    Exact coordinates(PointId p) {
        const Record& r = points_[p];
        return r.is_of_doubles() ? homogeneous_of<D>(r.approximation) : exact(p);
    }

private:
    static constexpr double unit = 0x1p-53;

    PointId push(const Record& r) {
        points_.push_back(r);
        return static_cast<PointId>(points_.size() - 1);
    }

    std::uint32_t store(Exact x) {
        exact_.push_back(std::move(x));
        return static_cast<std::uint32_t>(exact_.size() - 1);
    }

    static double tight_error(const Record& r) {
        double largest = 0;
        for (double x : r.approximation) largest = std::max(largest, std::abs(x));
        return largest * unit * (1 + 0x1p-50) + 0x1p-1074;
    }

    /// The correctly rounded approximation of a meet without its exact coordinates. Returns: whether that worked.
    bool round_meet(PointId p) {
        if constexpr (D == 3 && !filtering::always_fails) {
            Record& r = points_[p];
            if (r.kind != Record::Kind::meet || r.exact != no_id || is_infinite(p)) return false;
            if (const auto x =
                    grid_meet({&planes.exact(r.planes[0]), &planes.exact(r.planes[1]), &planes.exact(r.planes[2])})) {
                place_at(r, *x);
                return true;
            }
            std::array<DoubleDoublePlane, 3> rows;
            for (std::size_t n = 0; n < 3; ++n) {
                const auto& head = planes.approximation(r.planes[n]);
                if (!(head[0] == head[0])) return false;
                const auto& tail = planes.tail(r.planes[n]);
                for (std::size_t i = 0; i < 4; ++i) rows[n][i] = {head[i], tail[i]};
            }
            const std::optional<std::array<double, 3>> x = rounded_meet(rows);
            if (!x) return false;
            r.approximation = *x;
            r.rounded = true;
            r.error = tight_error(r);
            return true;
        } else {
            return false;
        }
    }

    void approximate(Record& r) const {
        const Exact& e = exact_[r.exact];
        bool finite = true;
        for (std::size_t i = 0; i < D; ++i) {
            r.approximation[i] = ratio_to_double(e[i], e[D]);
            finite = finite && std::isfinite(r.approximation[i]);
        }
        r.rounded = true;
        r.error = finite ? tight_error(r) : std::numeric_limits<double>::infinity();
    }

    /// Evaluates the filter. Returns whether the sign is certain; `value` and `bound` describe the scaled distance.
    ///
    /// Each coefficient and product carries a relative error of at most u = 2^-53, the D additions likewise, so the
    /// sum of |n_i x_i| + |c| times (1+u)^(D+3) - 1 < (D+4) u bounds the rounding; the point's error e contributes at
    /// most e * sum |n_i|. Products that underflow lose at most 2^-1074 each. NaN and infinity fail every comparison.
    bool distance(std::uint32_t k, const Record& r, double& value, double& bound) const {
        const auto& n = planes.approximation(k);
        double s = n[D];
        double magnitude = std::abs(n[D]);
        double norm = 0;
        for (std::size_t i = 0; i < D; ++i) {
            const double t = n[i] * r.approximation[i];
            s += t;
            magnitude += std::abs(t);
            norm += std::abs(n[i]);
        }
        value = s;
        bound = magnitude * (double(D + 6) * unit) + r.error * norm * (1 + 0x1p-40) + 0x1p-1060;
        return !filtering::always_fails && (s > bound || -s > bound);
    }

    Sign side_of_canonical(std::uint32_t k, PointId p) {
        ++counts_.sides;
        const Record& r = points_[p];
        for (const std::uint32_t through : r.planes)
            if (through == k) {
                ++counts_.by_identity;
                return Sign::zero;
            }
        if (r.is_of_doubles() && planes.axis(k) >= 0) {
            const double at = planes.axis_position(k);
            const double x = r.approximation[std::size_t(planes.axis(k))];
            if (at == at) return x < at ? Sign::minus : (x > at ? Sign::plus : Sign::zero);
        }
        double value = 0;
        double bound = 0;
        if (distance(k, r, value, bound)) return value > 0 ? Sign::plus : Sign::minus;
        return side_exact(k, p);
    }

    Sign side_exact(std::uint32_t k, PointId p) {
        ++counts_.filter_failures;
        if (!points_[p].rounded) {
            refine(p);
            double value = 0;
            double bound = 0;
            if (distance(k, points_[p], value, bound)) return value > 0 ? Sign::plus : Sign::minus;
        }
        ++counts_.exact_tests;
        if (planes.has_frame()) {
            if (const Sign s = side_at_infinity(k, p); s != Sign::zero) return s;
        }
        const auto& n = planes.exact(k);
        const Record& r = points_[p];
        WideInteger sum;
        if (r.is_of_doubles()) {
            const Exact e = homogeneous_of<D>(r.approximation);
            for (std::size_t i = 0; i <= D; ++i) add_product(sum, n[i], e[i]);
        } else {
            const Exact& e = exact(p);
            for (std::size_t i = 0; i <= D; ++i) add_product(sum, n[i], e[i]);
        }
        return sum.sign();
    }

    /// The sign of the factor of R in n . x + c w.
    Sign side_at_infinity(std::uint32_t k, PointId p) {
        const int c = planes.reach(k);
        const Reach* b = reach(p);
        if (b == nullptr) return sign_of_value(c);  // weights are positive
        WideInteger sum;
        for (std::size_t i = 0; i < D; ++i) add_product(sum, planes.exact(k)[i], (*b)[i]);
        if (c != 0) add_product(sum, Integer(c), exact(p)[D]);
        return sum.sign();
    }

    /// The order of the factors of R in coordinate i of p and q, both with exact coordinates.
    Sign compare_reach(std::size_t i, PointId p, PointId q) {
        if (!planes.has_frame()) return Sign::zero;
        const Reach* a = reach(p);
        const Reach* b = reach(q);
        WideInteger difference;
        if (a != nullptr) add_product(difference, (*a)[i], exact_[points_[q].exact][D]);
        if (b != nullptr) sub_product(difference, (*b)[i], exact_[points_[p].exact][D]);
        return difference.sign();
    }

    /// Notes that a meet of D axis-parallel planes at doubles is a point of doubles. Returns whether it is one.
    bool place_on_axes(Record& r) const {
        std::array<double, D> x{};
        for (const std::uint32_t k : r.planes) {
            const int axis = planes.axis(k);
            if (axis < 0) return false;
            x[std::size_t(axis)] = planes.axis_position(k);
            if (!(x[std::size_t(axis)] == x[std::size_t(axis)])) return false;
        }
        place_at(r, x);
        return true;
    }

    /// Notes that a meet is a point of doubles.
    static void place_at(Record& r, const std::array<double, D>& x) {
        r.approximation = x;
        r.error = 0;
        r.rounded = true;
    }

    /// Approximates the crossing of h with the segment ab by X = A + T (B - A), T = |DA| / (|DA| + |DB|).
    ///
    /// With |da|, |db| off by at most d, T is off by at most d / (|da| + |db| - 2d); rounding adds 3u to it. X moves by
    /// |b - a| times that, by at most the larger endpoint error, and by the rounding of three operations.
    void interpolate(std::uint32_t k, const Record& a, const Record& b, Record& r) const {
        double da = 0;
        double db = 0;
        double ea = 0;
        double eb = 0;
        const bool a_certain = distance(k, a, da, ea);
        const bool b_certain = distance(k, b, db, eb);
        const double gap = std::abs(da) + std::abs(db);
        const double slack = 2 * (ea > eb ? ea : eb);
        if (!a_certain || !b_certain || !(gap > 2 * slack)) {
            r.error = std::numeric_limits<double>::infinity();
            r.approximation = a.approximation;
            return;
        }
        const double t = std::abs(da) / gap;
        const double off = slack / (gap - slack) + 8 * unit;
        double error = 0;
        for (std::size_t i = 0; i < D; ++i) {
            const double d = b.approximation[i] - a.approximation[i];
            r.approximation[i] = a.approximation[i] + t * d;
            const double e =
                std::abs(d) * off + (std::abs(a.approximation[i]) + std::abs(b.approximation[i])) * 0x1p-52;
            error = e > error ? e : error;
        }
        error += a.error > b.error ? a.error : b.error;
        r.error = error * (1 + 0x1p-40) + 0x1p-1060;
        if (!(r.error < 0x1p1000)) r.error = std::numeric_limits<double>::infinity();
    }

    std::vector<Record> points_;
    std::vector<Exact> exact_;
    std::unordered_map<std::uint32_t, Reach> reaches_;  // by the index of the exact coordinates
    KernelCounts counts_;
};

CLEAVE_END_NAMESPACE

#endif

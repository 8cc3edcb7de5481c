// SPDX-License-Identifier: Apache-2.0
/// A table of interned planes: primitive integer coefficients, a double approximation for filters, and residues.
#ifndef CLEAVE_GEOMETRY_PLANE_TABLE_HPP
#define CLEAVE_GEOMETRY_PLANE_TABLE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/handles.hpp>
#include <cleave/geometry/plane_relation.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/modular.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Interned planes in dimension D. A plane is stored once, as the primitive integer vector (n, c) whose first non-zero
/// normal entry is positive; the orientation is a bit of the id. Equal sets have equal ids, so "coplanar" is a
/// comparison of integers.
template <int D>
class PlaneTable {
public:
    /// n_1, ..., n_D, c.
    using Coefficients = std::array<Integer, D + 1>;
    /// The same, divided by a power of two so that the largest |n_i| lies in [1/2, 1]. Each entry is correctly rounded.
    using Approximation = std::array<double, D + 1>;
    using Residues = std::array<Mod61, D + 1>;

    [[nodiscard]] std::size_t size() const noexcept { return exact_.size(); }

    /// The canonical coefficients of the unoriented plane k.
    [[nodiscard]] const Coefficients& exact(std::uint32_t k) const { return *exact_[k]; }
    /// Entries are NaN where the approximation would not obey the filter's error model (far out of double's range).
    [[nodiscard]] const Approximation& approximation(std::uint32_t k) const { return approximations_[k]; }
    /// What the approximation leaves out of each coefficient, within 2^-106 of the coefficient. Computed when first
    /// asked for. Requires: the approximation is not NaN.
    const Approximation& tail(std::uint32_t k) {
        if (k >= tails_.size()) tails_.resize(size(), unknown());
        Approximation& t = tails_[k];
        if (!(t[0] == t[0])) t = find_tail(exact(k), approximation(k));
        return t;
    }

    /// Residues of the canonical coefficients modulo 2^61-1.
    [[nodiscard]] const Residues& residues(std::uint32_t k) const { return residues_[k]; }
    /// The axis that the plane is perpendicular to, or -1.
    [[nodiscard]] int axis(std::uint32_t k) const { return axes_[k]; }
    /// For an axis-parallel plane whose position is exactly a double: that position; NaN otherwise.
    [[nodiscard]] double axis_position(std::uint32_t k) const { return positions_[k]; }

    /// Interns the plane with these coefficients, given up to a non-zero factor; a negative factor reverses it.
    /// Requires: some normal entry is non-zero. Returns: the oriented id. Cost: D + 1 gcds and a hash look-up.
    PlaneId intern(Coefficients coefficients) {
        std::uint32_t orientation = 0;
        make_primitive(coefficients, orientation);
        return 2 * intern_canonical(std::move(coefficients)) + orientation;
    }

    /// The same for coefficients that are primitive, the first of the normal's that is not zero being positive.
    /// Returns: the unoriented number.
    std::uint32_t intern_primitive(Coefficients&& coefficients) { return intern_canonical(std::move(coefficients)); }

    /// Interns plane k of another table. Cost: a hash look-up, and a copy where it is new.
    std::uint32_t intern_from(const PlaneTable& other, std::uint32_t k) {
        if (const int r = other.reach(k); r != 0) return frame(other.axis_of_frame(k), r < 0);
        return intern_shared(other, k);
    }

    /// The plane x_axis = R (`upper`) or x_axis = -R of the infimaximal frame, unoriented; R is a symbol larger than
    /// every number. Its `exact` coefficients are those of x_axis = 0, and `reach` tells the rest. It is no ordinary
    /// plane: nothing else is ever interned as it. Made when first asked for.
    std::uint32_t frame(int axis, bool upper) {
        const std::size_t which = 2 * std::size_t(axis) + (upper ? 1 : 0);
        if (frame_[which] != no_id) return frame_[which];
        const auto k = static_cast<std::uint32_t>(exact_.size());
        Coefficients c{};
        c[std::size_t(axis)] = Integer(1);
        Approximation a{};
        a[std::size_t(axis)] = 1;
        a[D] = std::nan("");  // so that every filter fails
        Residues r;
        r[std::size_t(axis)] = Mod61(1);
        r[D] = upper ? Mod61(0) - reach_residue() : reach_residue();
        exact_.push_back(std::make_shared<const Coefficients>(std::move(c)));
        approximations_.push_back(a);
        residues_.push_back(r);
        hashes_.push_back(hash(r));
        axes_.push_back(-1);
        positions_.push_back(std::nan(""));
        reaches_.resize(std::size_t(k) + 1, 0);
        reaches_[k] = upper ? -1 : 1;
        return frame_[which] = k;
    }

    /// The factor of R in the offset of plane k: -1 for x_axis = R, 1 for x_axis = -R, 0 for an ordinary plane.
    [[nodiscard]] int reach(std::uint32_t k) const noexcept { return k < reaches_.size() ? reaches_[k] : 0; }
    /// Whether some plane of the frame is in the table; if not, every point is finite.
    [[nodiscard]] bool has_frame() const noexcept { return !reaches_.empty(); }

    /// What stands for R modulo 2^61-1, so that residues of points and planes at infinity are consistent like others:
    /// an arbitrary fixed number, because equal residues are always confirmed exactly.
    [[nodiscard]] static constexpr Mod61 reach_residue() noexcept { return Mod61(0x123456789abcdefULL); }

    /// Interns the axis-parallel plane x_axis = position, facing the positive direction.
    PlaneId intern_axis_plane(int axis, double position) {
        const DoubleParts parts = decompose(position);
        Coefficients c{};
        const bool fraction = parts.exponent < 0;
        c[std::size_t(axis)] = Integer::scaled(1, fraction ? unsigned(-parts.exponent) : 0U);
        c[D] = -Integer::scaled(parts.mantissa, fraction ? 0U : unsigned(parts.exponent));
        return intern(std::move(c));
    }

    /// How two oriented planes lie with respect to each other.
    [[nodiscard]] PlaneRelation relation(PlaneId h, PlaneId g) const {
        if (h == g) return PlaneRelation::same;
        if (unoriented(h) == unoriented(g)) return PlaneRelation::opposite;
        const Coefficients& a = exact(unoriented(h));
        const Coefficients& b = exact(unoriented(g));
        std::size_t pivot = 0;
        while (a[pivot].is_zero()) ++pivot;
        for (std::size_t i = 0; i < D; ++i)
            if (!(WideInteger(a[i]) * WideInteger(b[pivot]) == WideInteger(b[i]) * WideInteger(a[pivot])))
                return PlaneRelation::crossing;
        // Canonical planes have a positive first normal entry, so parallel ones are co-oriented as stored.
        return is_flipped(h) == is_flipped(g) ? PlaneRelation::parallel : PlaneRelation::antiparallel;
    }

    void reserve(std::size_t n) {
        exact_.reserve(n);
        approximations_.reserve(n);
        residues_.reserve(n);
        hashes_.reserve(n);
        axes_.reserve(n);
        positions_.reserve(n);
        if (2 * n > slots_.size()) rehash(2 * n);
    }

    /// The largest bit length among normal entries and among offsets.
    [[nodiscard]] std::pair<std::size_t, std::size_t> bits() const {
        std::size_t normal = 0;
        std::size_t offset = 0;
        for (const auto& shared : exact_) {
            const Coefficients& c = *shared;
            for (int i = 0; i < D; ++i) normal = std::max<std::size_t>(normal, c[std::size_t(i)].bit_length());
            offset = std::max<std::size_t>(offset, c[D].bit_length());
        }
        return {normal, offset};
    }

private:
    [[nodiscard]] int axis_of_frame(std::uint32_t k) const {
        int axis = 0;
        while (exact(k)[std::size_t(axis)].is_zero()) ++axis;
        return axis;
    }

    static constexpr std::array<std::uint32_t, 2 * D> no_frame() {
        std::array<std::uint32_t, 2 * D> a{};
        a.fill(no_id);
        return a;
    }

    static void make_primitive(Coefficients& c, std::uint32_t& orientation) {
        int first = 0;
        while (first < D && c[std::size_t(first)].is_zero()) ++first;
        CLEAVE_REQUIRES(first < D);
        Integer divisor;
        for (const Integer& x : c) {
            if (x.is_zero()) continue;
            divisor = divisor.is_zero() ? abs(x) : gcd(divisor, x);
            if (divisor == Integer(1)) break;
        }
        if (!(divisor == Integer(1)))
            for (Integer& x : c)
                if (!x.is_zero()) x = exact_divide(x, divisor);
        if (c[std::size_t(first)].sign() == Sign::minus) {
            orientation = 1;
            for (Integer& x : c) x = -x;
        }
    }

    static std::uint64_t hash(const Residues& r) {
        std::uint64_t h = 0x9e3779b97f4a7c15ULL;
        for (const Mod61& x : r) {
            h ^= x.value() + 0x9e3779b97f4a7c15ULL + (h << 6U) + (h >> 2U);
            h *= 0xff51afd7ed558ccdULL;
            h ^= h >> 32U;
        }
        return h;
    }

    std::uint32_t intern_canonical(Coefficients&& c) {
        Residues residues;
        for (std::size_t i = 0; i <= D; ++i) residues[i] = Mod61(c[i].modulo_61());
        const std::uint64_t h = hash(residues);
        const std::size_t at = find_slot(h, [&](std::uint32_t k) { return exact(k) == c; });
        if (slots_[at] != no_id) return slots_[at];
        approximations_.push_back(approximate(c));
        axes_.push_back(find_axis(c));
        positions_.push_back(axes_.back() < 0 ? std::nan("") : exact_position(c, axes_.back()));
        return append(at, h, residues, std::make_shared<const Coefficients>(std::move(c)));
    }

    /// Coefficients are shared with the other table: a plane is in memory once, however many results it goes through.
    std::uint32_t intern_shared(const PlaneTable& other, std::uint32_t index) {
        const std::shared_ptr<const Coefficients>& c = other.exact_[index];
        const std::uint64_t h = other.hashes_[index];
        const std::size_t at = find_slot(h, [&](std::uint32_t k) { return exact_[k] == c || exact(k) == *c; });
        if (slots_[at] != no_id) return slots_[at];
        approximations_.push_back(other.approximations_[index]);
        axes_.push_back(other.axes_[index]);
        positions_.push_back(other.positions_[index]);
        return append(at, h, other.residues_[index], c);
    }

    /// The slot of the plane with that hash for which `is_it` holds, or the empty slot where it belongs.
    template <class IsIt>
    std::size_t find_slot(std::uint64_t h, IsIt&& is_it) {
        if (2 * (exact_.size() + 1) > slots_.size()) rehash(std::max<std::size_t>(64, 4 * exact_.size()));
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = std::size_t(h) & mask;
        while (slots_[at] != no_id && !(hashes_[slots_[at]] == h && is_it(slots_[at]))) at = (at + 1) & mask;
        return at;
    }

    std::uint32_t append(std::size_t slot, std::uint64_t h, const Residues& residues,
                         std::shared_ptr<const Coefficients> c) {
        const auto k = static_cast<std::uint32_t>(exact_.size());
        slots_[slot] = k;
        hashes_.push_back(h);
        residues_.push_back(residues);
        exact_.push_back(std::move(c));
        return k;
    }

    static Approximation unknown() {
        Approximation a;
        a.fill(std::nan(""));
        return a;
    }

    /// The power of two by which approximations are smaller.
    static std::size_t scale(const Coefficients& c) {
        std::size_t top = 0;
        for (std::size_t i = 0; i < D; ++i) top = std::max<std::size_t>(top, c[i].bit_length());
        return top;
    }

    static Approximation find_tail(const Coefficients& c, const Approximation& a) {
        const std::size_t top = scale(c);
        Approximation tail{};
        for (std::size_t i = 0; i <= D; ++i) {
            if (c[i].bit_length() <= 53) continue;  // a double
            const DoubleParts head = decompose(a[i]);
            const auto shift = static_cast<std::size_t>(std::int64_t(head.exponent) + std::int64_t(top));
            tail[i] = to_double(Integer(c[i] - Integer::scaled(head.mantissa, shift)), -std::int64_t(top));
        }
        return tail;
    }

    static Approximation approximate(const Coefficients& c) {
        const std::size_t top = scale(c);
        Approximation a;
        bool fits = true;
        for (std::size_t i = 0; i <= D; ++i) {
            a[i] = to_double(c[i], -std::int64_t(top));
            // The filter's model is a relative error of 2^-53 per coefficient: no subnormals, no infinities.
            if (!c[i].is_zero() && !(std::abs(a[i]) >= 0x1p-900 && std::abs(a[i]) <= 0x1p900)) fits = false;
        }
        return fits ? a : unknown();
    }

    static int find_axis(const Coefficients& c) {
        int axis = -1;
        for (int i = 0; i < D; ++i) {
            if (c[std::size_t(i)].is_zero()) continue;
            if (axis >= 0) return -1;
            axis = i;
        }
        return axis;
    }

    static double exact_position(const Coefficients& c, int axis) {
        const Integer& n = c[std::size_t(axis)];
        // Primitive and exactly a double only if the coefficient is a power of two.
        if (n.trailing_zeros() + 1 != n.bit_length()) return std::nan("");
        const double x = to_double(-c[D], -std::int64_t(n.bit_length() - 1));
        if (!std::isfinite(x) || (!c[D].is_zero() && std::abs(x) < 0x1p-1000)) return std::nan("");
        return c[D].bit_length() - std::size_t(c[D].is_zero() ? 0 : c[D].trailing_zeros()) <= 53 ? x : std::nan("");
    }

    void rehash(std::size_t wanted) {
        std::size_t n = 64;
        while (n < wanted) n *= 2;
        slots_.assign(n, no_id);
        for (std::size_t k = 0; k < hashes_.size(); ++k) {
            std::size_t at = std::size_t(hashes_[k]) & (n - 1);
            if (reach(static_cast<std::uint32_t>(k)) != 0) continue;
            while (slots_[at] != no_id) at = (at + 1) & (n - 1);
            slots_[at] = static_cast<std::uint32_t>(k);
        }
    }

    std::vector<std::shared_ptr<const Coefficients>> exact_;
    std::vector<Approximation> approximations_;
    std::vector<Approximation> tails_;  // shorter than the table where nothing asked
    std::vector<Residues> residues_;
    std::vector<std::uint64_t> hashes_;
    std::vector<int> axes_;
    std::vector<double> positions_;
    std::vector<std::int8_t> reaches_;  // shorter than the table where it ends in ordinary planes
    std::array<std::uint32_t, 2 * D> frame_ = no_frame();
    std::vector<std::uint32_t> slots_;
};

CLEAVE_END_NAMESPACE

#endif

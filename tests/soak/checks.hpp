// SPDX-License-Identifier: Apache-2.0
/// One evaluation, and everything that is known about its result without looking at it.
#ifndef CLEAVE_TESTS_SOAK_CHECKS_HPP
#define CLEAVE_TESTS_SOAK_CHECKS_HPP

#include "soak/draw.hpp"
#include "support/region_checker.hpp"
#include "support/tree_set.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace soak {

/// How much has been compared.
struct Counts {
    std::size_t evaluations = 0;
    std::size_t localised = 0;  ///< by the localised engine itself, which found everything to fit together
    std::size_t tree_merges = 0;
    std::size_t verified = 0;
    std::size_t measured = 0;  ///< identities of measures
    std::size_t probes = 0;    ///< points that an operand and a result were asked about

    Counts& operator+=(const Counts& c) {
        evaluations += c.evaluations;
        localised += c.localised;
        tree_merges += c.tree_merges;
        verified += c.verified;
        measured += c.measured;
        probes += c.probes;
        return *this;
    }
};

/// Two ways to one set led to two sets, or a result breaks a promise.
class Disagreement : public std::runtime_error {
public:
    Disagreement(const std::string& what, std::string evidence)
        : std::runtime_error(what), evidence_(std::move(evidence)) {}

    /// The function and the operands.
    [[nodiscard]] const std::string& evidence() const noexcept { return evidence_; }

private:
    std::string evidence_;
};

/// Evaluates functions and throws `Disagreement`.
class Checker {
public:
    explicit Checker(Dice& dice) : dice_(&dice) {}

    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

    /// The function's value. Cheap comparisons are made each time, dear ones now and then and of small operands.
    template <int D>
    Region<D> evaluate(const BooleanFunction& function, std::vector<Region<D>> operands) {
        if constexpr (D == 3) {
            if (!one_in(*dice_, 6))
                for (Region<3>& r : operands)
                    if (!one_in(*dice_, 20)) r = as_mesh(r);
        }
        try {
            return compared<D>(function, operands);
        } catch (const std::exception& e) {
            throw Disagreement(e.what(), describe<D>(function, operands));
        }
    }

    /// The four operations, and what they say about each other's measure.
    template <int D>
    void four_operations(const Region<D>& a, const Region<D>& b) {
        std::vector<Region<D>> r;
        for (const Operation o : cleave::all_operations) r.push_back(evaluate<D>(BooleanFunction::from(o, 2), {a, b}));
        if (!are_measurable<D>({a, b})) return;
        const auto size = [](const Region<D>& x) { return cleave::measure(x).value(); };
        const Rational of_a = size(a);
        const Rational of_b = size(b);
        const Rational common = size(r[at(Operation::intersection)]);
        require_measure(size(r[at(Operation::union_)]), of_a + of_b - common, "of a union");
        require_measure(size(r[at(Operation::difference)]), of_a - common, "of a difference");
        require_measure(size(r[at(Operation::symmetric_difference)]), of_a + of_b - 2 * common,
                        "of a symmetric difference");
    }

    /// Where at least one, two, ... of the operands are, whose measures are those of the operands together; parity; and
    /// any functions, some beside their complements.
    template <int D>
    void many(const std::vector<Region<D>>& operands) {
        const auto k = unsigned(operands.size());
        const BooleanFunction any = BooleanFunction::union_(k);
        const bool measurable = are_measurable<D>(operands);
        Rational sum(0);
        Rational whole(0);
        for (const Region<D>& r : operands) sum += measurable ? cleave::measure(r).value() : Rational(0);
        for (unsigned m = 1; m <= k; ++m) {
            if (!measurable && one_in(*dice_, 2)) continue;
            const Region<D> r = evaluate<D>(BooleanFunction::at_least(m, k), operands);
            if (!measurable) continue;
            const Rational size = cleave::measure(r).value();
            if (m == 1) whole = size;
            sum -= size;
        }
        if (measurable) require_measure(sum, Rational(0), "of many operands counted together");
        evaluate<D>(BooleanFunction::symmetric_difference(k), operands);
        evaluate<D>(BooleanFunction::difference(k), operands);
        for (int n = 0; n < 2; ++n) {
            const BooleanFunction f = draw_function(*dice_, k);
            if (!measurable || one_in(*dice_, 2)) {
                evaluate<D>(f, operands);
                continue;
            }
            const Region<D> inside = evaluate<D>(f & any, operands);
            const Region<D> outside = evaluate<D>(any - f, operands);
            require_measure(cleave::measure(inside).value() + cleave::measure(outside).value(), whole,
                            "of a function and its complement");
        }
    }

private:
    static constexpr std::size_t most_measured = 200;  // faces of all operands; of rotated ones sums grow long
    static constexpr std::size_t most_merged = 40;
    static constexpr std::size_t most_probed = 400;
    static constexpr std::size_t most_verified = 80;

    static std::size_t at(Operation o) {
        const auto& all = cleave::all_operations;
        return std::size_t(std::find(all.begin(), all.end(), o) - all.begin());
    }

    static void require(bool condition, const std::string& what) {
        if (!condition) throw support::Defect(what);
    }

    template <int D>
    static std::size_t faces_of(const std::vector<Region<D>>& operands) {
        std::size_t faces = 0;
        for (const Region<D>& r : operands) faces += r.face_count();
        return faces;
    }

    template <int D>
    static bool are_measurable(const std::vector<Region<D>>& operands) {
        return faces_of<D>(operands) <= most_measured &&
               std::all_of(operands.begin(), operands.end(), [](const Region<D>& r) { return r.is_bounded(); });
    }

    void require_measure(const Rational& found, const Rational& wanted, const std::string& what) {
        ++counts_.measured;
        if (found != wanted)
            throw Disagreement("the measure " + what,
                               cleave::to_text(found) + " instead of " + cleave::to_text(wanted));
    }

    /// The same set as a mesh of triangles gives it, whose faces have no planes where its points are doubles.
    static Region<3> as_mesh(const Region<3>& r) {
        if (r.surface().is_conforming || !r.has_bounded_boundary() || r.face_count() == 0) return r;
        const bool turned = !r.is_bounded();
        const cleave::RationalMesh exact = cleave::to_rational_mesh(turned ? ~r : r);
        cleave::Mesh doubles;
        doubles.corners = exact.corners;
        doubles.first = exact.first;
        for (const Coordinates<3>& p : exact.points) {
            std::array<double, 3> q{};
            for (std::size_t i = 0; i < 3; ++i) {
                q[i] = cleave::to_double(p[i]);
                if (!std::isfinite(q[i]) || cleave::number_traits<Rational>::from_double(q[i]) != p[i]) {
                    const Region<3> given = cleave::to_region<Rational>(exact);
                    return turned ? ~given : given;
                }
            }
            doubles.points.push_back(q);
        }
        const Region<3> given = cleave::to_region(doubles);
        return turned ? ~given : given;
    }

    template <int D>
    Region<D> compared(const BooleanFunction& function, const std::vector<Region<D>>& operands) {
        ++counts_.evaluations;
        const std::string form = canonical(by<D>(cleave::Engine::boundary_filter, function, operands));
        const Region<D> result = by<D>(cleave::Engine::localised, function, operands);
        require(canonical(result) == form, "the localised engine and boundary filtering");
        repeat<D>(function, operands, result);
        const std::size_t faces = faces_of<D>(operands);
        if (one_in(*dice_, 10) && faces <= most_merged) {
            ++counts_.tree_merges;
            require(canonical(by<D>(cleave::Engine::tree_merge, function, operands)) == form,
                    "tree merging and boundary filtering");
        }
        // The checker knows points, not directions: a boundary must be bounded.
        if (one_in(*dice_, 3) && result.face_count() <= most_verified && result.has_bounded_boundary()) {
            ++counts_.verified;
            support::verified(result);
        }
        if (one_in(*dice_, 3) && faces <= most_probed) probe<D>(function, operands, result);
        return result;
    }

    template <int D>
    static Region<D> by(cleave::Engine engine, const BooleanFunction& function,
                        const std::vector<Region<D>>& operands) {
        return cleave::evaluate<D, Rational>(engine, function, operands);
    }

    /// A second evaluation gives the same bytes. In space it is made without what the first might have fallen back to.
    template <int D>
    void repeat(const BooleanFunction& function, const std::vector<Region<D>>& operands, const Region<D>& result) {
        if constexpr (D == 3) {
            if (std::all_of(operands.begin(), operands.end(),
                            [](const Region<3>& r) { return r.has_bounded_boundary(); })) {
                std::deque<cleave::Boundary<3>> conforming;
                std::vector<const cleave::Boundary<3>*> boundaries;
                for (const Region<3>& r : operands)
                    boundaries.push_back(r.surface().is_conforming
                                             ? &r.surface()
                                             : &conforming.emplace_back(cleave::make_conforming(r.boundary())));
                const cleave::OperationOptions options;
                cleave::SurfaceEvaluation evaluation(boundaries, function, options);
                require(evaluation.is_sound(), "the localised engine with itself");
                const Region<3> again(evaluation.finish());
                require(support::dump(again.surface()) == support::dump(result.surface()),
                        "the localised engine and its repetition");
                require_balanced(result.surface());
                ++counts_.localised;
                return;
            }
        }
        if (!one_in(*dice_, 4)) return;
        const Region<D> again = by<D>(cleave::Engine::localised, function, operands);
        require(support::dump(again.boundary()) == support::dump(result.boundary()),
                "an evaluation and its repetition");
    }

    /// Edges match from end to end: each as often this way as the other.
    static void require_balanced(const cleave::Boundary<3>& b) {
        require(b.is_conforming, "a result's edges and what it says about them");
        std::map<std::pair<cleave::PointId, cleave::PointId>, int> balance;
        for (std::size_t l = 0; l + 1 < b.faces.loop_first.size(); ++l) {
            const std::span<const cleave::Corner> loop = b.faces.loop(l);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const cleave::PointId p = loop[i].point;
                const cleave::PointId q = loop[i + 1 == loop.size() ? 0 : i + 1].point;
                balance[std::minmax(p, q)] += p < q ? 1 : -1;
            }
        }
        for (const auto& [ends, b_of_edge] : balance) require(b_of_edge == 0, "an edge and its opposite");
    }

    /// Points near vertices and between them, in the operands and in the result as trees know them.
    template <int D>
    void probe(const BooleanFunction& function, const std::vector<Region<D>>& operands, const Region<D>& result) {
        std::vector<Coordinates<D>> base;
        const auto take = [&](const Region<D>& r, int count) {
            const std::vector<Coordinates<D>> corners = cleave::vertices(r);
            for (; count > 0 && !corners.empty(); --count) base.push_back(pick(*dice_, corners));
        };
        for (const Region<D>& r : operands) take(r, 6);
        take(result, 8);
        if (base.empty()) return;
        std::vector<Coordinates<D>> points;
        for (Coordinates<D> p : base) {
            const Rational step = support::rational(1, one_in(*dice_, 2) ? 1009 : 1000003);
            const Rational size = one_in(*dice_, 4) ? Rational(step * power_of_two(-60)) : step;
            for (Rational& x : p) x += size * dice_->between(-97, 97);
            points.push_back(p);
        }
        for (int n = 0; n < 12; ++n) {
            std::vector<Coordinates<D>> some;
            for (int k = dice_->between(2, 4); k > 0; --k) some.push_back(pick(*dice_, base));
            Coordinates<D> p = centroid_of<D>(some);
            for (Rational& x : p) x += support::rational(dice_->between(-97, 97), 1009);
            points.push_back(p);
        }
        std::deque<support::TreeSet<D>> sets;
        for (const Region<D>& r : operands) sets.emplace_back(r);
        support::TreeSet<D> of_result(result);
        for (const Coordinates<D>& p : points) {
            BooleanFunction::Bits bits = 0;
            bool on_boundary = false;
            for (std::size_t i = 0; i < sets.size(); ++i) {
                const cleave::Location where = sets[i].at(p);
                on_boundary = on_boundary || where == cleave::Location::boundary;
                if (where == cleave::Location::inside) bits |= BooleanFunction::Bits(1) << i;
            }
            if (on_boundary) continue;
            ++counts_.probes;
            require(of_result.at(p) == (function(bits) ? cleave::Location::inside : cleave::Location::outside),
                    "a point of the operands and of the result");
        }
    }

    template <int D>
    static std::string describe(const BooleanFunction& function, const std::vector<Region<D>>& operands) {
        std::string text = "the function, for operands 0, 1, ... as the bits of a number that counts up: ";
        const std::size_t rows = std::size_t(1) << std::min(operands.size(), std::size_t(8));
        for (std::size_t bits = 0; bits < rows; ++bits) text += function(bits) ? '1' : '0';
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const cleave::Boundary<D>& b = operands[i].surface();
            text += "\noperand " + std::to_string(i) + ": " + std::to_string(b.faces.faces.size()) + " faces" +
                    (b.is_complete ? "" : ", without planes") + (b.is_conforming ? ", conforming\n" : "\n") +
                    canonical(operands[i]);
        }
        return text;
    }

    Dice* dice_;
    Counts counts_;
};

}  // namespace soak

#endif

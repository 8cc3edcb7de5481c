// SPDX-License-Identifier: Apache-2.0
// Expressions of three to five operands, evaluated at once and folded from binary operations.
#include <cleave/setop/apply.hpp>

#include "support/region_generators.hpp"

#include <bit>
#include <type_traits>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

template <int D>
using Dimension = std::integral_constant<int, D>;

template <int D>
std::size_t cases(std::size_t n) {
    return D == 1 ? 4 * n : (D == 2 ? 2 * n : n);
}

/// Where at least m of the operands are: the union of the intersections of all choices of m.
template <int D>
Region<D> at_least(unsigned m, const std::vector<Region<D>>& operands) {
    Region<D> sum = Region<D>::empty();
    for (unsigned choice = 0; choice < (1U << operands.size()); ++choice) {
        if (unsigned(std::popcount(choice)) != m) continue;
        Region<D> common = Region<D>::full();
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (((choice >> i) & 1U) != 0) common = common & operands[i];
        sum = sum | common;
    }
    return sum;
}

/// A random expression, as a function of bits and as a region made by binary operations.
template <int D>
struct FoldedExpression {
    BooleanFunction function;
    Region<D> region;
};

template <int D>
FoldedExpression<D> random_expression(const std::vector<Region<D>>& operands, int steps) {
    const auto arity = unsigned(operands.size());
    const auto leaf = [&] {
        const auto i = unsigned(draw_index(arity));
        return FoldedExpression<D>{BooleanFunction::operand(i, arity), operands[i]};
    };
    FoldedExpression<D> e = leaf();
    for (int s = 0; s < steps; ++s) {
        const FoldedExpression<D> other = leaf();
        switch (draw_int(0, 5)) {
            case 0:
                e = {e.function | other.function, e.region | other.region};
                break;
            case 1:
                e = {e.function & other.function, e.region & other.region};
                break;
            case 2:
                e = {e.function - other.function, e.region - other.region};
                break;
            case 3:
                e = {e.function ^ other.function, e.region ^ other.region};
                break;
            default:
                e = {~e.function, ~e.region};
                break;
        }
    }
    return e;
}

template <int D>
std::vector<Region<D>> regions(const std::vector<Solid<D>>& solids) {
    std::vector<Region<D>> result;
    for (const Solid<D>& s : solids) result.push_back(s.region());
    return result;
}

}  // namespace

TEMPLATE_TEST_CASE("expressions: counts and parity of many operands", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    law("at least m of k", cases<D>(10), [] {
        const std::size_t k = 3 + draw_index(3);
        const auto a = regions(draw_vector<Solid<D>>(k));
        for (unsigned m = 1; m <= k; ++m)
            RC_ASSERT(equal_sets(checked_evaluate<D, Rational>(BooleanFunction::at_least(m, unsigned(k)), a),
                                 at_least(m, a)));
    });
    law("parity and difference", cases<D>(20), [] {
        const std::size_t k = 3 + draw_index(3);
        const auto a = regions(draw_vector<Solid<D>>(k));
        Region<D> odd = a[0];
        Region<D> left = a[0];
        for (std::size_t i = 1; i < k; ++i) {
            odd = odd ^ a[i];
            left = left - a[i];
        }
        RC_ASSERT(
            equal_sets(checked_evaluate<D, Rational>(BooleanFunction::symmetric_difference(unsigned(k)), a), odd));
        RC_ASSERT(equal_sets(checked_evaluate<D, Rational>(BooleanFunction::difference(unsigned(k)), a), left));
    });
}

TEMPLATE_TEST_CASE("expressions: any formula", "", Dimension<1>, Dimension<2>, Dimension<3>) {
    constexpr int D = TestType::value;
    law("at once and step by step", cases<D>(30), [] {
        const std::size_t k = 3 + draw_index(3);
        const auto a = regions(draw_vector<Solid<D>>(k));
        const FoldedExpression<D> e = random_expression(a, draw_int(1, 8));
        RC_ASSERT(equal_sets(checked_evaluate<D, Rational>(e.function, a), e.region));
    });
    law("atoms add up to the union", cases<D>(10), [] {
        const auto solids = draw_vector<BoundedSolid<D>>(3);
        const auto a = regions(std::vector<Solid<D>>(solids.begin(), solids.end()));
        Rational sum(0);
        std::array<Rational, 3> parts{Rational(0), Rational(0), Rational(0)};
        for (unsigned atom = 1; atom < 8; ++atom) {
            BooleanFunction f = BooleanFunction::constant(true, 3);
            for (unsigned i = 0; i < 3; ++i) {
                const BooleanFunction bit = BooleanFunction::operand(i, 3);
                f = f & (((atom >> i) & 1U) != 0 ? bit : ~bit);
            }
            const Rational size = ExactRegion<D>(checked_evaluate<D, Rational>(f, a)).measure();
            sum += size;
            for (unsigned i = 0; i < 3; ++i)
                if (((atom >> i) & 1U) != 0) parts[i] += size;
        }
        RC_ASSERT(sum == ExactRegion<D>(checked_evaluate<D, Rational>(BooleanFunction::union_(3), a)).measure());
        for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(parts[i] == ExactRegion<D>(a[i]).measure());
    });
}

TEST_CASE("expressions: as many operands as a word has bits") {
    // Overlapping intervals [i, i + 3): three of them cover every point but those of the first two and last two units.
    std::vector<Region<1>> a;
    for (int i = 0; i < 64; ++i) a.push_back(box<1>({i}, {i + 3}));
    const auto size = [&](const BooleanFunction& f) {
        return ExactRegion<1>(checked_evaluate<1, Rational>(f, a)).measure();
    };
    CHECK(size(BooleanFunction::union_(64)) == 66);
    CHECK(size(BooleanFunction::at_least(2, 64)) == 64);
    CHECK(size(BooleanFunction::at_least(3, 64)) == 62);
    CHECK(size(BooleanFunction::at_least(4, 64)) == 0);
    CHECK(size(BooleanFunction::symmetric_difference(64)) == 64);
    CHECK(size(BooleanFunction::difference(64)) == 1);
}

// SPDX-License-Identifier: Apache-2.0
// What random points, planes and maps are made of, for every dimension and number: drawn as integers, here alone.
#include "support/geometry_generators.hpp"

#include "support/generators.hpp"

#include <cleave/geometry/cross_point.hpp>

#include <rapidcheck.h>

#include <algorithm>
#include <array>

namespace generators {

namespace {

using Integers = std::vector<int>;

/// -limit, ..., limit, and zero more often than the others. Not so far from zero in early cases, where points then
/// often coincide, but never zero alone: points would all be the same.
rc::Gen<int> around_zero(int limit) {
    return [limit](const rc::Random& random, int size) {
        const std::uint64_t word = rc::Random(random).next();
        const int most = std::clamp((limit * size + rc::kNominalSize / 2) / rc::kNominalSize, 1, limit);
        const auto range = static_cast<std::uint64_t>(2 * most + 1);
        const int drawn = word % 4 == 0 ? 0 : static_cast<int>(word / 4 % range) - most;
        return rc::shrinkable::shrinkRecur(drawn, [](int x) { return rc::shrink::towards<int>(x, 0); });
    };
}

/// The same numbers in every case: where all zeros are no answer, small ones are none either.
rc::Gen<Integers> small_entries(std::size_t count) {
    return rc::gen::map(rc::gen::container<Integers>(count, rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 5))),
                        [](Integers x) {
                            constexpr std::array<int, 5> values{0, 1, -1, 2, -2};  // simplest first
                            for (int& entry : x) entry = values[static_cast<std::size_t>(entry)];
                            return x;
                        });
}

rc::Gen<Integers> points(std::size_t count, std::size_t dimension) {
    const auto numerators = rc::gen::container<Integers>(count * dimension, around_zero(4));
    const auto weights = rc::gen::container<Integers>(count, rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 8)));
    return rc::gen::map(rc::gen::pair(numerators, weights), [=](const std::pair<Integers, Integers>& drawn) {
        Integers x;
        for (std::size_t i = 0; i < count; ++i) {
            const auto first = drawn.first.begin() + static_cast<std::ptrdiff_t>(i * dimension);
            x.insert(x.end(), first, first + static_cast<std::ptrdiff_t>(dimension));
            x.push_back(std::max(1, drawn.second[i] - 4));  // six ones, a two and a three
        }
        return x;
    });
}

}  // namespace

std::vector<int> draw_points(std::size_t count, std::size_t dimension) {
    return *points(count, dimension);
}

std::vector<int> draw_segment() {
    return *rc::gen::suchThat(points(2, 2), [](const Integers& x) {
        return point<2, cleave::Integer>(x, 0) != point<2, cleave::Integer>(x, 1);
    });
}

std::vector<int> draw_triangle() {
    return *rc::gen::suchThat(points(3, 3), [](const Integers& x) {
        std::array<cleave::Point<3, cleave::Integer>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = point<3, cleave::Integer>(x, i);
        return cleave::join(corners).has_value();
    });
}

std::vector<int> draw_plane(std::size_t dimension) {
    return *rc::gen::suchThat(small_entries(dimension + 1), [](const Integers& c) {
        return std::any_of(c.begin(), c.end() - 1, [](int x) { return x != 0; });
    });
}

std::vector<int> draw_map(std::size_t dimension) {
    Integers map = *small_entries(dimension * (dimension + 1));
    map.push_back(support::draw_int(1, 4));
    return map;
}

void show_homogeneous(std::ostream& out, std::span<const cleave::Fraction> numbers) {
    const char* between = "(";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i + 1 == numbers.size()) between = " : ";
        out << between << numbers[i].num.to_string();
        if (!numbers[i].den.is_one()) out << "/" << numbers[i].den.to_string();
        between = ", ";
    }
    out << ")";
}

}  // namespace generators

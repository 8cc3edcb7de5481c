// SPDX-License-Identifier: Apache-2.0
// rapidcheck's machinery, for all tests: what it draws here, it draws nowhere else.
#include "support/property.hpp"

#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace support {

namespace {

/// The value nearest to zero in [first, past).
int simplest(int first, int past) {
    return first <= 0 && 0 < past ? 0 : first;
}

/// rapidcheck's own inRange takes only a part of the range, near its lower end, while sizes are small, and shrinks
/// towards that end.
rc::Gen<int> uniform(int first, int past) {
    return [first, past](const rc::Random& random, int) {
        if (past <= first) throw rc::GenerationFailure("an empty range of integers");
        const auto range = static_cast<std::uint64_t>(std::int64_t(past) - first);
        const auto drawn = std::int64_t(rc::Random(random).next() % range) + first;
        return rc::shrinkable::shrinkRecur(static_cast<int>(drawn), [first, past](int x) {
            return rc::shrink::towards<int>(x, simplest(first, past));
        });
    };
}

/// As many of `bits` bits as the size, a percentage, says.
int bits_at(int size, int bits) {
    return std::min(bits, (size * bits + rc::kNominalSize / 2) / rc::kNominalSize);
}

std::uint64_t low_bits(std::uint64_t word, int bits) {
    return bits == 64 ? word : word & ((std::uint64_t(1) << bits) - 1);
}

}  // namespace

void check_property(const std::string& description, std::size_t cases, const std::function<void()>& body) {
    SECTION(description) {
        rc::detail::TestParams parameters = rc::detail::configuration().testParams;
        parameters.maxSuccess = static_cast<int>(cases);
        const auto result =
            rc::detail::checkTestable(body, rc::detail::TestMetadata{description, description}, parameters);
        std::ostringstream report;
        rc::detail::printResultMessage(result, report);
        INFO(report.str());
        CHECK(result.is<rc::detail::SuccessResult>());
    }
}

std::size_t cases_of_property() {
    return static_cast<std::size_t>(std::max(1, rc::detail::configuration().testParams.maxSuccess));
}

std::size_t cases_of_law(std::size_t cases) {
    const auto usual = static_cast<std::size_t>(rc::detail::TestParams().maxSuccess);
    const std::size_t wanted = cases_of_property();
    return wanted == usual ? scaled(cases) : std::max<std::size_t>(1, cases * wanted / usual);
}

int draw_int(int first, int past) {
    return *uniform(first, past);
}

std::vector<int> draw_ints(std::size_t count, int first, int past) {
    return *rc::gen::container<std::vector<int>>(count, uniform(first, past));
}

std::vector<int> draw_crowded_ints(std::size_t count, int first, int past) {
    return *rc::gen::container<std::vector<int>>(count,
                                                 rc::gen::oneOf(uniform(first, past), rc::gen::inRange(first, past)));
}

std::size_t draw_index(std::size_t count) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, count));
}

std::size_t draw_choice(std::initializer_list<int> weights) {
    const std::vector<int> list(weights);
    const rc::Gen<std::size_t> choice = [list](const rc::Random& random, int) {
        const auto sum = static_cast<std::uint64_t>(std::accumulate(list.begin(), list.end(), 0));
        auto left = static_cast<int>(rc::Random(random).next() % sum);
        std::size_t chosen = 0;
        while (left >= list[chosen]) left -= list[chosen++];
        return rc::shrinkable::shrinkRecur(chosen,
                                           [](std::size_t x) { return rc::shrink::towards<std::size_t>(x, 0); });
    };
    return *choice;
}

bool draw_bool() {
    return *rc::gen::arbitrary<bool>();
}

std::vector<bool> draw_bools(std::size_t count) {
    const std::vector<int> drawn = draw_ints(count, 0, 2);
    return {drawn.begin(), drawn.end()};
}

std::uint64_t draw_word(int bits) {
    const rc::Gen<std::uint64_t> word = [bits](const rc::Random& random, int size) {
        return rc::shrinkable::shrinkRecur(low_bits(rc::Random(random).next(), bits_at(size, bits)),
                                           &rc::shrink::integral<std::uint64_t>);
    };
    return *word;
}

std::int64_t draw_signed(int bits) {
    const rc::Gen<std::int64_t> number = [bits](const rc::Random& random, int size) {
        const int n = bits_at(size, bits);
        const std::uint64_t word = low_bits(rc::Random(random).next(), n);
        const bool negative = n > 0 && (word >> (n - 1) & 1) != 0;
        const std::uint64_t extended = negative ? word | ~low_bits(~std::uint64_t(0), n) : word;
        return rc::shrinkable::shrinkRecur(static_cast<std::int64_t>(extended), &rc::shrink::integral<std::int64_t>);
    };
    return *number;
}

std::vector<bool> draw_membership() {
    // The length first: it shrinks to the last member that matters. Then the members before it.
    const std::size_t length = *rc::gen::inRange<std::size_t>(0, 101);
    const rc::Gen<std::vector<std::size_t>> members = [length](const rc::Random&, int) {
        std::vector<std::size_t> all(length);
        std::iota(all.begin(), all.end(), std::size_t(0));
        return rc::shrinkable::shrinkRecur(
            all, [](const std::vector<std::size_t>& some) { return rc::shrink::removeChunks(some); });
    };
    std::vector<bool> belongs(length, false);
    for (const std::size_t i : *members) belongs[i] = true;
    return belongs;
}

bool property_detail::is_counterexample() {
    try {
        throw;
    } catch (const rc::detail::CaseResult& result) {
        return result.type == rc::detail::CaseResult::Type::Failure;
    } catch (const rc::GenerationFailure&) {
        return false;
    } catch (...) {
        return true;
    }
}

std::ostream& property_detail::counterexample_log() {
    return rc::detail::log();
}

}  // namespace support

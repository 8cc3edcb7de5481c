// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/large_vector.hpp>
//
#include "support/catch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

using namespace cleave;

namespace {

struct alignas(64) Aligned {
    std::array<char, 64> bytes{};
};

bool is_aligned(const void* p, std::size_t to) {
    return reinterpret_cast<std::uintptr_t>(p) % to == 0;
}

}  // namespace

TEST_CASE("large vector: keeps its values through every size, from a few bytes to many megabytes") {
    LargeVector<std::uint32_t> v;
    std::uint64_t sum = 0;
    for (const std::size_t size : {1U, 100U, 1U << 19U, (1U << 20U) - 1, 1U << 20U, (1U << 20U) + 1, 5U << 20U}) {
        for (std::size_t n = v.size(); n < size; ++n) {
            v.push_back(static_cast<std::uint32_t>(n));
            sum += n;
        }
        CHECK(std::accumulate(v.begin(), v.end(), std::uint64_t(0)) == sum);
        const LargeVector<std::uint32_t> copy = v;
        CHECK(copy == v);
    }
    LargeVector<std::uint32_t> moved = std::move(v);
    CHECK(moved.size() == 5U << 20U);
    moved.resize(10);
    moved.shrink_to_fit();
    CHECK(moved == LargeVector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("large vector: memory is aligned, and too much of it is refused") {
    for (const std::size_t size : {1U, 1000U, 1U << 16U, 1U << 17U}) {
        const LargeVector<Aligned> v(size);
        CHECK(is_aligned(v.data(), alignof(Aligned)));
    }
    LargeAllocator<Aligned> allocator;
    CHECK_THROWS_AS(allocator.allocate(std::numeric_limits<std::size_t>::max() / 8), std::bad_array_new_length);
    CHECK(allocator == LargeAllocator<int>());
}

// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs_buffer.hpp>

#include "support/catch.hpp"

#include <utility>

using namespace cleave;

namespace {

/// A buffer of n limbs 1, 2, 3, ...
template <unsigned K>
LimbBuffer<K> counting(std::size_t n, bool negative = false) {
    LimbBuffer<K> r(n);
    for (std::size_t i = 0; i < n; ++i) r.data()[i] = i + 1;
    r.set_size(n, negative);
    return r;
}

template <unsigned K>
bool counts_to(const LimbBuffer<K>& x, std::size_t n, bool negative = false) {
    if (x.count() != n || (n != 0 && x.view().negative() != negative)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (x.data()[i] != i + 1) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("limbs_buffer: the heap is used from one limb beyond the inline size on") {
    CHECK_FALSE(counting<4>(4).on_heap());
    CHECK(counting<4>(5).on_heap());
    CHECK(LimbBuffer<4>().capacity() == 4);
    CHECK(LimbBuffer<4>(100).capacity() == 100);
    CHECK(sizeof(LimbBuffer<6>) == 56);
}

TEST_CASE("limbs_buffer: copies and moves between inline and heap in every combination") {
    for (const std::size_t from : {0U, 1U, 4U, 5U, 9U}) {
        for (const std::size_t to : {0U, 1U, 4U, 5U, 9U}) {
            const auto source = counting<4>(from, true);
            auto target = counting<4>(to);
            target = source;
            CHECK(counts_to(target, from, true));
            CHECK(counts_to(source, from, true));
            auto moved_to = counting<4>(to);
            auto moved_from = source;
            moved_to = std::move(moved_from);
            CHECK(counts_to(moved_to, from, true));
            CHECK(counts_to(moved_from, 0));
            moved_from = counting<4>(7);  // a moved-from buffer is usable
            CHECK(counts_to(moved_from, 7));
            const LimbBuffer<4> constructed(std::move(moved_to));
            CHECK(counts_to(constructed, from, true));
            CHECK(counts_to(moved_to, 0));
        }
    }
}

TEST_CASE("limbs_buffer: assigning a buffer to itself changes nothing") {
    for (const std::size_t n : {0U, 3U, 9U}) {
        auto x = counting<4>(n, true);
        auto& alias = x;
        x = alias;
        CHECK(counts_to(x, n, true));
        x = std::move(alias);
        CHECK(counts_to(x, n, true));
    }
}

TEST_CASE("limbs_buffer: growing keeps what it is told to keep") {
    auto x = counting<4>(4);
    x.reserve(50, 4);
    CHECK(x.on_heap());
    CHECK(x.capacity() >= 50);
    CHECK(counts_to(x, 4));
    x.reserve(10, 4);  // never shrinks
    CHECK(x.capacity() >= 50);
}

TEST_CASE("limbs_buffer: views, signs and sizes") {
    auto x = counting<4>(3);
    CHECK(x.view().size == 3);
    CHECK(x.view().negated().size == -3);
    CHECK(x.view().negated().count() == 3);
    CHECK(x.view().negated().absolute().size == 3);
    x.flip_sign();
    CHECK(x.signed_size() == -3);
    x.data()[2] = 0;
    x.data()[1] = 0;
    x.set_size_normalised(3, true);
    CHECK(x.signed_size() == -1);
    x.set_signed_size(2);
    CHECK(x.count() == 2);
    x.clear();
    CHECK(x.count() == 0);
}

TEST_CASE("limbs_buffer: a size that no memory holds is an error, not a wrap-around") {
    CHECK_THROWS_AS(LimbBuffer<4>(std::size_t(1) << 40), NumberError);
}

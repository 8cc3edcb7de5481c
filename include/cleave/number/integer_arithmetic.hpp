// SPDX-License-Identifier: Apache-2.0
/// Signed arithmetic between limb buffers: the machinery under `BasicInteger`'s operators.
///
/// Operands are views, so one instantiation per result size serves every combination of inline sizes. Every function
/// allows its result to be one of its operands.
#ifndef CLEAVE_NUMBER_INTEGER_ARITHMETIC_HPP
#define CLEAVE_NUMBER_INTEGER_ARITHMETIC_HPP

#include <cleave/number/limbs_buffer.hpp>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <memory>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

namespace arithmetic {

/// Limbs for a product of any two stack-sized operands; longer products go by the heap.
inline constexpr std::size_t scratch_limbs = 64;

[[nodiscard]] inline bool equal(LimbView a, LimbView b) noexcept {
    return a.size == b.size && limbs::compare(a.limbs, b.limbs, a.count()) == 0;
}

[[nodiscard]] inline std::strong_ordering compare(LimbView a, LimbView b) noexcept {
    if (a.size != b.size) return a.size <=> b.size;
    const int magnitudes = limbs::compare(a.limbs, b.limbs, a.count());
    return (a.negative() ? -magnitudes : magnitudes) <=> 0;
}

/// out = (|a| + |b|) with the sign `negative`. Requires: |a| has at least as many limbs as |b|.
template <unsigned R>
void assign_magnitude_sum(LimbBuffer<R>& out, LimbView a, LimbView b, bool negative) {
    const std::size_t n = a.count();
    if (out.capacity() < n) {  // then `out` is not a, and growing it in place could lose b
        LimbBuffer<R> fresh(n + 1);
        assign_magnitude_sum(fresh, a, b, negative);
        out = std::move(fresh);
        return;
    }
    const Limb carry = limbs::add(out.data(), a.limbs, n, b.limbs, b.count());
    if (carry == 0) {
        out.set_size(n, negative);
    } else {
        out.reserve(n + 1, n);
        out.data()[n] = carry;
        out.set_size(n + 1, negative);
    }
}

/// out = (|a| - |b|) with the sign `negative`. Requires: |a| >= |b|.
template <unsigned R>
void assign_magnitude_difference(LimbBuffer<R>& out, LimbView a, LimbView b, bool negative) {
    const std::size_t n = a.count();
    if (out.capacity() < n) {
        LimbBuffer<R> fresh(n);
        assign_magnitude_difference(fresh, a, b, negative);
        out = std::move(fresh);
        return;
    }
    static_cast<void>(limbs::subtract(out.data(), a.limbs, n, b.limbs, b.count()));
    out.set_size_normalised(n, negative);
}

/// out = a + b.
template <unsigned R>
void assign_sum(LimbBuffer<R>& out, LimbView a, LimbView b) {
    const std::size_t n = a.count();
    const std::size_t m = b.count();
    if (a.negative() == b.negative()) {
        if (n >= m)
            assign_magnitude_sum(out, a, b, a.negative());
        else
            assign_magnitude_sum(out, b, a, a.negative());
    } else if (limbs::compare(a.limbs, n, b.limbs, m) >= 0) {
        assign_magnitude_difference(out, a, b, a.negative());
    } else {
        assign_magnitude_difference(out, b, a, b.negative());
    }
}

/// out = a * b where `out` holds neither operand and is n + m limbs long. Requires: neither is zero.
inline std::size_t multiply_into(Limb* out, LimbView a, LimbView b) noexcept {
    const std::size_t n = a.count();
    const std::size_t m = b.count();
    // The inner loop runs over the longer operand.
    if (n >= m)
        limbs::multiply(out, a.limbs, n, b.limbs, m);
    else
        limbs::multiply(out, b.limbs, m, a.limbs, n);
    return n + m - (out[n + m - 1] == 0 ? 1 : 0);
}

/// The product of two numbers in scratch memory: on the stack up to a size that covers every predicate.
class ScratchProduct {
public:
    ScratchProduct(LimbView a, LimbView b) {
        if (a.size == 0 || b.size == 0) return;
        const std::size_t length = a.count() + b.count();
        Limb* out = stack_;
        if (length > scratch_limbs) {
            heap_.reset(new Limb[length]);
            out = heap_.get();
        }
        const auto size = static_cast<std::int32_t>(multiply_into(out, a, b));
        view_ = {out, a.negative() == b.negative() ? size : -size};
    }
    ScratchProduct(const ScratchProduct&) = delete;
    ScratchProduct& operator=(const ScratchProduct&) = delete;

    [[nodiscard]] LimbView view() const noexcept { return view_; }

private:
    LimbView view_;
    std::unique_ptr<Limb[]> heap_;
    Limb stack_[scratch_limbs];  // written only as far as the product reaches
};

/// out = a * b.
template <unsigned R>
void assign_product(LimbBuffer<R>& out, LimbView a, LimbView b) {
    if (a.size == 0 || b.size == 0) {
        out.clear();
        return;
    }
    const std::size_t length = a.count() + b.count();
    const bool negative = a.negative() != b.negative();
    const bool aliased = out.data() == a.limbs || out.data() == b.limbs;
    if (!aliased && length <= out.capacity()) {
        out.set_size(multiply_into(out.data(), a, b), negative);
    } else if (length <= scratch_limbs) {
        // Also the way for a product whose top limb may turn out to be zero, so that it needs no heap after all.
        out.assign(ScratchProduct(a, b).view());
    } else {
        LimbBuffer<R> fresh(length);
        fresh.set_size(multiply_into(fresh.data(), a, b), negative);
        out = std::move(fresh);
    }
}

/// out = a * 2^shift.
template <unsigned R>
void assign_shifted_left(LimbBuffer<R>& out, LimbView a, std::size_t shift) {
    const std::size_t n = a.count();
    if (n == 0) {
        out.clear();
        return;
    }
    const std::size_t whole = shift / limbs::bits;
    const unsigned part = static_cast<unsigned>(shift % limbs::bits);
    const bool extra = part != 0 && (a.limbs[n - 1] >> (limbs::bits - part)) != 0;
    const std::size_t size = n + whole + (extra ? 1 : 0);
    if (size > out.capacity()) {
        LimbBuffer<R> fresh(size);
        assign_shifted_left(fresh, a, shift);
        out = std::move(fresh);
        return;
    }
    Limb* to = out.data();
    if (part != 0) {
        const Limb carried = limbs::shift_left(to + whole, a.limbs, n, part);
        if (extra) to[n + whole] = carried;
    } else {
        for (std::size_t i = n; i-- != 0;) to[i + whole] = a.limbs[i];
    }
    std::fill(to, to + whole, Limb(0));
    out.set_size(size, a.negative());
}

/// out = floor(a / 2^shift) over n limbs, leading zeros included. Requires: shift < 64 n. `out` may be a.
inline void shift_out(Limb* out, const Limb* a, std::size_t n, std::size_t shift) noexcept {
    const std::size_t whole = shift / limbs::bits;
    const unsigned part = static_cast<unsigned>(shift % limbs::bits);
    if (part != 0)
        limbs::shift_right(out, a + whole, n - whole, part);
    else
        limbs::copy(out, a + whole, n - whole);
    std::fill(out + (n - whole), out + n, Limb(0));
}

/// out = a / 2^shift truncated toward zero.
template <unsigned R>
void assign_shifted_right(LimbBuffer<R>& out, LimbView a, std::size_t shift) {
    const std::size_t whole = shift / limbs::bits;
    const unsigned part = static_cast<unsigned>(shift % limbs::bits);
    if (a.count() <= whole) {
        out.clear();
        return;
    }
    const std::size_t n = a.count() - whole;
    if (n > out.capacity()) {
        LimbBuffer<R> fresh(n);
        assign_shifted_right(fresh, a, shift);
        out = std::move(fresh);
        return;
    }
    if (part != 0)
        limbs::shift_right(out.data(), a.limbs + whole, n, part);
    else
        limbs::copy(out.data(), a.limbs + whole, n);
    out.set_size_normalised(n, a.negative());
}

}  // namespace arithmetic

CLEAVE_END_NAMESPACE

#endif

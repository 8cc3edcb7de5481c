// SPDX-License-Identifier: Apache-2.0
/// Signed arithmetic between limb buffers: the machinery under `BasicInteger`'s operators.
///
/// Operands are views, so one instantiation per result size serves every combination of inline sizes. Every function
/// allows its result to be one of its operands.
#ifndef CLEAVE_NUMBER_INTEGER_ARITHMETIC_HPP
#define CLEAVE_NUMBER_INTEGER_ARITHMETIC_HPP

#include <cleave/number/limbs_buffer.hpp>
#include <cleave/number/limbs_product.hpp>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
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

/// The magnitude of a number of at most two limbs.
[[nodiscard]] inline UInt128 short_magnitude(LimbView a) noexcept {
    if (a.size == 0) return 0;
    const UInt128 low = a.limbs[0];
    return a.count() == 2 ? low | (UInt128(a.limbs[1]) << limbs::bits) : low;
}

/// out = x + y for magnitudes of 128 bits and their signs.
///
/// Signs of determinants are coin tosses, so neither the signs nor the comparison is a branch: y is complemented where
/// the signs differ, and the sum where it comes out negative.
template <unsigned R>
void assign_short_sum(LimbBuffer<R>& out, UInt128 x, bool x_negative, UInt128 y, bool y_negative) {
    const UInt128 opposite = UInt128(0) - UInt128(x_negative != y_negative ? 1 : 0);
    UInt128 sum = x + ((y ^ opposite) - opposite);
    const Limb carry = opposite == 0 && sum < x ? 1 : 0;
    const UInt128 negative = opposite & (UInt128(0) - UInt128(x < y ? 1 : 0));
    sum = (sum ^ negative) - negative;
    if (R < 3 && carry != 0) out.reserve(3, 0);
    Limb* to = out.data();
    to[0] = static_cast<Limb>(sum);
    to[1] = static_cast<Limb>(sum >> limbs::bits);
    if (R >= 3 || carry != 0) to[2] = carry;
    const std::size_t size = carry != 0 ? 3U : (to[1] != 0 ? 2U : (to[0] != 0 ? 1U : 0U));
    out.set_size(size, x_negative != (negative != 0));
}

/// A magnitude of up to four limbs in registers: the functions are inlined by force, because passed in memory it would
/// be written in halves and read in wholes, which stalls.
struct FourLimbs {
    Limb l0 = 0;
    Limb l1 = 0;
    Limb l2 = 0;
    Limb l3 = 0;

    /// Requires: at most four limbs.
    [[gnu::always_inline]] static FourLimbs load(LimbView a) noexcept {
        FourLimbs r;
        const std::size_t n = a.count();
        if (n >= 1) r.l0 = a.limbs[0];
        if (n >= 2) r.l1 = a.limbs[1];
        if (n >= 3) r.l2 = a.limbs[2];
        if (n >= 4) r.l3 = a.limbs[3];
        return r;
    }

    /// The product of two numbers with at most four limbs together, a the longer. Requires: b is not zero.
    [[gnu::always_inline]] static FourLimbs product(LimbView a, LimbView b) noexcept {
        FourLimbs r;
        const Limb y0 = b.limbs[0];
        UInt128 t = UInt128(a.limbs[0]) * y0;
        r.l0 = static_cast<Limb>(t);
        r.l1 = static_cast<Limb>(t >> limbs::bits);
        if (a.count() >= 2) {
            t = UInt128(a.limbs[1]) * y0 + r.l1;
            r.l1 = static_cast<Limb>(t);
            r.l2 = static_cast<Limb>(t >> limbs::bits);
            if (b.count() == 2) {
                const Limb y1 = b.limbs[1];
                t = UInt128(a.limbs[0]) * y1 + r.l1;
                r.l1 = static_cast<Limb>(t);
                t = UInt128(a.limbs[1]) * y1 + r.l2 + static_cast<Limb>(t >> limbs::bits);
                r.l2 = static_cast<Limb>(t);
                r.l3 = static_cast<Limb>(t >> limbs::bits);
            } else if (a.count() == 3) {
                t = UInt128(a.limbs[2]) * y0 + r.l2;
                r.l2 = static_cast<Limb>(t);
                r.l3 = static_cast<Limb>(t >> limbs::bits);
            }
        }
        return r;
    }
};

/// out = x + y likewise. Requires: R >= 5.
template <unsigned R>
[[gnu::always_inline]] inline void assign_medium_sum(LimbBuffer<R>& out, FourLimbs x, bool x_negative, FourLimbs y,
                                                     bool y_negative) {
    static_assert(R >= 5);
    const Limb opposite = x_negative != y_negative ? ~Limb(0) : 0;
    // Complements first: an xor between two additions with carry would make compilers save the carry.
    y.l0 ^= opposite;
    y.l1 ^= opposite;
    y.l2 ^= opposite;
    y.l3 ^= opposite;
    auto carry = static_cast<unsigned char>(opposite & 1);
    Limb s0 = limbs::add_carry(x.l0, y.l0, carry);
    Limb s1 = limbs::add_carry(x.l1, y.l1, carry);
    Limb s2 = limbs::add_carry(x.l2, y.l2, carry);
    Limb s3 = limbs::add_carry(x.l3, y.l3, carry);
    // x + 2^256 - y without a carry out: negative.
    const Limb negative = opposite & (Limb(carry) - 1);
    s0 ^= negative;
    s1 ^= negative;
    s2 ^= negative;
    s3 ^= negative;
    unsigned char borrow = 0;
    s0 = limbs::subtract_borrow(s0, negative, borrow);
    s1 = limbs::subtract_borrow(s1, negative, borrow);
    s2 = limbs::subtract_borrow(s2, negative, borrow);
    s3 = limbs::subtract_borrow(s3, negative, borrow);
    const Limb s4 = Limb(carry) & ~opposite;
    Limb* to = out.data();
    to[0] = s0;
    to[1] = s1;
    to[2] = s2;
    to[3] = s3;
    to[4] = s4;
    const std::size_t size = s4 != 0 ? 5U : (s3 != 0 ? 4U : (s2 != 0 ? 3U : (s1 != 0 ? 2U : (s0 != 0 ? 1U : 0U))));
    out.set_size(size, x_negative != (negative != 0));
}

/// out = a + b, where `out` has one limb more than the longer of both and may be a or b. Returns: the signed size.
/// Requires: neither is zero. Branchless in the signs, as above.
inline std::int32_t add_into(Limb* out, LimbView a, LimbView b) noexcept {
    // The larger magnitude first; usually its size or its top limb tells, and the choice compiles to conditional moves.
    const bool less = a.count() != b.count() ? a.count() < b.count() : limbs::compare(a.limbs, b.limbs, a.count()) < 0;
    const LimbView x = less ? b : a;
    const LimbView y = less ? a : b;
    const std::size_t n = x.count();
    const std::size_t m = y.count();
    const Limb opposite = a.negative() != b.negative() ? ~Limb(0) : 0;
    auto carry = static_cast<unsigned char>(opposite & 1);
    std::size_t i = 0;
    for (; i + 4 <= m; i += 4) {  // four at a time keep the carry in the processor's flag
        const Limb s0 = limbs::add_carry(x.limbs[i], y.limbs[i] ^ opposite, carry);
        const Limb s1 = limbs::add_carry(x.limbs[i + 1], y.limbs[i + 1] ^ opposite, carry);
        const Limb s2 = limbs::add_carry(x.limbs[i + 2], y.limbs[i + 2] ^ opposite, carry);
        const Limb s3 = limbs::add_carry(x.limbs[i + 3], y.limbs[i + 3] ^ opposite, carry);
        out[i] = s0;
        out[i + 1] = s1;
        out[i + 2] = s2;
        out[i + 3] = s3;
    }
    for (; i < m; ++i) out[i] = limbs::add_carry(x.limbs[i], y.limbs[i] ^ opposite, carry);
    for (; i < n; ++i) out[i] = limbs::add_carry(x.limbs[i], opposite, carry);
    out[n] = Limb(carry) & ~opposite;
    const auto size = static_cast<std::int32_t>(limbs::normalised_size(out, n + 1));
    return x.negative() ? -size : size;
}

/// out = a + b where the register form does not apply.
template <unsigned R>
[[gnu::noinline]] void assign_long_sum(LimbBuffer<R>& out, LimbView a, LimbView b) {
    if (a.size == 0 || b.size == 0) {
        out.assign(a.size == 0 ? b : a);
        return;
    }
    if constexpr (R >= 5) {
        if (a.count() <= 4 && b.count() <= 4) {
            assign_medium_sum(out, FourLimbs::load(a), a.negative(), FourLimbs::load(b), b.negative());
            return;
        }
    }
    const std::size_t length = std::max(a.count(), b.count()) + 1;
    if (length <= out.capacity()) {
        out.set_signed_size(add_into(out.data(), a, b));
    } else if (length <= scratch_limbs) {
        // The sum may fit although a carry would not.
        Limb sum[scratch_limbs];
        const std::int32_t size = add_into(sum, a, b);
        out.assign({sum, size});
    } else {
        LimbBuffer<R> fresh(length);
        fresh.set_signed_size(add_into(fresh.data(), a, b));
        out = std::move(fresh);
    }
}

/// out = a + b.
template <unsigned R>
void assign_sum(LimbBuffer<R>& out, LimbView a, LimbView b) {
    if (a.count() <= 2 && b.count() <= 2)
        assign_short_sum(out, short_magnitude(a), a.negative(), short_magnitude(b), b.negative());
    else
        assign_long_sum(out, a, b);
}

/// out = a * b where `out` holds neither operand and is n + m limbs long. Returns: the signed size.
inline std::int32_t multiply_into(Limb* out, LimbView a, LimbView b) noexcept {
    if (a.size == 0 || b.size == 0) return 0;
    const bool negative = a.negative() != b.negative();
    if (a.count() < b.count()) std::swap(a, b);
    const std::size_t n = a.count();
    const std::size_t m = b.count();
    limbs::multiply(out, a.limbs, n, b.limbs, m);
    const auto size = static_cast<std::int32_t>(n + m - (out[n + m - 1] == 0 ? 1 : 0));
    return negative ? -size : size;
}

/// out = a * b where the register form does not apply.
template <unsigned R>
[[gnu::noinline]] void assign_long_product(LimbBuffer<R>& out, LimbView a, LimbView b) {
    const std::size_t length = a.count() + b.count();
    const bool aliased = out.data() == a.limbs || out.data() == b.limbs;
    if (!aliased && length <= out.capacity()) {
        out.set_signed_size(multiply_into(out.data(), a, b));
    } else if (length <= scratch_limbs) {
        // Also the way for a product whose top limb may turn out to be zero, so that it needs no heap after all.
        Limb product[scratch_limbs];
        const std::int32_t size = multiply_into(product, a, b);
        out.assign({product, size});
    } else {
        LimbBuffer<R> fresh(length);
        fresh.set_signed_size(multiply_into(fresh.data(), a, b));
        out = std::move(fresh);
    }
}

/// out = a * b.
template <unsigned R>
void assign_product(LimbBuffer<R>& out, LimbView a, LimbView b) {
    const bool negative = a.negative() != b.negative();
    if (a.count() == 1 && b.count() == 1) {
        const UInt128 product = UInt128(a.limbs[0]) * b.limbs[0];
        Limb* to = out.data();
        to[0] = static_cast<Limb>(product);
        to[1] = static_cast<Limb>(product >> limbs::bits);
        out.set_size(to[1] != 0 ? 2 : 1, negative);
    } else if (R >= 4 && a.count() == 2 && b.count() == 2) {
        const Limb x0 = a.limbs[0];
        const Limb x1 = a.limbs[1];
        const Limb y0 = b.limbs[0];
        const Limb y1 = b.limbs[1];
        const UInt128 low = UInt128(x0) * y0;
        const UInt128 cross0 = UInt128(x0) * y1 + static_cast<Limb>(low >> limbs::bits);
        const UInt128 cross1 = UInt128(x1) * y0 + static_cast<Limb>(cross0);
        const UInt128 high =
            UInt128(x1) * y1 + static_cast<Limb>(cross0 >> limbs::bits) + static_cast<Limb>(cross1 >> limbs::bits);
        Limb* to = out.data();
        to[0] = static_cast<Limb>(low);
        to[1] = static_cast<Limb>(cross1);
        to[2] = static_cast<Limb>(high);
        to[3] = static_cast<Limb>(high >> limbs::bits);
        out.set_size(to[3] != 0 ? 4 : 3, negative);
    } else {
        assign_long_product(out, a, b);
    }
}

/// acc += a * b, or acc -= a * b, in scratch memory.
template <unsigned R>
[[gnu::noinline]] void add_long_product(LimbBuffer<R>& acc, LimbView a, LimbView b, bool subtract) {
    const std::size_t length = a.count() + b.count();
    if (length <= scratch_limbs) {
        Limb product[scratch_limbs];
        const std::int32_t size = multiply_into(product, a, b);
        assign_long_sum(acc, acc.view(), {product, subtract ? -size : size});
    } else {
        LimbBuffer<2> product(length);
        const std::int32_t size = multiply_into(product.data(), a, b);
        assign_long_sum(acc, acc.view(), {product.data(), subtract ? -size : size});
    }
}

/// The same in registers. Requires: a and b are not zero and have at most four limbs together, a the longer; acc has at
/// most four.
template <unsigned R>
[[gnu::noinline]] void add_medium_product(LimbBuffer<R>& acc, LimbView a, LimbView b, bool negative) {
    const LimbView sum = acc.view();
    assign_medium_sum(acc, FourLimbs::load(sum), sum.negative(), FourLimbs::product(a, b), negative);
}

/// acc += a * b, or acc -= a * b; `acc` may be an operand.
template <unsigned R>
void add_product(LimbBuffer<R>& acc, LimbView a, LimbView b, bool subtract) {
    const LimbView sum = acc.view();
    if (a.size == 0 || b.size == 0) return;
    const bool negative = (a.negative() != b.negative()) != subtract;
    const std::size_t length = a.count() + b.count();
    if (length == 2 && sum.count() <= 2) {
        assign_short_sum(acc, short_magnitude(sum), sum.negative(), UInt128(a.limbs[0]) * b.limbs[0], negative);
        return;
    }
    if constexpr (R >= 5) {
        if (length <= 4 && sum.count() <= 4) {
            if (a.count() < b.count()) std::swap(a, b);
            add_medium_product(acc, a, b, negative);
            return;
        }
    }
    add_long_product(acc, a, b, subtract);
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

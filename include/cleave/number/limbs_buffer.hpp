// SPDX-License-Identifier: Apache-2.0
/// Storage of a sign and a magnitude: limbs inside the object up to a fixed number, on the heap beyond.
#ifndef CLEAVE_NUMBER_LIMBS_BUFFER_HPP
#define CLEAVE_NUMBER_LIMBS_BUFFER_HPP

#include <cleave/base/contract.hpp>
#include <cleave/base/error.hpp>
#include <cleave/number/limbs.hpp>

#include <cstddef>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// A number somewhere in memory: |size| limbs, top one not zero, and the sign of `size`. Owns nothing.
struct LimbView {
    const Limb* limbs = nullptr;
    std::int32_t size = 0;

    [[nodiscard]] constexpr std::size_t count() const noexcept {
        return static_cast<std::size_t>(size < 0 ? -std::int64_t(size) : std::int64_t(size));
    }
    [[nodiscard]] constexpr bool negative() const noexcept { return size < 0; }
    [[nodiscard]] constexpr LimbView negated() const noexcept { return {limbs, -size}; }
    [[nodiscard]] constexpr LimbView absolute() const noexcept { return {limbs, size < 0 ? -size : size}; }
};

/// Limbs and a sign. Invariant: the top limb of a non-empty buffer is not zero (its owner sees to it).
/// Limbs beyond the size are never read, written or cleared, so a buffer with room for many costs no more than it
/// holds.
template <unsigned InlineLimbs>
class LimbBuffer {
    static_assert(InlineLimbs >= 2, "two limbs inside the object hold any built-in integer and every carry of one");

public:
    LimbBuffer() noexcept : size_(0), capacity_(InlineLimbs), heap_(nullptr) {}

    /// An empty buffer with room for `count` limbs.
    explicit LimbBuffer(std::size_t count) : LimbBuffer() {
        if (count > InlineLimbs) allocate(count);
    }

    LimbBuffer(const LimbBuffer& other) : LimbBuffer() { assign(other.view()); }
    explicit LimbBuffer(LimbView other) : LimbBuffer() { assign(other); }

    /// Leaves `other` zero.
    LimbBuffer(LimbBuffer&& other) noexcept : LimbBuffer() { take(other); }

    LimbBuffer& operator=(const LimbBuffer& other) {
        assign(other.view());
        return *this;
    }

    LimbBuffer& operator=(LimbBuffer&& other) noexcept {
        if (this != &other) {
            if (other.on_heap()) release();
            take(other);
        }
        return *this;
    }

    ~LimbBuffer() { release(); }

    [[nodiscard]] Limb* data() noexcept { return on_heap() ? heap_ : inline_; }
    [[nodiscard]] const Limb* data() const noexcept { return on_heap() ? heap_ : inline_; }
    [[nodiscard]] LimbView view() const noexcept { return {data(), size_}; }
    [[nodiscard]] std::size_t count() const noexcept { return view().count(); }
    [[nodiscard]] std::int32_t signed_size() const noexcept { return size_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
    [[nodiscard]] bool on_heap() const noexcept { return capacity_ > InlineLimbs; }

    /// Says how many limbs hold the number now. Requires: count <= capacity(), the top limb is not zero.
    void set_size(std::size_t count, bool negative) noexcept {
        const auto size = static_cast<std::int32_t>(count);
        size_ = negative ? -size : size;
    }

    /// The same, the sign being that of the size.
    void set_signed_size(std::int32_t size) noexcept { size_ = size; }

    /// Drops leading zero limbs from `count`, then sets the size.
    void set_size_normalised(std::size_t count, bool negative) noexcept {
        set_size(limbs::normalised_size(data(), count), negative);
    }

    /// Copies the number. `other` may be this buffer's own, or a part of it.
    void assign(LimbView other) {
        const std::size_t n = other.count();
        if (n > capacity_) {
            LimbBuffer fresh(n);
            limbs::copy(fresh.heap_, other.limbs, n);
            release();
            take(fresh);
        } else if (Limb* out = data(); out != other.limbs) {
            limbs::copy(out, other.limbs, n);
        }
        size_ = other.size;
    }

    /// Makes room for `count` limbs and keeps the first `kept`.
    void reserve(std::size_t count, std::size_t kept) {
        if (count <= capacity_) return;
        LimbBuffer fresh(count + count / 2);
        limbs::copy(fresh.heap_, data(), kept);
        fresh.size_ = size_;
        release();
        take(fresh);
    }

    /// Becomes zero and keeps its memory.
    void clear() noexcept { size_ = 0; }

    void flip_sign() noexcept { size_ = -size_; }

private:
    void allocate(std::size_t count) {
        if (count > 0x7fff'0000U) throw NumberError("an integer of more than 2^37 bits is beyond this library");
        heap_ = new Limb[count];
        capacity_ = static_cast<std::uint32_t>(count);
    }

    /// Requires: this buffer owns no heap memory, or `other` does not.
    void take(LimbBuffer& other) noexcept {
        size_ = other.size_;
        if (other.on_heap()) {
            heap_ = other.heap_;
            capacity_ = other.capacity_;
            other.capacity_ = InlineLimbs;
        } else {
            limbs::copy(data(), other.inline_, other.count());
        }
        other.size_ = 0;
    }

    void release() noexcept {
        if (on_heap()) free_heap();
    }

    // Out of line: heap memory is the rare case, and g++ 12 warns of freeing the limbs inside wherever it can see both.
    [[gnu::noinline, gnu::cold]] void free_heap() noexcept {
        delete[] heap_;
        capacity_ = InlineLimbs;
    }

    std::int32_t size_;
    std::uint32_t capacity_;
    union {
        Limb inline_[InlineLimbs];
        Limb* heap_;
    };
};

CLEAVE_END_NAMESPACE

#endif

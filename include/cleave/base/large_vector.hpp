// SPDX-License-Identifier: Apache-2.0
/// A vector for lists that may take many megabytes: fresh memory for them comes in large pages where the system has
/// such.
#ifndef CLEAVE_BASE_LARGE_VECTOR_HPP
#define CLEAVE_BASE_LARGE_VECTOR_HPP

#include <cleave/base/config.hpp>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

CLEAVE_BEGIN_NAMESPACE

/// Memory from the heap. On Linux a list of some megabytes asks for pages of 2 MiB. The first use of a page interrupts
/// the program, for about a microsecond besides clearing it; 512 times as often with pages of 4 KiB, which for lists
/// that are filled once and read a few times is much of all the time there is.
template <class T>
class LargeAllocator {
public:
    using value_type = T;

    LargeAllocator() = default;
    template <class U>
    LargeAllocator(const LargeAllocator<U>&) noexcept {}  // NOLINT: allocators convert

    [[nodiscard]] T* allocate(std::size_t n) {
        if (n > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) throw std::bad_array_new_length();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        if (is_large(n)) {
            const std::size_t size = (n * sizeof(T) + page - 1) / page * page;
            void* const memory = std::aligned_alloc(page, size);
            if (memory == nullptr) throw std::bad_alloc();
            static_cast<void>(madvise(memory, size, MADV_HUGEPAGE));  // advice: it works without
            return static_cast<T*>(memory);
        }
#endif
        return std::allocator<T>().allocate(n);
    }

    void deallocate(T* memory, std::size_t n) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        if (is_large(n)) {
            std::free(memory);
            return;
        }
#endif
        std::allocator<T>().deallocate(memory, n);
    }

    template <class U>
    friend bool operator==(const LargeAllocator&, const LargeAllocator<U>&) noexcept {
        return true;
    }

private:
    static constexpr std::size_t page = std::size_t(1) << 21U;

    static bool is_large(std::size_t n) noexcept {
        return n * sizeof(T) >= 2 * page;
    }
};

/// A std::vector in every other respect.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

CLEAVE_END_NAMESPACE

#endif

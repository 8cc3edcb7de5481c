// SPDX-License-Identifier: Apache-2.0
/// A reference to an executor of any type: what options of algorithms hold.
#ifndef CLEAVE_EXECUTION_EXECUTOR_REF_HPP
#define CLEAVE_EXECUTION_EXECUTOR_REF_HPP

#include <cleave/execution/executor.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

CLEAVE_BEGIN_NAMESPACE

/// Refers to an executor, or to none and runs everything on the calling thread. An `Executor` itself; copies refer to
/// the same executor. Cost: an indirect call for each piece; nothing is allocated.
class ExecutorRef {
public:
    /// Runs everything on the calling thread, in the order given.
    ExecutorRef() = default;

    /// Requires: `executor` outlives this object and its copies.
    template <Executor E>
    requires(!std::same_as<E, ExecutorRef>) ExecutorRef(const E& executor)
        : executor_(&executor), calls_(&calls_of<E>) {}  // NOLINT: options are assigned one

    /// A temporary would be gone before its first use.
    template <Executor E>
    requires(!std::same_as<E, ExecutorRef>) ExecutorRef(const E&& executor)
    = delete;

    [[nodiscard]] std::size_t concurrency() const { return calls_ == nullptr ? 1 : calls_->concurrency(executor_); }

    template <class F, class G>
    void invoke(F&& f, G&& g) const {
        if (calls_ == nullptr) {
            SequentialExecutor().invoke(f, g);
            return;
        }
        const Piece first{&f, [](const void* piece, std::size_t) { as<F>(piece)(); }};
        const Piece second{&g, [](const void* piece, std::size_t) { as<G>(piece)(); }};
        calls_->invoke(executor_, first, second);
    }

    template <class F>
    void for_each_index(std::size_t n, F&& f) const {
        if (calls_ == nullptr) {
            SequentialExecutor().for_each_index(n, f);
            return;
        }
        const Piece piece{&f, [](const void* p, std::size_t i) { as<F>(p)(i); }};
        calls_->for_each_index(executor_, n, piece);
    }

private:
    /// A function of any type, by reference.
    struct Piece {
        const void* function;
        void (*call)(const void*, std::size_t);

        void operator()(std::size_t i) const { call(function, i); }
    };

    struct Calls {
        std::size_t (*concurrency)(const void*);
        void (*invoke)(const void*, const Piece&, const Piece&);
        void (*for_each_index)(const void*, std::size_t, const Piece&);
    };

    /// The function that a piece was made of.
    template <class F>
    static std::remove_reference_t<F>& as(const void* piece) {
        return *static_cast<std::remove_reference_t<F>*>(const_cast<void*>(piece));
    }

    template <class E>
    static constexpr Calls calls_of{
        [](const void* e) { return std::size_t(static_cast<const E*>(e)->concurrency()); },
        [](const void* e, const Piece& f, const Piece& g) {
            static_cast<const E*>(e)->invoke([&f] { f(0); }, [&g] { g(0); });
        },
        [](const void* e, std::size_t n, const Piece& f) { static_cast<const E*>(e)->for_each_index(n, f); }};

    const void* executor_ = nullptr;
    const Calls* calls_ = nullptr;
};

CLEAVE_END_NAMESPACE

#endif

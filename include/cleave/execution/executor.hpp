// SPDX-License-Identifier: Apache-2.0
/// Where independent pieces of work run: the `Executor` concept and the executor that uses no second thread.
///
/// | expression               | meaning                                                                               |
/// |--------------------------|---------------------------------------------------------------------------------------|
/// | `e.concurrency()`        | how many pieces may run at once, at least 1                                           |
/// | `e.invoke(f, g)`         | runs `f()` and `g()`, in any order or at once; returns when both have ended           |
/// | `e.for_each_index(n, f)` | runs `f(i)` for each i in [0, n), in any order or at once; returns when all have ended
/// |
///
/// Semantic demands: calls may nest; what a piece throws comes out of the call after every piece that had started has
/// ended (one of them, where several throw). Work must not depend on the order, nor take ids or sums from it: results
/// are the same for every executor.
#ifndef CLEAVE_EXECUTION_EXECUTOR_HPP
#define CLEAVE_EXECUTION_EXECUTOR_HPP

#include <cleave/base/config.hpp>

#include <concepts>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// See the table at the head of this file. `const E&`: an executor is shared by all who were given it.
template <class E>
concept Executor = requires(const E& e, std::size_t n, void (*piece)(), void (*indexed_piece)(std::size_t)) {
    { e.concurrency() } -> std::convertible_to<std::size_t>;
    e.invoke(piece, piece);
    e.for_each_index(n, indexed_piece);
};

/// Runs everything on the calling thread, in the order given.
class SequentialExecutor {
public:
    [[nodiscard]] static constexpr std::size_t concurrency() noexcept { return 1; }

    template <class F, class G>
    void invoke(F&& f, G&& g) const {
        f();
        g();
    }

    template <class F>
    void for_each_index(std::size_t n, F&& f) const {
        for (std::size_t i = 0; i < n; ++i) f(i);
    }
};

CLEAVE_END_NAMESPACE

#endif

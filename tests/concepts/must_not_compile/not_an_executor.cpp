// SPDX-License-Identifier: Apache-2.0
// Something that runs work in pairs, but cannot loop, is no executor.
// refused: for_each_index
#include <cleave/execution/executor.hpp>

struct PairsOnly {
    [[nodiscard]] unsigned concurrency() const { return 1; }
    void invoke(void (*f)(), void (*g)()) const {
        f();
        g();
    }
#ifndef CLEAVE_MUST_NOT_COMPILE
    void for_each_index(std::size_t n, void (*f)(std::size_t)) const {
        for (std::size_t i = 0; i < n; ++i) f(i);
    }
#endif
};

template <cleave::Executor E>
void use(const E&) {}

void use_pairs() {
    use(PairsOnly());
}

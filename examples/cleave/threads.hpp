// SPDX-License-Identifier: Apache-2.0
// The threads that --threads asks for.
#pragma once

#include <cleave/execution/executor_ref.hpp>

#include <cstddef>
#include <memory>

/// oneTBB's threads where the program was built with it, else the standard library's.
class Threads {
public:
    explicit Threads(std::size_t count);
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    [[nodiscard]] cleave::ExecutorRef executor() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

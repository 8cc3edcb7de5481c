// SPDX-License-Identifier: Apache-2.0
/// The pairs of operands, the same on every machine but for the last digits of sin, cos and sqrt.
#ifndef CLEAVE_BENCHMARKS_SIDE_BY_SIDE_CASES_HPP
#define CLEAVE_BENCHMARKS_SIDE_BY_SIDE_CASES_HPP

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine.hpp"

namespace side_by_side {

struct Case {
    std::string name;
    Operation operation = Operation::union_;
    std::function<std::pair<Arrays, Arrays>()> make;  ///< made when needed: the large ones fill memory
};

/// All cases that can be had here. Tiny: the smallest size of each kind. `missing` receives the names of those whose
/// files are not there.
[[nodiscard]] std::vector<Case> cases(bool tiny, std::vector<std::string>& missing);

}  // namespace side_by_side

#endif

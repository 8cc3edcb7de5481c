// SPDX-License-Identifier: Apache-2.0
/// What is compared: an engine takes two triangle meshes as arrays, and gives one.
#ifndef CLEAVE_BENCHMARKS_SIDE_BY_SIDE_ENGINE_HPP
#define CLEAVE_BENCHMARKS_SIDE_BY_SIDE_ENGINE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace side_by_side {

/// Triangles as arrays: three indices into `points` each.
struct Arrays {
    std::vector<std::array<double, 3>> points;
    std::vector<std::uint32_t> corners;

    [[nodiscard]] std::size_t face_count() const { return corners.size() / 3; }
};

enum class Operation { union_, intersection, difference };

/// Processor time of this process, in seconds: all engines run on one thread, and what else the machine does is not
/// counted. On an idle machine it is the time on the clock.
[[nodiscard]] inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// Seconds of the parts of one run, where an engine has such parts.
struct Stages {
    double prepare = 0;
    double operate = 0;
    double finish = 0;  ///< from the engine's own form back to arrays
};

struct Engine {
    std::string name;
    std::string description;
    /// One run, arrays to arrays. Throws where the engine has no answer.
    std::function<Arrays(Operation, const Arrays&, const Arrays&, Stages&)> run;
    /// Whether volumes add up exactly; empty where the engine has no exact measure.
    std::function<bool(Operation, const Arrays&, const Arrays&)> adds_up_exactly;
    bool has_stages = false;
    /// Slow by its nature: run once, on operands of no more than this many faces. 0: any size, any number of runs.
    std::size_t once_up_to = 0;
};

[[nodiscard]] Engine cleave_engine();

/// CGAL's engines. Their source has a compiler's run of its own: CGAL wants other flags (-frounding-math).
[[nodiscard]] std::vector<Engine> cgal_engines();

}  // namespace side_by_side

#endif

// SPDX-License-Identifier: Apache-2.0
/// One run of an engine in a process of its own, with the check of its answer: an engine that crashes, fills memory or
/// never returns costs its own case only, and the peak of memory is its own.
#ifndef CLEAVE_BENCHMARKS_SIDE_BY_SIDE_TRIAL_HPP
#define CLEAVE_BENCHMARKS_SIDE_BY_SIDE_TRIAL_HPP

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "check.hpp"
#include "engine.hpp"

namespace side_by_side {

/// What a trial found. Plain bytes, because it comes through a pipe.
struct Trial {
    bool has_result = false;
    bool is_checked = false;
    bool is_right = false;
    double seconds = 0;
    double volume = 0;
    double peak_mib = 0;  ///< memory beyond that of the operands
    std::size_t faces = 0;
    char message[300] = {};

    void say(const std::string& text) { std::snprintf(message, sizeof message, "%s", text.c_str()); }
};

namespace trial {

inline double peak_mib() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
#if defined(__APPLE__)
    return double(use.ru_maxrss) / (1024 * 1024);
#else
    return double(use.ru_maxrss) / 1024;
#endif
}

inline void check(Trial& trial, const Engine& engine, Operation operation, const Arrays& a, const Arrays& b,
                  const Arrays& result) {
    trial.volume = volume(result);
    trial.faces = result.face_count();
    std::string wrong = defect(result);
    // Once is enough of a slow engine: its volume is still compared with the others'.
    if (wrong.empty() && engine.once_up_to == 0) {
        Stages stages;
        const double intersection = volume(engine.run(Operation::intersection, a, b, stages));
        if (!adds_up(operation, volume(a), volume(b), trial.volume, intersection))
            wrong = "volumes do not add up";
        else if (engine.adds_up_exactly && !engine.adds_up_exactly(operation, a, b))
            wrong = "volumes do not add up exactly";
    }
    trial.is_checked = true;
    trial.is_right = wrong.empty();
    trial.say(wrong);
}

/// In the child: reports after the run, and again after the check.
inline void work(int report, const Engine& engine, Operation operation, const Arrays& a, const Arrays& b) {
    Trial trial;
    const auto send = [&] { return write(report, &trial, sizeof trial) == ssize_t(sizeof trial); };
    try {
        const double before = peak_mib();
        Stages stages;
        const double start = processor_seconds();
        const Arrays result = engine.run(operation, a, b, stages);
        trial.seconds = processor_seconds() - start;
        trial.peak_mib = peak_mib() - before;
        trial.has_result = true;
        if (!send()) return;
        check(trial, engine, operation, a, b, result);
    } catch (const std::exception& error) {
        trial.say(trial.has_result ? "in its check: " + std::string(error.what()) : error.what());
    }
    send();
}

}  // namespace trial

[[nodiscard]] inline Trial try_once(const Engine& engine, Operation operation, const Arrays& a, const Arrays& b,
                                    unsigned limit_seconds) {
#if defined(__GLIBC__)
    malloc_trim(0);  // or the child would find memory that is there already
#endif
    std::fflush(nullptr);
    Trial last;
    int ends[2];
    if (pipe(ends) != 0) {
        last.say("no pipe");
        return last;
    }
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        alarm(limit_seconds);
        trial::work(ends[1], engine, operation, a, b);
        std::_Exit(0);
    }
    close(ends[1]);
    Trial next;
    while (read(ends[0], &next, sizeof next) == ssize_t(sizeof next)) last = next;
    close(ends[0]);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        last.say("no process");
    } else if (WIFSIGNALED(status)) {
        const std::string how = WTERMSIG(status) == SIGALRM ? "over " + std::to_string(limit_seconds) + " s"
                                                            : std::string(strsignal(WTERMSIG(status)));
        last.say(last.has_result ? "in its check: " + how : how);
    }
    return last;
}

}  // namespace side_by_side

#endif

// SPDX-License-Identifier: Apache-2.0
// Random cases for as long as one likes: the localised engine beside the two others, measures, points, and everything
// that a result promises. Exit status 1 where anything disagrees; what repeats the case is printed.
#include "soak/cases.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>

namespace {

using namespace soak;
using Clock = std::chrono::steady_clock;

const char* const usage =
    "usage: soak [--seconds N] [--seed S] [--kinds LIST] [--case K]\n"
    "\n"
    "  --seconds N   how long to draw cases; 5 unless given, or CLEAVE_TEST_SCALE per cent of it; one of each kind at "
    "least\n"
    "  --seed S      which cases; 1 unless given\n"
    "  --kinds LIST  only these kinds, with commas between them\n"
    "  --case K      only case K of each kind; where it fails, the operands are printed\n"
    "  --help        this text\n"
    "\n"
    "kinds:\n";

void print_usage(std::FILE* to) {
    std::fputs(usage, to);
    for (const Kind& k : all_kinds) std::fprintf(to, "  %-12s  %s\n", k.name, k.about);
}

struct Options {
    double seconds = 0.05 * double(scaled(100));
    std::uint32_t seed = 1;
    std::vector<const Kind*> kinds;
    std::optional<std::uint32_t> only;
    bool help = false;
};

std::uint32_t number_of(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw cleave::Error("not a number: " + std::string(text));
    return value;
}

std::vector<const Kind*> kinds_of(std::string_view list) {
    std::vector<const Kind*> kinds;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        const std::string_view name = list.substr(0, comma);
        const auto* const kind =
            std::find_if(all_kinds.begin(), all_kinds.end(), [&](const Kind& k) { return k.name == name; });
        if (kind == all_kinds.end()) throw cleave::Error("there is no kind " + std::string(name));
        kinds.push_back(kind);
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return kinds;
}

Options read_options(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string_view name = arguments[i];
        if (name == "--help") {
            options.help = true;
            return options;
        }
        if (i + 1 == count) throw cleave::Error("no such option, or its value is missing: " + std::string(name));
        const std::string_view value = arguments[++i];
        if (name == "--seconds")
            options.seconds = number_of(value);
        else if (name == "--seed")
            options.seed = number_of(value);
        else if (name == "--kinds")
            options.kinds = kinds_of(value);
        else if (name == "--case")
            options.only = number_of(value);
        else
            throw cleave::Error("there is no option " + std::string(name));
    }
    if (options.kinds.empty())
        for (const Kind& k : all_kinds) options.kinds.push_back(&k);
    return options;
}

/// What was done of one kind.
struct Row {
    Counts counts;
    std::size_t cases = 0;
    std::size_t disagreements = 0;
    double seconds = 0;
    double slowest = 0;
    std::uint32_t slowest_case = 0;
};

class Soak {
public:
    explicit Soak(const Options& options) : options_(options), rows_(options.kinds.size()) {}

    /// Draws cases of all kinds in turn. Returns: whether nothing disagreed.
    bool run() {
        if (options_.only) {
            for (std::size_t k = 0; k < rows_.size(); ++k) run_case(k, *options_.only);
        } else {
            const Clock::time_point start = Clock::now();
            for (std::uint32_t n = 0;; ++n)
                for (std::size_t k = 0; k < rows_.size(); ++k) {
                    if (n > 0 && since(start) >= options_.seconds) return print_table();
                    run_case(k, n);
                }
        }
        return print_table();
    }

private:
    static constexpr std::size_t most_reported = 20;  // of one kind

    static double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

    /// The dice of a case: any kind, seed and number give others (FNV-1a of the text).
    [[nodiscard]] unsigned seed_of(const Kind& kind, std::uint32_t n) const {
        std::uint32_t hash = 2166136261U;
        for (const char c : kind.name + ("/" + std::to_string(options_.seed)) + "/" + std::to_string(n))
            hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
        return hash;
    }

    void run_case(std::size_t k, std::uint32_t n) {
        const Kind& kind = *options_.kinds[k];
        Row& row = rows_[k];
        Dice dice(seed_of(kind, n));
        Checker checker(dice);
        const Clock::time_point start = Clock::now();
        try {
            kind.run(dice, checker);
        } catch (const Disagreement& e) {
            report(kind, row, n, e.what());
            if (options_.only) std::printf("%s\n", e.evidence().c_str());
        } catch (const std::exception& e) {
            report(kind, row, n, e.what());
        }
        const double seconds = since(start);
        row.counts += checker.counts();
        ++row.cases;
        row.seconds += seconds;
        if (seconds <= row.slowest) return;
        row.slowest = seconds;
        row.slowest_case = n;
    }

    void report(const Kind& kind, Row& row, std::uint32_t n, const char* what) const {
        if (++row.disagreements > most_reported) return;
        std::printf("disagreement: %s\n    soak --kinds %s --seed %u --case %u\n", what, kind.name,
                    unsigned(options_.seed), unsigned(n));
        std::fflush(stdout);
    }

    /// Returns: whether nothing disagreed.
    [[nodiscard]] bool print_table() const {
        std::printf("%-10s %7s %8s %10s %8s %9s %9s %9s %9s %8s %s\n", "kind", "cases", "seconds", "evaluated",
                    "localised", "by trees", "verified", "measured", "probes", "disagree", "slowest (case)");
        Row all;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Row& r = rows_[k];
            print(options_.kinds[k]->name, r);
            all.counts += r.counts;
            all.cases += r.cases;
            all.disagreements += r.disagreements;
            all.seconds += r.seconds;
            if (r.slowest <= all.slowest) continue;
            all.slowest = r.slowest;
            all.slowest_case = r.slowest_case;
        }
        print("all", all);
        return all.disagreements == 0;
    }

    static void print(const char* name, const Row& r) {
        std::printf("%-10s %7zu %8.1f %10zu %9zu %8zu %9zu %9zu %9zu %9zu %.1f s (%u)\n", name, r.cases, r.seconds,
                    r.counts.evaluations, r.counts.localised, r.counts.tree_merges, r.counts.verified,
                    r.counts.measured, r.counts.probes, r.disagreements, r.slowest, unsigned(r.slowest_case));
    }

    Options options_;
    std::vector<Row> rows_;
};

}  // namespace

int main(int count, char** arguments) {
    try {
        const Options options = read_options(count, arguments);
        if (options.help) {
            print_usage(stdout);
            return 0;
        }
        return Soak(options).run() ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "soak: %s\n", e.what());
        print_usage(stderr);
        return 2;
    }
}

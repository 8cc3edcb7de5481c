// SPDX-License-Identifier: Apache-2.0
// cleave beside other engines for Boolean operations on meshes, from arrays to arrays (points as doubles and triangles,
// in and out), in processor time of one thread. Every engine's answer is checked first, in a process of its own:
// closed, volumes add up (for cleave also exactly), and the engines' volumes agree. Those with an answer are then timed
// in turn, two rounds to warm up and the median of the others. `side_by_side --help` has the options;
// side_by_side/manifold.mjs times Manifold on the same operands, which `--write-cases` writes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side/cases.hpp"
#include "side_by_side/check.hpp"
#include "side_by_side/engine.hpp"
#include "side_by_side/trial.hpp"

namespace {

using namespace side_by_side;

struct Options {
    std::string cases = ".";
    std::string engines = ".";
    unsigned runs = 15;
    unsigned limit = 900;
    std::string json;
    std::string write_cases;
    bool smoke = false;
};

constexpr const char* help =
    "side_by_side [option...]\n"
    "  --cases REGEXP     those cases whose names match (all)\n"
    "  --engines REGEXP   those engines whose names match; cleave is always among them (all)\n"
    "  --runs N           runs of each engine that takes up to 2 s a run; slower ones have fewer (15)\n"
    "  --limit SECONDS    of each engine's first run and check, which happen in a process of their own (900)\n"
    "  --json FILE        results, with compiler and flags\n"
    "  --write-cases DIR  writes the operands for side_by_side/manifold.mjs, and times nothing\n"
    "  --smoke            tiny operands, one run: do all engines run, and are the answers right?\n"
    "The environment variable CLEAVE_MODELS_DIR names a folder with real meshes.\n";

/// An engine's results on one case.
struct Column {
    Trial trial;
    bool is_asked = false;
    bool is_wrong = false;        ///< has a result, and it failed a check
    std::vector<double> seconds;  ///< of processor time
    std::vector<double> wall;     ///< on the clock, where measured
    std::vector<Stages> stages;
};

struct Row {
    std::string name;
    std::size_t first_faces = 0;
    std::size_t second_faces = 0;
    std::vector<Column> columns;
    std::vector<std::string> notes;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

double median(const std::vector<Stages>& stages, double Stages::*stage) {
    std::vector<double> values;
    for (const Stages& s : stages) values.push_back(s.*stage);
    return median(values);
}

/// How many runs a time is the median of, from the time of the first.
unsigned runs_of(double seconds, unsigned wanted) {
    if (seconds <= 2) return wanted;
    return std::min(wanted, seconds <= 10 ? 5U : seconds <= 60 ? 3U : 1U);
}

void compare_volumes(Row& row, const std::vector<Engine>& engines) {
    const Trial& ours = row.columns[0].trial;
    for (std::size_t e = 0; e < engines.size(); ++e) {
        Column& c = row.columns[e];
        if (!c.is_asked) continue;
        std::string text = c.trial.message;
        const double error = std::abs(c.trial.volume - ours.volume);
        if (c.trial.is_checked && row.columns[0].trial.is_checked && error > 1e-6 * std::abs(ours.volume))
            text += (text.empty() ? "" : "; ") + std::string("volume differs from cleave's");
        c.is_wrong = c.trial.has_result && !text.empty();
        if (!text.empty()) row.notes.push_back(engines[e].name + ": " + text);
    }
}

Row measure(const Case& one, const std::vector<Engine>& engines, const Options& options) {
    const auto [a, b] = one.make();
    Row row{one.name, a.face_count(), b.face_count(), std::vector<Column>(engines.size()), {}};
    std::vector<unsigned> runs(engines.size(), 0);
    unsigned rounds = 0;
    for (std::size_t e = 0; e < engines.size(); ++e) {
        Column& c = row.columns[e];
        c.is_asked = engines[e].once_up_to == 0 || std::max(row.first_faces, row.second_faces) <= engines[e].once_up_to;
        if (!c.is_asked) continue;
        c.trial = try_once(engines[e], one.operation, a, b, options.limit);
        if (!c.trial.has_result) continue;
        runs[e] = engines[e].once_up_to != 0 ? 1 : runs_of(c.trial.seconds, options.runs);
        // A single run is the trial itself.
        if (runs[e] == 1 && !engines[e].has_stages) {
            c.seconds = {c.trial.seconds};
            runs[e] = 0;
        }
        rounds = std::max(rounds, runs[e]);
    }
    compare_volumes(row, engines);
    const unsigned warm = options.smoke ? 0 : 2;
    for (unsigned round = 0; round < rounds + warm; ++round)
        for (std::size_t e = 0; e < engines.size(); ++e) {
            // The trial has warmed a slow engine up.
            const unsigned own_warm = row.columns[e].trial.seconds > 2 ? 0 : warm;
            if (round >= runs[e] + own_warm) continue;
            Stages stages;
            const auto clock = std::chrono::steady_clock::now();
            const double start = processor_seconds();
            const Arrays result = engines[e].run(one.operation, a, b, stages);
            const double time = processor_seconds() - start;
            const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - clock;
            if (round < own_warm) continue;
            row.columns[e].seconds.push_back(time);
            row.columns[e].wall.push_back(wall.count());
            row.columns[e].stages.push_back(stages);
        }
    return row;
}

std::string milliseconds(double seconds) {
    char text[32];
    const double ms = seconds * 1e3;
    std::snprintf(text, sizeof text, ms < 10 ? "%.3f" : ms < 1000 ? "%.1f" : "%.0f", ms);
    return text;
}

/// A time over cleave's. "!" marks a wrong answer, "-" that the engine was not asked.
std::string ratio(const Column& c, const Column& ours) {
    if (!c.is_asked) return "-";
    if (c.seconds.empty() || ours.seconds.empty()) return "failed";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", median(c.seconds) / median(ours.seconds));
    return text + std::string(c.is_wrong ? "!" : "");
}

std::string time_text(const Column& c) {
    if (!c.is_asked) return "-";
    return c.seconds.empty() ? "failed" : milliseconds(median(c.seconds)) + (c.is_wrong ? "!" : "");
}

void print_head(const std::vector<Engine>& engines) {
    std::printf(
        "Processor time over cleave's, then medians in ms, the runs of each engine, and the peak of memory in MiB.\n"
        "!: the answer is wrong, see below the line. failed: no answer. -: not asked, too large for it.\n\n");
    std::printf("%-28s %17s", "case", "faces");
    const std::span<const Engine> others = std::span(engines).subspan(1);
    for (const Engine& e : others) std::printf(" %13s", (e.name + "/cleave").c_str());
    std::printf(" | %10s %10s %10s %10s", "cleave", "prepare", "operate", "export");
    for (const Engine& e : others) std::printf(" %10s", e.name.c_str());
    std::printf(" | %11s | %s\n", "runs", "MiB");
}

void print(const Row& row) {
    const Column& ours = row.columns[0];
    std::printf("%-28s %17s", row.name.c_str(),
                (std::to_string(row.first_faces) + " " + std::to_string(row.second_faces)).c_str());
    for (std::size_t e = 1; e < row.columns.size(); ++e) std::printf(" %13s", ratio(row.columns[e], ours).c_str());
    std::printf(" | %10s", time_text(ours).c_str());
    for (double Stages::*stage : {&Stages::prepare, &Stages::operate, &Stages::finish})
        std::printf(" %10s", milliseconds(median(ours.stages, stage)).c_str());
    for (std::size_t e = 1; e < row.columns.size(); ++e) std::printf(" %10s", time_text(row.columns[e]).c_str());
    std::string runs;
    std::string memory;
    for (const Column& c : row.columns) {
        runs += (runs.empty() ? "" : " ") + std::to_string(c.seconds.size());
        memory +=
            (memory.empty() ? "" : " ") + (c.trial.has_result ? std::to_string(std::lround(c.trial.peak_mib)) : "-");
    }
    std::printf(" | %11s | %s\n", runs.c_str(), memory.c_str());
    for (const std::string& note : row.notes) std::printf("    ! %s\n", note.c_str());
    std::fflush(stdout);
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + '"';
}

void write_json(const std::string& path, const std::vector<Engine>& engines, const std::vector<Row>& rows) {
    std::ofstream out(path);
    out.precision(17);
    out << "{\n  \"compiler\": " << quoted(SIDE_BY_SIDE_COMPILER) << ",\n  \"flags\": " << quoted(SIDE_BY_SIDE_FLAGS)
        << ",\n  \"engines\": {";
    for (std::size_t e = 0; e < engines.size(); ++e)
        out << (e == 0 ? "" : ", ") << quoted(engines[e].name) << ": " << quoted(engines[e].description);
    out << "},\n  \"cases\": [";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const Row& row = rows[r];
        out << (r == 0 ? "" : ",") << "\n    {\"name\": " << quoted(row.name) << ", \"faces\": [" << row.first_faces
            << ", " << row.second_faces << "]";
        for (std::size_t e = 0; e < engines.size(); ++e) {
            const Column& c = row.columns[e];
            if (!c.is_asked) continue;
            out << ",\n     " << quoted(engines[e].name) << ": {\"runs\": " << c.seconds.size();
            if (!c.seconds.empty())
                out << ", \"ms\": " << median(c.seconds) * 1e3
                    << ", \"least_ms\": " << *std::min_element(c.seconds.begin(), c.seconds.end()) * 1e3
                    << ", \"most_ms\": " << *std::max_element(c.seconds.begin(), c.seconds.end()) * 1e3;
            if (!c.wall.empty()) out << ", \"wall_ms\": " << median(c.wall) * 1e3;
            if (engines[e].has_stages)
                out << ", \"prepare_ms\": " << median(c.stages, &Stages::prepare) * 1e3
                    << ", \"operate_ms\": " << median(c.stages, &Stages::operate) * 1e3
                    << ", \"export_ms\": " << median(c.stages, &Stages::finish) * 1e3;
            if (c.trial.has_result)
                out << ", \"result_faces\": " << c.trial.faces << ", \"volume\": " << c.trial.volume
                    << ", \"peak_mib\": " << c.trial.peak_mib;
            out << ", \"right\": " << (c.trial.is_right && !c.is_wrong ? "true" : "false") << "}";
        }
        out << ",\n     \"notes\": [";
        for (std::size_t n = 0; n < row.notes.size(); ++n) out << (n == 0 ? "" : ", ") << quoted(row.notes[n]);
        out << "]}";
    }
    out << "\n  ]\n}\n";
    if (!out.flush()) throw std::runtime_error(path + " cannot be written");
}

/// 64-bit count of points, their doubles, 64-bit count of triangles, their 32-bit indices; in the machine's byte order.
void write_operand(const std::filesystem::path& path, const Arrays& arrays) {
    std::ofstream out(path, std::ios::binary);
    const auto write = [&](const auto* data, std::size_t count) {
        out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count * sizeof *data));
    };
    const std::uint64_t points = arrays.points.size();
    const std::uint64_t triangles = arrays.face_count();
    write(&points, 1);
    write(arrays.points.data(), arrays.points.size());
    write(&triangles, 1);
    write(arrays.corners.data(), arrays.corners.size());
    if (!out.flush()) throw std::runtime_error(path.string() + " cannot be written");
}

void write_cases(const std::filesystem::path& folder, const std::vector<Case>& list) {
    std::filesystem::create_directories(folder);
    std::ofstream index(folder / "cases.json");
    index << "[";
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto [a, b] = list[i].make();
        write_operand(folder / (list[i].name + ".first"), a);
        write_operand(folder / (list[i].name + ".second"), b);
        index << (i == 0 ? "" : ",") << "\n  {\"name\": " << quoted(list[i].name)
              << ", \"operation\": " << (list[i].operation == Operation::difference ? "\"difference\"" : "\"union\"")
              << "}";
    }
    index << "\n]\n";
    if (!index.flush()) throw std::runtime_error("cases.json cannot be written");
}

/// nullopt: help was asked for and given.
std::optional<Options> parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        std::string name = arguments[i];
        std::optional<std::string> given;
        if (const std::size_t equals = name.find('='); equals != std::string::npos) {
            given = name.substr(equals + 1);
            name.resize(equals);
        }
        const auto value = [&] {
            if (given) return *given;
            if (++i == count) throw std::invalid_argument(name + " needs a value");
            return std::string(arguments[i]);
        };
        const auto number = [&] {
            const std::string text = value();
            if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos ||
                std::stoul(text) == 0)
                throw std::invalid_argument(name + " needs a number from 1 to 999999");
            return static_cast<unsigned>(std::stoul(text));
        };
        if (name == "--cases")
            options.cases = value();
        else if (name == "--engines")
            options.engines = value();
        else if (name == "--runs")
            options.runs = number();
        else if (name == "--limit")
            options.limit = number();
        else if (name == "--json")
            options.json = value();
        else if (name == "--write-cases")
            options.write_cases = value();
        else if (name == "--smoke")
            options.smoke = true;
        else if (name == "--help")
            return std::printf("%s", help), std::nullopt;
        else
            throw std::invalid_argument("there is no option " + name + "; --help lists them");
    }
    if (options.smoke) options.runs = 1;
    return options;
}

int run(const Options& options) {
    std::vector<Engine> engines{cleave_engine()};
#if defined(SIDE_BY_SIDE_WITH_CGAL)
    for (const Engine& e : cgal_engines())
        if (std::regex_search(e.name, std::regex(options.engines))) engines.push_back(e);
#endif
    std::vector<std::string> missing;
    std::vector<Case> list = cases(options.smoke, missing);
    const std::regex wanted(options.cases);
    std::erase_if(list, [&](const Case& c) { return !std::regex_search(c.name, wanted); });
    if (!options.write_cases.empty()) {
        write_cases(options.write_cases, list);
        return 0;
    }
    std::vector<Row> rows;
    bool is_right = true;
    print_head(engines);
    for (const Case& c : list) {
        rows.push_back(measure(c, engines, options));
        print(rows.back());
        const Column& ours = rows.back().columns[0];
        is_right = is_right && ours.trial.is_right && !ours.is_wrong;
        if (!options.json.empty()) write_json(options.json, engines, rows);  // after each: all of them take long
    }
    if (!options.smoke)
        for (const std::string& name : missing)
            if (std::regex_search(name, wanted)) std::printf("skipped: CLEAVE_MODELS_DIR has no %s\n", name.c_str());
    if (!is_right) std::printf("cleave failed a check\n");
    return is_right ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        const std::optional<Options> options = parse(count, arguments);
        return options ? run(*options) : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "side_by_side: %s\n", error.what());
        return 2;
    }
}

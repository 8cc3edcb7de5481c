// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include "report.hpp"
#include "threads.hpp"

#include <cleave/base/error.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/resolve.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/components.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/expression.hpp>
#include <cleave/setop/expression_text.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace cleave;
using Solid = Region<3>;

/// Adds the time until its end to `total`.
class Stopwatch {
public:
    explicit Stopwatch(double& total) : total_(total) {}
    ~Stopwatch() {
        const std::chrono::duration<double> passed = Clock::now() - start_;
        total_ += passed.count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& total_;
    Clock::time_point start_ = Clock::now();
};

/// What every subcommand works with.
struct Context {
    const Options& options;
    Interrupt& interrupt;
    ProgressBar& bar;
    ExecutorRef executor;
    Seconds seconds;
    std::string notes;  // printed last, so that they do not tear the progress line

    void stage(const std::string& name) {
        if (interrupt.token().stop_requested()) throw Cancelled();
        bar.stage(name);
    }

    void print_notes() {
        bar.close();
        if (!options.quiet) std::cerr << notes;
    }
};

template <class T>
struct Operand {
    std::string file;
    MeshOrigin origin;
    PolygonMesh<T> mesh;
};

template <class T>
Operand<T> read_operand(Context& context, const std::string& file) {
    context.stage("reading " + file);
    const Stopwatch watch(context.seconds.read);
    Operand<T> operand{file, {}, {}};
    operand.mesh = read_mesh<T>(file, &operand.origin);
    return operand;
}

/// All operands, read at once. Of several that cannot be read the first one is told about.
template <class T>
std::vector<Operand<T>> read_operands(Context& context) {
    const std::vector<std::string>& files = context.options.inputs;
    context.stage("reading " + (files.size() == 1 ? files.front() : std::to_string(files.size()) + " files"));
    const Stopwatch watch(context.seconds.read);
    std::vector<Operand<T>> operands(files.size());
    std::vector<std::exception_ptr> errors(files.size());
    context.executor.for_each_index(files.size(), [&](std::size_t i) {
        try {
            if (context.interrupt.token().stop_requested()) throw Cancelled();
            operands[i].file = files[i];
            operands[i].mesh = read_mesh<T>(files[i], &operands[i].origin);
        } catch (...) {
            errors[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return operands;
}

/// Frees the mesh.
template <class T>
Solid prepare(Context& context, Operand<T>& operand) {
    context.stage("preparing " + operand.file);
    MeshReport report;
    Solid solid;
    {
        const Stopwatch watch(context.seconds.prepare);
        ProgressReporter progress(context.bar.callback(), context.interrupt.token());
        ToRegionOptions settings;
        settings.strictness = context.options.strictness();
        settings.origin = &operand.origin;
        settings.report = &report;
        settings.check_self_intersections = context.options.check_crossings;
        settings.progress = &progress;
        settings.executor = context.executor;
        try {
            solid = to_region(operand.mesh, settings);
        } catch (const NumberError& error) {
            throw FileError(operand.file, 0, error.what());
        }
    }
    context.notes += tolerated_text(operand.file, report);
    operand.mesh = {};
    operand.origin = {};
    return solid;
}

OperandReport report_of(Context& context, const std::string& file, const Solid& solid) {
    context.stage("measuring " + file);
    OperandReport report;
    report.file = file;
    report.volume = context.options.json ? measure_volume(solid, json_fraction_digits, json_decimal_digits)
                                         : measure_volume(solid, text_fraction_digits, text_decimal_digits);
    return report;
}

/// The operation as an expression: of any number of operands.
Expression<3> expression_of(const Options& options, const std::vector<Solid>& operands) {
    if (options.command == Options::Command::eval)
        return parse_expression(options.expression, [&](std::string_view name) {
            const auto at = std::find(options.names.begin(), options.names.end(), name);
            return Expression<3>(operands.at(static_cast<std::size_t>(at - options.names.begin())));
        });
    Expression<3> sum(operands.front());
    for (std::size_t i = 1; i < operands.size(); ++i) {
        switch (options.operation) {
            case Operation::union_:
                sum |= operands[i];
                break;
            case Operation::intersection:
                sum &= operands[i];
                break;
            case Operation::difference:
                sum -= operands[i];
                break;
            case Operation::symmetric_difference:
                sum ^= operands[i];
                break;
        }
    }
    return sum;
}

Solid operate(const Context& context, const std::vector<Solid>& operands, ProgressReporter& progress) {
    OperationOptions settings;
    settings.progress = &progress;
    settings.executor = context.executor;
    return evaluate(context.options.engine, expression_of(context.options, operands), settings);
}

ExportedMesh<double> export_mesh(const Solid& solid, const ToMeshOptions& settings, double) {
    return to_exported_mesh(solid, settings);
}
ExportedMesh<Rational> export_mesh(const Solid& solid, const ToMeshOptions& settings, const Rational&) {
    return to_exported_rational_mesh(solid, settings);
}

/// Points of the triangles in an STL file, as its reader sees them: those that differ in single precision.
std::size_t count_stl_points(const Mesh& mesh) {
    std::vector<std::array<float, 3>> points;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::array<std::array<float, 3>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                corners[i][axis] = static_cast<float>(mesh.points[mesh.face(f)[i]][axis]) + 0.0F;  // one zero
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            points.insert(points.end(), corners.begin(), corners.end());
    }
    std::sort(points.begin(), points.end());
    return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

/// Finds out that a file cannot be written before hours of work, not after.
void require_writable(const std::string& file) {
    static_cast<void>(mesh_format(file));
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored) &&
        !std::filesystem::is_directory(file, ignored))
        return;  // a pipe or a device: opening it would be noticed at its other end
    const OutputFile probe(file);
}

/// Writes a result and tells what became of it. Whatever is measured is measured before: an interrupted run leaves
/// nothing behind.
template <class T, class MeasureOperands>
int deliver(Context& context, const Solid& solid, std::vector<OperandReport>& reports,
            MeasureOperands&& measure_operands) {
    const Options& options = context.options;
    context.stage("exporting " + options.output);
    ExportedMesh<T> exported;
    {
        const Stopwatch watch(context.seconds.export_);
        exported = export_mesh(solid, {context.executor}, T());
    }
    context.notes += rounding_text(options.output, exported.rounding);

    ResultReport result;
    const bool wants_report = options.json || !options.quiet;
    if (wants_report) {
        measure_operands();
        result.volume = report_of(context, options.output, solid).volume;
        context.stage("connecting " + options.output);
        const Connectivity connected = connectivity(solid);
        result.closed = connected.closed;
        result.components = connected.components;
    }
    context.stage("writing " + options.output);
    StlRounding rounding;
    {
        const Stopwatch watch(context.seconds.write);
        context.interrupt.protect([&] { rounding = write_mesh(options.output, exported.mesh); });
    }
    context.notes += rounding_text(options.output, rounding);
    result.file = options.output;
    result.faces = exported.mesh.face_count() - rounding.lost_triangles;
    result.vertices = exported.mesh.point_count();
    if constexpr (std::is_same_v<T, double>)
        if (mesh_format(options.output) == MeshFormat::stl) result.vertices = count_stl_points(exported.mesh);
    context.print_notes();
    if (options.json)
        std::cout << boolean_json(options, reports, result, context.seconds) << '\n';
    else if (!options.quiet)
        std::cout << boolean_text(options, reports, result, context.seconds);
    return 0;
}

template <class T>
int run_boolean(Context& context) {
    const Options& options = context.options;
    require_writable(options.output);
    std::vector<Operand<T>> operands = read_operands<T>(context);
    std::vector<OperandReport> reports;
    std::vector<Solid> solids;
    for (Operand<T>& operand : operands) {
        OperandReport& report = reports.emplace_back();
        report.vertices = operand.mesh.point_count();
        report.faces = operand.mesh.face_count();
        solids.push_back(prepare(context, operand));
    }

    context.stage(operation_name(options));
    ProgressReporter progress(context.bar.callback(), context.interrupt.token());
    Solid solid;
    {
        const Stopwatch watch(context.seconds.operate);
        solid = operate(context, solids, progress);
    }
    return deliver<T>(context, solid, reports, [&] {
        for (std::size_t i = 0; i < solids.size(); ++i) {
            OperandReport report = report_of(context, options.inputs[i], solids[i]);
            report.vertices = reports[i].vertices;
            report.faces = reports[i].faces;
            reports[i] = std::move(report);
        }
    });
}

template <class T>
int run_resolve(Context& context) {
    const Options& options = context.options;
    require_writable(options.output);
    Operand<T> operand = read_operand<T>(context, options.inputs.front());
    std::vector<OperandReport> reports(1);
    reports[0].file = operand.file;
    reports[0].vertices = operand.mesh.point_count();
    reports[0].faces = operand.mesh.face_count();
    context.stage("resolving " + operand.file);
    ProgressReporter progress(context.bar.callback(), context.interrupt.token());
    MeshReport report;
    Solid solid;
    {
        const Stopwatch watch(context.seconds.operate);
        try {
            solid = resolve(operand.mesh, options.rule,
                            {options.strictness(), &operand.origin, &report, &progress, context.executor});
        } catch (const NumberError& error) {
            throw FileError(operand.file, 0, error.what());
        }
    }
    context.notes += tolerated_text(operand.file, report);
    operand = {};
    return deliver<T>(context, solid, reports, [] {});
}

template <class T>
int run_info(Context& context) {
    std::vector<OperandReport> reports;
    for (const std::string& file : context.options.inputs) {
        Operand<T> operand = read_operand<T>(context, file);
        const std::size_t vertices = operand.mesh.point_count();
        const std::size_t faces = operand.mesh.face_count();
        reports.push_back(report_of(context, file, prepare(context, operand)));
        reports.back().vertices = vertices;
        reports.back().faces = faces;
    }
    context.print_notes();
    if (context.options.json)
        std::cout << info_json(reports) << '\n';
    else if (!context.options.quiet)
        std::cout << info_text(reports);
    return 0;
}

template <class T>
int run_check(Context& context) {
    const Options& options = context.options;
    const std::string& file = options.inputs.front();
    const Operand<T> operand = read_operand<T>(context, file);
    context.stage("checking " + file);
    MeshReport report = validate(operand.mesh, context.executor);
    const std::string oddities = explain(report, operand.mesh, &operand.origin);
    ProgressReporter progress(context.bar.callback(), context.interrupt.token());
    ToRegionOptions settings;
    settings.strictness = options.strictness();
    settings.origin = &operand.origin;
    settings.check_self_intersections = options.check_crossings;
    settings.progress = &progress;
    settings.executor = context.executor;
    std::optional<std::size_t> crossings;
    std::string message;
    try {
        static_cast<void>(to_region(operand.mesh, settings));
        if (options.check_crossings) crossings = 0;
    } catch (const Cancelled&) {
        throw;
    } catch (const SelfIntersectionError& error) {
        message = error.what();
        crossings = error.contacts().size();
    } catch (const Error& error) {
        message = error.what();
    }
    const bool valid = message.empty();
    context.print_notes();
    if (options.json) std::cout << check_json(file, report, crossings, valid, message) << '\n';
    if (!valid) {
        std::cerr << "cleave: " << message << '\n';
    } else if (!options.json && !options.quiet) {
        std::cout << file << ": " << report.point_count << " vertices, " << report.face_count
                  << " faces, bounds a solid" << (options.check_crossings ? ", no faces cross" : "") << '\n';
        if (!oddities.empty()) std::cout << oddities << '\n';
    }
    return valid ? 0 : 1;
}

template <class T>
int run_as(Context& context) {
    switch (context.options.command) {
        case Options::Command::boolean:
        case Options::Command::eval:
            return run_boolean<T>(context);
        case Options::Command::resolve:
            return run_resolve<T>(context);
        case Options::Command::info:
            return run_info<T>(context);
        case Options::Command::check:
            return run_check<T>(context);
    }
    return 2;
}

}  // namespace

int run(const Options& options, Interrupt& interrupt, ProgressBar& bar) {
    const Threads threads(options.threads);
    Context context{options, interrupt, bar, threads.executor(), {}, {}};
    return options.rational ? run_as<Rational>(context) : run_as<double>(context);
}

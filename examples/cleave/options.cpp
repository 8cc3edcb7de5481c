// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <cleave/io/mesh_file.hpp>
#include <cleave/setop/expression_text.hpp>
#include <cleave/version.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <thread>

namespace {

using cleave::Engine;
using cleave::Operation;

constexpr const char* about = R"(Exact Boolean operations on solids given as closed triangle or polygon meshes.

No tolerance, no repair, no perturbation: the result is the set that the operation
defines, its volume an exact fraction. Coordinates are taken as they are: every
double is a rational number.)";

constexpr const char* examples = R"(Examples:
  cleave union part.off boss.stl -o whole.off
  cleave difference block.off drill1.off drill2.off -o drilled.stl
  cleave xor before.obj after.obj -o changes.off --json
  cleave intersection a.off b.off -o exact.off --rational
  cleave eval 'block - (drill | slot)' block=a.off drill=b.off slot=c.off -o part.off
  cleave resolve scan.stl -o solid.off --rule non-zero
  cleave info model.stl
  cleave check model.off --strict --check-crossings

Files: OFF, OBJ and STL, by their extension; STL is written in its binary form.
Exit status: 0 done, 1 bad input (nothing is written), 2 bad command line.)";

/// More would be a slip of the keyboard.
constexpr std::size_t most_threads = 1024;

struct BooleanCommand {
    Operation operation;
    const char* name;
    const char* alias;
    const char* description;
    const char* example;
};

constexpr BooleanCommand boolean_commands[] = {
    {Operation::union_, "union", nullptr, "Points of any operand",
     "Example:\n  cleave union part.off boss.stl rib.stl -o whole.off"},
    {Operation::intersection, "intersection", nullptr, "Points of all operands",
     "Example:\n  cleave intersection model.off room.off -o inside.off --json"},
    {Operation::difference, "difference", nullptr, "Points of the first operand that are in no other",
     "Example:\n  cleave difference block.off drill1.off drill2.off -o drilled.stl"},
    {Operation::symmetric_difference, "symmetric-difference", "xor", "Points of an odd number of operands",
     "Example:\n  cleave xor before.obj after.obj -o changes.off"},
};

/// Shows the arguments of a subcommand as people write them, and not once more in a list.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* app, std::string) const override {
        std::string text = "\nUsage: cleave ";
        if (app->get_parent() == nullptr) return text + "SUBCOMMAND ...\n";
        text += app->get_name();
        for (const CLI::Option* option : app->get_options())
            if (option->get_positional()) text += ' ' + option->get_option_text();
        if (app->get_option_no_throw("--output") != nullptr) text += " -o OUT";
        return text + " [OPTIONS]\n";
    }
    std::string make_positionals(const CLI::App*) const override { return {}; }
};

/// Options that every subcommand has.
void add_common(CLI::App& command, Options& options) {
    command.add_flag("--json", options.json, "Print one line of JSON, and nothing else, on the standard output");
    command.add_flag("--rational", options.rational,
                     "Read decimals as the rationals they stand for, and fractions p/q");
    command.add_flag("--strict", options.strict,
                     "Refuse faces without area and faces that are not flat; else the former\n"
                     "are left out, the latter split into triangles, and both are reported");
    command
        .add_option("--threads", options.threads,
                    "How many threads work, 1 to 1024; else as many as the machine offers.\nThe result is the same")
        ->check(CLI::Range(std::size_t(1), most_threads))
        ->option_text("N");
    command.add_flag("--quiet", options.quiet, "Print nothing but errors, and the line of --json");
}

/// Subcommands that read solids can ask whether they are.
void add_check_crossings(CLI::App& command, Options& options) {
    command.add_flag("--check-crossings", options.check_crossings,
                     "Refuse meshes whose faces cross or overlap each other, and name the\n"
                     "faces; else such a mesh gives a closed but otherwise unspecified result");
}

void add_output(CLI::App& command, Options& options) {
    command.add_option("-o,--output", options.output, "File to write: OFF, OBJ or STL; replaced if it exists")
        ->option_text("OUT");
}

constexpr const char* about_output =
    "\n\nWith --rational, OUT (OFF or OBJ) holds fractions p/q: the result exactly. Without, it holds\n"
    "the nearest doubles, in triangles.";

/// Options of subcommands that operate and write a mesh.
void add_operating(CLI::App& command, Options& options, const std::string& example) {
    add_output(command, options);
    command
        .add_option("--engine", options.engine_name,
                    "How to work it out: automatic (default), localised, boundary-filter or tree-merge")
        ->check(CLI::IsMember({"automatic", "localised", "boundary-filter", "tree-merge"}))
        ->option_text("NAME");
    add_common(command, options);
    add_check_crossings(command, options);
    command.footer(example + about_output);
}

void choose_engine(Options& options) {
    if (options.engine_name == "localised") options.engine = Engine::localised;
    if (options.engine_name == "boundary-filter") options.engine = Engine::boundary_filter;
    if (options.engine_name == "tree-merge") options.engine = Engine::tree_merge;
}

void add_boolean(CLI::App& app, Options& options, const BooleanCommand& boolean) {
    CLI::App* command = app.add_subcommand(boolean.name, boolean.description);
    if (boolean.alias != nullptr) command->alias(boolean.alias);
    command->add_option("FILES", options.inputs)->expected(1, 1 << 20)->option_text("A B [C...]");
    add_operating(*command, options, boolean.example);
    command->final_callback([&options, boolean] {
        options.command = Options::Command::boolean;
        options.operation = boolean.operation;
        choose_engine(options);
    });
}

void add_eval(CLI::App& app, Options& options) {
    CLI::App* command = app.add_subcommand("eval", "The value of an expression, worked out at once");
    command->add_option("EXPRESSION", options.expression)->option_text("EXPRESSION");
    command->add_option("OPERANDS", options.inputs)->expected(1, 1 << 20)->option_text("NAME=FILE [NAME=FILE...]");
    add_operating(*command, options,
                  "Operators: a | b, a & b, a - b, a ^ b (in exactly one), ~a (all but a), and parentheses;\n"
                  "~ binds first, then -, &, ^, |. A result without bounds has no mesh.\n\n"
                  "Example:\n  cleave eval '(a | b) - c' a=plate.off b=rib.off c=drill.off -o part.off");
    command->final_callback([&options] {
        options.command = Options::Command::eval;
        choose_engine(options);
    });
}

void add_resolve(CLI::App& app, Options& options) {
    CLI::App* command = app.add_subcommand("resolve", "The solid that a mesh means where its faces cross each other");
    command->add_option("FILE", options.inputs)->expected(1, 1 << 20)->option_text("A");
    add_output(*command, options);
    command
        ->add_option("--rule", options.rule_name,
                     "Which winding numbers are inside: positive (default), non-zero or\neven-odd")
        ->check(CLI::IsMember({"positive", "non-zero", "even-odd"}))
        ->option_text("NAME");
    add_common(*command, options);
    command->footer(
        std::string(
            "The winding number of a point is how often the mesh runs around it: 1 inside a solid, 2 where two\n"
            "overlap, -1 inside one that is inside out. The mesh has to be closed.\n\n"
            "Example:\n  cleave resolve scan.stl -o solid.off --rule non-zero") +
        about_output);
    command->final_callback([&options] {
        options.command = Options::Command::resolve;
        options.rule = cleave::winding_rule_from_text(options.rule_name).value();
    });
}

/// An extension that is none at all is for the reader to refuse: bad input, not a bad command line.
bool is_stl(const std::string& file) {
    try {
        return !file.empty() && cleave::mesh_format(file) == cleave::MeshFormat::stl;
    } catch (const cleave::FileError&) {
        return false;
    }
}

/// The names in an expression; a stand-in for a value of it.
struct Names {
    std::set<std::string> names;
    friend Names operator|(Names a, const Names& b) {
        a.names.insert(b.names.begin(), b.names.end());
        return a;
    }
    friend Names operator&(const Names& a, const Names& b) { return a | b; }
    friend Names operator-(const Names& a, const Names& b) { return a | b; }
    friend Names operator^(const Names& a, const Names& b) { return a | b; }
    friend Names operator~(const Names& a) { return a; }
};

/// Takes NAME=FILE apart, and finds out whether names and expression fit.
void require_names(Options& options) {
    if (options.inputs.empty())
        throw CLI::ValidationError("eval takes an expression and NAME=FILE for each of its names");
    for (std::string& input : options.inputs) {
        const std::size_t at = input.find('=');
        const std::string name = input.substr(0, at);
        if (at == std::string::npos || at + 1 == input.size() || !cleave::is_expression_name(name))
            throw CLI::ValidationError("'" + input + "' is not NAME=FILE");
        if (std::find(options.names.begin(), options.names.end(), name) != options.names.end())
            throw CLI::ValidationError("the name '" + name + "' is given twice");
        options.names.push_back(name);
        input.erase(0, at + 1);
    }
    try {
        const Names used = cleave::parse_expression(options.expression,
                                                    [](std::string_view name) { return Names{{std::string(name)}}; });
        for (const std::string& name : used.names)
            if (std::find(options.names.begin(), options.names.end(), name) == options.names.end())
                throw CLI::ValidationError("the expression names '" + name + "', which is no operand: add " + name +
                                           "=FILE");
        for (const std::string& name : options.names)
            if (used.names.count(name) == 0)
                throw CLI::ValidationError("the operand '" + name + "' is not in the expression");
    } catch (const cleave::ExpressionError& error) {
        throw CLI::ValidationError(error.what());
    }
}

/// What CLI11 does not check, or does not say in so many words.
void require_sense(Options& options) {
    if (options.command == Options::Command::eval) require_names(options);
    const std::size_t files = options.inputs.size();
    if (options.command == Options::Command::info || options.command == Options::Command::check) {
        if (options.command == Options::Command::check && files != 1)
            throw CLI::ValidationError("check takes one file, found " + std::to_string(files));
        if (files == 0) throw CLI::ValidationError("which file? None was named");
        return;
    }
    if (options.command == Options::Command::resolve && files != 1)
        throw CLI::ValidationError("resolve takes one file, found " + std::to_string(files));
    if (options.command == Options::Command::boolean && files < 2)
        throw CLI::ValidationError("an operation takes two operands or more, found " + std::to_string(files));
    if (options.output.empty()) throw CLI::ValidationError("the name of the output is missing: -o OUT");
    if (options.rational && is_stl(options.output))
        throw CLI::ValidationError(
            "STL cannot hold the fractions of --rational: name an output that ends in .off or .obj");
}

}  // namespace

std::variant<Options, int> parse_command_line(int argc, char** argv) {
    Options options;
    options.threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
    CLI::App app(about, "cleave");
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(24);
    app.footer(examples);
    app.set_version_flag("--version", std::string("cleave ") + CLEAVE_VERSION_STRING);
    app.require_subcommand(1);
    for (const BooleanCommand& boolean : boolean_commands) add_boolean(app, options, boolean);
    add_eval(app, options);
    add_resolve(app, options);

    CLI::App* info = app.add_subcommand("info", "Numbers of vertices and faces, and the exact volume");
    info->add_option("FILES", options.inputs)->expected(1, 1 << 20)->option_text("A [B...]");
    add_common(*info, options);
    add_check_crossings(*info, options);
    info->footer("Example:\n  cleave info model.stl --json");
    info->final_callback([&options] { options.command = Options::Command::info; });

    CLI::App* check = app.add_subcommand("check", "Whether a mesh bounds a solid; if not, why and where");
    check->add_option("FILE", options.inputs)->expected(1, 1 << 20)->option_text("A");
    add_common(*check, options);
    add_check_crossings(*check, options);
    check->footer(
        "Example:\n  cleave check model.off --strict --check-crossings\n\n"
        "Exit status 0: every operation accepts the mesh. Whether faces cross each other is asked by\n"
        "--check-crossings alone.");
    check->final_callback([&options] { options.command = Options::Command::check; });

    try {
        app.parse(argc, argv);
        require_sense(options);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // help or version
        std::string message = error.what();
        const std::string first = argc > 1 ? argv[1] : "--help";
        if (app.get_subcommands().empty() && !first.empty() && first.front() != '-')
            message = "there is no subcommand '" + first + "'";
        std::cerr << "cleave: " << message << "\nRun cleave --help, or cleave SUBCOMMAND --help, for what there is.\n";
        return 2;
    }
    return options;
}

const char* operation_name(const Options& options) {
    if (options.command == Options::Command::eval) return "eval";
    if (options.command == Options::Command::resolve) return "resolve";
    for (const BooleanCommand& boolean : boolean_commands)
        if (boolean.operation == options.operation) return boolean.name;
    return "";
}

const char* engine_name(Engine engine) {
    switch (engine) {
        case Engine::boundary_filter:
            return "boundary-filter";
        case Engine::tree_merge:
            return "tree-merge";
        case Engine::automatic:  // operands are bounded solids
        case Engine::localised:
            break;
    }
    return "localised";
}

// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <cleave/io/mesh_file.hpp>
#include <cleave/version.hpp>

#include <iostream>
#include <memory>
#include <string>

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
  cleave info model.stl
  cleave check model.off --strict

Files: OFF, OBJ and STL, by their extension; STL is written in its binary form.
Exit status: 0 done, 1 bad input (nothing is written), 2 bad command line.)";

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
    command.add_flag("--quiet", options.quiet, "Print nothing but errors, and the line of --json");
}

void add_boolean(CLI::App& app, Options& options, const BooleanCommand& boolean) {
    CLI::App* command = app.add_subcommand(boolean.name, boolean.description);
    if (boolean.alias != nullptr) command->alias(boolean.alias);
    command->add_option("FILES", options.inputs)->expected(1, 1 << 20)->option_text("A B [C...]");
    command->add_option("-o,--output", options.output, "File to write: OFF, OBJ or STL; replaced if it exists")
        ->option_text("OUT");
    command
        ->add_option("--engine", options.engine_name,
                     "How to work it out: automatic (default), boundary-filter or tree-merge")
        ->check(CLI::IsMember({"automatic", "boundary-filter", "tree-merge"}))
        ->option_text("NAME");
    add_common(*command, options);
    command->footer(std::string(boolean.example) +
                    "\n\nWith --rational, OUT (OFF or OBJ) holds fractions p/q: the result exactly. Without, it holds\n"
                    "the nearest doubles, in triangles.");
    command->final_callback([&options, boolean] {
        options.command = Options::Command::boolean;
        options.operation = boolean.operation;
        if (options.engine_name == "boundary-filter") options.engine = Engine::boundary_filter;
        if (options.engine_name == "tree-merge") options.engine = Engine::tree_merge;
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

/// What CLI11 does not check, or does not say in so many words.
void require_sense(const Options& options) {
    const std::size_t files = options.inputs.size();
    if (options.command != Options::Command::boolean) {
        if (options.command == Options::Command::check && files != 1)
            throw CLI::ValidationError("check takes one file, found " + std::to_string(files));
        if (files == 0) throw CLI::ValidationError("which file? None was named");
        return;
    }
    if (files < 2)
        throw CLI::ValidationError("an operation takes two operands or more, found " + std::to_string(files));
    if (options.output.empty()) throw CLI::ValidationError("the name of the output is missing: -o OUT");
    if (options.rational && is_stl(options.output))
        throw CLI::ValidationError(
            "STL cannot hold the fractions of --rational: name an output that ends in .off or .obj");
}

}  // namespace

std::variant<Options, int> parse_command_line(int argc, char** argv) {
    Options options;
    CLI::App app(about, "cleave");
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(24);
    app.footer(examples);
    app.set_version_flag("--version", std::string("cleave ") + CLEAVE_VERSION_STRING);
    app.require_subcommand(1);
    for (const BooleanCommand& boolean : boolean_commands) add_boolean(app, options, boolean);

    CLI::App* info = app.add_subcommand("info", "Numbers of vertices and faces, and the exact volume");
    info->add_option("FILES", options.inputs)->expected(1, 1 << 20)->option_text("A [B...]");
    add_common(*info, options);
    info->footer("Example:\n  cleave info model.stl --json");
    info->final_callback([&options] { options.command = Options::Command::info; });

    CLI::App* check = app.add_subcommand("check", "Whether a mesh bounds a solid; if not, why and where");
    check->add_option("FILE", options.inputs)->expected(1, 1 << 20)->option_text("A");
    add_common(*check, options);
    check->footer(
        "Example:\n  cleave check model.off --strict\n\n"
        "Exit status 0: every operation accepts the mesh. Whether faces cross each other is not asked.");
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

const char* operation_name(Operation operation) {
    for (const BooleanCommand& boolean : boolean_commands)
        if (boolean.operation == operation) return boolean.name;
    return "";
}

const char* engine_name(Engine engine) {
    return engine == Engine::tree_merge ? "tree-merge" : "boundary-filter";
}

// SPDX-License-Identifier: Apache-2.0
// What the command line asks for.
#pragma once

#include <cleave/base/operation.hpp>
#include <cleave/base/winding_rule.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/setop/engines.hpp>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

struct Options {
    enum class Command { boolean, eval, resolve, info, check };

    Command command = Command::boolean;
    cleave::Operation operation = cleave::Operation::union_;
    std::string engine_name = "automatic";
    cleave::Engine engine = cleave::Engine::automatic;
    std::string rule_name = "positive";
    cleave::WindingRule rule = cleave::WindingRule::positive;
    std::string expression;
    std::vector<std::string> names;  ///< of `eval`'s operands, as many as inputs
    std::vector<std::string> inputs;
    std::string output;
    bool json = false;
    bool rational = false;
    bool strict = false;
    bool check_crossings = false;
    bool quiet = false;
    std::size_t threads = 1;  ///< as the command line says, or as many as the machine offers

    [[nodiscard]] cleave::Strictness strictness() const {
        return strict ? cleave::Strictness::strict : cleave::Strictness::tolerant;
    }
};

/// The options, or the status to exit with: 0 after --help or --version, 2 for a command line that makes no sense,
/// which has been explained on the error stream.
std::variant<Options, int> parse_command_line(int argc, char** argv);

/// The name of the subcommand that operates.
const char* operation_name(const Options& options);

/// The name of the engine that does the work: `automatic` stands for the one it chooses.
const char* engine_name(cleave::Engine engine);

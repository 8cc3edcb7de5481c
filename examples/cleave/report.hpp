// SPDX-License-Identifier: Apache-2.0
// What the program found, as one line of JSON or as text for people.
#pragma once

#include "options.hpp"

#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/region/region.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// A volume in the three forms of the JSON line.
struct Volume {
    std::optional<std::string> fraction;  ///< "p/q" if p and q have at most the digits asked for, else nothing
    std::string decimal;                  ///< rounded to the significant digits asked for
    std::optional<std::string> residue;   ///< modulo 2^61-1; nothing where the denominator is divisible by it
};

/// `max_digits`: of the fraction, numerator and denominator together, signs not counted. `digits`: of the decimal.
Volume measure_volume(const cleave::Region<3>& region, std::size_t max_digits, int digits);

/// The most digits of an exact volume in JSON and in text.
inline constexpr std::size_t json_fraction_digits = 2000;
inline constexpr std::size_t text_fraction_digits = 60;
/// Significant digits of the decimal volume likewise.
inline constexpr int json_decimal_digits = 40;
inline constexpr int text_decimal_digits = 17;

struct OperandReport {
    std::string file;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    Volume volume;  ///< without digits where it is not known
};

struct ResultReport {
    std::string file;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    Volume volume;
    bool closed = false;
    std::size_t components = 0;
};

struct Seconds {
    double read = 0;     ///< files to arrays
    double prepare = 0;  ///< arrays to regions, validation included
    double operate = 0;  ///< the Boolean
    double export_ = 0;  ///< region to arrays
    double write = 0;    ///< arrays to the file
};

/// The report of a subcommand that wrote a mesh.
std::string boolean_json(const Options& options, const std::vector<OperandReport>& operands, const ResultReport& result,
                         const Seconds& seconds);
std::string info_json(const std::vector<OperandReport>& operands);
/// `crossings`: how many pairs of faces cross or overlap, if that was asked.
std::string check_json(const std::string& file, const cleave::MeshReport& report, std::optional<std::size_t> crossings,
                       bool valid, const std::string& message);

std::string boolean_text(const Options& options, const std::vector<OperandReport>& operands, const ResultReport& result,
                         const Seconds& seconds);
std::string info_text(const std::vector<OperandReport>& operands);

/// One line for each kind of defect that the tolerant mode takes care of; empty if there is none.
std::string tolerated_text(const std::string& file, const cleave::MeshReport& report);

/// What rounding changed, if anything.
std::string rounding_text(const std::string& file, const cleave::RoundingReport& rounding);
std::string rounding_text(const std::string& file, const cleave::StlRounding& rounding);

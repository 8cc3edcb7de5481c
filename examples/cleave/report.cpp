// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <cleave/query/measure.hpp>
#include <cleave/query/measure_fraction.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace {

using Json = nlohmann::ordered_json;  // keys stay in the order in which they are set
using cleave::MeshDefect;

/// A file's name may hold any bytes; in JSON, those that are not UTF-8 are replaced.
std::string one_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json text_or_null(const std::optional<std::string>& text) {
    return text ? Json(*text) : Json(nullptr);
}

void set_volume(Json& json, const Volume& volume) {
    json["volume"] = text_or_null(volume.fraction);
    json["volume_40"] = volume.decimal;
    json["volume_mod"] = text_or_null(volume.residue);
}

Json operands_json(const std::vector<OperandReport>& operands) {
    Json list = Json::array();
    for (const OperandReport& operand : operands) {
        Json json;
        json["file"] = operand.file;
        json["vertices"] = operand.vertices;
        json["faces"] = operand.faces;
        if (!operand.volume.decimal.empty()) set_volume(json, operand.volume);
        list.push_back(std::move(json));
    }
    return list;
}

const char* defect_key(MeshDefect kind) {
    switch (kind) {
        case MeshDefect::point_not_finite:
            return "points_not_finite";
        case MeshDefect::index_out_of_range:
            return "indices_out_of_range";
        case MeshDefect::open_edge:
            return "open_edges";
        case MeshDefect::misoriented_edge:
            return "misoriented_edges";
        case MeshDefect::unbalanced_edge:
            return "unbalanced_edges";
        case MeshDefect::crossing_outline:
            return "crossing_outlines";
        case MeshDefect::too_few_corners:
            return "too_few_corners";
        case MeshDefect::repeated_corner:
            return "repeated_corners";
        case MeshDefect::zero_area:
            return "zero_area_faces";
        case MeshDefect::not_planar:
            return "non_planar_faces";
        case MeshDefect::t_junction:
            return "t_junctions";
        case MeshDefect::unused_point:
            return "unused_points";
    }
    return "";
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

std::string volume_text(const Volume& volume) {
    if (!volume.fraction) return "about " + volume.decimal;
    if (volume.fraction->find('/') == std::string::npos) return *volume.fraction;
    return *volume.fraction + ", about " + volume.decimal;
}

template <class Report>
std::string row(const Report& report, std::size_t width) {
    std::string name = report.file;
    name.resize(std::max(width, name.size()), ' ');
    return "  " + name + "  " + counted(report.vertices, "vertex", "vertices") + ", " +
           counted(report.faces, "face", "faces") +
           (report.volume.decimal.empty() ? std::string() : ", volume " + volume_text(report.volume));
}

std::size_t name_width(const std::vector<OperandReport>& operands, std::size_t least = 0) {
    for (const OperandReport& operand : operands) least = std::max(least, operand.file.size());
    return std::min<std::size_t>(least, 40);
}

std::string seconds_text(double seconds) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3f", seconds);
    return buffer;
}

}  // namespace

Volume measure_volume(const cleave::Region<3>& region, std::size_t max_digits, int digits) {
    Volume volume;
    if (const auto exact = cleave::measure_fraction(region, max_digits)) {
        volume.fraction = exact->num.to_string();
        if (!exact->den.is_one()) *volume.fraction += '/' + exact->den.to_string();
    }
    volume.decimal = cleave::measure_digits(region, digits).value();
    if (const auto residue = cleave::measure_modulo(region)) volume.residue = std::to_string(residue->value());
    return volume;
}

std::string boolean_json(const Options& options, const std::vector<OperandReport>& operands, const ResultReport& result,
                         const Seconds& seconds) {
    Json json;
    json["op"] = operation_name(options);
    if (options.command == Options::Command::eval) json["expression"] = options.expression;
    if (options.command == Options::Command::resolve)
        json["rule"] = options.rule_name;
    else
        json["engine"] = engine_name(options.engine);
    json["threads"] = options.threads;
    json["operands"] = operands_json(operands);
    Json& r = json["result"];
    r["vertices"] = result.vertices;
    r["faces"] = result.faces;
    set_volume(r, result.volume);
    r["closed"] = result.closed;
    r["components"] = result.components;
    Json& s = json["seconds"];
    s["read"] = seconds.read;
    s["prepare"] = seconds.prepare;
    s["operate"] = seconds.operate;
    s["export"] = seconds.export_;
    s["write"] = seconds.write;
    return one_line(json);
}

std::string info_json(const std::vector<OperandReport>& operands) {
    return one_line(operands_json(operands));
}

std::string check_json(const std::string& file, const cleave::MeshReport& report, std::optional<std::size_t> crossings,
                       bool valid, const std::string& message) {
    Json json;
    json["file"] = file;
    json["vertices"] = report.point_count;
    json["faces"] = report.face_count;
    json["valid"] = valid;
    json["closed"] = report.is_closed();
    Json& defects = json["defects"];
    for (const MeshDefect kind : cleave::all_mesh_defects) defects[defect_key(kind)] = report.count(kind);
    if (crossings) json["crossings"] = *crossings;
    json["message"] = message.empty() ? Json(nullptr) : Json(message);
    return one_line(json);
}

std::string boolean_text(const Options& options, const std::vector<OperandReport>& operands, const ResultReport& result,
                         const Seconds& seconds) {
    const std::size_t width = name_width(operands, result.file.size());
    const bool is_eval = options.command == Options::Command::eval;
    std::string text = (is_eval ? options.expression : std::string(operation_name(options))) + " of " +
                       std::to_string(operands.size()) + " operands, by the " + engine_name(options.engine) +
                       " engine\n";
    if (options.command == Options::Command::resolve) text = "resolve by the " + options.rule_name + " rule\n";
    for (const OperandReport& operand : operands) text += row(operand, width) + '\n';
    text += row(result, width) + ", " + (result.closed ? "closed" : "NOT CLOSED") + ", " +
            counted(result.components, "component", "components") + '\n';
    text += "  seconds: read " + seconds_text(seconds.read) + ", prepare " + seconds_text(seconds.prepare) +
            ", operate " + seconds_text(seconds.operate) + ", export " + seconds_text(seconds.export_) + ", write " +
            seconds_text(seconds.write) + '\n';
    return text;
}

std::string info_text(const std::vector<OperandReport>& operands) {
    const std::size_t width = name_width(operands);
    std::string text;
    for (const OperandReport& operand : operands) text += row(operand, width).substr(2) + '\n';
    return text;
}

std::string tolerated_text(const std::string& file, const cleave::MeshReport& report) {
    std::string text;
    const auto add = [&](MeshDefect kind, const char* one, const char* many) {
        if (const std::size_t n = report.count(kind); n != 0)
            text += "note: " + file + ": " + counted(n, one, many) + '\n';
    };
    add(MeshDefect::too_few_corners, "face with fewer than three different corners was left out",
        "faces with fewer than three different corners were left out");
    add(MeshDefect::zero_area, "face without area was left out", "faces without area were left out");
    add(MeshDefect::repeated_corner, "face that repeats a corner was read without the repetition",
        "faces that repeat a corner were read without the repetition");
    add(MeshDefect::not_planar, "face that is not flat was split into triangles",
        "faces that are not flat were split into triangles");
    add(MeshDefect::crossing_outline, "flat face whose outline crosses itself was split into triangles",
        "flat faces whose outlines cross themselves were split into triangles");
    return text;
}

std::string rounding_text(const std::string& file, const cleave::RoundingReport& rounding) {
    if (rounding.points_merged == 0) return {};
    std::string text = "note: " + file + ": rounding to doubles merged " +
                       counted(rounding.points_merged, "point", "points") + " with others";
    if (rounding.faces_vanished != 0)
        text += ", and " + counted(rounding.faces_vanished, "triangle", "triangles") + " vanished";
    return text + "; --rational writes the exact result\n";
}

std::string rounding_text(const std::string& file, const cleave::StlRounding& rounding) {
    if (rounding.rounded_coordinates == 0) return {};
    std::string text = "note: " + file + ": STL holds single precision: " +
                       counted(rounding.rounded_coordinates, "coordinate was", "coordinates were") + " rounded";
    if (rounding.lost_triangles != 0)
        text += ", and " + counted(rounding.lost_triangles, "triangle", "triangles") + " vanished";
    return text + "; OFF and OBJ keep doubles\n";
}

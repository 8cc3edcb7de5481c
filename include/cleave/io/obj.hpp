// SPDX-License-Identifier: Apache-2.0
/// The OBJ format (Wavefront): reading and writing the polygon meshes in it.
///
/// Read: `v` (what follows its three coordinates, a weight or a colour, is passed over), `f` with indices `v`, `v/t`,
/// `v//n`, `v/t/n`, counted from 1 or backwards from the latest vertex (negative), lines continued by a backslash,
/// comments from '#'. Passed over: textures, normals, groups, materials, points, lines. Refused with a message:
/// free-form curves and surfaces, and words that are none of the format's. Fractions `p/q` are coordinates as in
/// off.hpp.
#ifndef CLEAVE_IO_OBJ_HPP
#define CLEAVE_IO_OBJ_HPP

#include <cleave/io/coordinate.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/io/text_writer.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Statements that carry no polygon. `call` and `csh`, which bring in other files, are not among them.
[[nodiscard]] inline bool is_harmless_in_obj(std::string_view word) {
    constexpr std::array<std::string_view, 23> words{
        "vt",       "vn",         "vp",        "g",     "s",     "o",   "mg",    "usemtl",
        "mtllib",   "usemap",     "maplib",    "l",     "p",     "lod", "bevel", "c_interp",
        "d_interp", "shadow_obj", "trace_obj", "ctech", "stech", "bzp", "cdc"};
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Statements of free-form geometry, whose surfaces would be silently missing.
[[nodiscard]] inline bool is_free_form_in_obj(std::string_view word) {
    constexpr std::array<std::string_view, 15> words{"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf", "parm",
                                                     "trim",   "hole", "scrv", "sp",   "end",  "con",   "res"};
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The vertex of a face corner `v`, `v/t`, `v//n` or `v/t/n`. Positive indices may run ahead of the vertices read so
/// far: they are checked at the end.
[[nodiscard]] inline std::uint32_t read_obj_corner(const TextReader& reader, std::string_view word,
                                                   std::size_t point_count, std::size_t face) {
    const std::string_view text = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), index);
    if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size()) {
        reader.fail_expected("a vertex index of face " + std::to_string(face), word);
    }
    if (index == 0) reader.fail("face " + std::to_string(face) + " has vertex index 0; OBJ counts from 1");
    if (index < 0) index += static_cast<std::int64_t>(point_count) + 1;
    if (index <= 0 || index > std::numeric_limits<std::uint32_t>::max()) {
        reader.fail("face " + std::to_string(face) + " has vertex index " + std::string(text) + ", but " +
                    std::to_string(point_count) + " vertices come before it");
    }
    return static_cast<std::uint32_t>(index - 1);
}

}  // namespace detail

/// The mesh in an OBJ text. `file` is the name for messages; `origin`, if given, receives it and the line of each point
/// and face. Messages count vertices and faces from 0, like the mesh.
/// Throws: FileError with the line, what was expected, and what was found.
template <class T = double>
[[nodiscard]] PolygonMesh<T> read_obj(std::string_view text, const std::string& file = "OBJ text",
                                      MeshOrigin* origin = nullptr) {
    TextReader reader(text, file, '#', TextReader::Lines::continued);
    PolygonMesh<T> mesh;
    MeshOrigin lines{file, {}, {}};
    std::uint32_t largest = 0;  // index asked for so far
    std::size_t largest_in_face = 0;
    do {
        const std::string_view word = reader.word();
        const auto line = static_cast<std::uint32_t>(reader.line());
        if (word == "v") {
            const std::size_t i = mesh.points.size();
            auto& point = mesh.points.emplace_back();
            for (std::size_t axis = 0; axis < 3; ++axis) read_coordinate(reader, reader.word(), i, axis, point[axis]);
            while (!reader.word().empty()) continue;
            if (origin != nullptr) lines.point_lines.push_back(line);
        } else if (word == "f" || word == "fo") {
            const std::size_t f = mesh.face_count();
            lines.face_lines.push_back(line);
            for (std::string_view corner = reader.word(); !corner.empty(); corner = reader.word()) {
                const std::uint32_t index = detail::read_obj_corner(reader, corner, mesh.point_count(), f);
                if (index > largest) {
                    largest = index;
                    largest_in_face = f;
                }
                mesh.corners.push_back(index);
            }
            if (mesh.corners.size() == mesh.first.back()) {
                reader.fail("face " + std::to_string(f) + " has no corners");
            }
            mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        } else if (detail::is_free_form_in_obj(word)) {
            reader.fail("free-form geometry (" + quote_word(word) + ") is not supported; convert it to polygons");
        } else if (!word.empty()) {
            if (!detail::is_harmless_in_obj(word)) {
                reader.fail_expected("a statement of the OBJ format, such as v or f", word);
            }
            while (!reader.word().empty()) continue;  // to the end of its last continuation line
        }
    } while (reader.next_line());
    if (mesh.face_count() != 0 && largest >= mesh.point_count()) {
        throw FileError(file, lines.face_lines[largest_in_face],
                        "face " + std::to_string(largest_in_face) + " has vertex index " +
                            std::to_string(std::uint64_t{largest} + 1) + ", but the file has " +
                            std::to_string(mesh.point_count()) + " vertices");
    }
    if (origin != nullptr) *origin = std::move(lines);
    return mesh;
}

/// The mesh as OBJ text. Doubles are written so that they read back as the same doubles, rationals as `p/q`.
template <class T>
[[nodiscard]] std::string write_obj(const PolygonMesh<T>& mesh) {
    TextWriter out;
    out.reserve(64 * mesh.point_count() + 8 * mesh.corners.size() + 64);
    for (const auto& p : mesh.points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        if (face.empty()) continue;  // has no place in the format
        out << 'f';
        for (const std::uint32_t corner : face) out << ' ' << std::uint64_t{corner} + 1;
        out << '\n';
    }
    return out.take();
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// The OFF format (Geomview's Object File Format, text form): reading and writing polygon meshes.
///
/// Read: header OFF, or COFF, NOFF, STOFF and their combinations, whose colours, normals and texture coordinates are
/// passed over; the counts on the header's line or the next; comments from '#'; polygons of any size with or without a
/// colour after them. Refused with a message: binary files, and the 4- and n-dimensional variants. Coordinates may also
/// be fractions `p/q` where the mesh holds rationals; that is an extension, and how RationalMesh is written.
#ifndef CLEAVE_IO_OFF_HPP
#define CLEAVE_IO_OFF_HPP

#include <cleave/io/coordinate.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/io/text_writer.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Header of an OFF file: what stands on a vertex line besides three coordinates.
struct OffHeader {
    bool attributes = false;
};

/// Reads the keyword. It is optional in the format, but a file without it could be anything, so it is demanded here.
[[nodiscard]] inline OffHeader read_off_header(TextReader& reader) {
    const std::string_view word = reader.next_word();
    std::string_view prefix = word;
    if (!prefix.ends_with("OFF")) reader.fail_expected("the header OFF", word);
    prefix.remove_suffix(3);
    OffHeader header;
    if (prefix.starts_with("ST")) {
        header.attributes = true;
        prefix.remove_prefix(2);
    }
    for (const char c : prefix) {
        if (c == 'C' || c == 'N') {
            header.attributes = true;
        } else if (c == '4' || c == 'n') {
            reader.fail("header " + quote_word(word) +
                        " announces points that are not three-dimensional; expected OFF");
        } else {
            reader.fail_expected("the header OFF", word);
        }
    }
    return header;
}

/// A count from the counts line. It is not trusted further than the 32 bits that indices have.
[[nodiscard]] inline std::size_t read_off_count(const TextReader& reader, std::string_view word, const char* what) {
    const std::uint64_t count = read_index(reader, word, what);
    if (count > std::numeric_limits<std::uint32_t>::max()) {
        reader.fail(std::string(what) + " is " + std::to_string(count) + ", more than a mesh can hold");
    }
    return static_cast<std::size_t>(count);
}

}  // namespace detail

/// The mesh in an OFF text. `file` is the name for messages; `origin`, if given, receives it and the line of each point
/// and face. Throws: FileError with the line, what was expected, and what was found.
template <class T = double>
[[nodiscard]] PolygonMesh<T> read_off(std::string_view text, const std::string& file = "OFF text",
                                      MeshOrigin* origin = nullptr) {
    TextReader reader(text, file);
    const detail::OffHeader header = detail::read_off_header(reader);
    std::string_view word = reader.next_word();
    if (word == "BINARY") reader.fail("binary OFF is not supported; convert the file to text");
    if (word.empty()) reader.fail("expected the counts of vertices, faces and edges, found the end of the file");
    const std::size_t point_count = detail::read_off_count(reader, word, "the number of vertices");
    const std::size_t face_count = detail::read_off_count(reader, reader.word(), "the number of faces");
    // The number of edges is often wrong and sometimes missing; nothing depends on it.
    if (!reader.at_line_end()) (void)read_index(reader, reader.word(), "the number of edges");
    if (!reader.at_line_end()) reader.fail_expected("the end of the counts line", reader.word());

    PolygonMesh<T> mesh;
    // Counts may lie, so memory is asked for by what the file can hold: "0 0 0" and "3 0 1 2", each with a line end.
    mesh.points.reserve(std::min(point_count, reader.bytes_left() / 6 + 1));
    mesh.first.reserve(std::min(face_count, reader.bytes_left() / 8) + 1);
    mesh.corners.reserve(3 * std::min(face_count, reader.bytes_left() / 8));
    if (origin != nullptr) *origin = {file, {}, {}};
    for (std::size_t i = 0; i < point_count; ++i) {
        auto& point = mesh.points.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string_view coordinate = axis == 0 ? reader.next_word() : reader.word();
            if (axis == 0 && coordinate.empty()) {
                reader.fail("expected vertex " + std::to_string(i) + " of " + std::to_string(point_count) +
                            ", found the end of the file");
            }
            read_coordinate(reader, coordinate, i, axis, point[axis]);
        }
        if (origin != nullptr) origin->point_lines.push_back(static_cast<std::uint32_t>(reader.line()));
        if (header.attributes) {
            (void)reader.rest_of_line();
        } else if (!reader.at_line_end()) {
            reader.fail_expected("the end of the line after the three coordinates of vertex " + std::to_string(i) +
                                     " (a header COFF or NOFF would announce colours or normals)",
                                 reader.word());
        }
    }
    for (std::size_t f = 0; f < face_count; ++f) {
        word = reader.next_word();
        if (word.empty()) {
            reader.fail("expected face " + std::to_string(f) + " of " + std::to_string(face_count) +
                        ", found the end of the file");
        }
        if (origin != nullptr) origin->face_lines.push_back(static_cast<std::uint32_t>(reader.line()));
        const std::uint64_t size = read_index(reader, word, "the number of corners of face", f);
        if (size > std::numeric_limits<std::uint32_t>::max() - mesh.corners.size()) {
            reader.fail("face " + std::to_string(f) + " has " + std::to_string(size) + " corners, too many for a mesh");
        }
        for (std::uint64_t c = 0; c < size; ++c) {
            word = reader.word();
            const std::uint64_t index = read_index(reader, word, "a vertex index of face", f);
            if (index >= point_count) {
                reader.fail("face " + std::to_string(f) + " has vertex index " + std::to_string(index) + ", but the " +
                            std::to_string(point_count) + " vertices are numbered from 0");
            }
            mesh.corners.push_back(static_cast<std::uint32_t>(index));
        }
        mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        (void)reader.rest_of_line();  // a colour
    }
    word = reader.next_word();
    if (!word.empty()) {
        reader.fail_expected("the end of the file after " + std::to_string(face_count) + " faces", word);
    }
    return mesh;
}

/// The mesh as OFF text. Doubles are written so that they read back as the same doubles, rationals as `p/q`.
template <class T>
[[nodiscard]] std::string write_off(const PolygonMesh<T>& mesh) {
    TextWriter out;
    out.reserve(64 * mesh.point_count() + 8 * mesh.corners.size() + 64);
    out << "OFF\n" << std::uint64_t{mesh.point_count()} << ' ' << std::uint64_t{mesh.face_count()} << " 0\n";
    for (const auto& p : mesh.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        out << std::uint64_t{face.size()};
        for (const std::uint32_t corner : face) out << ' ' << corner;
        out << '\n';
    }
    return out.take();
}

CLEAVE_END_NAMESPACE

#endif

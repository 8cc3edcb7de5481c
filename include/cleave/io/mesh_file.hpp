// SPDX-License-Identifier: Apache-2.0
/// `read_mesh` and `write_mesh`: mesh files, the format chosen by the name's extension.
#ifndef CLEAVE_IO_MESH_FILE_HPP
#define CLEAVE_IO_MESH_FILE_HPP

#include <cleave/base/error.hpp>
#include <cleave/io/obj.hpp>
#include <cleave/io/off.hpp>
#include <cleave/io/output_file.hpp>
#include <cleave/io/stl.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

CLEAVE_BEGIN_NAMESPACE

/// The formats that are read and written.
enum class MeshFormat : std::uint8_t { off, obj, stl };

/// The format that a file's extension names, in capitals or not. Throws: FileError for any other extension.
[[nodiscard]] inline MeshFormat mesh_format(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (detail::equal_ignoring_case(extension, ".off")) return MeshFormat::off;
    if (detail::equal_ignoring_case(extension, ".obj")) return MeshFormat::obj;
    if (detail::equal_ignoring_case(extension, ".stl")) return MeshFormat::stl;
    throw FileError(path.string(), 0,
                    (extension.empty() ? "has no extension" : "has the unknown extension " + quote_word(extension)) +
                        "; expected .off, .obj or .stl");
}

/// Reads a mesh: `read_mesh(path)` with doubles, `read_mesh<Rational>(path)` with exact rationals. `origin`, if given,
/// receives the name and the lines of points and faces, for `explain` and `require_valid`. The mesh is what the file
/// says; whether it bounds anything is for `validate`.
/// Throws: FileError, with file, line, what was expected and what was found.
template <class T = double>
[[nodiscard]] PolygonMesh<T> read_mesh(const std::filesystem::path& path, MeshOrigin* origin = nullptr) {
    const MeshFormat format = mesh_format(path);
    const std::string text = read_file(path);
    const std::string name = path.string();
    if (text.empty()) throw FileError(name, 0, "is empty");
    switch (format) {
        case MeshFormat::off:
            return read_off<T>(text, name, origin);
        case MeshFormat::obj:
            return read_obj<T>(text, name, origin);
        case MeshFormat::stl:
            break;
    }
    return read_stl<T>(text, name, origin);
}

/// Writes a mesh; the file appears complete or not at all. OFF and OBJ hold the mesh exactly (rationals as `p/q`, which
/// few other programs read); STL is binary and rounds, as the result says.
/// Throws: FileError where the file cannot be written, Error where the format cannot hold the mesh.
template <class T>
StlRounding write_mesh(const std::filesystem::path& path, const PolygonMesh<T>& mesh) {
    StlRounding rounding;
    switch (mesh_format(path)) {
        case MeshFormat::off:
            write_file(path, write_off(mesh));
            break;
        case MeshFormat::obj:
            write_file(path, write_obj(mesh));
            break;
        case MeshFormat::stl:
            write_file(path, write_stl(mesh, StlKind::binary, &rounding));
            break;
    }
    return rounding;
}

CLEAVE_END_NAMESPACE

#endif

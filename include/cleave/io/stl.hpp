// SPDX-License-Identifier: Apache-2.0
/// The STL format, text and binary: reading and writing triangles.
///
/// STL has no indices: corners at equal coordinates become one point. Its normals are not read, a triangle's side
/// follows from the order of its corners. Binary STL holds 32-bit floats, so writing one rounds: `StlRounding` says how
/// much. Text STL holds decimals; doubles are written so that they read back as the same doubles.
#ifndef CLEAVE_IO_STL_HPP
#define CLEAVE_IO_STL_HPP

#include <cleave/base/error.hpp>
#include <cleave/io/coordinate.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/io/text_writer.hpp>
#include <cleave/mesh/face_shape.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/weld.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The two kinds of STL files.
enum class StlKind : std::uint8_t { text, binary };

/// What writing an STL file changed.
struct StlRounding {
    std::size_t rounded_coordinates = 0;  ///< coordinates of points that are not exactly what was written
    std::size_t lost_triangles = 0;       ///< triangles two of whose corners round to the same point; left out

    [[nodiscard]] bool is_exact() const noexcept { return rounded_coordinates == 0; }
};

namespace detail {

inline constexpr std::size_t stl_header = 80, stl_prologue = 84, stl_triangle = 50;

[[nodiscard]] inline std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return value;
}

inline void append_little_endian(std::string& bytes, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
}

/// A file is binary where its size is what its count of triangles demands: text is out of the question then, because
/// its bytes 80 to 83 would be a count above 150 million. "solid" at the start means nothing, binary writers put it
/// there too; but text must start with it.
[[nodiscard]] inline bool is_binary_stl(std::string_view bytes) {
    if (bytes.size() < stl_prologue) return false;
    return bytes.size() - stl_prologue == std::uint64_t{little_endian(bytes, stl_header)} * stl_triangle;
}

[[nodiscard]] inline bool equal_ignoring_case(std::string_view word, std::string_view lower) {
    if (word.size() != lower.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i] >= 'A' && word[i] <= 'Z' ? static_cast<char>(word[i] - 'A' + 'a') : word[i];
        if (c != lower[i]) return false;
    }
    return true;
}

[[nodiscard]] inline Mesh read_binary_stl(std::string_view bytes, const std::string& file) {
    Mesh mesh;
    const std::uint32_t count = little_endian(bytes, stl_header);
    if (count > std::numeric_limits<std::uint32_t>::max() / 3) {
        throw FileError(file, 0, "has more triangles than a mesh can hold");
    }
    mesh.points.reserve(3 * std::size_t{count});
    for (std::uint32_t t = 0; t < count; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            auto& point = mesh.points.emplace_back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // Twelve bytes of normal, then the corners; two bytes of attributes at the end.
                const std::size_t at = stl_prologue + stl_triangle * std::size_t{t} + 12 + 12 * c + 4 * axis;
                point[axis] = static_cast<double>(std::bit_cast<float>(little_endian(bytes, at)));
                if (!std::isfinite(point[axis])) {
                    throw FileError(file, 0,
                                    "triangle " + std::to_string(t) + " has an infinite or NaN coordinate (byte " +
                                        std::to_string(at) + ")");
                }
            }
        }
    }
    return mesh;
}

inline void expect_word(TextReader& reader, std::string_view word, std::string_view expected) {
    if (!equal_ignoring_case(word, expected)) reader.fail_expected(quote_word(expected), word);
}

template <class T>
[[nodiscard]] PolygonMesh<T> read_text_stl(TextReader& reader, MeshOrigin* origin) {
    PolygonMesh<T> mesh;
    const auto word_of_file = [&](std::string_view expected) {
        const std::string_view word = reader.next_word();
        if (word.empty()) reader.fail("expected " + quote_word(expected) + ", found the end of the file");
        expect_word(reader, word, expected);
    };
    // Several solids in one file are one mesh.
    for (std::string_view word = reader.next_word(); !word.empty(); word = reader.next_word()) {
        expect_word(reader, word, "solid");
        (void)reader.rest_of_line();  // a name
        for (;;) {
            word = reader.next_word();
            if (word.empty()) reader.fail("expected 'facet' or 'endsolid', found the end of the file");
            if (equal_ignoring_case(word, "endsolid")) break;
            if (!equal_ignoring_case(word, "facet")) reader.fail_expected("'facet' or 'endsolid'", word);
            if (origin != nullptr) origin->face_lines.push_back(static_cast<std::uint32_t>(reader.line()));
            (void)reader.rest_of_line();  // the normal, which need not be right
            word_of_file("outer");
            word_of_file("loop");
            for (std::size_t c = 0; c < 3; ++c) {
                word_of_file("vertex");
                const std::size_t i = mesh.points.size();
                auto& point = mesh.points.emplace_back();
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    read_coordinate(reader, reader.word(), i, axis, point[axis]);
                }
                if (origin != nullptr) origin->point_lines.push_back(static_cast<std::uint32_t>(reader.line()));
            }
            word_of_file("endloop");
            word_of_file("endfacet");
        }
        (void)reader.rest_of_line();  // the name again
    }
    return mesh;
}

/// The mesh whose triangles are consecutive triples of points, equal points merged.
template <class T>
[[nodiscard]] PolygonMesh<T> weld_triples(PolygonMesh<T> soup, MeshOrigin* origin) {
    soup.corners.resize(soup.points.size());
    soup.first.resize(soup.points.size() / 3 + 1);
    for (std::size_t i = 0; i < soup.corners.size(); ++i) soup.corners[i] = static_cast<std::uint32_t>(i);
    for (std::size_t f = 0; f < soup.first.size(); ++f) soup.first[f] = static_cast<std::uint32_t>(3 * f);
    PolygonMesh<T> mesh = weld(soup);
    if (origin != nullptr && !origin->point_lines.empty()) {
        // The line of a point is that of its first mention: points are numbered in the order of those.
        std::vector<std::uint32_t> lines;
        for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
            if (mesh.corners[i] == lines.size()) lines.push_back(origin->point_lines[i]);
        }
        origin->point_lines = std::move(lines);
    }
    return mesh;
}

}  // namespace detail

/// The mesh in the bytes of an STL file of either kind. `file` is the name for messages; `origin`, if given, receives
/// it and, for text, the line of each point and face. Throws: FileError: with the line for text, with the two sizes for
/// a binary file that is cut off.
template <class T = double>
[[nodiscard]] PolygonMesh<T> read_stl(std::string_view bytes, const std::string& file = "STL data",
                                      MeshOrigin* origin = nullptr) {
    if (origin != nullptr) *origin = {file, {}, {}};
    if (detail::is_binary_stl(bytes)) {
        Mesh mesh = detail::weld_triples(detail::read_binary_stl(bytes, file), nullptr);
        if constexpr (std::is_same_v<T, double>) {
            return mesh;
        } else {
            PolygonMesh<T> exact;
            for (const auto& p : mesh.points) exact.points.push_back({T(p[0]), T(p[1]), T(p[2])});
            exact.corners = std::move(mesh.corners);
            exact.first = std::move(mesh.first);
            return exact;
        }
    }
    const bool text = bytes.find('\0') == std::string_view::npos;
    if (!text && bytes.size() >= detail::stl_prologue) {
        const std::uint64_t count = detail::little_endian(bytes, detail::stl_header);
        throw FileError(file, 0,
                        "is not a complete binary STL file: its count of " + std::to_string(count) +
                            " triangles takes " + std::to_string(detail::stl_prologue + count * detail::stl_triangle) +
                            " bytes, but it has " + std::to_string(bytes.size()));
    }
    TextReader reader(bytes, file, '\n');  // no comments in this format
    return detail::weld_triples(detail::read_text_stl<T>(reader, origin), origin);
}

/// The mesh as an STL file, its faces in triangles. `rounding`, if given, says what that changed: coordinates become
/// floats in a binary file and doubles in a text file, each the nearest. Triangles that lose a corner are left out,
/// which keeps the rest closed.
/// Throws: Error for a coordinate beyond the range of that type, or more triangles than the format can count.
/// Requires: finite points, and every corner refers to one.
template <class T>
[[nodiscard]] std::string write_stl(const PolygonMesh<T>& mesh, StlKind kind = StlKind::binary,
                                    StlRounding* rounding = nullptr) {
    StlRounding changes;
    Mesh rounded;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        auto& point = rounded.points.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const T& exact = mesh.points[i][axis];
            if constexpr (std::is_same_v<T, double>) {
                point[axis] = kind == StlKind::binary ? static_cast<double>(static_cast<float>(exact)) : exact;
            } else {
                // Once: a double on the way to a float would round twice.
                const Fraction f = number_traits<T>::to_fraction(exact);
                point[axis] = kind == StlKind::binary ? static_cast<double>(ratio_to_float(f.num, f.den))
                                                      : ratio_to_double(f.num, f.den);
            }
            if (!std::isfinite(point[axis])) {
                throw Error("point " + std::to_string(i) + " has a coordinate too large for STL; use OFF or OBJ");
            }
            if (T(point[axis]) != exact) ++changes.rounded_coordinates;
        }
    }
    // Triangles are those of the exact faces, whose corners are then moved.
    const SplitMesh<T> split = triangulate_faces(mesh);
    std::vector<IndexTriangle> triangles;
    for (std::size_t t = 0; t < split.mesh.face_count(); ++t) {
        const auto face = split.mesh.face(t);
        const auto &a = rounded.points[face[0]], &b = rounded.points[face[1]], &c = rounded.points[face[2]];
        if (a == b || b == c || c == a) {
            ++changes.lost_triangles;
        } else {
            triangles.push_back({face[0], face[1], face[2]});
        }
    }
    if (triangles.size() > std::numeric_limits<std::uint32_t>::max()) throw Error("too many triangles for STL");
    if (rounding != nullptr) *rounding = changes;

    // The normal is for readers who want one; computed in doubles, zero where that fails.
    const auto normal = [&](const IndexTriangle& t) {
        const auto &p = rounded.points[t[0]], &q = rounded.points[t[1]], &r = rounded.points[t[2]];
        std::array<double, 3> n;
        for (std::size_t x = 0; x < 3; ++x) {
            const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
            n[x] = (q[y] - p[y]) * (r[z] - p[z]) - (q[z] - p[z]) * (r[y] - p[y]);
        }
        const double length = std::hypot(n[0], n[1], n[2]);
        for (double& x : n) x = length > 0 && std::isfinite(length) ? x / length : 0;
        return n;
    };
    if (kind == StlKind::text) {
        TextWriter out;
        const auto put = [&](const std::array<double, 3>& p) {
            out << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
        };
        out << "solid cleave\n";
        for (const IndexTriangle& t : triangles) {
            out << "facet normal";
            put(normal(t));
            out << "outer loop\n";
            for (const std::uint32_t corner : t) {
                out << "vertex";
                put(rounded.points[corner]);
            }
            out << "endloop\nendfacet\n";
        }
        out << "endsolid cleave\n";
        return out.take();
    }
    std::string out("binary STL written by cleave");
    out.resize(detail::stl_header, ' ');
    out.reserve(detail::stl_prologue + detail::stl_triangle * triangles.size());
    detail::append_little_endian(out, static_cast<std::uint32_t>(triangles.size()));
    const auto put = [&](const std::array<double, 3>& p) {
        for (const double x : p) detail::append_little_endian(out, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    };
    for (const IndexTriangle& t : triangles) {
        put(normal(t));
        for (const std::uint32_t corner : t) put(rounded.points[corner]);
        out += std::string_view("\0\0", 2);
    }
    return out;
}

CLEAVE_END_NAMESPACE

#endif

// SPDX-License-Identifier: Apache-2.0
/// The boundary of a region in triangles: faces that are none are cut into triangles, each for itself.
#ifndef CLEAVE_MESH_BOUNDARY_TRIANGLES_HPP
#define CLEAVE_MESH_BOUNDARY_TRIANGLES_HPP

#include <cleave/base/error.hpp>
#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/mesh/boundary_points.hpp>
#include <cleave/mesh/triangulate.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/conform.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Conforming triangles of a region's boundary: three indices of its points each, and the source of each.
struct ConformingTriangles {
    std::vector<PointId> corners;
    std::vector<Source> sources;
};

namespace detail {

/// Faces of a boundary with their loops, one after the other.
struct FaceLoops {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> first_loop{0};    ///< face i has loops [first_loop[i], first_loop[i + 1])
    std::vector<std::uint32_t> first_corner{0};  ///< loop l has corners [first_corner[l], first_corner[l + 1])
    std::vector<PointId> corners;
    std::vector<PlaneId> edges;  ///< of the edge that starts at each corner; may be `no_id`, or all missing

    void end_loop() { first_corner.push_back(static_cast<std::uint32_t>(corners.size())); }
    void end_face(std::uint32_t face) {
        faces.push_back(face);
        first_loop.push_back(static_cast<std::uint32_t>(first_corner.size() - 1));
    }

    [[nodiscard]] bool is_triangle(std::size_t i) const {
        return first_corner[first_loop[i + 1]] - first_corner[first_loop[i]] == 3;
    }
    [[nodiscard]] std::span<const PointId> corners_of(std::size_t i) const {
        const std::uint32_t begin = first_corner[first_loop[i]];
        return std::span(corners).subspan(begin, first_corner[first_loop[i + 1]] - begin);
    }
};

/// Predicates in the plane of one face.
class FaceTests {
public:
    /// Face i of the loops.
    FaceTests(BoundaryPoints& points, const Boundary<3>& boundary, const FaceLoops& loops, std::size_t i)
        : points_(&points),
          boundary_(&boundary),
          loops_(&loops),
          index_(i),
          plane_(boundary.faces.faces[loops.faces[i]].plane),
          projection_(points.projection_of(plane_)) {}

    /// The lexicographic order of the projected points.
    [[nodiscard]] bool less(PointId p, PointId q) {
        if (p == q) return false;
        const Sign s = points_->compare(projection_.u, p, q);
        return s != Sign::zero ? s == Sign::minus : points_->compare(projection_.v, p, q) == Sign::minus;
    }

    /// The turn p, q, r as seen from outside.
    [[nodiscard]] Sign orient(PointId p, PointId q, PointId r) {
        return points_->turn(p, q, r, projection_, [&] { return are_on_one_line(p, q, r); });
    }

private:
    static constexpr std::size_t few = 16;  // corners that are looked through

    /// Planes other than the face's own on which a point is said to lie: each is a line of the face.
    struct Lines {
        std::array<std::uint32_t, 5> planes{};
        std::size_t count = 0;

        void add(std::uint32_t k) {
            if (count < planes.size()) planes[count++] = k;
        }
        [[nodiscard]] bool contain(std::uint32_t k) const {
            return std::find(planes.begin(), planes.begin() + std::ptrdiff_t(count), k) !=
                   planes.begin() + std::ptrdiff_t(count);
        }
    };

    /// Whether planes say so: those that the points were made of, and those of the edges that they end.
    [[nodiscard]] bool are_on_one_line(PointId p, PointId q, PointId r) const {
        const Lines of_p = lines(p);
        const Lines of_q = lines(q);
        const Lines of_r = lines(r);
        return std::any_of(of_p.planes.begin(), of_p.planes.begin() + std::ptrdiff_t(of_p.count),
                           [&](std::uint32_t k) { return of_q.contain(k) && of_r.contain(k); });
    }

    [[nodiscard]] Lines lines(PointId p) const {
        Lines lines;
        const auto add = [&](std::uint32_t k) {
            if (k != unoriented(plane_)) lines.add(k);
        };
        const PointRecord<3>& record = boundary_->points[p];
        if (record.kind == PointRecord<3>::Kind::meet)
            for (const std::uint32_t k : record.planes) add(k);
        const std::size_t first = loops_->first_loop[index_];
        const std::size_t last = loops_->first_loop[index_ + 1];
        if (loops_->edges.empty() || loops_->corners_of(index_).size() > few) return lines;
        for (std::size_t l = first; l < last; ++l) {
            const std::size_t begin = loops_->first_corner[l];
            const std::size_t end = loops_->first_corner[l + 1];
            for (std::size_t c = begin; c < end; ++c) {
                if (loops_->corners[c] != p) continue;
                for (const PlaneId h : {loops_->edges[c], loops_->edges[c == begin ? end - 1 : c - 1]})
                    if (h != no_id) add(unoriented(h));
            }
        }
        return lines;
    }

    BoundaryPoints* points_;
    const Boundary<3>* boundary_;
    const FaceLoops* loops_;
    std::size_t index_;
    PlaneId plane_;
    Projection projection_;
};

/// The triangles of one short loop by cutting ears that contain no other corner, not even on their edges. Returns:
/// whether that worked; it may not where the loop passes a point twice. Cost: cubic, but cheaper than a sweep for a few
/// corners.
inline bool cut_ears(FaceTests& tests, std::span<const PointId> corners, std::vector<IndexTriangle>& out) {
    constexpr std::size_t most = 8;
    if (corners.size() > most) return false;
    std::array<std::uint32_t, most> rest{};
    std::copy(corners.begin(), corners.end(), rest.begin());
    std::size_t n = corners.size();
    const std::size_t before = out.size();
    const auto is_ear = [&](std::size_t i) {
        const std::uint32_t p = rest[(i + n - 1) % n];
        const std::uint32_t q = rest[i];
        const std::uint32_t r = rest[(i + 1) % n];
        if (tests.orient(p, q, r) != Sign::plus) return false;
        for (std::size_t k = 2; k + 1 < n; ++k) {
            const std::uint32_t x = rest[(i + k) % n];
            if (tests.orient(p, q, x) != Sign::minus && tests.orient(q, r, x) != Sign::minus &&
                tests.orient(r, p, x) != Sign::minus)
                return false;
        }
        return true;
    };
    for (; n > 3; --n) {
        std::size_t i = 0;
        while (i < n && !is_ear(i)) ++i;
        if (i == n) break;
        out.push_back({rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]});
        std::copy(rest.begin() + std::ptrdiff_t(i) + 1, rest.begin() + std::ptrdiff_t(n),
                  rest.begin() + std::ptrdiff_t(i));
    }
    if (n == 3 && tests.orient(rest[0], rest[1], rest[2]) == Sign::plus) {
        out.push_back({rest[0], rest[1], rest[2]});
        return true;
    }
    out.resize(before);
    return false;
}

/// The triangles of some faces, one after the other.
struct FacePieces {
    std::vector<IndexTriangle> triangles;
    std::vector<std::uint32_t> count;    ///< by face
    std::size_t crossing = no_crossing;  ///< the first face whose edges cross; nothing comes after it

    static constexpr std::size_t no_crossing = ~std::size_t(0);
};

inline FacePieces triangulate_faces(const Boundary<3>& boundary, const FaceLoops& loops, std::size_t begin,
                                    std::size_t end) {
    FacePieces pieces;
    BoundaryPoints points(boundary);
    Triangulator triangulator;
    std::vector<std::uint32_t> first;
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t before = pieces.triangles.size();
        const std::span<const PointId> corners = loops.corners_of(i);
        if (loops.is_triangle(i)) {
            pieces.triangles.push_back({corners[0], corners[1], corners[2]});
        } else {
            FaceTests tests(points, boundary, loops, i);
            const std::uint32_t l = loops.first_loop[i];
            first.clear();
            for (std::uint32_t k = l; k <= loops.first_loop[i + 1]; ++k)
                first.push_back(loops.first_corner[k] - loops.first_corner[l]);
            const bool done =
                (first.size() == 2 && cut_ears(tests, corners, pieces.triangles)) ||
                triangulator.triangulate(
                    corners, first, [&](PointId p, PointId q, PointId r) { return tests.orient(p, q, r); },
                    [&](PointId p, PointId q) { return tests.less(p, q); }, pieces.triangles);
            if (!done) {
                pieces.crossing = loops.faces[i];
                return pieces;
            }
        }
        pieces.count.push_back(static_cast<std::uint32_t>(pieces.triangles.size() - before));
    }
    return pieces;
}

/// The triangles of `loops` in the place of their faces, all other faces as they are.
inline ConformingTriangles put_together(const Boundary<3>& boundary, const FaceLoops& loops, ExecutorRef executor) {
    constexpr std::size_t grain = std::size_t(1) << 7U;
    std::vector<FacePieces> pieces(chunk_count(loops.faces.size(), grain));
    for_each_chunk(executor, loops.faces.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t c) {
        pieces[c] = triangulate_faces(boundary, loops, begin, end);
    });
    std::size_t count = boundary.faces.faces.size() - loops.faces.size();
    for (const FacePieces& p : pieces) {
        if (p.crossing != FacePieces::no_crossing)
            throw Error("face " + std::to_string(p.crossing) +
                        " of the region has crossing edges: an operand intersected itself; check the operands");
        count += p.triangles.size();
    }
    // For each run of faces: `as_it_is(face)`, or `cut(triangles)` of one that was cut.
    const auto for_each_face = [&](auto&& as_it_is, auto&& cut) {
        std::uint32_t f = 0;
        for (std::size_t c = 0; c < pieces.size(); ++c) {
            std::size_t t = 0;
            for (std::size_t i = 0; i < pieces[c].count.size(); ++i) {
                for (const std::uint32_t face = loops.faces[c * grain + i]; f < face; ++f) as_it_is(f);
                cut(f++, std::span(pieces[c].triangles).subspan(t, pieces[c].count[i]));
                t += pieces[c].count[i];
            }
        }
        for (; f < boundary.faces.faces.size(); ++f) as_it_is(f);
    };
    ConformingTriangles out;
    const FaceList& list = boundary.faces;
    const auto fill_corners = [&] {
        out.corners.resize(3 * count);
        PointId* to = out.corners.data();
        for_each_face(
            [&](std::uint32_t f) {
                const Corner* const c = list.corners.data() + list.loop_first[list.faces[f].first_loop];
                for (std::size_t i = 0; i < 3; ++i) *to++ = c[i].point;
            },
            [&](std::uint32_t, std::span<const IndexTriangle> triangles) {
                for (const IndexTriangle& t : triangles) to = std::copy(t.begin(), t.end(), to);
            });
    };
    const auto fill_sources = [&] {
        out.sources.resize(count);
        Source* to = out.sources.data();
        for_each_face([&](std::uint32_t f) { *to++ = list.faces[f].source; },
                      [&](std::uint32_t f, std::span<const IndexTriangle> triangles) {
                          to = std::fill_n(to, triangles.size(), list.faces[f].source);
                      });
    };
    executor.invoke(fill_corners, fill_sources);
    return out;
}

}  // namespace detail

/// The faces of a boundary that conforms in triangles. Requires: finite, and conforming as it is.
/// Throws: Error where edges of a face cross.
[[nodiscard]] inline ConformingTriangles triangulate_conforming(const Boundary<3>& boundary, ExecutorRef executor) {
    detail::FaceLoops loops;
    for (std::uint32_t f = 0; f < boundary.faces.faces.size(); ++f) {
        const FaceList::Face& face = boundary.faces.faces[f];
        if (face.loop_count == 1 && boundary.faces.loop(face.first_loop).size() == 3) continue;
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            for (const Corner& c : boundary.faces.loop(l)) {
                loops.corners.push_back(c.point);
                loops.edges.push_back(c.edge);
            }
            loops.end_loop();
        }
        loops.end_face(f);
    }
    return detail::put_together(boundary, loops, executor);
}

/// The faces of any boundary in triangles that conform. Every vertex that lies on an edge is used.
/// Requires: finite and complete. Throws: Error where edges of a face cross.
[[nodiscard]] inline ConformingTriangles triangulate_boundary(const Boundary<3>& boundary, ExecutorRef executor) {
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    Conformer conformer(kernel, boundary, loaded);
    detail::FaceLoops loops;
    for (std::uint32_t f = 0; f < boundary.faces.faces.size(); ++f) {
        const FaceList::Face& face = boundary.faces.faces[f];
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            const std::span<const PointId> loop = conformer.loop(l);
            loops.corners.insert(loops.corners.end(), loop.begin(), loop.end());
            loops.end_loop();
        }
        loops.end_face(f);
    }
    return detail::put_together(boundary, loops, executor);
}

CLEAVE_END_NAMESPACE

#endif

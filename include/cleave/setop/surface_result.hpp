// SPDX-License-Identifier: Apache-2.0
/// The boundary that a localised evaluation puts together: faces that pass by index, and new ones in the kernel's ids.
#ifndef CLEAVE_SETOP_SURFACE_RESULT_HPP
#define CLEAVE_SETOP_SURFACE_RESULT_HPP

#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/region/surface_operands.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Notes which faces there will be, and puts them together at the end, when all sizes are known: points and planes in
/// the order of the operands', common points last. Pieces of that run side by side; what they give does not depend on
/// how.
class SurfaceResult {
public:
    explicit SurfaceResult(SurfaceOperands& operands) : operands_(&operands) {}

    /// Faces first ... last - 1 of operand i as they are, or turned round.
    void add_copies(std::uint32_t i, std::uint32_t first, std::uint32_t last, bool flip) {
        if (first == last) return;
        if (!runs_.empty() && runs_.back().operand == i && runs_.back().last == first && runs_.back().flip == flip)
            runs_.back().last = last;
        else
            runs_.push_back({i, first, last, flip, {}});
    }

    /// The faces that `make` appends to a list, with points and planes of the kernel; edges of input meshes may lack
    /// theirs.
    template <class Make>
    void add_faces(Make&& make) {
        const auto first = static_cast<std::uint32_t>(made_.faces.size());
        make(made_);
        add_copies(no_id, first, static_cast<std::uint32_t>(made_.faces.size()), false);
    }

    /// The boundary. Tells `progress` of `share` units of work. Throws: Cancelled. Cost: linear in the result, and in
    /// the points and planes of the operands and the kernel.
    [[nodiscard]] Boundary<3> finish(bool value_at_infinity, ExecutorRef executor, ProgressReporter* progress,
                                     std::size_t share) {
        executor_ = executor;
        progress_ = progress;
        const auto advance = [&](std::size_t units) {
            if (progress != nullptr) progress->advance(units);
        };
        kernel_slots_ = operands_->vertex_count();
        out_.value_at_infinity = value_at_infinity;
        out_.is_complete = false;
        out_.is_conforming = true;
        place_runs();
        mark();
        advance(share / 4);
        number_points();
        intern_planes();
        advance(share / 4);
        fill_points();
        advance(share / 4);
        fill_faces();
        advance(share - share / 4 * 3);
        return std::move(out_);
    }

private:
    static constexpr std::size_t grain = 8192;  // faces or points that are worth a piece of work

    /// Sizes, or places in the result's lists.
    struct Extent {
        std::size_t faces = 0, loops = 0, corners = 0;
    };

    /// Faces that follow each other in a list and in the result: an operand's, or made ones (`operand` is `no_id`).
    struct Run {
        std::uint32_t operand, first, last;
        bool flip;
        Extent at;  // in the result
    };

    [[nodiscard]] const FaceList& list(const Run& run) const {
        return run.operand == no_id ? made_ : operands_->boundary(run.operand).faces;
    }

    /// The loops and corners of a list's faces before f.
    static Extent before(const FaceList& list, std::uint32_t f) {
        const std::size_t loops = f == list.faces.size() ? list.loop_first.size() - 1 : list.faces[f].first_loop;
        return {f, loops, list.loop_first[loops]};
    }

    void place_runs() {
        Extent at;
        for (Run& run : runs_) {
            run.at = at;
            const Extent from = before(list(run), run.first);
            const Extent to = before(list(run), run.last);
            at.faces += to.faces - from.faces;
            at.loops += to.loops - from.loops;
            at.corners += to.corners - from.corners;
        }
        size_ = at;
    }

    void throw_if_stopped() const {
        if (progress_ != nullptr) progress_->throw_if_stopped();
    }

    /// Calls f(begin, end, chunk) for pieces of 0 ... n - 1.
    template <class F>
    void for_each_piece(std::size_t n, F&& f) const {
        for_each_chunk(executor_, n, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            throw_if_stopped();
            f(begin, end, chunk);
        });
    }

    /// Calls f(run, first, last) for the parts of runs, side by side.
    template <class F>
    void for_each_part(F&& f) const {
        for_each_piece(size_.faces, [&](std::size_t begin, std::size_t end, std::size_t) {
            auto run = std::upper_bound(runs_.begin(), runs_.end(), begin,
                                        [](std::size_t n, const Run& r) { return n < r.at.faces; }) -
                       1;
            for (; begin < end; ++run) {
                const std::size_t first = run->first + (begin - run->at.faces);
                const std::size_t last = std::min<std::size_t>(run->last, first + (end - begin));
                f(*run, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last));
                begin += last - first;
            }
        });
    }

    // --- points and planes that are needed ---------------------------------------------------------------------------

    /// A slot for each vertex of the operands, numbered through, and then for each point of the kernel. A point that is
    /// both has the slot of the first vertex that became it.
    [[nodiscard]] std::size_t kernel_slot(PointId p) const {
        const std::uint32_t origin = operands_->origin(p);
        return origin != no_id ? origin : kernel_slots_ + p;
    }

    /// Where the slots of a list's points begin that their faces refer to: an operand's, or the kernel's (`no_id`). An
    /// operand's vertex that has another slot is dealt with apart (`for_each_elsewhere`).
    [[nodiscard]] std::size_t slot(std::uint32_t i, PointId p) const {
        return i == no_id ? kernel_slot(p) : operands_->vertex(i, p);
    }

    /// Calls f(own, slot) for the vertices whose slot is not their own.
    template <class F>
    void for_each_elsewhere(F&& f) const {
        for (std::uint32_t i = 0; i < operands_->count(); ++i)
            for_each_piece(operands_->boundary(i).points.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
                for (auto p = static_cast<PointId>(begin); p < end; ++p) {
                    const PointId known = operands_->known_point(i, p);
                    if (known == no_id) continue;
                    const std::size_t own = operands_->vertex(i, p);
                    if (const std::size_t slot = kernel_slot(known); slot != own) f(own, slot);
                }
            });
    }

    /// Whoever marks an entry says the same; pieces may do so at once.
    static void mark(std::uint32_t& entry) { std::atomic_ref(entry).store(0, std::memory_order_relaxed); }

    void mark_plane(std::uint32_t i, PlaneId h) {
        if (h != no_id) mark(planes_[first_plane(i) + unoriented(h)]);
    }

    /// Where the planes of an operand's table, or the kernel's (`no_id`), begin in `planes_`.
    [[nodiscard]] std::size_t first_plane(std::uint32_t i) const {
        return i == no_id ? first_plane_.back() : first_plane_[i];
    }

    void mark() {
        Kernel<3>& kernel = operands_->kernel();
        std::size_t planes = 0;
        for (std::uint32_t i = 0; i < operands_->count(); ++i) {
            first_plane_.push_back(planes);
            planes += operands_->boundary(i).planes.size();
        }
        first_plane_.push_back(planes);
        planes_.assign(planes + kernel.planes.size(), no_id);
        points_.assign(kernel_slots_ + kernel.point_count(), no_id);
        for_each_part([&](const Run& run, std::uint32_t first, std::uint32_t last) {
            const FaceList& faces = list(run);
            for (std::uint32_t f = first; f < last; ++f) {
                mark_plane(run.operand, faces.faces[f].plane);
                for (const Corner& c : faces.corners_of(f)) {
                    mark(points_[slot(run.operand, c.point)]);
                    mark_plane(run.operand, c.edge);
                }
            }
        });
        // Nobody's slot is elsewhere's, so pieces do not disturb each other.
        for_each_elsewhere([&](std::size_t own, std::size_t slot) {
            if (points_[own] == no_id) return;
            points_[own] = no_id;
            mark(points_[slot]);
        });
        for (PointId p = 0; p < kernel.point_count(); ++p)
            if (points_[kernel_slot(p)] != no_id && !(kernel.point(p).error < std::numeric_limits<double>::infinity()))
                kernel.refine(p);
    }

    /// Where a point's record is: in the kernel (`operand` is `no_id`), or in an operand.
    struct Place {
        std::uint32_t operand;
        PointId point;
    };

    /// Calls f(slot, place) for the points of the result in a range of slots.
    template <class F>
    void for_each_point(std::size_t begin, std::size_t end, F&& f) const {
        std::uint32_t i = 0;
        for (std::size_t s = begin; s < end; ++s) {
            if (points_[s] == no_id) continue;
            if (s >= kernel_slots_) {
                f(s, Place{no_id, static_cast<PointId>(s - kernel_slots_)});
                continue;
            }
            while (i + 1 < operands_->count() && s >= operands_->vertex(i + 1, 0)) ++i;
            const auto p = static_cast<PointId>(s - operands_->vertex(i, 0));
            const PointId known = operands_->known_point(i, p);
            f(s, known != no_id ? Place{no_id, known} : Place{i, p});
        }
    }

    [[nodiscard]] const PointRecord<3>& record(const Place& at) const {
        return at.operand == no_id ? operands_->kernel().point(at.point)
                                   : operands_->boundary(at.operand).points[at.point];
    }

    /// A meet's exact coordinates are made again if they are needed; its rounded ones stay.
    static bool keeps_exact(const PointRecord<3>& r) {
        return r.exact != no_id && r.kind == PointRecord<3>::Kind::integers;
    }

    void number_points() {
        struct Count {
            std::uint32_t points = 0, exact = 0;
        };
        std::vector<Count> first(chunk_count(points_.size(), grain));
        for_each_piece(points_.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            Count count;
            for_each_point(begin, end, [&](std::size_t, const Place& at) {
                const PointRecord<3>& r = record(at);
                ++count.points;
                if (keeps_exact(r)) ++count.exact;
                if (r.kind != PointRecord<3>::Kind::meet) return;
                for (const std::uint32_t k : r.planes) mark_plane(at.operand, 2 * k);
            });
            first[chunk] = count;
        });
        Count all;
        for (Count& count : first) {
            const Count here = count;
            count = all;
            all.points += here.points;
            all.exact += here.exact;
            first_exact_.push_back(count.exact);
        }
        make_room(all.points, all.exact);
        for_each_piece(points_.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            std::uint32_t number = first[chunk].points;
            for (std::size_t s = begin; s < end; ++s)
                if (points_[s] != no_id) points_[s] = number++;
        });
    }

    /// Fresh memory costs about as much as what is written there: the lists share the threads.
    void make_room(std::size_t points, std::size_t exact) {
        const auto lengthen = [&](auto& list, std::size_t size) {
            list.reserve(size);
            while (list.size() < size) {
                throw_if_stopped();
                list.resize(std::min(size, list.size() + 16 * grain));
            }
        };
        executor_.for_each_index(3, [&](std::size_t which) {
            if (which == 0) {
                lengthen(out_.points, points);
                lengthen(out_.exact, exact);
            } else if (which == 1) {
                lengthen(out_.faces.faces, size_.faces);
            } else {
                lengthen(out_.faces.loop_first, size_.loops + 1);
                lengthen(out_.faces.corners, size_.corners);
            }
        });
    }

    void intern_planes() {
        for (std::uint32_t i = 0; i <= operands_->count(); ++i) {
            const bool is_kernel = i == operands_->count();
            const PlaneTable<3>& table = is_kernel ? operands_->kernel().planes : operands_->boundary(i).planes;
            for (std::uint32_t k = 0; k < table.size(); ++k) {
                if (k % grain == 0) throw_if_stopped();
                std::uint32_t& number = planes_[first_plane_[i] + k];
                if (number != no_id) number = out_.planes.intern_from(table, k);
            }
        }
    }

    [[nodiscard]] PlaneId plane(std::uint32_t i, PlaneId h) const {
        return h == no_id ? no_id : 2 * planes_[first_plane(i) + unoriented(h)] + (h & 1U);
    }

    // --- the lists ---------------------------------------------------------------------------------------------------

    void fill_points() {
        std::vector<Bounds<3>> bounds(chunk_count(points_.size(), grain));
        for_each_piece(points_.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            std::uint32_t next_exact = first_exact_[chunk];
            for_each_point(begin, end, [&](std::size_t s, const Place& at) {
                PointRecord<3>& r = out_.points[points_[s]];
                r = record(at);
                if (r.kind == PointRecord<3>::Kind::meet) {
                    for (std::uint32_t& k : r.planes) k = unoriented(plane(at.operand, 2 * k));
                } else {
                    r.planes.fill(no_id);
                }
                if (keeps_exact(r)) {
                    out_.exact[next_exact] = at.operand == no_id ? operands_->kernel().exact(at.point)
                                                                 : operands_->boundary(at.operand).exact[r.exact];
                    r.exact = next_exact++;
                } else {
                    r.exact = no_id;
                }
                bounds[chunk].include(r.approximation, r.error);
            });
        });
        for (const Bounds<3>& b : bounds) out_.bounds.include(b);
    }

    void fill_faces() {
        FaceList& out = out_.faces;
        for_each_elsewhere([&](std::size_t own, std::size_t slot) { points_[own] = points_[slot]; });
        for_each_part([&](const Run& run, std::uint32_t first, std::uint32_t last) {
            const FaceList& from = list(run);
            const Extent start = before(from, run.first);
            const Extent here = before(from, first);
            std::size_t f_out = run.at.faces + (first - run.first);
            std::size_t l_out = run.at.loops + (here.loops - start.loops);
            std::size_t c_out = run.at.corners + (here.corners - start.corners);
            std::vector<Corner> loop;
            for (std::uint32_t f = first; f < last; ++f) {
                const FaceList::Face& face = from.faces[f];
                if (face.plane == no_id) {  // a triangle; only operands have such
                    const Corner* const c = from.corners.data() + from.loop_first[face.first_loop];
                    const std::uint32_t* const number = points_.data() + operands_->vertex(run.operand, 0);
                    Corner* const to = out.corners.data() + c_out;
                    to[0] = {number[c[0].point], no_id};
                    to[run.flip ? 2 : 1] = {number[c[1].point], no_id};
                    to[run.flip ? 1 : 2] = {number[c[2].point], no_id};
                    c_out += 3;
                    out.faces[f_out++] = {no_id, static_cast<std::uint32_t>(l_out), 1, {run.operand, f}};
                    out.loop_first[++l_out] = static_cast<std::uint32_t>(c_out);
                    continue;
                }
                PlaneId h = plane(run.operand, face.plane);
                if (run.flip && h != no_id) h = flipped(h);
                out.faces[f_out++] = {h, static_cast<std::uint32_t>(l_out), face.loop_count,
                                      run.operand == no_id ? face.source : Source{run.operand, f}};
                for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                    Corner* const to = out.corners.data() + c_out;
                    for (const Corner& c : from.loop(l))
                        out.corners[c_out++] = {points_[slot(run.operand, c.point)], plane(run.operand, c.edge)};
                    out.loop_first[++l_out] = static_cast<std::uint32_t>(c_out);
                    if (!run.flip) continue;
                    loop.assign(to, out.corners.data() + c_out);
                    reverse_loop<3>(loop);
                    std::copy(loop.begin(), loop.end(), to);
                }
            }
        });
    }

    SurfaceOperands* operands_;
    ExecutorRef executor_;
    const ProgressReporter* progress_ = nullptr;
    Boundary<3> out_;
    std::vector<Run> runs_;
    FaceList made_;
    Extent size_;
    std::size_t kernel_slots_ = 0;
    std::vector<std::uint32_t> points_;  // of each slot, to the result's
    std::vector<std::uint32_t> planes_;  // of the operands' tables and the kernel's
    std::vector<std::size_t> first_plane_;
    std::vector<std::uint32_t> first_exact_;  // of each piece of slots
};

CLEAVE_END_NAMESPACE

#endif

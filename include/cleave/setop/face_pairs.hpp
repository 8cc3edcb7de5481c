// SPDX-License-Identifier: Apache-2.0
/// Which faces of different operands can have something in common, by their boxes and then by their planes.
#ifndef CLEAVE_SETOP_FACE_PAIRS_HPP
#define CLEAVE_SETOP_FACE_PAIRS_HPP

#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/setop/face_contact.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Two faces that neither boxes nor planes keep apart, f of the operand that comes first.
struct FacePair {
    std::uint32_t i, j, f, g;
    FaceContact::PackedSigns signs;
};

/// Finds the pairs, operand by operand and ascending by face. Nothing but doubles is looked at where faces are
/// triangles of doubles, so pieces of the work run side by side; other pairs are decided in the operands' kernel.
class FacePairs {
public:
    using Bits = std::uint64_t;

    /// `progress` is asked whether to stop.
    FacePairs(SurfaceOperands& operands, FaceContact& contact, ExecutorRef executor, const ProgressReporter* progress)
        : operands_(&operands),
          contact_(&contact),
          executor_(executor),
          progress_(progress),
          neighbours_(operands.count(), 0),
          near_(operands.count()),
          boxes_(operands.count()) {
        find_neighbours();
        executor.for_each_index(operands.count(), [this](std::size_t i) { find_near(static_cast<std::uint32_t>(i)); });
        find_pairs();
        boxes_ = {};
    }

    /// The operands whose bounds meet those of operand i.
    [[nodiscard]] Bits neighbours(std::uint32_t i) const { return neighbours_[i]; }
    /// Faces of operand i whose boxes meet another operand's box, ascending.
    [[nodiscard]] std::span<const std::uint32_t> near(std::uint32_t i) const { return near_[i]; }
    [[nodiscard]] std::span<const FacePair> pairs() const noexcept { return pairs_; }
    /// Pairs whose boxes meet.
    [[nodiscard]] std::size_t box_pair_count() const noexcept { return box_pair_count_; }

private:
    static constexpr std::size_t grain = 4096;  // faces or pairs that are worth a piece of work
    static constexpr std::size_t boxes_between_polls = std::size_t(1) << 17U;

    void throw_if_stopped() const {
        if (progress_ != nullptr) progress_->throw_if_stopped();
    }

    void find_neighbours() {
        for (std::uint32_t j = 1; j < operands_->count(); ++j)
            for (std::uint32_t i = 0; i < j; ++i) {
                if (operands_->boundary(i).bounds.disjoint(operands_->boundary(j).bounds)) continue;
                neighbours_[i] |= Bits(1) << j;
                neighbours_[j] |= Bits(1) << i;
            }
    }

    [[nodiscard]] bool are_neighbours(std::uint32_t i, std::uint32_t j) const {
        return (neighbours_[i] >> j & 1U) != 0;
    }

    // --- faces near other operands -----------------------------------------------------------------------------------

    /// Lists the faces that may meet another operand, with their boxes. Where all corners of a face are beyond one side
    /// of the box around all neighbours, a bit for each side tells.
    void find_near(std::uint32_t i) {
        const Boundary<3>& b = operands_->boundary(i);
        std::vector<Bounds<3>> others;
        Bounds<3> all;
        for (std::uint32_t j = 0; j < operands_->count(); ++j)
            if (are_neighbours(i, j)) {
                others.push_back(operands_->boundary(j).bounds);
                all.include(others.back());
            }
        if (others.empty()) return;
        std::vector<std::uint8_t> beyond(b.points.size());
        for_each_chunk(executor_, b.points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t p = begin; p < end; ++p) beyond[p] = sides_beyond(b.points[p], all);
        });
        const auto may_meet = [&](std::uint32_t f) {
            std::uint8_t common = 0xff;
            for (const Corner& c : b.faces.corners_of(f)) common &= beyond[c.point];
            if (common != 0) return false;
            if (others.size() == 1) return true;
            const Bounds<3> box = box_of(b, f);
            return !std::all_of(others.begin(), others.end(), [&](const Bounds<3>& o) { return box.disjoint(o); });
        };
        throw_if_stopped();
        const std::size_t faces = b.faces.faces.size();
        std::vector<std::vector<std::uint32_t>> found(chunk_count(faces, grain));
        for_each_chunk(executor_, faces, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            std::vector<std::uint32_t>& out = found[chunk];
            for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
                if (may_meet(f)) out.push_back(f);
        });
        throw_if_stopped();
        std::vector<std::uint32_t>& near = near_[i];
        std::size_t count = 0;
        for (const auto& list : found) count += list.size();
        near.reserve(count);
        for (const auto& list : found) near.insert(near.end(), list.begin(), list.end());
        boxes_[i].resize(count);
        for_each_chunk(executor_, count, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t n = begin; n < end; ++n) boxes_[i][n] = {box_of(b, near[n]), near[n]};
        });
    }

    static Bounds<3> box_of(const Boundary<3>& b, std::uint32_t f) {
        Bounds<3> box;
        for (const Corner& c : b.faces.corners_of(f)) {
            const PointRecord<3>& r = b.points[c.point];
            if (r.error != 0) {
                box.include(r.approximation, r.error);
                continue;
            }
            for (std::size_t x = 0; x < 3; ++x) {
                box.lo[x] = std::min(box.lo[x], r.approximation[x]);
                box.hi[x] = std::max(box.hi[x], r.approximation[x]);
            }
        }
        return box;
    }

    /// A bit for each side of a box that a point is certainly beyond.
    static std::uint8_t sides_beyond(const PointRecord<3>& r, const Bounds<3>& box) {
        Bounds<3> at{r.approximation, r.approximation};
        if (r.error != 0) {
            at = {};
            at.include(r.approximation, r.error);
        }
        unsigned sides = 0;
        for (std::size_t x = 0; x < 3; ++x)
            sides |= unsigned(at.hi[x] < box.lo[x]) << x | unsigned(at.lo[x] > box.hi[x]) << (x + 3);
        return static_cast<std::uint8_t>(sides);
    }

    // --- pairs -------------------------------------------------------------------------------------------------------

    /// f and g in one number, which ascends by f, then by g.
    using Key = std::uint64_t;

    void find_pairs() {
        std::vector<NamedBox<3>> first, second;
        const auto reaching = [&](std::uint32_t i, std::uint32_t j, std::vector<NamedBox<3>>& out) {
            out.clear();
            const Bounds<3>& bounds = operands_->boundary(j).bounds;
            for (const NamedBox<3>& b : boxes_[i])
                if (!b.box.disjoint(bounds)) out.push_back(b);
        };
        for (std::uint32_t j = 1; j < operands_->count(); ++j)
            for (std::uint32_t i = 0; i < j; ++i) {
                if (!are_neighbours(i, j)) continue;
                if (operands_->count() == 2) {  // what is near is what reaches the other
                    first.swap(boxes_[0]);
                    second.swap(boxes_[1]);
                } else {
                    reaching(i, j, first);
                    reaching(j, i, second);
                }
                keys_.clear();
                for_each_piece(BoxGroup<3>(first), BoxGroup<3>(second));
                box_pair_count_ += keys_.size();
                throw_if_stopped();
                sort_keys(i);
                throw_if_stopped();
                compare_planes(i, j);
            }
    }

    /// Collects the pairs of boxes that meet. Halves go their own ways, on different threads where they are large: each
    /// with a copy of what both would reorder.
    void for_each_piece(BoxGroup<3> a, BoxGroup<3> b) {
        throw_if_stopped();
        const bool is_large = executor_.concurrency() > 1 && a.boxes.size() + b.boxes.size() >= 2 * grain;
        if (is_large) {
            const Bounds<3> of_a = a.bounds;
            const Bounds<3> of_b = b.bounds;
            executor_.invoke([&] { a.keep_meeting(of_b); }, [&] { b.keep_meeting(of_a); });
            if (a.boxes.empty() || b.boxes.empty()) return;
        } else if (!b.keep_meeting(a.bounds) || !a.keep_meeting(b.bounds)) {
            return;
        }
        if (!is_large) {
            std::vector<Key> found;
            std::size_t looked_at = 0;
            for_each_meeting_pair<3>(
                a.boxes, b.boxes, [&](std::uint32_t f, std::uint32_t g) { found.push_back(Key(f) << 32U | g); },
                [&](std::size_t boxes) {
                    looked_at += boxes;
                    if (looked_at < boxes_between_polls) return;
                    looked_at = 0;
                    throw_if_stopped();
                });
            const std::lock_guard<std::mutex> lock(mutex_);
            if (keys_.empty())
                keys_ = std::move(found);
            else
                keys_.insert(keys_.end(), found.begin(), found.end());
            return;
        }
        const bool split_a = a.boxes.size() >= b.boxes.size();
        const auto halves = (split_a ? a : b).split();
        const BoxGroup<3>& lower = halves.first;
        const BoxGroup<3>& upper = halves.second;
        const std::span<NamedBox<3>> shared = split_a ? b.boxes : a.boxes;
        std::vector<NamedBox<3>> copy;
        for (const NamedBox<3>& box : shared)
            if (!box.box.disjoint(upper.bounds)) copy.push_back(box);
        executor_.invoke(
            [&] {
                if (split_a)
                    for_each_piece(lower, b);
                else
                    for_each_piece(a, lower);
            },
            [&] {
                if (split_a)
                    for_each_piece(upper, BoxGroup<3>(copy));
                else
                    for_each_piece(BoxGroup<3>(copy), upper);
            });
    }

    /// By counting the first faces where there are many pairs, by comparing where there are few.
    void sort_keys(std::uint32_t i) {
        const std::size_t faces = operands_->boundary(i).faces.faces.size();
        if (keys_.size() < faces / 8 + 64) {
            std::sort(keys_.begin(), keys_.end());
            return;
        }
        std::vector<std::size_t> next(faces + 1, 0);
        for (const Key k : keys_) ++next[(k >> 32U) + 1];
        for (std::size_t f = 0; f < faces; ++f) next[f + 1] += next[f];
        std::vector<Key> sorted(keys_.size());
        for (const Key k : keys_) sorted[next[k >> 32U]++] = k;
        keys_.swap(sorted);
        // `next` now has the end of each face's pairs.
        for_each_chunk(executor_, faces, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t f = begin; f < end; ++f)
                std::sort(keys_.begin() + std::ptrdiff_t(f == 0 ? 0 : next[f - 1]),
                          keys_.begin() + std::ptrdiff_t(next[f]));
        });
    }

    void compare_planes(std::uint32_t i, std::uint32_t j) {
        std::vector<std::vector<FacePair>> found(chunk_count(keys_.size(), grain));
        for_each_chunk(executor_, keys_.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            throw_if_stopped();
            compare_planes(i, j, {keys_.data() + begin, end - begin}, found[chunk]);
        });
        for (std::vector<FacePair>& list : found)
            for (FacePair& p : list) {
                if (p.signs == undecided) {
                    if (!contact_->reach(i, p.f, j, p.g)) continue;
                    p.signs = contact_->signs();
                }
                pairs_.push_back(p);
            }
    }

    /// Three corners' positions.
    using Triangle = std::array<const std::array<double, 3>*, 3>;

    static Triangle triangle(const Boundary<3>& b, std::uint32_t f) {
        const std::span<const Corner> c = b.faces.corners_of(f);
        return {&b.points[c[0].point].approximation, &b.points[c[1].point].approximation,
                &b.points[c[2].point].approximation};
    }

    /// Keeps what planes do not keep apart. Looks at nothing but doubles; other pairs are left undecided.
    void compare_planes(std::uint32_t i, std::uint32_t j, std::span<const Key> keys, std::vector<FacePair>& out) const {
        const Boundary<3>& a = operands_->boundary(i);
        const Boundary<3>& b = operands_->boundary(j);
        std::uint32_t last = no_id;
        Triangle at_f{};
        RoughPlane of_f{};
        for (const Key k : keys) {
            const auto f = static_cast<std::uint32_t>(k >> 32U);
            const auto g = static_cast<std::uint32_t>(k);
            if (a.faces.faces[f].plane != no_id || b.faces.faces[g].plane != no_id) {
                out.push_back({i, j, f, g, undecided});
                continue;
            }
            if (f != last) {
                last = f;
                at_f = triangle(a, f);
                of_f = rough_plane(*at_f[0], *at_f[1], *at_f[2]);
            }
            const Triangle at_g = triangle(b, g);
            FaceContact::PackedSigns of_corners_f = 0;
            FaceContact::PackedSigns of_corners_g = 0;
            if (!is_cut(rough_plane(*at_g[0], *at_g[1], *at_g[2]), at_g, at_f, of_corners_f) ||
                !is_cut(of_f, at_f, at_g, of_corners_g))
                continue;
            out.push_back({i, j, f, g, of_corners_f | of_corners_g << 6U});
        }
    }

    /// Whether corners are on both sides of a triangle's plane, or on it. `signs`: two bits for each, as `FaceContact`
    /// packs them.
    static bool is_cut(const RoughPlane& plane, const Triangle& of, const Triangle& corners,
                       FaceContact::PackedSigns& signs) {
        for (std::size_t n = 0; n < 3; ++n) {
            const Sign s = filtered_sign([&] { return approximate_side(plane, *corners[n]); },
                                         [&] { return exact_side(*of[0], *of[1], *of[2], *corners[n]); });
            signs |= static_cast<FaceContact::PackedSigns>(int(s) + 1) << (2 * n);
        }
        return signs != 0 && signs != all_plus;
    }

    static constexpr FaceContact::PackedSigns all_plus = 0b101010;
    /// Not a value that `FaceContact` packs.
    static constexpr FaceContact::PackedSigns undecided = ~FaceContact::PackedSigns(0) - 1;

    SurfaceOperands* operands_;
    FaceContact* contact_;
    ExecutorRef executor_;
    const ProgressReporter* progress_;
    std::vector<Bits> neighbours_;
    std::vector<std::vector<std::uint32_t>> near_;
    std::vector<std::vector<NamedBox<3>>> boxes_;
    std::vector<Key> keys_;
    std::mutex mutex_;  // of keys_ while pieces run
    std::vector<FacePair> pairs_;
    std::size_t box_pair_count_ = 0;
};

CLEAVE_END_NAMESPACE

#endif

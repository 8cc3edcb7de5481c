// SPDX-License-Identifier: Apache-2.0
/// What two faces of different operands have in common: points and segments, each with the least feature of either
/// face that contains it, so that all faces at an edge or a vertex give a common point the same name.
#ifndef CLEAVE_SETOP_FACE_CONTACT_HPP
#define CLEAVE_SETOP_FACE_CONTACT_HPP

#include <cleave/region/surface_operands.hpp>
#include <cleave/setop/crossing_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The corners of one face in a row.
struct FaceOutline {
    struct Entry {
        std::uint32_t corner;  ///< in the operand's list
        PointId point;         ///< of the operand
        std::uint32_t next;
        std::uint32_t previous;
    };

    std::uint32_t operand = no_id;
    std::uint32_t face = no_id;
    std::vector<Entry> entries;

    void read(const SurfaceOperands& operands, std::uint32_t i, std::uint32_t f) {
        if (operand == i && face == f) return;
        operand = i;
        face = f;
        entries.clear();
        const FaceList& list = operands.boundary(i).faces;
        const FaceList::Face& source = list.faces[f];
        for (std::uint32_t l = source.first_loop; l < source.first_loop + source.loop_count; ++l) {
            const auto at = static_cast<std::uint32_t>(entries.size());
            const std::uint32_t first = list.loop_first[l];
            const std::uint32_t size = list.loop_first[l + 1] - first;
            for (std::uint32_t n = 0; n < size; ++n)
                entries.push_back({first + n, list.corners[first + n].point, at + (n + 1 == size ? 0 : n + 1),
                                   at + (n == 0 ? size : n) - 1});
        }
    }

    [[nodiscard]] bool is_triangle() const noexcept { return entries.size() == 3; }
    /// The corner opposite an edge of a triangle.
    [[nodiscard]] PointId opposite(std::uint32_t n) const {
        return is_triangle() ? entries[entries[n].previous].point : no_id;
    }
};

/// The least part of a face that contains a point or a segment.
struct Feature {
    enum class Kind : std::uint8_t { vertex, edge, interior };
    Kind kind = Kind::interior;
    std::uint32_t corner = no_id;  ///< the vertex's, or the one at which the edge starts

    friend bool operator==(const Feature&, const Feature&) = default;
};

/// A point of two faces.
struct ContactPoint {
    PointId point;
    Feature of_f, of_g;
};

/// A segment of two faces that do not lie on one plane; its direction is n_f x n_g. `f_sides`: where the face f is
/// beside it, 1 on the minus side of g's plane, 2 on the plus side. For coplanar faces the direction is that of f's
/// edge, and the bits tell the minus and plus side of that edge's own plane.
struct ContactSegment {
    PointId from, to;
    Feature of_f, of_g;
    std::uint8_t f_sides, g_sides;
};

/// Finds contacts of one pair of faces after the other. Keeps scratch memory.
class FaceContact {
public:
    explicit FaceContact(SurfaceOperands& operands) : operands_(&operands) {}

    [[nodiscard]] const FaceOutline& f() const noexcept { return f_; }
    [[nodiscard]] const FaceOutline& g() const noexcept { return g_; }
    [[nodiscard]] std::span<const ContactPoint> points() const noexcept { return points_; }
    [[nodiscard]] std::span<const ContactSegment> segments() const noexcept { return segments_; }

    /// On which sides of each other's planes the corners of two faces lie: for small faces two bits for each corner,
    /// those of f first, from the lowest bit on: 0 on the minus side, 1 on the plane, 2 on the plus side.
    using PackedSigns = std::uint32_t;

    /// Whether the faces can have anything in common, by the planes alone.
    bool reach(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t g) {
        return !apart(i, f, j, g, f_signs_) && !apart(j, g, i, f, g_signs_);
    }

    /// What `reach` found out, if it returned true, for `find`.
    [[nodiscard]] PackedSigns signs() const {
        if (f_signs_.size() + g_signs_.size() > most_packed) return unpacked;
        PackedSigns packed = 0;
        for (const std::vector<Sign>* signs : {&g_signs_, &f_signs_})
            for (std::size_t n = signs->size(); n-- > 0;)
                packed = packed << 2U | static_cast<PackedSigns>(int((*signs)[n]) + 1);
        return packed;
    }

    /// Finds everything that faces (i, f) and (j, g) have in common. Returns: whether they are coplanar; their contacts
    /// are then found by `find_coplanar`. Requires: they can have something in common, as `signs` says.
    bool find(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t g, PackedSigns signs) {
        points_.clear();
        segments_.clear();
        f_.read(*operands_, i, f);
        g_.read(*operands_, j, g);
        if (signs == unpacked) {
            reach(i, f, j, g);
        } else {
            for (auto [face, out] : {std::pair(&f_, &f_signs_), std::pair(&g_, &g_signs_)}) {
                out->clear();
                for (std::size_t n = 0; n < face->entries.size(); ++n, signs >>= 2U)
                    out->push_back(static_cast<Sign>(int(signs & 3U) - 1));
            }
        }
        if (std::all_of(f_signs_.begin(), f_signs_.end(), [](Sign s) { return s == Sign::zero; })) return true;
        direction_.axis = -1;
        make_events(f_, f_signs_, true, f_events_, f_more_, f_flat_);
        make_events(g_, g_signs_, false, g_events_, g_more_, g_flat_);
        if (f_events_.empty() || g_events_.empty()) return false;
        merge([&](Event& a, Event& b) { return order(a, b); });
        return false;
    }

    /// For coplanar faces: what edge n of f's outline has in common with g. Segments run along the edge.
    void find_coplanar(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t g, std::uint32_t n) {
        points_.clear();
        segments_.clear();
        f_.read(*operands_, i, f);
        g_.read(*operands_, j, g);
        const FaceOutline::Entry& from = f_.entries[n];
        const FaceOutline::Entry& to = f_.entries[from.next];
        const PlaneId along = operands_->oriented_edge_plane(i, f, from.corner, from.point, to.point, f_.opposite(n));
        Kernel<3>& kernel = operands_->kernel();
        g_signs_.clear();
        for (const FaceOutline::Entry& e : g_.entries) {
            g_signs_.push_back(kernel.side(along, operands_->point(j, e.point)));
        }
        if (on_one_side(g_signs_)) return;
        const PointId a = operands_->point(i, from.point);
        const PointId b = operands_->point(i, to.point);
        direction_ = direction_between(kernel, a, b);
        line_ = along;
        make_events(g_, g_signs_, false, g_events_, g_more_, g_flat_, true);
        f_flat_.assign(1, n);
        f_events_.clear();
        f_more_.clear();
        f_events_.push_back({a, n, true, 1});
        f_events_.push_back({b, from.next, true, 1});
        merge([&](Event& x, Event& y) { return order_points(x, y); });
        line_ = no_id;
    }

private:
    static constexpr std::size_t most_packed = 15;
    static constexpr PackedSigns unpacked = ~PackedSigns(0);

    /// Whether all corners are on one open side.
    static bool on_one_side(const std::vector<Sign>& signs) {
        return signs.front() != Sign::zero &&
               std::all_of(signs.begin(), signs.end(), [&](Sign s) { return s == signs.front(); });
    }

    /// The sides of face (j, g)'s plane on which the corners of face (i, f) lie. Returns: whether all are on one open
    /// side, so that the faces have nothing in common.
    bool apart(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t g, std::vector<Sign>& signs) {
        signs.clear();
        const FaceList& list = operands_->boundary(i).faces;
        const FaceList::Face& face = list.faces[f];
        const std::uint32_t last = list.loop_first[face.first_loop + face.loop_count];
        for (std::uint32_t c = list.loop_first[face.first_loop]; c < last; ++c)
            signs.push_back(operands_->side(j, g, i, list.corners[c].point));
        return on_one_side(signs);
    }

    /// Where a face's boundary meets the common line. `toggles`: whether crossing it enters or leaves what of the face
    /// is next to the line on its minus side (1) and on its plus side (2).
    struct Event {
        PointId point;    // of the kernel; `no_id` until it is needed
        std::uint32_t n;  // in the outline: the vertex, or the edge's start
        bool vertex;
        std::uint8_t toggles;
    };

    static std::uint8_t sides(Sign s) { return s == Sign::minus ? 1 : (s == Sign::plus ? 2 : 0); }

    void make_events(const FaceOutline& face, const std::vector<Sign>& signs, bool first, std::vector<Event>& events,
                     std::vector<Event>& more, std::vector<std::uint32_t>& flat, bool always_sort = false) {
        events.clear();
        more.clear();
        flat.clear();
        for (std::uint32_t n = 0; n < face.entries.size(); ++n) {
            const Sign s = signs[n];
            const Sign t = signs[face.entries[n].next];
            if (s == Sign::zero) {
                const Sign before = signs[face.entries[n].previous];
                events.push_back({operands_->point(face.operand, face.entries[n].point), n, true,
                                  static_cast<std::uint8_t>(sides(before) ^ sides(t))});
                if (t == Sign::zero) flat.push_back(n);
            } else if (t != Sign::zero && s != t) {
                events.push_back({no_id, n, false, 3});
            }
        }
        if (events.size() < 2) return;
        if (!always_sort && face.is_triangle() && events.size() == 2) {
            // Along n_f x n_g, an edge from the minus to the plus side enters f and leaves g.
            bool in_order = true;
            if (!flat.empty())
                in_order =
                    (events[0].n == flat[0]) == (signs[face.entries[face.entries[flat[0]].next].next] == Sign::minus);
            else if (!events[0].vertex)
                in_order = signs[events[0].n] == Sign::minus;
            else
                in_order = signs[events[1].n] == Sign::plus;
            if (in_order != first) std::swap(events[0], events[1]);
            return;
        }
        for (Event& e : events) point_of(e, face);
        if (direction_.axis < 0) find_direction();
        std::sort(events.begin(), events.end(), [&](const Event& a, const Event& b) {
            return a.point != b.point &&
                   operands_->kernel().compare(direction_.axis, b.point, a.point) == direction_.sign;
        });
        // A face that touches itself passes one point several times.
        std::size_t kept = 0;
        for (std::size_t e = 1; e < events.size(); ++e) {
            if (events[e].point == events[kept].point) {
                events[kept].toggles = static_cast<std::uint8_t>(events[kept].toggles ^ events[e].toggles);
                more.push_back(events[e]);
            } else {
                events[++kept] = events[e];
            }
        }
        events.resize(kept + 1);
    }

    void find_direction() {
        direction_ = edge_direction(operands_->kernel(), operands_->plane(f_.operand, f_.face),
                                    operands_->plane(g_.operand, g_.face));
    }

    /// The kernel's point of an event.
    PointId point_of(Event& e, const FaceOutline& face) {
        if (e.point != no_id) return e.point;
        const FaceOutline::Entry& from = face.entries[e.n];
        const FaceOutline::Entry& to = face.entries[from.next];
        const std::uint32_t i = face.operand;
        const FaceOutline& other = &face == &f_ ? g_ : f_;
        // Both faces at the edge ask for the point.
        PointId* known = nullptr;
        if (line_ == no_id)
            if (const auto edge = operands_->edge_name(i, face.face, from.corner)) {
                known = &crossings_[{*edge, (std::uint64_t(other.operand) << 32U) | other.face}];
                if (*known != no_id) return e.point = *known;
            }
        const PlaneId across = line_ != no_id ? line_ : operands_->plane(other.operand, other.face);
        const PointId x =
            operands_->kernel().cross(across, operands_->point(i, from.point), operands_->point(i, to.point),
                                      {unoriented(operands_->plane(i, face.face)),
                                       operands_->edge_plane(i, face.face, from.corner, from.point, to.point)});
        if (known == nullptr) return e.point = operands_->interner()(x);
        // Planes may still name it twice, where faces are coplanar; its place tells.
        return e.point = *known = operands_->interner().by_place_alone(x);
    }

    /// The order of an event of f and one of g along the line: minus where f's comes first.
    Sign order(Event& a, Event& b) {
        if (!a.vertex && !b.vertex) {
            const auto [p, q] = rising(f_, f_signs_, a.n);
            const auto [r, s] = rising(g_, g_signs_, b.n);
            if (operands_->is_of_doubles(f_.operand, p) && operands_->is_of_doubles(f_.operand, q) &&
                operands_->is_of_doubles(g_.operand, r) && operands_->is_of_doubles(g_.operand, s))
                return -plane_side(operands_->position(f_.operand, p), operands_->position(f_.operand, q),
                                   operands_->position(g_.operand, r), operands_->position(g_.operand, s));
        }
        if (direction_.axis < 0 && !(a.point != no_id && a.point == b.point)) find_direction();
        return order_points(a, b);
    }

    Sign order_points(Event& a, Event& b) {
        const PointId p = point_of(a, f_);
        const PointId q = point_of(b, g_);
        if (p == q) return Sign::zero;
        return operands_->kernel().compare(direction_.axis, p, q) * direction_.sign;
    }

    /// The ends of an edge across the line, the one on the minus side first.
    static std::pair<PointId, PointId> rising(const FaceOutline& face, const std::vector<Sign>& signs,
                                              std::uint32_t n) {
        const PointId p = face.entries[n].point;
        const PointId q = face.entries[face.entries[n].next].point;
        return signs[n] == Sign::minus ? std::pair(p, q) : std::pair(q, p);
    }

    /// The feature of a face at a place of the line where it has the event `e` or none, in the state before the place.
    static Feature feature(const FaceOutline& face, const Event* e, std::uint8_t state, std::uint32_t along) {
        if (e != nullptr) return {e->vertex ? Feature::Kind::vertex : Feature::Kind::edge, face.entries[e->n].corner};
        if (state == 3 || along == no_id) return {};
        return {Feature::Kind::edge, face.entries[along].corner};
    }

    /// The edge in the line that contains what is between events e and e + 1; `no_id` where there is none.
    static std::uint32_t flat_edge(const FaceOutline& face, const std::vector<Event>& events,
                                   const std::vector<std::uint32_t>& flat, std::size_t e, SurfaceOperands& operands) {
        for (const std::uint32_t n : flat) {
            const PointId a = operands.point(face.operand, face.entries[n].point);
            const PointId b = operands.point(face.operand, face.entries[face.entries[n].next].point);
            bool begun = false;
            bool ended = false;
            for (std::size_t i = 0; i < events.size(); ++i)
                if (events[i].point == a || events[i].point == b) (i <= e ? begun : ended) = true;
            if (begun && ended) return n;
        }
        return no_id;
    }

    /// Walks along the line through the events of both faces.
    template <class Order>
    void merge(Order&& compare) {
        std::size_t x = 0;
        std::size_t y = 0;
        std::uint8_t fs = 0;
        std::uint8_t gs = 0;
        std::uint32_t f_along = no_id;
        std::uint32_t g_along = no_id;
        PointId from = no_id;
        while (x < f_events_.size() || y < g_events_.size()) {
            if ((x == f_events_.size() && fs == 0) || (y == g_events_.size() && gs == 0)) break;
            Sign s = Sign::zero;
            if (x == f_events_.size())
                s = Sign::plus;
            else if (y == g_events_.size())
                s = Sign::minus;
            else
                s = compare(f_events_[x], g_events_[y]);
            Event* const a = s != Sign::plus ? &f_events_[x] : nullptr;
            Event* const b = s != Sign::minus ? &g_events_[y] : nullptr;
            const bool common = (a != nullptr || fs != 0) && (b != nullptr || gs != 0);
            const Feature of_f = feature(f_, a, fs, f_along);
            const Feature of_g = feature(g_, b, gs, g_along);
            const std::uint8_t f_before = fs;
            const std::uint8_t g_before = gs;
            const std::uint32_t f_edge = f_along;
            const std::uint32_t g_edge = g_along;
            if (a != nullptr) {
                fs = static_cast<std::uint8_t>(fs ^ a->toggles);
                f_along = fs == 1 || fs == 2 ? flat_edge(f_, f_events_, f_flat_, x, *operands_) : no_id;
                ++x;
            }
            if (b != nullptr) {
                gs = static_cast<std::uint8_t>(gs ^ b->toggles);
                g_along = gs == 1 || gs == 2 ? flat_edge(g_, g_events_, g_flat_, y, *operands_) : no_id;
                ++y;
            }
            if (!common) {
                from = no_id;
                continue;
            }
            // A vertex is its own name, else the edge of f that crosses g's plane, else the edge of g.
            PointId at = no_id;
            if (a != nullptr && a->vertex)
                at = a->point;
            else if (b != nullptr && b->vertex)
                at = b->point;
            else
                at = a != nullptr ? point_of(*a, f_) : point_of(*b, g_);
            points_.push_back({at, of_f, of_g});
            for (const Event& e : f_more_)
                if (e.point == at) points_.push_back({at, feature(f_, &e, 0, no_id), of_g});
            for (const Event& e : g_more_)
                if (e.point == at) points_.push_back({at, of_f, feature(g_, &e, 0, no_id)});
            // A vertex of a face in the middle of one of its own edges is no end of anything by itself.
            const bool f_passes = a != nullptr && f_edge != no_id && f_edge == f_along && f_before == fs;
            const bool g_passes = b != nullptr && g_edge != no_id && g_edge == g_along && g_before == gs;
            if ((a == nullptr || f_passes) && (b == nullptr || g_passes)) continue;
            if (f_passes) points_.push_back({at, piece(f_, fs, f_along), of_g});
            if (g_passes) points_.push_back({at, of_f, piece(g_, gs, g_along)});
            if (from != no_id && f_before != 0 && g_before != 0)
                segments_.push_back(
                    {from, at, piece(f_, f_before, f_edge), piece(g_, g_before, g_edge), f_before, g_before});
            from = at;
        }
    }

    static Feature piece(const FaceOutline& face, std::uint8_t state, std::uint32_t along) {
        if (state == 3 || along == no_id) return {};
        return {Feature::Kind::edge, face.entries[along].corner};
    }

    SurfaceOperands* operands_;
    CrossingTable crossings_;
    FaceOutline f_, g_;
    std::vector<Sign> f_signs_, g_signs_;
    std::vector<Event> f_events_, g_events_;
    std::vector<Event> f_more_, g_more_;          // at the place of another event of the same face
    std::vector<std::uint32_t> f_flat_, g_flat_;  // edges in the line
    AxisDirection direction_;
    PlaneId line_ = no_id;  // coplanar faces: the plane along f's edge
    std::vector<ContactPoint> points_;
    std::vector<ContactSegment> segments_;
};

CLEAVE_END_NAMESPACE

#endif

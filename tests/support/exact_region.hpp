// SPDX-License-Identifier: Apache-2.0
/// A region copied out into plain rational coordinates, and what can be asked of it without the library: membership of
/// points by counting crossings along a ray, measure, first moments, areas. It reads the stored boundary, nothing else:
/// no tree, no kernel, no filter.
#ifndef CLEAVE_TESTS_SUPPORT_EXACT_REGION_HPP
#define CLEAVE_TESTS_SUPPORT_EXACT_REGION_HPP

#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace support {

using cleave::Rational;

/// What a checker throws; both test frameworks report it.
class Defect : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

template <int D>
using Coordinates = std::array<Rational, std::size_t(D)>;

[[nodiscard]] inline Rational rational(const cleave::Integer& num, const cleave::Integer& den = 1) {
    return cleave::number_traits<Rational>::from_fraction(num, den);
}

[[nodiscard]] inline int sign(const Rational& x) {
    return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

/// The sign of a - b.
[[nodiscard]] inline int compare(const Rational& a, const Rational& b) {
    return a < b ? -1 : (b < a ? 1 : 0);
}

template <std::size_t K>
[[nodiscard]] Rational dot(const std::array<Rational, K>& a, const std::array<Rational, K>& b) {
    Rational sum(0);
    for (std::size_t i = 0; i < K; ++i) sum += a[i] * b[i];
    return sum;
}

template <std::size_t K>
[[nodiscard]] std::array<Rational, K> subtract(const std::array<Rational, K>& a, const std::array<Rational, K>& b) {
    std::array<Rational, K> d;
    for (std::size_t i = 0; i < K; ++i) d[i] = a[i] - b[i];
    return d;
}

/// origin + t * direction
template <std::size_t K>
[[nodiscard]] std::array<Rational, K> along(const std::array<Rational, K>& origin, const Rational& t,
                                            const std::array<Rational, K>& direction) {
    std::array<Rational, K> p;
    for (std::size_t i = 0; i < K; ++i) p[i] = origin[i] + t * direction[i];
    return p;
}

[[nodiscard]] inline Coordinates<3> cross(const Coordinates<3>& a, const Coordinates<3>& b) {
    Coordinates<3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    return c;
}

/// The solution of D equations n_i . x = -c_i by elimination; nullopt where they have none or many.
template <int D>
[[nodiscard]] std::optional<Coordinates<D>> solve(
    std::array<std::array<Rational, std::size_t(D) + 1>, std::size_t(D)> m) {
    constexpr std::size_t n = std::size_t(D);
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        while (pivot < n && m[pivot][column] == 0) ++pivot;
        if (pivot == n) return std::nullopt;
        std::swap(m[pivot], m[column]);
        for (std::size_t row = 0; row < n; ++row) {
            if (row == column) continue;
            const Rational factor = m[row][column] / m[column][column];
            for (std::size_t i = 0; i <= n; ++i) m[row][i] -= factor * m[column][i];
        }
    }
    Coordinates<D> x;
    for (std::size_t i = 0; i < n; ++i) x[i] = -m[i][n] / m[i][i];
    return x;
}

/// Where a point lies.
enum class Where { outside, inside, boundary };

/// A plane n.x + c with plus outside, as n_0, ..., n_{D-1}, c.
template <int D>
using Coefficients = std::array<Rational, std::size_t(D) + 1>;

template <int D>
[[nodiscard]] Coordinates<D> normal(const Coefficients<D>& h) {
    Coordinates<D> n;
    for (std::size_t i = 0; i < std::size_t(D); ++i) n[i] = h[i];
    return n;
}

template <int D>
[[nodiscard]] Rational value(const Coefficients<D>& h, const Coordinates<D>& p) {
    return Rational(dot(normal<D>(h), p) + h[std::size_t(D)]);
}

/// One face: its oriented plane and its loops, each a list of points (D = 2: two, D = 1: one).
template <int D>
struct ExactFace {
    Coefficients<D> plane;
    std::vector<std::vector<Coordinates<D>>> loops;
};

/// How often loops of points in the plane wind round p, or nullopt where p is on one of them. Half-open rule for
/// vertices on the horizontal ray, so no position is special.
[[nodiscard]] inline std::optional<int> winding(const std::vector<std::vector<Coordinates<2>>>& loops,
                                                const Coordinates<2>& p) {
    int turns = 0;
    for (const auto& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Coordinates<2>& a = loop[i];
            const Coordinates<2>& b = loop[i + 1 == loop.size() ? 0 : i + 1];
            const int low = compare(a[1], p[1]);
            const int high = compare(b[1], p[1]);
            if (low * high > 0) continue;              // above or below
            if (a[0] < p[0] && b[0] < p[0]) continue;  // to the left
            const Rational left = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            const int side = sign(left);
            if (side == 0 && (low != 0 || high != 0 || a[0] <= p[0] || b[0] <= p[0])) return std::nullopt;
            if (low <= 0 && high > 0 && side > 0) ++turns;
            if (high <= 0 && low > 0 && side < 0) --turns;
        }
    }
    return turns;
}

/// A region as rationals.
template <int D>
class ExactRegion {
public:
    static constexpr std::size_t dimension = std::size_t(D);
    using Point = Coordinates<D>;

    template <class N>
    explicit ExactRegion(const cleave::Region<D, N>& region) : ExactRegion(region.boundary()) {}

    explicit ExactRegion(const cleave::Boundary<D>& b) : value_at_infinity_(b.value_at_infinity) {
        for (const cleave::PointRecord<D>& r : b.points) points_.push_back(coordinates(b, r));
        for (const auto& f : b.faces.faces) {
            ExactFace<D> face;
            face.plane = coefficients(b, f.plane);
            for (std::uint32_t l = f.first_loop; l < f.first_loop + f.loop_count; ++l) {
                face.loops.emplace_back();
                for (const cleave::Corner& c : b.faces.loop(l)) face.loops.back().push_back(points_.at(c.point));
            }
            faces_.push_back(std::move(face));
        }
        for (const ExactFace<D>& f : faces_) boxes_.push_back(box_of(f));
        if constexpr (D == 3)
            for (const ExactFace<D>& f : faces_) shadows_.push_back(shadow(f));
    }

    [[nodiscard]] bool value_at_infinity() const { return value_at_infinity_; }
    [[nodiscard]] const std::vector<ExactFace<D>>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<Point>& points() const { return points_; }

    /// The oriented plane h of a boundary's table.
    [[nodiscard]] static Coefficients<D> coefficients(const cleave::Boundary<D>& b, cleave::PlaneId h) {
        Coefficients<D> c;
        const auto& stored = b.planes.exact(cleave::unoriented(h));
        for (std::size_t i = 0; i <= dimension; ++i) {
            c[i] = rational(stored[i]);
            if (cleave::is_flipped(h)) c[i] = Rational(-c[i]);
        }
        return c;
    }

    /// The exact place of a stored point; a meet is solved for from its planes.
    [[nodiscard]] static Point coordinates(const cleave::Boundary<D>& b, const cleave::PointRecord<D>& r) {
        using Kind = typename cleave::PointRecord<D>::Kind;
        Point p;
        if (r.kind == Kind::doubles) {
            for (std::size_t i = 0; i < dimension; ++i)
                p[i] = cleave::number_traits<Rational>::from_double(r.approximation[i]);
        } else if (r.kind == Kind::integers) {
            const auto& e = b.exact.at(r.exact);
            for (std::size_t i = 0; i < dimension; ++i) p[i] = rational(e[i], e[dimension]);
        } else {
            std::array<Coefficients<D>, dimension> rows;
            for (std::size_t i = 0; i < dimension; ++i) rows[i] = coefficients(b, 2 * r.planes[i]);
            const std::optional<Point> x = solve<D>(rows);
            if (!x) throw Defect("a point is named by planes that do not meet in one point");
            p = *x;
        }
        return p;
    }

    /// Whether p is inside, outside, or on a face. Throws: Defect where the crossings of a ray contradict each other.
    [[nodiscard]] Where locate(const Point& p) const {
        for (std::size_t f = 0; f < faces_.size(); ++f)
            if (on_face(f, p)) return Where::boundary;
        return value_off(p, std::nullopt, faces_.size()) ? Where::inside : Where::outside;
    }

    /// The value of the set just beside face f at its point p, on the plus side.
    /// Returns: nullopt where another face passes through p as well.
    [[nodiscard]] std::optional<bool> value_above(std::size_t f, const Point& p) const {
        for (std::size_t g = 0; g < faces_.size(); ++g)
            if (g != f && on_face(g, p)) return std::nullopt;
        return value_off(p, normal<D>(faces_[f].plane), f);
    }

    [[nodiscard]] bool on_face(std::size_t f, const Point& p) const {
        const ExactFace<D>& face = faces_[f];
        for (std::size_t i = 0; i < dimension; ++i)
            if (p[i] < boxes_[f].lo[i] || p[i] > boxes_[f].hi[i]) return false;
        if (value<D>(face.plane, p) != 0) return false;
        if constexpr (D == 1) {
            return true;
        } else if constexpr (D == 2) {
            for (const auto& s : face.loops)
                if (dot(subtract(p, s[0]), subtract(p, s[1])) <= 0) return true;
            return false;
        } else {
            return winding(shadows_[f].loops, project(shadows_[f], p)) != std::optional<int>(0);
        }
    }

    /// Points in the interior of face f, different for different `attempt`. nullopt where this attempt found none.
    [[nodiscard]] std::optional<Point> sample(std::size_t f, int attempt) const {
        const ExactFace<D>& face = faces_[f];
        if constexpr (D == 1) {
            return face.loops[0][0];
        } else {
            const Rational s(Rational(attempt % 5 + 1) / Rational(attempt + 2));
            const auto& loop = face.loops[std::size_t(attempt) % face.loops.size()];
            if constexpr (D == 2) {
                return along(loop[0], s, subtract(loop[1], loop[0]));
            } else {
                const std::size_t i = std::size_t(attempt / 2) % loop.size();
                const Point edge = subtract(loop[i + 1 == loop.size() ? 0 : i + 1], loop[i]);
                return inward(f, along(loop[i], s, edge), cross(normal<3>(face.plane), edge));
            }
        }
    }

    /// Length, area, volume. Requires: bounded.
    [[nodiscard]] Rational measure() const {
        Rational sum(0);
        each_simplex([&](const Rational& m, const std::array<const Point*, dimension>&) { sum += m; });
        return sum;
    }

    /// The integral of the coordinates, by signed cones from the origin over simplices of the boundary; divided by the
    /// measure it is the centroid. Requires: bounded.
    [[nodiscard]] Point first_moment() const {
        Point sum;
        for (Rational& x : sum) x = 0;
        each_simplex([&](const Rational& m, const std::array<const Point*, dimension>& corners) {
            for (std::size_t i = 0; i < dimension; ++i)
                for (const Point* p : corners) sum[i] += m * (*p)[i];
        });
        for (Rational& x : sum) x /= D + 1;
        return sum;
    }

    [[nodiscard]] Point centroid() const {
        Point c = first_moment();
        const Rational m = measure();
        for (Rational& x : c) x /= m;
        return c;
    }

    /// The area (D = 2: length) of the boundary. Requires: every face is axis-parallel, so that it is rational.
    [[nodiscard]] Rational boundary_measure() const requires(D >= 2) {
        Rational sum(0);
        for (const ExactFace<D>& f : faces_) {
            const Point area = area_vector(f);
            int axes = 0;
            for (const Rational& x : area) {
                axes += x != 0 ? 1 : 0;
                sum += x < 0 ? Rational(-x) : x;
            }
            if (axes != 1) throw Defect("boundary_measure: a face is not axis-parallel");
        }
        return sum;
    }

    /// The sum of the faces' outward area vectors; zero for every closed boundary.
    [[nodiscard]] Point total_area_vector() const requires(D >= 2) {
        Point sum;
        for (Rational& x : sum) x = 0;
        for (const ExactFace<D>& f : faces_) {
            const Point area = area_vector(f);
            for (std::size_t i = 0; i < dimension; ++i) sum[i] += area[i];
        }
        return sum;
    }

    /// The number of different oriented planes that carry faces.
    [[nodiscard]] std::size_t plane_count() const {
        std::set<Coefficients<D>> planes;
        for (const ExactFace<D>& f : faces_) planes.insert(f.plane);  // stored planes are primitive
        return planes.size();
    }

private:
    /// A face seen along an axis that is not parallel to it, mirrored where that makes it face the viewer.
    struct Shadow {
        std::size_t u = 0;
        std::size_t v = 0;
        std::vector<std::vector<Coordinates<2>>> loops;
    };

    struct Box {
        Point lo;
        Point hi;
    };

    [[nodiscard]] static Box box_of(const ExactFace<D>& f) {
        Box box{f.loops[0][0], f.loops[0][0]};
        for (const auto& loop : f.loops)
            for (const Point& p : loop)
                for (std::size_t i = 0; i < dimension; ++i) {
                    box.lo[i] = std::min(box.lo[i], p[i]);
                    box.hi[i] = std::max(box.hi[i], p[i]);
                }
        return box;
    }

    [[nodiscard]] static Coordinates<2> project(const Shadow& s, const Point& p) requires(D == 3) {
        return {p[s.u], p[s.v]};
    }

    [[nodiscard]] static Shadow shadow(const ExactFace<D>& f) requires(D == 3) {
        std::size_t axis = 0;
        while (f.plane[axis] == 0) ++axis;
        Shadow s{(axis + 1) % 3, (axis + 2) % 3, {}};
        if (f.plane[axis] < 0) std::swap(s.u, s.v);
        for (const auto& loop : f.loops) {
            s.loops.emplace_back();
            for (const Point& p : loop) s.loops.back().push_back(project(s, p));
        }
        return s;
    }

    /// How the ray from p along d meets face f: 0 not at all, +1 leaving, -1 entering; nullopt where it passes through
    /// the face's edge or runs along its plane, or p lies on the face.
    [[nodiscard]] std::optional<int> hit(std::size_t f, const Point& p, const Point& d) const {
        const ExactFace<D>& face = faces_[f];
        // All of the face is behind the ray's start.
        for (std::size_t i = 0; i < dimension; ++i)
            if ((d[i] > 0 && boxes_[f].hi[i] < p[i]) || (d[i] < 0 && boxes_[f].lo[i] > p[i])) return 0;
        const Rational speed = dot(normal<D>(face.plane), d);
        const Rational distance = value<D>(face.plane, p);
        if (speed == 0) {
            if (distance == 0) return std::nullopt;
            return 0;
        }
        if (sign(speed) * sign(distance) > 0) return 0;
        const Rational t = -distance / speed;
        const Point q = along(p, t, d);
        const int direction = sign(speed);
        bool through = false;
        if constexpr (D == 1) {
            through = true;
        } else if constexpr (D == 2) {
            for (const auto& s : face.loops) {
                const int where = sign(Rational(dot(subtract(q, s[0]), subtract(q, s[1]))));
                if (where == 0) return std::nullopt;
                through = through || where < 0;
            }
        } else {
            const std::optional<int> turns = winding(shadows_[f].loops, project(shadows_[f], q));
            if (!turns) return std::nullopt;
            if (*turns != 0 && *turns != 1)
                throw Defect("a face winds round a point " + std::to_string(*turns) + " times");
            through = *turns == 1;
        }
        if (!through) return 0;
        if (t == 0) return std::nullopt;
        return direction;
    }

    /// The value of the set at p, or just beside it towards `towards` where p lies on face `on`: that at infinity plus
    /// the signed crossings on the way there.
    [[nodiscard]] bool value_off(const Point& p, const std::optional<Point>& towards, std::size_t on) const {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            Point d;
            for (std::size_t i = 0; i < dimension; ++i)
                d[i] = Rational((attempt * int(7 * i + 3) + int(5 * i * i) + 11) % 97 - 48) / int(i + 1);
            if (towards) {
                const int s = sign(Rational(dot(*towards, d)));
                if (s == 0) continue;
                if (s < 0)
                    for (Rational& x : d) x = Rational(-x);
            }
            bool zero = true;
            for (const Rational& x : d) zero = zero && x == 0;
            if (zero) continue;
            const std::optional<int> crossings = count_crossings(p, d, on);
            if (!crossings) continue;
            const int v = *crossings + (value_at_infinity_ ? 1 : 0);
            if (v != 0 && v != 1)
                throw Defect("the faces along a ray contradict each other: value " + std::to_string(v));
            return v == 1;
        }
        throw Defect("every ray from a point is degenerate");
    }

    [[nodiscard]] std::optional<int> count_crossings(const Point& p, const Point& d, std::size_t skip) const {
        int sum = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            if (f == skip) continue;
            const std::optional<int> h = hit(f, p, d);
            if (!h) return std::nullopt;
            sum += *h;
        }
        return sum;
    }

    /// Half-way from point m of an edge of face f to the next edge in direction d, which points into the face.
    [[nodiscard]] std::optional<Point> inward(std::size_t f, const Point& m, const Point& d) const requires(D == 3) {
        const Shadow& s = shadows_[f];
        const Coordinates<2> a = project(s, m);
        const Coordinates<2> v{d[s.u], d[s.v]};
        std::optional<Rational> nearest;
        for (const auto& loop : s.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Coordinates<2>& b = loop[i];
                const Coordinates<2> w = subtract(loop[i + 1 == loop.size() ? 0 : i + 1], b);
                const Rational det = v[0] * w[1] - v[1] * w[0];
                if (det == 0) continue;
                const Coordinates<2> ab = subtract(b, a);
                const Rational t = (ab[0] * w[1] - ab[1] * w[0]) / det;
                const Rational u = (ab[0] * v[1] - ab[1] * v[0]) / det;
                if (t < 0 || u < 0 || u > 1) continue;
                if (t == 0) {
                    if (u == 0 || u == 1) return std::nullopt;  // another part of the face touches the edge in m
                    continue;                                   // the edge itself
                }
                if (!nearest || t < *nearest) nearest = t;
            }
        }
        if (!nearest) throw Defect("the left side of an edge is not in its face");
        const Point q = along(m, Rational(*nearest / 2), d);
        if (winding(s.loops, project(s, q)) != std::optional<int>(1))
            throw Defect("the left side of an edge is not in its face");
        return q;
    }

    /// Calls `use(measure of the cone from the origin, its corners besides the origin)` for simplices that tile the
    /// boundary.
    template <class Use>
    void each_simplex(Use&& use) const {
        if (value_at_infinity_) throw Defect("an unbounded set has no measure");
        for (const ExactFace<D>& f : faces_) {
            for (const auto& loop : f.loops) {
                if constexpr (D == 1) {
                    use(Rational(sign(f.plane[0]) * loop[0][0]), {&loop[0]});
                } else if constexpr (D == 2) {
                    use(Rational((loop[0][0] * loop[1][1] - loop[0][1] * loop[1][0]) / 2), {&loop[0], &loop[1]});
                } else {
                    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
                        use(Rational(dot(loop[0], cross(loop[i], loop[i + 1])) / 6),
                            {&loop[0], &loop[i], &loop[i + 1]});
                }
            }
        }
    }

    [[nodiscard]] static Point area_vector(const ExactFace<D>& f) {
        Point sum;
        for (Rational& x : sum) x = 0;
        for (const auto& loop : f.loops) {
            if constexpr (D == 2) {
                sum[0] += loop[1][1] - loop[0][1];
                sum[1] += loop[0][0] - loop[1][0];
            } else if constexpr (D == 3) {
                for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                    const Point c = cross(subtract(loop[i], loop[0]), subtract(loop[i + 1], loop[0]));
                    for (std::size_t j = 0; j < 3; ++j) sum[j] += c[j] / 2;
                }
            }
        }
        return sum;
    }

    bool value_at_infinity_ = false;
    std::vector<ExactFace<D>> faces_;
    std::vector<Point> points_;
    std::vector<Box> boxes_;
    std::vector<Shadow> shadows_;  // D = 3: of each face
};

}  // namespace support

#endif

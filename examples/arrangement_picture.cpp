// SPDX-License-Identifier: Apache-2.0
/// Draws what the localised engine knows of one face, into arrangement.svg: a face of a solid A that two solids B and C
/// cut, the segments and points that it has in common with theirs, what each point is named by, and the pieces between
/// them with what they lie in.
#include <cleave.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cleave;
using Bits = FacePiece::Bits;
using Place = std::array<double, 2>;  // on the page

const std::array<const char*, 3> names{"A", "B", "C"};
const std::array<const char*, 3> inks{"#1b2733", "#1f6fb5", "#c2570c"};
const char* const red = "#b3261e";

/// The fill of what lies in the operands whose bits are set, B's the second and C's the third.
const char* fill_of(Bits label) {
    static const std::array<const char*, 4> fills{"#eef1f5", "#bcd9f3", "#fbd9a5", "#b7d8a4"};
    return fills[std::size_t(label >> 1U & 3U)];
}

std::string words_of(Bits label) {
    static const std::array<const char*, 4> words{"in neither", "in B", "in C", "in B and C"};
    return words[std::size_t(label >> 1U & 3U)];
}

/// The prism that leans over z = 0: its section there has these corners, and its edges run along (1, 1, 3).
Region<3> leaning_prism(const std::vector<std::array<int, 2>>& section) {
    std::vector<std::array<Rational, 3>> points;
    for (const auto& [x, y] : section) {
        points.push_back({Rational(x - 1), Rational(y - 1), Rational(-3)});
        points.push_back({Rational(x + 1), Rational(y + 1), Rational(3)});
    }
    return convex_hull<3>(points);
}

// --- the face ---------------------------------------------------------------------------------------------------

/// A common point of the face.
struct CommonPoint {
    PointId point;
    std::array<Feature::Kind, 3> least;  ///< the least feature of each operand that it lies on
    Bits on = 0;                         ///< those operands

    [[nodiscard]] bool is_triple() const { return on == 7; }

    /// "edge of A x face of B", with a times sign.
    [[nodiscard]] std::string name() const {
        static const std::array<const char*, 3> kinds{"vertex of ", "edge of ", "face of "};
        std::string text;
        for (std::size_t i = 0; i < 3; ++i)
            if ((on >> i & 1U) != 0)
                text += (text.empty() ? "" : " \xc3\x97 ") + std::string(kinds[std::size_t(least[i])]) + names[i];
        return text;
    }
};

/// A piece of an edge, or one side of a common segment: what is on its left lies in the operands of `label`.
struct Side {
    PointId from, to;
    Bits label;
};

/// A face of the first operand, cut and labelled.
class Arrangement {
public:
    /// Requires: some operand touches the face.
    Arrangement(std::span<const Boundary<3>* const> boundaries, std::uint32_t face)
        : operands_(boundaries), contacts_(operands_, {}, nullptr, 0), labels_(operands_, contacts_, {}, nullptr) {
        const std::span<const std::uint32_t> near = contacts_.near(0);
        const auto at = std::size_t(std::lower_bound(near.begin(), near.end(), face) - near.begin());
        records_ = contacts_.walk(0).of(face);
        outline_.read(operands_, 0, face);
        pieces_ = labels_.pieces(0, at);
        labels_.complete(outline_, records_, pieces_);
        find_points();
    }

    /// Common points from left to right.
    [[nodiscard]] const std::vector<CommonPoint>& points() const { return points_; }
    [[nodiscard]] std::span<const SegmentRecord> segments() const { return records_.segments; }

    /// The pieces of edges and both sides of the segments inside.
    [[nodiscard]] std::vector<Side> sides() {
        std::vector<Side> sides;
        for (const FacePiece& p : pieces_) {
            sides.push_back({end(p, true), end(p, false), p.left.below});
            if (p.n == no_id) sides.push_back({end(p, false), end(p, true), p.right.below});
        }
        return sides;
    }

    /// The corners of the face.
    [[nodiscard]] std::vector<PointId> corners() {
        std::vector<PointId> all;
        for (const FaceOutline::Entry& e : outline_.entries) all.push_back(operands_.point(0, e.point));
        return all;
    }

    [[nodiscard]] std::array<Rational, 2> coordinates(PointId p) {
        const Homogeneous<3> h = operands_.kernel().coordinates(p);
        return {number_traits<Rational>::from_fraction(h[0], h[3]), number_traits<Rational>::from_fraction(h[1], h[3])};
    }

private:
    PointId end(const FacePiece& p, bool is_start) {
        const PointId known = is_start ? p.from : p.to;
        if (known != no_id) return known;
        const FaceOutline::Entry& from = outline_.entries[p.n];
        return operands_.point(0, is_start ? from.point : outline_.entries[from.next].point);
    }

    void find_points() {
        std::map<PointId, CommonPoint> found;
        for (const PointContact& c : records_.points) {
            const auto interior = Feature::Kind::interior;
            CommonPoint& p =
                found.try_emplace(c.point, CommonPoint{c.point, {interior, interior, interior}, 1}).first->second;
            p.on |= Bits(1) << c.operand;
            p.least[0] = std::min(p.least[0], c.of_face.kind);
            p.least[c.operand] = std::min(p.least[c.operand], c.of_other.kind);
        }
        for (const auto& [point, p] : found) points_.push_back(p);
        std::sort(points_.begin(), points_.end(), [this](const CommonPoint& a, const CommonPoint& b) {
            return coordinates(a.point) < coordinates(b.point);
        });
    }

    SurfaceOperands operands_;
    SurfaceContacts contacts_;
    SurfaceLabels labels_;
    FaceRecords records_;
    FaceOutline outline_;
    std::span<FacePiece> pieces_;
    std::vector<CommonPoint> points_;
};

// --- the page ---------------------------------------------------------------------------------------------------

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", x);
    return text;
}

class Page {
public:
    void polygon(const std::vector<Place>& corners, const std::string& style) {
        out_ += "<polygon points=\"";
        for (const Place& p : corners) out_ += number(p[0]) + "," + number(p[1]) + " ";
        out_ += "\" " + style + "/>\n";
    }

    void line(Place a, Place b, const std::string& style) {
        out_ += "<line x1=\"" + number(a[0]) + "\" y1=\"" + number(a[1]) + "\" x2=\"" + number(b[0]) + "\" y2=\"" +
                number(b[1]) + "\" " + style + "/>\n";
    }

    void text(Place at, const std::string& words, const std::string& style) {
        out_ += "<text x=\"" + number(at[0]) + "\" y=\"" + number(at[1]) + "\" stroke=\"none\" " + style + ">" + words +
                "</text>\n";
    }

    void dot(Place at, double radius, const std::string& style) {
        out_ += "<circle cx=\"" + number(at[0]) + "\" cy=\"" + number(at[1]) + "\" r=\"" + number(radius) + "\" " +
                style + "/>\n";
    }

    /// A point's number in a circle.
    void mark(Place at, std::size_t n, bool is_triple) {
        const std::string ink = is_triple ? red : inks[0];
        dot(at, 9.5, "fill=\"" + (is_triple ? ink : "white") + "\" stroke=\"" + ink + "\" stroke-width=\"1.5\"");
        text({at[0], at[1] + 4.5}, std::to_string(n),
             "font-size=\"12.5\" text-anchor=\"middle\" fill=\"" + (is_triple ? std::string("white") : ink) + "\"");
    }

    void write(const std::string& file, double width, double height) const {
        std::ofstream svg(file);
        svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
            << "\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" "
               "fill=\"white\"/>\n"
            << out_ << "</svg>\n";
        if (!svg.flush()) throw Error("can't write " + file);
    }

private:
    std::string out_;
};

std::string filled(const std::string& colour) {
    return "fill=\"" + colour + "\"";
}

std::string only_filled(const std::string& colour) {
    return filled(colour) + " stroke=\"none\"";
}

std::string stroked(const std::string& colour, double width) {
    return "stroke=\"" + colour + "\" stroke-width=\"" + number(width) + "\" stroke-linecap=\"round\"";
}

// --- where the words of a piece go ------------------------------------------------------------------------------

double area(const std::vector<Place>& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Place& p = loop[i];
        const Place& q = loop[(i + 1) % loop.size()];
        twice += p[0] * q[1] - p[1] * q[0];
    }
    return twice / 2;
}

/// How far inside a loop a point is, words being three times as wide as high.
double depth(const std::vector<Place>& loop, Place x) {
    bool inside = false;
    double least = 1e9;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Place& p = loop[i];
        const Place& q = loop[(i + 1) % loop.size()];
        if ((p[1] > x[1]) != (q[1] > x[1]) && x[0] < p[0] + (q[0] - p[0]) * (x[1] - p[1]) / (q[1] - p[1]))
            inside = !inside;
        const Place d{(q[0] - p[0]) / 3, q[1] - p[1]};
        const Place e{(x[0] - p[0]) / 3, x[1] - p[1]};
        const double t = std::clamp((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1]), 0.0, 1.0);
        least = std::min(least, std::hypot(e[0] - t * d[0], e[1] - t * d[1]));
    }
    return inside ? least : -least;
}

Place middle(const std::vector<Place>& loop) {
    Place best = loop.front();
    double most = -1e9;
    for (double y = 0; y < 520; y += 4)
        for (double x = 0; x < 700; x += 4) {
            const double d = depth(loop, {x, y});
            if (d <= most) continue;
            most = d;
            best = {x, y};
        }
    return best;
}

// --- the drawing ------------------------------------------------------------------------------------------------

class Drawing {
public:
    explicit Drawing(Arrangement& arrangement) : arrangement_(&arrangement) {}

    /// The pieces by label, as loops with the piece on their left.
    [[nodiscard]] std::map<Bits, std::vector<std::vector<PointId>>> loops() {
        std::map<Bits, std::vector<Side>> by_label;
        for (const Side& s : arrangement_->sides()) by_label[s.label].push_back(s);
        std::map<Bits, std::vector<std::vector<PointId>>> loops;
        for (auto& [label, sides] : by_label)
            while (!sides.empty()) loops[label].push_back(take_loop(sides));
        return loops;
    }

    void face(Page& page) {
        std::vector<std::pair<Place, std::string>> words;
        for (const auto& [label, list] : loops())
            for (const std::vector<PointId>& loop : list) {
                std::vector<Place> corners;
                for (const PointId p : loop) corners.push_back(place(p));
                page.polygon(corners, only_filled(fill_of(label)));
                if (area(corners) < 0) words.push_back({middle(corners), words_of(label)});  // y goes down here
            }
        std::vector<Place> outline;
        for (const PointId p : arrangement_->corners()) outline.push_back(place(p));
        page.polygon(outline, "fill=\"none\" stroke-linejoin=\"round\" " + stroked(inks[0], 2.5));
        for (const SegmentRecord& s : arrangement_->segments()) segment(page, s);
        for (const Place& p : outline) page.dot(p, 4, only_filled(inks[0]));
        for (std::size_t n = 0; n < arrangement_->points().size(); ++n) {
            const CommonPoint& p = arrangement_->points()[n];
            page.mark(place(p.point), n + 1, p.is_triple());
        }
        for (const auto& [at, text] : words)
            page.text({at[0], at[1] + 5}, text, filled(inks[0]) + " font-style=\"italic\" text-anchor=\"middle\"");
    }

    void legend(Page& page, double left, double top) const {
        for (std::size_t n = 0; n < arrangement_->points().size(); ++n, top += 25) {
            const CommonPoint& p = arrangement_->points()[n];
            page.mark({left + 10, top}, n + 1, p.is_triple());
            page.text({left + 28, top + 5}, p.name(), filled(p.is_triple() ? red : inks[0]));
        }
    }

    [[nodiscard]] Place place(PointId p) {
        const std::array<Rational, 2> x = arrangement_->coordinates(p);
        return {40 + 44 * to_double(x[0]), 460 - 44 * to_double(x[1])};
    }

private:
    /// Takes the sides of one loop, turning left as far as possible where several go on.
    std::vector<PointId> take_loop(std::vector<Side>& sides) {
        std::vector<PointId> loop;
        Side s = sides.back();
        sides.pop_back();
        const PointId first = s.from;
        for (;;) {
            loop.push_back(s.from);
            if (s.to == first) return loop;
            auto next = sides.end();
            for (auto n = sides.begin(); n != sides.end(); ++n)
                if (n->from == s.to && (next == sides.end() || left_turn(s, *n) > left_turn(s, *next))) next = n;
            if (next == sides.end()) throw Error("the pieces of the face are not closed");
            s = *next;
            sides.erase(next);
        }
    }

    double left_turn(const Side& a, const Side& b) {
        const Place p = place(a.from);
        const Place q = place(a.to);
        const Place r = place(b.to);
        const Place d{q[0] - p[0], p[1] - q[1]};
        const Place e{r[0] - q[0], q[1] - r[1]};
        return std::atan2(d[0] * e[1] - d[1] * e[0], d[0] * e[0] + d[1] * e[1]);
    }

    /// A common segment with an arrow: the other operand is inside on its left.
    void segment(Page& page, const SegmentRecord& s) {
        const Place a = place(s.from);
        const Place b = place(s.to);
        const char* const ink = inks[s.operand];
        page.line(a, b, stroked(ink, 2.5));
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const Place d{(b[0] - a[0]) / length, (b[1] - a[1]) / length};
        const Place m{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
        page.polygon({{m[0] + 7 * d[0], m[1] + 7 * d[1]},
                      {m[0] - 5 * d[0] - 5 * d[1], m[1] - 5 * d[1] + 5 * d[0]},
                      {m[0] - 5 * d[0] + 5 * d[1], m[1] - 5 * d[1] - 5 * d[0]}},
                     only_filled(ink));
    }

    Arrangement* arrangement_;
};

/// Solids as they are seen from in front and above.
class View {
public:
    View(double left, double top) : left_(left), top_(top) {}

    void add(const Region<3>& solid, const std::string& colour) {
        const Boundary<3>& b = solid.boundary();
        for (const FaceList::Face& face : b.faces.faces) {
            Shape shape{{}, colour, 0};
            for (const Corner& c : b.faces.loop(face.first_loop)) {
                const auto& x = b.points[c.point].approximation;
                shape.corners.push_back(place(x));
                shape.depth += x[1] - 0.5 * x[2];
            }
            shape.depth /= double(shape.corners.size());
            if (area(shape.corners) < 0) shapes_.push_back(shape);  // others are seen from behind
        }
    }

    /// What was added, from back to front.
    void draw(Page& page) {
        std::stable_sort(shapes_.begin(), shapes_.end(),
                         [](const Shape& a, const Shape& b) { return a.depth > b.depth; });
        for (const Shape& s : shapes_)
            page.polygon(s.corners, filled(s.colour) + " stroke-linejoin=\"round\" " + stroked(inks[0], 1));
        shapes_.clear();
    }

    void name(Page& page, const std::array<double, 3>& x, const char* name) const {
        const Place at = place(x);
        page.text({at[0], at[1] + 5}, name, filled(inks[0]) + " text-anchor=\"middle\"");
    }

private:
    struct Shape {
        std::vector<Place> corners;
        std::string colour;
        double depth;
    };

    [[nodiscard]] Place place(const std::array<double, 3>& x) const {
        return {left_ + 11 * (x[0] + 0.35 * x[1]), top_ - 11 * (0.55 * x[1] + 0.8 * x[2])};
    }

    double left_, top_;
    std::vector<Shape> shapes_;
};

void legend_of_lines(Page& page, double left, double top) {
    const std::array<const char*, 3> lines{"edges of the face", "in common with B", "in common with C"};
    for (std::size_t i = 0; i < 3; ++i, left += 185) {
        page.line({left, top}, {left + 34, top}, stroked(inks[i], 2.5));
        page.text({left + 44, top + 5}, lines[i], filled(inks[0]));
    }
    page.polygon({{left + 12, top}, {left, top - 5}, {left, top + 5}}, only_filled(inks[0]));
    page.text({left + 22, top + 5}, "has the other solid on its left", filled(inks[0]));
}

void run() {
    const Region<3> a = prism<Rational>({{0, 0}, {12, 0}, {14, 4}, {9, 9}, {1, 7}}, -5, 0);
    const Region<3> b = leaning_prism({{5, 2}, {15, 1}, {18, 3}, {6, 6}});
    const Region<3> c = simplex<3>({{2, 3, 0}, {7, 10, 4}, {10, 1, -2}, {7, 7, -4}});
    const std::array<Boundary<3>, 3> conforming{make_conforming(a.boundary()), make_conforming(b.boundary()),
                                                make_conforming(c.boundary())};
    const std::array<const Boundary<3>*, 3> operands{&conforming[0], &conforming[1], &conforming[2]};
    Arrangement arrangement(operands, 1);  // the top of a prism
    Drawing drawing(arrangement);

    for (std::size_t n = 0; n < arrangement.points().size(); ++n) {
        const CommonPoint& p = arrangement.points()[n];
        const std::array<Rational, 2> x = arrangement.coordinates(p.point);
        std::printf("%zu: (%s, %s), %s\n", n + 1, to_text(x[0]).c_str(), to_text(x[1]).c_str(), p.name().c_str());
    }
    std::printf("common segments: %zu\n", arrangement.segments().size());
    for (const auto& [label, loops] : drawing.loops()) {
        std::size_t corners = 0;
        for (const auto& loop : loops) corners += loop.size();
        std::printf("pieces %s: %zu, corners: %zu\n", words_of(label).c_str(), loops.size(), corners);
    }

    Page page;
    page.text({24, 32}, "The top of A, where B and C cut it", filled(inks[0]) + " font-size=\"17\"");
    drawing.face(page);
    legend_of_lines(page, 40, 500);
    View view(716, 172);
    view.add(a, "#dfe4ea");
    view.draw(page);
    view.add(b - a - c, fill_of(2));
    view.add(c - a, fill_of(4));
    view.draw(page);
    view.name(page, {6, 0, -2.5}, names[0]);
    view.name(page, {11, 2, 1}, names[1]);
    view.name(page, {2.9, 7.8, 1.5}, names[2]);
    drawing.legend(page, 700, 270);
    page.write("arrangement.svg", 990, 525);
}

}  // namespace

int main() {
    try {
        run();
    } catch (const std::exception& e) {
        std::fprintf(stderr, "arrangement_picture: %s\n", e.what());
        return 1;
    }
}

// SPDX-License-Identifier: Apache-2.0
/// Draws a region beside its tree, before and after trimming, into tree.svg: the cells of the tree with its cuts, and
/// the nodes and leaves that they belong to.
#include <cleave.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace cleave;
using Tree = PlaneTree<PlaneId>;
using Model = PolytopeClip<2>;

constexpr double unit = 46;

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", x);
    return text;
}

/// The name of a node: a, b, ..., z, a1, ...
std::string name(std::size_t i) {
    return std::string(1, char('a' + i % 26)) + (i < 26 ? "" : std::to_string(i / 26));
}

class Drawing {
public:
    /// The cells inside [-1, 7] x [-1, 6], each polygon filled by its label, each sub-hyperplane with its node's name.
    void cells(Model& model, const Tree& whole, double left, double top) {
        Polytope view = model.universe();
        for (const auto& side : {make_plane<Integer>(1, 0, -7), make_plane<Integer>(-1, 0, -1),
                                 make_plane<Integer>(0, 1, -6), make_plane<Integer>(0, -1, -1)})
            view = *model.split_cell(model.kernel().planes.intern(side.coefficients()), view).minus;
        std::string lines;
        const Tree tree = restricted(model, whole, view);
        for_each_cell(model, tree, view, [&](Branch b, const Polytope& cell, const auto& split) {
            if (b.is_leaf()) {
                out_ += "<polygon points=\"" + polygon(model, cell, left, top) + "\" fill=\"" +
                        (tree.label(b) ? "#f2b84b" : "#eef1f5") + "\" stroke=\"none\"/>\n";
                return;
            }
            const Polytope& lid = model.body(*split.lid);
            const auto p = place(model, lid.points[0], left, top);
            const auto q = place(model, lid.points[1], left, top);
            lines += "<line x1=\"" + number(p[0]) + "\" y1=\"" + number(p[1]) + "\" x2=\"" + number(q[0]) + "\" y2=\"" +
                     number(q[1]) + "\" stroke=\"#3b4a5a\" stroke-width=\"1.5\"/>\n" +
                     text((p[0] + q[0]) / 2 + 7, (p[1] + q[1]) / 2 - 5, name(b.index()), "#b3261e");
        });
        out_ += lines;
    }

    /// The tree itself: minus to the left, plus to the right, leaves as squares.
    void tree(const Tree& tree, double left, double top) {
        double next = left;
        layout(tree, tree.root(), next, top);
    }

    void caption(double x, double y, const std::string& words) { out_ += text(x, y, words, "#1b2733"); }

    void write(const std::string& file, double width, double height) const {
        std::ofstream svg(file);
        svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
            << "\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" "
               "fill=\"white\"/>\n"
            << out_ << "</svg>\n";
        if (!svg.flush()) throw Error("can't write " + file);
    }

private:
    static std::string text(double x, double y, const std::string& words, const char* colour) {
        return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" fill=\"" + colour + "\">" + words + "</text>\n";
    }

    static std::array<double, 2> place(Model& model, PointId p, double left, double top) {
        model.kernel().refine(p);
        const auto& x = model.kernel().point(p).approximation;
        return {left + (x[0] + 1) * unit, top + (6 - x[1]) * unit};
    }

    static std::string polygon(Model& model, const Polytope& cell, double left, double top) {
        std::vector<std::array<double, 2>> corners;
        std::array<double, 2> middle{};
        for (const PointId p : cell.points) {
            corners.push_back(place(model, p, left, top));
            for (std::size_t i = 0; i < 2; ++i) middle[i] += corners.back()[i] / double(cell.size());
        }
        std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
            return std::atan2(a[1] - middle[1], a[0] - middle[0]) < std::atan2(b[1] - middle[1], b[0] - middle[0]);
        });
        std::string points;
        for (const auto& c : corners) points += number(c[0]) + "," + number(c[1]) + " ";
        return points;
    }

    double layout(const Tree& tree, Branch b, double& next, double y) {
        constexpr double step = 34;
        if (b.is_leaf()) {
            const double x = next + step / 2;
            next += step;
            out_ += "<rect x=\"" + number(x - 8) + "\" y=\"" + number(y - 8) + "\" width=\"16\" height=\"16\" fill=\"" +
                    (tree.label(b) ? "#f2b84b" : "#eef1f5") + "\" stroke=\"#3b4a5a\"/>\n";
            return x;
        }
        const double a = layout(tree, tree.minus(b), next, y + 52);
        const double c = layout(tree, tree.plus(b), next, y + 52);
        const double x = (a + c) / 2;
        for (const double child : {a, c})
            out_ += "<line x1=\"" + number(x) + "\" y1=\"" + number(y + 12) + "\" x2=\"" + number(child) + "\" y2=\"" +
                    number(y + 40) + "\" stroke=\"#3b4a5a\"/>\n";
        out_ += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) +
                "\" r=\"12\" fill=\"white\" stroke=\"#3b4a5a\"/>\n" + text(x - 4, y + 5, name(b.index()), "#b3261e");
        return x;
    }

    std::string out_;
};

void run() {
    // [merge]
    Kernel<2> kernel;
    Model model(kernel);
    const Tree square = tree_of_boundary(box<2>({0, 0}, {4, 4}).boundary(), kernel);
    const Tree triangle = tree_of_boundary(simplex<2>({{2, 1}, {6, 3}, {2, 5}}).boundary(), kernel);
    const Tree merged = collapse(merge(model, square, triangle, BooleanRule(Operation::union_)));
    const Tree trimmed = trim(model, merged);
    // [/merge]
    std::printf("square: %zu nodes, triangle: %zu nodes\n", square.node_count(), triangle.node_count());
    std::printf("merged and collapsed: %zu nodes, trimmed: %zu\n", merged.node_count(), trimmed.node_count());
    std::printf("pieces of boundary: %zu\n", boundary(model, trimmed).size());

    Drawing drawing;
    drawing.caption(30, 30, "the union of a square and a triangle, and the cuts of its tree");
    drawing.cells(model, trimmed, 30, 50);
    drawing.tree(trimmed, 440, 70);
    drawing.write("tree.svg", 860, 390);
}

}  // namespace

int main() {
    try {
        run();
    } catch (const std::exception& e) {
        std::fprintf(stderr, "tree_picture: %s\n", e.what());
        return 1;
    }
}

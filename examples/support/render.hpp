// SPDX-License-Identifier: Apache-2.0
/// A small software renderer for the examples' pictures: shaded triangles with hidden surfaces removed, soft shadows,
/// and the edges where surfaces meet drawn as fine lines.
///
/// Everything here is for the eye: doubles and floats, nothing exact. Several scenes stand side by side under one
/// camera, so that a solid keeps its place and size from panel to panel.
#ifndef CLEAVE_EXAMPLES_SUPPORT_RENDER_HPP
#define CLEAVE_EXAMPLES_SUPPORT_RENDER_HPP

#include <cleave/io/output_file.hpp>
#include <cleave/mesh/face_shape.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/weld.hpp>

#include "support/png.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace picture {

struct Vector {
    double x = 0, y = 0, z = 0;

    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
};
[[nodiscard]] inline double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vector a) {
    return std::sqrt(dot(a, a));
}
[[nodiscard]] inline Vector unit(Vector a) {
    return dot(a, a) > 0 ? (1 / length(a)) * a : Vector{0, 0, 1};
}

/// Red, green, blue as on the screen, 0 to 255.
struct Colour {
    double r = 0, g = 0, b = 0;
};

/// Colours for the operands of an operation: told apart in print, and by those who see fewer colours.
inline const std::vector<Colour> operand_colours{{86, 142, 210}, {240, 162, 72}, {112, 178, 122}, {205, 110, 140}};

/// A mesh and the colour of each of its faces.
struct Body {
    cleave::Mesh mesh;
    std::vector<Colour> colours;  ///< one for each face, or one for all
};

/// A mesh whose faces take the colour of the operand that each came from.
[[nodiscard]] inline Body body(const cleave::Mesh& mesh, const std::vector<std::uint32_t>& operand_of_face) {
    Body result{mesh, {}};
    for (const std::uint32_t o : operand_of_face) result.colours.push_back(operand_colours[o % operand_colours.size()]);
    return result;
}

/// What is seen in one panel.
using Scene = std::vector<Body>;

struct View {
    std::size_t panel_width = 640;
    std::size_t panel_height = 640;
    double azimuth = 35;     ///< degrees around the vertical, counter-clockwise
    double elevation = 22;   ///< degrees above the horizon
    int up = 2;              ///< the vertical axis: 0, 1, 2 for x, y, z
    double crease = 40;      ///< degrees: edges sharper than this are shaded as edges
    double drawn = 55;       ///< degrees: edges sharper than this are drawn
    bool edges = true;       ///< draw sharp edges and the seams between colours
    bool wireframe = false;  ///< draw all edges of faces
    bool shadows = true;
    Colour background{250, 250, 251};
    int samples = 3;  ///< per pixel, in each direction
};

namespace detail {

/// Screen colours are not proportional to light; shading is done in light.
[[nodiscard]] inline Vector to_light(Colour c) {
    const auto channel = [](double v) { return std::pow(v / 255, 2.2); };
    return {channel(c.r), channel(c.g), channel(c.b)};
}
[[nodiscard]] inline std::uint8_t to_screen(double light) {
    return static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(light, 0.0, 1.0), 1 / 2.2)));
}

struct Triangle {
    std::array<Vector, 3> corner;
    std::array<Vector, 3> normal;  // of the surface at each corner
    Vector light;                  // the colour
};

struct Line {
    Vector a, b;
    double strength;
};

/// One panel's geometry, y pointing up in the world.
struct Geometry {
    std::vector<Triangle> triangles;
    std::vector<Line> lines;
};

/// Adds a mesh: corner normals are averaged over the faces that meet there without a crease.
inline void add_body(const Body& source, const View& view, Geometry& out) {
    const cleave::SplitMesh<double> split = cleave::triangulate_faces(source.mesh);
    const cleave::Mesh mesh = cleave::weld(split.mesh);
    const auto colour_of = [&](std::size_t t) {
        return source.colours.size() == 1 ? source.colours[0] : source.colours[split.source[t]];
    };
    std::vector<Vector> points;
    for (const auto& p : mesh.points) {
        // A rotation that brings the vertical axis to y.
        if (view.up == 0) points.push_back({p[1], p[0], -p[2]});
        if (view.up == 1) points.push_back({p[0], p[1], p[2]});
        if (view.up == 2) points.push_back({p[0], p[2], -p[1]});
    }
    const std::size_t n = mesh.face_count();
    std::vector<Vector> normal(n);
    std::vector<std::vector<std::uint32_t>> faces_at(points.size());
    for (std::uint32_t t = 0; t < n; ++t) {
        const auto f = mesh.face(t);
        normal[t] = cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]);
        for (const std::uint32_t c : f) faces_at[c].push_back(t);
    }
    const double smooth = std::cos(view.crease * std::numbers::pi / 180);
    const double blunt = std::cos(view.drawn * std::numbers::pi / 180);
    for (std::uint32_t t = 0; t < n; ++t) {
        if (dot(normal[t], normal[t]) == 0) continue;
        const auto f = mesh.face(t);
        Triangle triangle;
        triangle.light = to_light(colour_of(t));
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.corner[i] = points[f[i]];
            Vector sum{};
            for (const std::uint32_t other : faces_at[f[i]]) {
                // The faces' areas are in their normals, so the larger ones count more.
                if (dot(unit(normal[other]), unit(normal[t])) >= smooth) sum = sum + normal[other];
            }
            triangle.normal[i] = unit(sum);
        }
        out.triangles.push_back(triangle);
    }
    // An edge is drawn where its faces meet at a crease or differ in colour, or where it has not just two faces.
    struct Side {
        std::uint32_t low, high, face;
    };
    std::vector<Side> sides;
    for (std::uint32_t t = 0; t < n; ++t) {
        const auto f = mesh.face(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = f[i], b = f[(i + 1) % 3];
            if (a != b) sides.push_back({std::min(a, b), std::max(a, b), t});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t j = i + 1;
        while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
        bool crease = j - i != 2;
        bool seam = false;
        bool inner = false;
        if (j - i == 2) {
            const std::uint32_t s = sides[i].face, t = sides[i + 1].face;
            const Colour c = colour_of(s), d = colour_of(t);
            crease = dot(unit(normal[s]), unit(normal[t])) < blunt;
            seam = c.r != d.r || c.g != d.g || c.b != d.b;
            inner = split.source[s] == split.source[t];  // a diagonal of one face
        }
        const double strength = (crease || seam) && view.edges ? 0.8 : (view.wireframe && !inner ? 0.35 : 0.0);
        if (strength > 0) out.lines.push_back({points[sides[i].low], points[sides[i].high], strength});
        i = j;
    }
}

/// An orthonormal frame that looks along -z.
struct Frame {
    Vector x, y, z;

    [[nodiscard]] static Frame looking_from(Vector direction) {
        const Vector z = unit(direction);
        const Vector x = unit(std::fabs(z.y) > 0.999 ? Vector{1, 0, 0} : cross({0, 1, 0}, z));
        return {x, cross(z, x), z};
    }
    [[nodiscard]] Vector operator()(Vector p) const { return {dot(p, x), dot(p, y), dot(p, z)}; }
};

/// Calls `f(px, py, w0, w1, w2)` for every sample in a triangle on the screen, with its barycentric coordinates.
template <class F>
void rasterise(const std::array<Vector, 3>& p, std::size_t width, std::size_t height, F&& f) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0 || !std::isfinite(area)) return;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto clamp = [](double v, std::size_t limit) {
        return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(limit)));
    };
    for (std::size_t y = clamp(std::ceil(top - 0.5), height); y < clamp(bottom + 0.5, height); ++y) {
        for (std::size_t x = clamp(std::ceil(left - 0.5), width); x < clamp(right + 0.5, width); ++x) {
            const double sx = static_cast<double>(x) + 0.5, sy = static_cast<double>(y) + 0.5;
            const double w0 = ((p[1].x - sx) * (p[2].y - sy) - (p[1].y - sy) * (p[2].x - sx)) / area;
            const double w1 = ((p[2].x - sx) * (p[0].y - sy) - (p[2].y - sy) * (p[0].x - sx)) / area;
            const double w2 = 1 - w0 - w1;
            if (w0 >= 0 && w1 >= 0 && w2 >= 0) f(x, y, w0, w1, w2);
        }
    }
}

/// Depths seen from the light: a point is in shadow where something is nearer to it.
class ShadowMap {
public:
    ShadowMap(const Geometry& geometry, Vector towards_light, Vector centre, double radius)
        : frame_(Frame::looking_from(towards_light)),
          centre_(frame_(centre)),
          scale_(size / (2.1 * radius)),
          depth_(size * size, -std::numeric_limits<float>::infinity()) {
        for (const Triangle& t : geometry.triangles) {
            const std::array<Vector, 3> p{project(t.corner[0]), project(t.corner[1]), project(t.corner[2])};
            rasterise(p, size, size, [&](std::size_t x, std::size_t y, double w0, double w1, double w2) {
                float& d = depth_[y * size + x];
                d = std::max(d, static_cast<float>(w0 * p[0].z + w1 * p[1].z + w2 * p[2].z));
            });
        }
    }

    /// The share of light that reaches a point, averaged over a square of the map `spread` cells to each side.
    [[nodiscard]] double light_at(Vector p, int spread, double bias) const {
        const Vector q = project(p);
        int lit = 0, all = 0;
        const int step = std::max(1, spread / 3);
        for (int dy = -spread; dy <= spread; dy += step) {
            for (int dx = -spread; dx <= spread; dx += step, ++all) {
                const double x = q.x + dx, y = q.y + dy;
                if (x < 0 || y < 0 || x >= size || y >= size) {
                    ++lit;
                } else {
                    const float d = depth_[static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x)];
                    lit += static_cast<double>(d) <= q.z + bias ? 1 : 0;
                }
            }
        }
        return static_cast<double>(lit) / all;
    }

private:
    static constexpr std::size_t size = 1536;

    [[nodiscard]] Vector project(Vector p) const {
        const Vector q = frame_(p) - centre_;
        return {size / 2.0 + scale_ * q.x, size / 2.0 - scale_ * q.y, q.z};
    }

    Frame frame_;
    Vector centre_;
    double scale_;
    std::vector<float> depth_;
};

/// Draws one panel.
class Panel {
public:
    Panel(const Geometry& geometry, const View& view, Vector centre, double radius, double floor)
        : geometry_(geometry),
          view_(view),
          centre_(centre),
          radius_(radius),
          floor_(floor),
          samples_(static_cast<std::size_t>(view.samples)),
          width_(view.panel_width * samples_),
          height_(view.panel_height * samples_),
          near_(width_ * height_, 0),
          owner_(width_ * height_, none),
          ink_(width_ * height_, 0) {
        const double a = view.azimuth * std::numbers::pi / 180, e = view.elevation * std::numbers::pi / 180;
        camera_ = Frame::looking_from({std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)});
        key_ = unit(0.45 * camera_.z + 0.95 * Vector{0, 1, 0} - 0.75 * camera_.x);
        fill_ = unit(0.6 * camera_.z + 0.1 * Vector{0, 1, 0} + 0.9 * camera_.x);
        distance_ = 5.2 * radius;
        zoom_ = 0.455 * static_cast<double>(std::min(width_, height_)) * std::sqrt(5.2 * 5.2 - 1);
    }

    void draw(Image& image, std::size_t left) {
        find_visible();
        draw_lines();
        const ShadowMap shadows(geometry_, key_, centre_, radius_);
        for (std::size_t y = 0; y < view_.panel_height; ++y) {
            for (std::size_t x = 0; x < view_.panel_width; ++x) {
                // The floor is soft, one look at it does for all samples of a pixel.
                Vector sum{}, floor{};
                bool floor_known = false;
                for (std::size_t s = 0; s < samples_ * samples_; ++s) {
                    const std::size_t sx = x * samples_ + s % samples_, sy = y * samples_ + s / samples_;
                    const std::size_t i = sy * width_ + sx;
                    if (owner_[i] == none && !std::exchange(floor_known, true)) floor = ground(x, y, shadows);
                    const double ink = static_cast<double>(ink_[i]);
                    const Vector seen = owner_[i] == none ? floor : surface(i, sx, sy, shadows);
                    sum = sum + (1 - ink) * seen + ink * line_colour;
                }
                sum = (1.0 / static_cast<double>(samples_ * samples_)) * sum;
                std::uint8_t* const pixel = image.pixel(left + x, y);
                pixel[0] = to_screen(sum.x);
                pixel[1] = to_screen(sum.y);
                pixel[2] = to_screen(sum.z);
            }
        }
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;
    static constexpr Vector line_colour{0.012, 0.014, 0.02};

    /// Screen position and, as z, the reciprocal of the depth: linear on the screen, larger is nearer.
    [[nodiscard]] Vector project(Vector p) const {
        const Vector q = camera_(p - centre_);
        const double nearness = 1 / std::max(distance_ - q.z, 1e-3 * distance_);
        return {static_cast<double>(width_) / 2 + zoom_ * q.x * nearness,
                static_cast<double>(height_) / 2 - zoom_ * q.y * nearness, nearness};
    }

    void find_visible() {
        for (std::uint32_t t = 0; t < geometry_.triangles.size(); ++t) {
            const auto& c = geometry_.triangles[t].corner;
            const std::array<Vector, 3> p{project(c[0]), project(c[1]), project(c[2])};
            rasterise(p, width_, height_, [&](std::size_t x, std::size_t y, double w0, double w1, double w2) {
                const auto nearness = static_cast<float>(w0 * p[0].z + w1 * p[1].z + w2 * p[2].z);
                const std::size_t i = y * width_ + x;
                if (nearness > near_[i]) {
                    near_[i] = nearness;
                    owner_[i] = t;
                }
            });
        }
    }

    /// Lines are a pixel and a half wide and hidden by what is clearly in front of them.
    void draw_lines() {
        const double half = 0.65 * static_cast<double>(samples_);
        for (const Line& line : geometry_.lines) {
            const Vector a = project(line.a), b = project(line.b);
            const double dx = b.x - a.x, dy = b.y - a.y;
            const double squared = dx * dx + dy * dy;
            const bool steep = std::fabs(dy) > std::fabs(dx);
            const double from = (steep ? std::min(a.y, b.y) : std::min(a.x, b.x)) - half;
            const double to = (steep ? std::max(a.y, b.y) : std::max(a.x, b.x)) + half;
            for (double m = std::floor(from); m <= to; m += 1) {
                const double along = m + 0.5;
                const double s =
                    squared == 0 ? 0 : std::clamp((along - (steep ? a.y : a.x)) / (steep ? dy : dx), 0.0, 1.0);
                const double middle = steep ? a.x + s * dx : a.y + s * dy;
                for (double k = std::floor(middle - 1.5 * half); k <= middle + 1.5 * half; k += 1) {
                    const double across = k + 0.5;
                    const double px = steep ? across : along, py = steep ? along : across;
                    const double t =
                        squared == 0 ? 0 : std::clamp(((px - a.x) * dx + (py - a.y) * dy) / squared, 0.0, 1.0);
                    const double ex = px - a.x - t * dx, ey = py - a.y - t * dy;
                    if (ex * ex + ey * ey > half * half) continue;
                    if (px < 0 || py < 0 || px >= static_cast<double>(width_) || py >= static_cast<double>(height_))
                        continue;
                    const std::size_t i = static_cast<std::size_t>(py) * width_ + static_cast<std::size_t>(px);
                    const double nearness = a.z + t * (b.z - a.z);
                    if (nearness * 1.004 < static_cast<double>(near_[i])) continue;
                    ink_[i] = std::max(ink_[i], static_cast<float>(line.strength));
                }
            }
        }
    }

    /// The light that a sample of a surface sends to the eye.
    [[nodiscard]] Vector surface(std::size_t i, std::size_t x, std::size_t y, const ShadowMap& shadows) const {
        const Triangle& t = geometry_.triangles[owner_[i]];
        const std::array<Vector, 3> p{project(t.corner[0]), project(t.corner[1]), project(t.corner[2])};
        const double sx = static_cast<double>(x) + 0.5, sy = static_cast<double>(y) + 0.5;
        const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        double w0 = ((p[1].x - sx) * (p[2].y - sy) - (p[1].y - sy) * (p[2].x - sx)) / area * p[0].z;
        double w1 = ((p[2].x - sx) * (p[0].y - sy) - (p[2].y - sy) * (p[0].x - sx)) / area * p[1].z;
        double w2 = ((p[0].x - sx) * (p[1].y - sy) - (p[0].y - sy) * (p[1].x - sx)) / area * p[2].z;
        const double sum = w0 + w1 + w2;  // divided out, weights are right in space and not only on the screen
        w0 /= sum;
        w1 /= sum;
        w2 /= sum;
        const Vector where = w0 * t.corner[0] + w1 * t.corner[1] + w2 * t.corner[2];
        const Vector eye = unit(centre_ + distance_ * camera_.z - where);
        Vector n = unit(w0 * t.normal[0] + w1 * t.normal[1] + w2 * t.normal[2]);
        if (dot(n, eye) < 0) n = n - (1.02 * dot(n, eye)) * eye;  // an averaged normal may lean away at the outline
        const double facing = std::max(0.0, dot(n, key_));
        const Vector flat = unit(cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]));
        double lit = 1;
        if (view_.shadows && facing > 0 && dot(flat, key_) > 0) {
            lit = shadows.light_at(where + (0.008 * radius_) * flat, 2, 0.004 * radius_);
            // Where light grazes the surface, flat triangles shade each other though the solid they stand for would
            // not.
            lit = std::max(lit, 1 - facing / 0.12);
        }
        const double sky = 0.5 + 0.5 * n.y;
        const double diffuse = 0.72 * facing * lit + 0.18 * std::max(0.0, dot(n, fill_)) + 0.12 + 0.17 * sky;
        const double gloss = 0.10 * lit * std::pow(std::max(0.0, dot(n, unit(key_ + eye))), 40);
        return diffuse * t.light + Vector{gloss, gloss, gloss};
    }

    /// The background, darker where the solids keep the light from the floor below them.
    [[nodiscard]] Vector ground(std::size_t x, std::size_t y, const ShadowMap& shadows) const {
        const Vector base = to_light(view_.background);
        if (!view_.shadows) return base;
        const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
        const double w = static_cast<double>(view_.panel_width), h = static_cast<double>(view_.panel_height);
        const double u = static_cast<double>(samples_) * (px - w / 2) / zoom_;
        const double v = static_cast<double>(samples_) * (h / 2 - py) / zoom_;
        const Vector ray = u * camera_.x + v * camera_.y - camera_.z;
        const Vector eye = centre_ + distance_ * camera_.z;
        if (ray.y >= 0) return base;
        const Vector where = eye + ((floor_ - eye.y) / ray.y) * ray;
        // Shadows fade towards the rim of the panel, where they would be cut off.
        const double rim = std::min({px, w - px, py, h - py}) / (0.12 * std::min(w, h));
        const double fade =
            std::clamp(rim, 0.0, 1.0) * std::clamp(1.9 - 0.6 * length(where - centre_) / radius_, 0.0, 1.0);
        if (fade == 0) return base;
        return (1 - 0.4 * fade * (1 - shadows.light_at(where, 30, 0.002 * radius_))) * base;
    }

    const Geometry& geometry_;
    const View& view_;
    Vector centre_;
    double radius_, floor_;
    std::size_t samples_, width_, height_;
    Frame camera_{};
    Vector key_, fill_;
    double distance_ = 0, zoom_ = 0;
    std::vector<float> near_;
    std::vector<std::uint32_t> owner_;
    std::vector<float> ink_;
};

}  // namespace detail

/// A picture of scenes side by side, all under the camera that frames them together.
[[nodiscard]] inline Image render(const std::vector<Scene>& scenes, const View& view = {}) {
    std::vector<detail::Geometry> panels(scenes.size());
    const double infinity = std::numeric_limits<double>::infinity();
    Vector lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        for (const Body& b : scenes[s]) detail::add_body(b, view, panels[s]);
        for (const detail::Triangle& t : panels[s].triangles) {
            for (const Vector& p : t.corner) {
                lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
                upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
            }
        }
    }
    if (!(lower.x <= upper.x)) lower = upper = {};
    const Vector centre = 0.5 * (lower + upper);
    double radius = 0;
    for (const detail::Geometry& g : panels) {
        for (const detail::Triangle& t : g.triangles) {
            for (const Vector& p : t.corner) radius = std::max(radius, length(p - centre));
        }
    }
    if (radius == 0) radius = 1;
    Image image(view.panel_width * scenes.size(), view.panel_height);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        detail::Panel(panels[s], view, centre, radius, lower.y).draw(image, s * view.panel_width);
    }
    return image;
}

/// Writes a PNG file. Throws: cleave::FileError.
inline void write_png(const std::filesystem::path& path, const Image& image) {
    cleave::write_file(path, to_png(image));
}

}  // namespace picture

#endif

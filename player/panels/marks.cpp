#include "player/panels/marks.h"

#include <algorithm>
#include <cmath>

#include "shaders/contract.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

std::array<float, 3> floats(const Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

std::array<std::uint8_t, 4> bytes(const MarkColor& color) {
    std::array<std::uint8_t, 4> out{};
    std::ranges::transform(color, out.begin(), [](float c) {
        return std::uint8_t(std::lround(255 * std::clamp(c, 0.0f, 1.0f)));
    });
    return out;
}

bool is_finite(const Mark& m) {
    const auto finite = [](float f) { return std::isfinite(f); };
    return std::ranges::all_of(m.points, [&](const auto& p) { return std::ranges::all_of(p, finite); }) &&
           std::ranges::all_of(m.sizes, finite);
}

/// Appends a mark. A mark without a texture joins the last run, whatever the run's texture.
void add(Marks& marks, const Mark& mark, GLuint texture = 0, bool decodes = false) {
    if (!is_finite(mark)) return;
    const bool fits =
        !marks.runs.empty() &&
        (texture == 0 || (marks.runs.back().texture == texture && marks.runs.back().decodes == decodes));
    if (!fits) marks.runs.push_back({texture, decodes, marks.marks.size(), 0});
    marks.marks.push_back(mark);
    ++marks.runs.back().count;
}

/// A segment between two points of a path; each end is joined to a neighboring segment or is round.
Mark line(std::span<const Vector3d> points, std::size_t begin, MarkSize width, const MarkColor& color,
          const MarkColor& end_color) {
    const bool first = begin == 0, last = begin + 2 == points.size();
    return {{floats(points[begin]), floats(points[begin + 1]), floats(points[first ? begin : begin - 1]),
             floats(points[last ? begin + 1 : begin + 2])},
            {float(width.units), float(width.pixels), first ? 1.0f : 0.0f, last ? 1.0f : 0.0f},
            {bytes(color), bytes(end_color)},
            shader::mark_line,
            0};
}

MarkColor mixed(const MarkColor& a, const MarkColor& b, float share) {
    MarkColor out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::lerp(a[i], b[i], share);
    return out;
}

}  // namespace

void clear(Marks& marks) {
    marks.marks.clear();
    marks.runs.clear();
}

void add_line(Marks& marks, const Vector3d& from, const Vector3d& to, MarkSize width,
              const MarkColor& color) {
    add_line(marks, from, to, width, color, color);
}

void add_line(Marks& marks, const Vector3d& from, const Vector3d& to, MarkSize width, const MarkColor& color,
              const MarkColor& end_color) {
    add_path(marks, std::array{from, to}, width, color, end_color);
}

void add_path(Marks& marks, std::span<const Vector3d> points, MarkSize width, const MarkColor& color,
              const MarkColor& end_color) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto color_at = [&](std::size_t n) {
            return mixed(color, end_color, float(n) / float(points.size() - 1));
        };
        add(marks, line(points, i, width, color_at(i), color_at(i + 1)));
    }
}

void add_ring(Marks& marks, const Vector3d& middle, const Vector3d& normal, double inner_radius,
              double outer_radius, const MarkColor& color) {
    // A negative inner radius makes a disc, which also covers its center.
    const double inner = inner_radius > 0 ? inner_radius : -outer_radius;
    add(marks, {{floats(middle), floats(normal / normal.norm())},
                {float(inner), float(outer_radius), 0, 0},
                {bytes(color), bytes(color)},
                shader::mark_ring,
                0});
}

void add_ball(Marks& marks, const Vector3d& middle, MarkSize radius, const MarkColor& color) {
    add(marks, {{floats(middle)},
                {float(radius.units), float(radius.pixels), 0, 0},
                {bytes(color), bytes(color)},
                shader::mark_ball,
                0});
}

void add_picture(Marks& marks, const Vector3d& upper_left, const Vector3d& upper_right,
                 const Vector3d& lower_left, const MarkPicture& picture, const MarkColor& color) {
    add(marks,
        {{floats(upper_left), floats(upper_right), floats(lower_left)},
         picture.part,
         {bytes(color), bytes(color)},
         shader::mark_picture,
         float(picture.layer)},
        picture.texture, picture.decodes);
}

}  // namespace vantage

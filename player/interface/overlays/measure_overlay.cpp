#include "player/interface/overlays/measure_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/overlays/scene_line.h"
#include "player/survey/number_text.h"
#include "player/survey/scale_bar.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using Segments = std::vector<std::pair<Vector3d, Vector3d>>;

constexpr ImU32 shadow = IM_COL32(0, 0, 0, 190), faint = IM_COL32(255, 255, 255, 170);

ImU32 color_of(MeasureLook look) {
    return look == MeasureLook::selected   ? IM_COL32(120, 200, 255, 255)
           : look == MeasureLook::finished ? IM_COL32(255, 205, 70, 255)
                                           : IM_COL32(255, 255, 255, 255);
}

/// The segments of a height measurement: vertical from the first point, then horizontal to the second.
Segments height_segments(const Vector3d& from, const Vector3d& to, const Vector3d& up) {
    const Vector3d corner = from + up * up.dot(to - from);
    return {{from, corner}, {corner, to}};
}

/// A disc, or a ring for a point that is not set.
void draw_point(ImDrawList& list, const View& view, const Vector3d& point, ImU32 color, bool ring) {
    const auto at = project(view.intrinsics, view.cam_from_origin, point);
    if (!at || !in_frame(view.intrinsics, at->pixel)) return;
    const ImVec2 center(float(at->pixel.x()), float(at->pixel.y()));
    if (ring) {
        list.AddCircle(center, 8, shadow, 0, 4);
        return list.AddCircle(center, 8, color, 0, 1.5f);
    }
    list.AddCircleFilled(center, 5, shadow);
    list.AddCircleFilled(center, 3.5f, color);
}

struct Rectangle {
    ImVec2 low, high;
};

/// Moves a rectangle up past those that it would cover, or else down if that would be outside the frame.
Rectangle beside_others(const Rectangle& r, std::span<const Rectangle> others, float frame_height) {
    constexpr float gap = 1;
    const float height = r.high.y - r.low.y;
    for (const bool up : {true, false}) {
        float y = r.low.y;
        const auto covered = [&](const Rectangle& o) {
            return r.low.x < o.high.x && o.low.x < r.high.x && y < o.high.y && o.low.y < y + height;
        };
        for (auto o = std::ranges::find_if(others, covered); o != others.end();
             o = std::ranges::find_if(others, covered))
            y = up ? o->low.y - height - gap : o->high.y + gap;
        if (y >= 0 && y + height <= frame_height) return {{r.low.x, y}, {r.high.x, y + height}};
    }
    return r;
}

/// `labels`: the previous labels, to which this one is added.
void draw_label(Controls& c, ImVec2 at, const std::string& text, ImU32 color,
                std::vector<Rectangle>& labels) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), frame = ImGui::GetIO().DisplaySize;
    const ImVec2 corner(std::max(0.0f, std::min(at.x + 8, frame.x - size.x - 10)),
                        std::max(0.0f, at.y - size.y - 6));
    const auto [low, high] =
        beside_others({corner, ImVec2(corner.x + size.x + 10, corner.y + size.y + 4)}, labels, frame.y);
    labels.push_back({low, high});
    c.note("Measurement label", low, high);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(low, high, IM_COL32(15, 18, 22, 215), 4);
    list.AddText(ImVec2(low.x + 5, low.y + 2), color, text.c_str());
}

void draw_lines(const DrawnMeasurement& d, const std::vector<Vector3d>& p, const View& view,
                const Vector3d& up) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Measure measure = d.measurement.measure;
    const ImU32 color = color_of(d.look);
    const Vector3d* const moving = d.look == MeasureLook::preview ? &p.back() : nullptr;
    Segments segments = lines_of(measure, p, up);
    std::erase_if(segments, [&](const auto& line) {
        const bool moves =
            moving && (measure == Measure::height || line.first == *moving || line.second == *moving);
        if (moves) scene_line(list, view, line.first, line.second, faint, 1.5f);
        return moves;
    });
    for (const auto& [a, b] : segments) scene_line(list, view, a, b, shadow, 4);
    for (const auto& [a, b] : segments) scene_line(list, view, a, b, color, 2);
    for (const Vector3d& v : p) draw_point(list, view, v, color, &v == moving);
}

}  // namespace

std::vector<Vector3d> points_from(const Measurement& m, const Vector3d& origin) {
    std::vector<Vector3d> out;
    for (const SurveyPoint& point : m.points) out.emplace_back(point.position - origin);
    return out;
}

Segments lines_of(Measure measure, const std::vector<Vector3d>& p, const Vector3d& up) {
    if (measure == Measure::height && p.size() == 2) return height_segments(p[0], p[1], up);
    Segments out;
    for (std::size_t i = 1; i < p.size(); ++i) out.emplace_back(p[i - 1], p[i]);
    if (measure == Measure::area && p.size() > 2) out.emplace_back(p.back(), p.front());
    return out;
}

Vector3d label_place(Measure measure, const std::vector<Vector3d>& p, const Vector3d& up) {
    if (measure == Measure::polyline || p.size() == 1) return p.back();
    if (measure == Measure::angle && p.size() == 3) return p[1];
    if (measure == Measure::height) return p[0] + up * (up.dot(p[1] - p[0]) / 2);
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& v : p) sum += v;
    return sum / double(p.size());
}

void draw_measurements(Controls& c, std::span<const DrawnMeasurement> measurements, const View& view,
                       const Vector3d& origin, const Vector3d& up) {
    std::vector<Rectangle> labels;
    for (const DrawnMeasurement& d : measurements) {
        const std::vector<Vector3d> p = points_from(d.measurement, origin);
        if (p.empty()) continue;
        draw_lines(d, p, view, up);
        const auto at =
            project(view.intrinsics, view.cam_from_origin, label_place(d.measurement.measure, p, up));
        if (!at || !in_frame(view.intrinsics, at->pixel) || d.label.empty()) continue;
        draw_label(c, ImVec2(float(at->pixel.x()), float(at->pixel.y())), d.label, color_of(d.look), labels);
    }
}

void show_scale_bar(Controls& c, const View& view, const Vector3d& point, const Scale& scale,
                    const Area& area) {
    const float em = ImGui::GetFontSize();
    const auto bar = scale_bar(view, point, scale, 8 * double(em));
    if (!bar) return;
    const std::string label =
        localized_numbers(number_text(bar->length)) + " " + tr_in("unit", name_of(shown_unit(scale)));
    const ImVec2 high(float(area.left + area.width) - 1.5f * em, float(area.top + area.height) - 1.2f * em),
        low(high.x - float(bar->pixels), high.y - 1.7f * em);
    const ImVec2 corner(low.x - 0.5f * em, low.y), size(high.x - low.x + em, high.y - low.y + 0.4f * em);
    c.begin_handle("Scale bar area", corner, size);
    c.explain(
        "Correct at the distance of the point about which the view turns; nearer parts appear larger, "
        "farther parts smaller.");
    ImGui::End();
    c.note("Drawn scale bar", low, high);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(15, 18, 22, 215), 4);
    const float text = ImGui::CalcTextSize(label.c_str()).x, end = 0.5f * em;
    list.AddText(ImVec2((low.x + high.x - text) / 2, low.y), IM_COL32_WHITE, label.c_str());
    list.AddRectFilled(ImVec2(low.x, high.y - 2), high, IM_COL32_WHITE);
    list.AddRectFilled(ImVec2(low.x, high.y - end), ImVec2(low.x + 2, high.y), IM_COL32_WHITE);
    list.AddRectFilled(ImVec2(high.x - 2, high.y - end), high, IM_COL32_WHITE);
}

}  // namespace vantage

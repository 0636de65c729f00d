#include "player/interface/measuring/profile_chart.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include "base/text/formatted.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/overlays/scene_line.h"
#include "player/survey/measurement.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

constexpr ImU32 profile_color = IM_COL32(255, 90, 60, 255);  // as that of cuts
constexpr double least_range = 1e-3;  ///< of the offsets in a chart, in lengths of the profile

/// The largest of 1, 2 or 5 times a power of ten that is at most `value`.
double round_below(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

/// An axis from a value at one pixel to a value at another.
struct Axis {
    double low, high;
    float from, to;
    float pixel(double value) const { return from + float((value - low) / (high - low)) * (to - from); }
};

/// The numbers along an axis, at most `most`; the last one has the unit.
struct Tick {
    double value;
    std::string text;
};
std::vector<Tick> ticks_of(const Axis& axis, int most, const char* unit) {
    const double range = axis.high - axis.low, step = 1 / round_below((most - 1) / range),
                 size = std::max(std::abs(axis.low), std::abs(axis.high));
    std::vector<Tick> out;
    for (double n = std::ceil(axis.low / step); n * step <= axis.high; ++n)
        out.push_back({n * step, localized_numbers(number_text(n * step, 5, size))});
    if (!out.empty()) out.back().text.append(" ").append(tr_in("unit", unit));
    return out;
}

/// Draws the numbers and lines of both axes. Numbers that would overlap the next one are left out.
void draw_ticks(ImDrawList& list, const Axis& x, const Axis& y, const char* unit) {
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_TextDisabled), grid = ImGui::GetColorU32(ImGuiCol_Border);
    const float em = ImGui::GetFontSize();
    float next = HUGE_VALF;
    for (const Tick& t : ticks_of(x, 6, unit) | std::views::reverse) {
        const float at = x.pixel(t.value), width = ImGui::CalcTextSize(t.text.c_str()).x,
                    left = std::min(at - width / 2, x.to + 0.4f * em - width);
        list.AddLine(ImVec2(at, y.from), ImVec2(at, y.to), grid);
        if (left + width + 0.6f * em > next) continue;
        list.AddText(ImVec2(left, y.from + 0.2f * em), text, t.text.c_str());
        next = left;
    }
    for (const Tick& t : ticks_of(y, 6, unit)) {
        const float at = y.pixel(t.value), width = ImGui::CalcTextSize(t.text.c_str()).x;
        list.AddLine(ImVec2(x.from, at), ImVec2(x.to, at), grid);
        list.AddText(ImVec2(x.from - 0.4f * em - width, at - 0.5f * em), text, t.text.c_str());
    }
}

/// The lowest and the highest offset.
std::array<double, 2> range_of(const SurfaceProfile& p) {
    std::array<double, 2> out{HUGE_VAL, -HUGE_VAL};
    for (const auto& offset : p.offsets)
        if (offset) out = {std::min(out[0], *offset), std::max(out[1], *offset)};
    return out;
}

/// Calls line(i) for consecutive offsets i and i + 1 that exist.
template <class Line>
void each_line(const SurfaceProfile& p, const Line& line) {
    for (std::size_t i = 0; i + 1 < p.offsets.size(); ++i)
        if (p.offsets[i] && p.offsets[i + 1]) line(i);
}

}  // namespace

void ProfileChart::show(Controls& c, Session& s, std::span<const PlacedMesh> meshes, const Survey& survey,
                        std::optional<std::size_t> selected) {
    hovered_.reset();
    if (!selected || survey.measurements[*selected].measure != Measure::profile) {
        profile_ = {};
        points_.clear();
        return;
    }
    const Measurement& m = survey.measurements[*selected];
    update(s, meshes, m.points, survey.up);
    if (profile_.reason) {
        ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
        ImGui::TextUnformatted(tr(profile_.reason));
        ImGui::PopTextWrapPos();
        return;
    }
    chart(c, survey.scale);
    caption(c, m, survey);
    if (c.button("Export profile"))
        s.window.commands.push_back(
            SaveTable{MARKED_IN("written", "profile"), profile_csv(profile_, survey.scale, origin_)});
    c.explain("Writes the profile as a table (CSV) next to the package.");
}

void ProfileChart::update(const Session& s, std::span<const PlacedMesh> meshes,
                          const std::vector<SurveyPoint>& points, const Eigen::Vector3d& up) {
    if (points == points_ && s.settings.sections == sections_ && std::ranges::equal(meshes, meshes_)) return;
    points_ = points;
    sections_ = s.settings.sections;
    meshes_.assign(meshes.begin(), meshes.end());
    profile_ =
        profile_between(meshes, sections_, {points[0].position - origin_, points[1].position - origin_}, up);
}

/// The scale of offsets is a round multiple of that of distances.
void ProfileChart::chart(Controls& c, const Scale& scale) {
    const float em = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size(22 * em, 10 * em);
    ImGui::InvisibleButton("##profile", size);
    c.note("Profile chart");
    const double unit = shown_length(scale);
    const char* const unit_name = name_of(shown_unit(scale));
    const float numbers = ImGui::CalcTextSize((std::string("-00.00 ") + tr_in("unit", unit_name)).c_str()).x;
    const Axis x{0, profile_.length * unit, corner.x + numbers + 0.5f * em, corner.x + size.x - 0.6f * em};
    const auto [low, high] = range_of(profile_);
    const double range = std::max(high - low, least_range * profile_.length) * unit,
                 middle = (low + high) / 2 * unit, per_pixel = x.high / double(x.to - x.from);
    Axis y{0, 0, corner.y + size.y - 1.6f * em, corner.y + 0.7f * em};
    vertical_scale_ = round_below(per_pixel * double(y.from - y.to) / range);
    const double half = per_pixel * double(y.from - y.to) / vertical_scale_ / 2;
    y.low = middle - half, y.high = middle + half;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(ImVec2(x.from, y.to), ImVec2(x.to, y.from), ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw_ticks(list, x, y, unit_name);
    list.PushClipRect(ImVec2(x.from, y.to), ImVec2(x.to, y.from), true);
    const auto at = [&](double distance, double offset) {
        return ImVec2(x.pixel(distance * unit), y.pixel(offset * unit));
    };
    list.AddLine(at(0, 0), at(profile_.length, profile_.rise), ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const auto place = [&](std::size_t i) { return at(profile_.distance(i), *profile_.offsets[i]); };
    each_line(profile_, [&](std::size_t i) { list.AddLine(place(i), place(i + 1), profile_color, 2); });
    if (ImGui::IsItemHovered()) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - x.from) / (x.to - x.from), 0.0f, 1.0f);
        hovered_ = std::size_t(std::lround(share * float(profile_.offsets.size() - 1)));
        const float column = x.pixel(profile_.distance(*hovered_) * unit);
        list.AddLine(ImVec2(column, y.from), ImVec2(column, y.to), ImGui::GetColorU32(ImGuiCol_Text));
        if (profile_.offsets[*hovered_]) list.AddCircleFilled(place(*hovered_), 4, IM_COL32_WHITE);
    }
    list.PopClipRect();
}

void ProfileChart::caption(Controls& c, const Measurement& m, const Survey& survey) const {
    const auto uncertainty = evaluate(m, survey.scale, survey.up).uncertainty;
    const auto number = [&](double length) {
        const double value = length * shown_length(survey.scale);
        return localized_numbers(uncertainty
                                     ? number_text(value, *uncertainty)
                                     : number_text(value, 5, profile_.length * shown_length(survey.scale)));
    };
    const auto with_unit = [&](double length) {
        return number(length) + " " + tr_in("unit", name_of(shown_unit(survey.scale)));
    };
    if (hovered_) {
        const auto& offset = profile_.offsets[*hovered_];
        const std::string distance = with_unit(profile_.distance(*hovered_)),
                          text = offset ? formatted(tr("at %s: %s"), distance.c_str(),
                                                    with_unit(*offset).c_str())
                                        : formatted(tr("at %s: no surface"), distance.c_str());
        ImGui::TextUnformatted(text.c_str());
        return;
    }
    const auto [low, high] = range_of(profile_);
    const std::string from = number(low), to = with_unit(high),
                      times = localized_numbers(number_text(vertical_scale_)),
                      text = formatted(profile_.heights ? tr("heights from %s to %s, vertical scale × %s")
                                                        : tr("offsets from %s to %s, vertical scale × %s"),
                                       from.c_str(), to.c_str(), times.c_str());
    ImGui::TextUnformatted(text.c_str());
    c.explain(profile_.heights ? marked("Heights above the first point, and the factor by which the chart "
                                        "enlarges them relative to distances, which are horizontal.")
                               : marked("Distances from the straight line between the points, positive "
                                        "outside the model, and the factor by which the chart enlarges them "
                                        "relative to distances along the line."));
}

void ProfileChart::draw(const View& view) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    each_line(profile_, [&](std::size_t i) {
        scene_line(list, view, *profile_.point(i), *profile_.point(i + 1), profile_color, 2);
    });
    const auto at = hovered_ ? profile_.point(*hovered_) : std::nullopt;
    const auto shown = at ? project(view.intrinsics, view.cam_from_origin, *at) : std::nullopt;
    if (!shown) return;
    const ImVec2 center(float(shown->pixel.x()), float(shown->pixel.y()));
    list.AddCircleFilled(center, 7, IM_COL32(0, 0, 0, 190));
    list.AddCircleFilled(center, 5, IM_COL32_WHITE);
}

}  // namespace vantage

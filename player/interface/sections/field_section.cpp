#include "player/interface/sections/field_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/text/formatted.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/overlays/seen_triangle.h"
#include "player/interface/overlays/value_at_pixel.h"
#include "player/interface/sections/choice.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

float legend_height() { return ImGui::GetFontSize(); }
float histogram_height() { return 3 * ImGui::GetFontSize(); }

/// The value under the pointer, from the visible triangles of the last frames.
std::optional<double> value_under_pointer(const Renderer& renderer, const ScalarField& field,
                                          const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const SeenTriangles seen = renderer.planner().seen();
    if (io.WantCaptureMouse || seen.view.intrinsics.width != view.intrinsics.width) return {};
    const Eigen::Vector2d at(io.MousePos.x, io.MousePos.y);
    const std::uint32_t triangle = seen_triangle(seen, at);
    if (triangle == 0) return {};
    return value_at_pixel(renderer.scene(), field.values, triangle - 1, seen.view, at);
}

bool has_zero(const ValueRange& range) { return range.low < 0 && range.high > 0; }

double place(double value, const FieldSettings& s, const ValueRange& range) {
    const auto scaled = [&](double v) { return s.logarithmic ? std::log(std::max(v, 1e-300)) : v; };
    return (scaled(value) - scaled(range.low)) / (scaled(range.high) - scaled(range.low));
}

/// The numbers at the ends of a legend and at 0. If 0 is so close to an end that the numbers would touch, it
/// is on its own line.
void legend_numbers(const FieldSettings& s, const ValueRange& range, float width) {
    const std::string lowest = localized_numbers(value_text(range.low, range)),
                      highest = localized_numbers(value_text(range.high, range));
    const float left = ImGui::GetCursorPosX(), end = width - ImGui::CalcTextSize(highest.c_str()).x;
    ImGui::TextUnformatted(lowest.c_str());
    const auto show_highest = [&] {
        ImGui::SameLine(left + end);
        ImGui::TextUnformatted(highest.c_str());
    };
    if (!has_zero(range)) return show_highest();
    const float digit = ImGui::CalcTextSize("0").x, zero = width * float(place(0, s, range)) - digit / 2;
    const bool own_line = zero < ImGui::CalcTextSize(lowest.c_str()).x + digit || zero + 2 * digit > end;
    if (own_line)
        show_highest();
    else
        ImGui::SameLine();
    ImGui::SetCursorPosX(left + std::clamp(zero, 0.0f, width - digit));
    ImGui::TextUnformatted("0");
    if (!own_line) show_highest();
}

/// The color map with the field's histogram above it, and a mark at the value under the pointer.
void legend(const ScalarField& field, const FieldSettings& s, std::optional<double> value) {
    const auto [map, range, center] = field_legend(field, s);
    const ColorTable table = color_table(map, center);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::GetContentRegionAvail().x;
    const float top = low.y + histogram_height(), bottom = top + legend_height();
    const float most = std::max(1.0f, *std::ranges::max_element(field.counts));
    const double bin = (field.high - field.low) / double(field.counts.size());
    list.PushClipRect(low, ImVec2(low.x + width, bottom), true);
    for (std::size_t i = 0; i < field.counts.size(); ++i) {
        const double from = place(field.low + double(i) * bin, s, range),
                     to = place(field.low + double(i + 1) * bin, s, range);
        // The square root keeps small counts visible.
        const float height = histogram_height() * std::sqrt(field.counts[i] / most);
        const auto at = [&](double share) { return low.x + width * float(std::clamp(share, -1.0, 2.0)); };
        list.AddRectFilled(ImVec2(at(from), top - height), ImVec2(std::max(at(to), at(from) + 1), top),
                           IM_COL32(150, 160, 175, 255));
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto x = [&](std::size_t at) { return low.x + width * float(at) / float(table.size()); };
        list.AddRectFilled(ImVec2(x(i), top), ImVec2(x(i + 1), bottom),
                           IM_COL32(table[i][0], table[i][1], table[i][2], 255));
    }
    for (int i = 0; i <= s.isolines && s.isolines > 0; ++i) {
        const float x = low.x + width * float(i) / float(s.isolines);
        list.AddLine(ImVec2(x, top), ImVec2(x, bottom), IM_COL32(0, 0, 0, 255));
    }
    if (has_zero(range)) {  // a tick over the number 0
        const float x = low.x + width * float(place(0, s, range));
        list.AddLine(ImVec2(x, bottom - legend_height() / 3), ImVec2(x, bottom), IM_COL32_BLACK);
    }
    if (value) {
        const float x = low.x + width * float(std::clamp(place(*value, s, range), 0.0, 1.0));
        list.AddLine(ImVec2(x, low.y), ImVec2(x, bottom), IM_COL32(255, 255, 255, 255), 2);
    }
    list.PopClipRect();
    ImGui::Dummy(ImVec2(width, histogram_height() + legend_height()));
    legend_numbers(s, range, width);
}

void range_sliders(Controls& c, const ScalarField& field, FieldSettings& s) {
    FieldSettings unbounded = s;
    unbounded.range.reset();
    const ValueRange whole = field_legend(field, unbounded).range;
    ValueRange range = field_legend(field, s).range;
    const ImGuiSliderFlags flags = s.logarithmic ? ImGuiSliderFlags_Logarithmic : 0;
    const char* const help = marked("Values outside the range have the color at its end.");
    bool changed = c.slider("Lowest", &range.low, whole.low, whole.high, "%.5g", flags);
    c.explain(help);
    changed |= c.slider("Highest", &range.high, whole.low, whole.high, "%.5g", flags);
    c.explain(help);
    if (changed && range.low < range.high) s.range = range;
    if (!s.range) return;
    if (c.button("Whole range")) s.range.reset();
    c.explain("From the field's lowest to its highest value.");
}

bool has_logarithms(const ScalarField& field) { return field.low >= 0 && field.least_positive > 0; }

void field_choice(Controls& c, std::span<const ScalarField> fields, FieldSettings& s) {
    std::vector<const char*> names{tr("none: photos only")};
    for (const ScalarField& field : fields) names.push_back(field.name.c_str());
    int chosen = std::clamp(s.index + 1, 0, int(fields.size()));
    const bool changed = c.combo("Field", &chosen, names.data(), int(names.size()));
    c.explain("Colors the model by values that are stored at its vertices or computed from the photos.");
    if (!changed) return;
    s.index = chosen - 1;
    s.range.reset();
    s.logarithmic &= s.index >= 0 && has_logarithms(fields[std::size_t(s.index)]);
}

/// The field in the settings, or null.
const ScalarField* shown_field(const FieldSettings& s, const Renderer& renderer) {
    const std::span<const ScalarField> fields = renderer.resources().fields.all();
    return s.index >= 0 && std::size_t(s.index) < fields.size() ? &fields[std::size_t(s.index)] : nullptr;
}

/// The legend, the unit, and the value under the pointer.
void explain_field(const ScalarField& field, const FieldSettings& s, const Renderer& renderer,
                   const View& view) {
    const std::optional<double> value = value_under_pointer(renderer, field, view);
    legend(field, s, value);
    if (const char* unit = unit_of(field)) ImGui::TextDisabled("%s", tr(unit));
    if (value)
        ImGui::TextUnformatted(
            formatted(tr("under the pointer: %s"),
                      localized_numbers(value_text(*value, field_legend(field, s).range)).c_str())
                .c_str());
    else
        ImGui::TextDisabled("%s", tr("under the pointer: no value"));
}

}  // namespace

void field_legend_panel(Controls& c, const FieldSettings& s, const Renderer& renderer, const View& view,
                        const Area& area) {
    const ScalarField* const field = shown_field(s, renderer);
    if (!field || !(s.share > 0)) return;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(area.left) + em, float(area.top + area.height) - em),
                            ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSize(ImVec2(std::min(20 * em, float(area.width) - 2 * em), 0));
    ImGui::Begin("##field", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::TextUnformatted(field->name.c_str());
    explain_field(*field, s, renderer, view);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    c.note("Legend", low, ImVec2(low.x + size.x, low.y + size.y));
    ImGui::End();
}

void field_section(Controls& c, FieldSettings& s, const Renderer& renderer, const View& view, bool more) {
    field_choice(c, renderer.resources().fields.all(), s);
    const ScalarField* const shown = shown_field(s, renderer);
    if (!shown) return;
    const ScalarField& field = *shown;
    explain_field(field, s, renderer, view);
    if (!more) return;
    static const char* const maps[] = {marked("automatic"), marked("viridis"), marked("magma"),
                                       marked("cividis"), marked("coolwarm")};
    choice(c, "Colors", s.map, maps);
    c.explain("The color map.");
    c.slider("Over photos", &s.share, 0.0, 1.0);
    c.explain("The mix of the field's colors and the photos.");
    c.slider("Isolines", &s.isolines, 0, 20);
    c.explain("Lines of equal value: the number of intervals into which they divide the color map.");
    if (has_logarithms(field)) {
        if (c.checkbox("Logarithmic", &s.logarithmic)) s.range.reset();
        c.explain("Uses the logarithm of the value. Zero has no color.");
    }
    range_sliders(c, field, s);
    if (field.without > 0)
        ImGui::TextDisabled("%s", localized(tr("%.1f %% of the vertices have no value"),
                                            100 * double(field.without) / double(field.values.size()))
                                      .c_str());
}

}  // namespace vantage

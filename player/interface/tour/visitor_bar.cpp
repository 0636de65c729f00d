#include "player/interface/tour/visitor_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>

#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/language_menu.h"
#include "player/interface/overlays/comparison.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

struct Tool {
    const char* name;
    Icon icon;
    const char* help;
};
constexpr Tool tools[] = {
    {marked("Home"), Icon::home, marked("Back to the first view (H)")},
    {MARKED_IN("tool", "Photos"), Icon::photos,
     marked("Show or hide the photos; click on one to view the scene from there (F4)")},
    {MARKED_IN("tool", "Compare"), Icon::compare,
     marked("Fly to the closest photo and compare the model with it (C)")},
    {MARKED_IN("tool", "Light"), Icon::light, marked("Move a lamp over the surface, to see its shape")},
    {marked("Help"), Icon::help, marked("Mouse and keyboard (F1)")},
    {marked("Full screen"), Icon::full_screen, marked("Full screen, or a window again (F11)")},
    {marked("Expert"), Icon::expert, marked("All settings (Tab)")}};

constexpr std::size_t tools_on_the_left = 4;

/// Tools for a kiosk. They include the choice of a language, because a kiosk does not know the visitor's
/// language.
constexpr Tool kiosk_tools[] = {
    tools[0], tools[1], tools[2], tools[3], {marked("Language"), Icon::language, marked("Choose a language")},
    tools[4]};
static_assert(tools[4].icon == Icon::help);

/// Width of the shown tools, each of which is followed by a gap.
float width_of(std::span<const Tool> shown, bool labels, float gap) {
    float width = 0;
    for (const Tool& tool : shown) width += Controls::icon_button_size(tool.name, labels).x + gap;
    return width;
}

/// A list above the bar, at a button, with items spaced for touch. Returns whether the list is open.
bool list_above(Controls& c, const char* name, const Area& bar, float button) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(button, float(bar.top) - 0.3f * em), ImGuiCond_Always,
                            ImVec2(button / std::max(1.0f, float(bar.width)), 1));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.6f * em, em));
    const bool open = c.popup(name);
    if (!open) ImGui::PopStyleVar();
    return open;
}

void end_list() {
    ImGui::EndPopup();
    ImGui::PopStyleVar();
}

void lights(Controls& c, Session& s, const Area& bar, float button) {
    if (!list_above(c, "##lights", bar, button)) return;
    LightSettings& l = s.settings.light;
    const auto choose = [&](const char* name, Light light) {
        if (c.menu_item(name, nullptr, l.light == light)) l.light = light;
    };
    choose("As in the photos", Light::photos);
    choose("Raking light that follows the pointer", Light::raking);
    choose("Lamp at the viewer", Light::lamp);
    if (l.light == Light::raking) s.lamp_follows = true;
    end_list();
}

void languages(Controls& c, WindowState& window, const Area& bar, float button) {
    if (!list_above(c, "##languages", bar, button)) return;
    language_items(c, window);
    end_list();
}

void use(const Tool& tool, Session& s, const Renderer& renderer, const View& view, double now) {
    switch (tool.icon) {
        case Icon::home:
            return fly_home(s, now);
        case Icon::photos:
            s.window.panels.photos = !s.window.panels.photos;
            return;
        case Icon::compare:
            return toggle_comparison(s, renderer.scene(), view, now);
        case Icon::light:
            return ImGui::OpenPopup("##lights");
        case Icon::language:
            return ImGui::OpenPopup("##languages");
        case Icon::full_screen:
            s.window.full_screen = !s.window.full_screen;
            return;
        case Icon::help:
            s.window.panels.help = !s.window.panels.help;
            return;
        case Icon::expert:
            s.window.panels.expert = !s.window.panels.expert;
            return;
    }
}

bool is_lit(Icon icon, const Session& s) {
    return (icon == Icon::photos && s.window.panels.photos) ||
           (icon == Icon::compare && s.settings.compare != Compare::nothing) ||
           (icon == Icon::light && s.settings.light.light != Light::photos) ||
           (icon == Icon::full_screen && s.window.full_screen) ||
           (icon == Icon::help && s.window.panels.help) || (icon == Icon::expert && s.window.panels.expert);
}

bool is_usable(Icon icon, const Renderer& renderer) {
    if (icon == Icon::photos || icon == Icon::compare) return !renderer.scene().photos.empty();
    return icon != Icon::light || !points_only(renderer.package().scene());
}

}  // namespace

void visitor_bar(Controls& c, Session& s, const Renderer& renderer, const View& view, const Area& area,
                 double now) {
    const float em = ImGui::GetFontSize();
    begin_docked("##bar", area, ImVec2(0.5f * em, 0.35f * em), ImGuiWindowFlags_NoDecoration);
    const std::span<const Tool> shown = s.window.kiosk ? std::span<const Tool>(kiosk_tools) : tools;
    const float gap = 0.5f * em;
    const bool labels = width_of(shown, true, gap) + 2 * gap < float(area.width);
    const std::size_t on_the_left = std::min(shown.size(), tools_on_the_left);
    const float right = float(area.width) - width_of(shown.subspan(on_the_left), labels, gap);
    float light_button = 0, language_button = 0;
    for (const Tool& tool : shown) {
        if (&tool == &shown[tools_on_the_left])
            ImGui::SameLine(right);
        else if (&tool != shown.data())
            ImGui::SameLine(0, gap);
        ImGui::BeginDisabled(!is_usable(tool.icon, renderer));
        if (c.icon_button(tool.name, tool.icon, is_lit(tool.icon, s), labels))
            use(tool, s, renderer, view, now);
        ImGui::EndDisabled();
        if (tool.icon == Icon::light) light_button = ImGui::GetItemRectMin().x;
        if (tool.icon == Icon::language) language_button = ImGui::GetItemRectMin().x;
        c.explain(tool.help);
    }
    lights(c, s, area, light_button);
    languages(c, s.window, area, language_button);
    ImGui::End();
}

}  // namespace vantage

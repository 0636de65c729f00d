#include "player/interface/tour/visitor_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/language_menu.h"
#include "player/interface/overlays/comparison.h"
#include "player/interface/tour/qr_code.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// `left`: at the left end of the bar, otherwise at the right end.
struct Tool {
    const char* name;
    Icon icon;
    const char* help;
    bool left, in_kiosk = true, in_window = true;
};
/// A kiosk has a choice of languages, because it does not know the visitor's language.
constexpr Tool tools[] = {
    {marked("Home"), Icon::home, marked("Back to the first view (H)"), true},
    {MARKED_IN("tool", "Photos"), Icon::photos,
     marked("Show or hide the photos; click on one to view the scene from there (F4)"), true},
    {MARKED_IN("tool", "Compare"), Icon::compare,
     marked("Fly to the closest photo and compare the model with it (C)"), true},
    {MARKED_IN("tool", "Light"), Icon::light,
     marked("Light the surface from a low angle, to see its shape; drag the lamp"), true},
    {marked("Only the object"), Icon::object, marked("Hide or show the background"), true},
    {MARKED_IN("tool", "Share"), Icon::share, marked("Open this scene's page on a phone"), false},
    {marked("Language"), Icon::language, marked("Choose a language"), false, true, false},
    {marked("Help"), Icon::help, marked("Mouse and keyboard (F1)"), false},
    {marked("Full screen"), Icon::full_screen, marked("Full screen, or a window again (F11)"), false, false},
    {marked("Expert"), Icon::expert, marked("All settings (Tab)"), false, false}};

bool is_usable(Icon icon, const WindowState& window, const Renderer& renderer) {
    switch (icon) {
        case Icon::photos:
        case Icon::compare:
            return !renderer.scene().photos.empty();
        case Icon::light:
            return !points_only(renderer.package().scene());
        case Icon::object:
            return renderer.scene().has_background();
        case Icon::share:
            return !window.web.empty();
        default:
            return true;
    }
}

std::vector<Tool> shown_tools(const WindowState& window, const Renderer& renderer) {
    std::vector<Tool> out;
    for (const Tool& tool : tools)
        if ((window.kiosk ? tool.in_kiosk : tool.in_window) && is_usable(tool.icon, window, renderer))
            out.push_back(tool);
    return out;
}

/// Width of the shown tools, each of which is followed by a gap.
float width_of(std::span<const Tool> shown, bool labels, float gap) {
    float width = 0;
    for (const Tool& tool : shown) width += Controls::icon_button_size(tool.name, labels).x + gap;
    return width;
}

/// Opens a popup's window above the bar, at a button.
bool popup_at(Controls& c, const char* name, const Area& bar, float button) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(button, float(bar.top) - 0.3f * em), ImGuiCond_Always,
                            ImVec2(button / std::max(1.0f, float(bar.width)), 1));
    return c.popup(name);
}

/// The list of languages, with items spaced for touch.
void languages(Controls& c, WindowState& window, const Area& bar, float button) {
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.6f * em, em));
    if (popup_at(c, "##languages", bar, button)) {
        language_items(c, window);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

/// The address of the scene's page, also as a QR code with a margin of four modules.
void page_on_the_web(Controls& c, const WindowState& window, const Area& bar, float button) {
    if (!popup_at(c, "##share", bar, button)) return;
    const QrCode code = qr_code(window.web);
    const float module = std::max(2.0f, std::floor(14 * ImGui::GetFontSize() / float(code.size + 8)));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = module * float(code.size + 8);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, ImVec2(corner.x + side, corner.y + side), IM_COL32_WHITE);
    for (int y = 0; y < code.size; ++y)
        for (int x = 0; x < code.size; ++x) {
            const ImVec2 low(corner.x + module * float(x + 4), corner.y + module * float(y + 4));
            if (code.dark(x, y))
                list.AddRectFilled(low, ImVec2(low.x + module, low.y + module), IM_COL32_BLACK);
        }
    ImGui::Dummy(ImVec2(side, side));
    c.note("QR code");
    ImGui::PushTextWrapPos(std::max(side, 14 * ImGui::GetFontSize()));
    ImGui::TextUnformatted(window.web.c_str());
    ImGui::PopTextWrapPos();
    if (!window.kiosk && c.button("Copy address")) ImGui::SetClipboardText(window.web.c_str());
    ImGui::EndPopup();
}

/// Raking light or none. The sidebar has other kinds of light.
void toggle_light(Session& s) {
    Light& light = s.settings.light.light;
    light = light == Light::photos ? Light::raking : Light::photos;
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
            return toggle_light(s);
        case Icon::object: {
            ShowBackground& background = s.settings.background;
            background = background == ShowBackground::off ? ShowBackground::on : ShowBackground::off;
            return;
        }
        case Icon::language:
            return ImGui::OpenPopup("##languages");
        case Icon::share:
            return ImGui::OpenPopup("##share");
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
           (icon == Icon::object && s.settings.background == ShowBackground::off) ||
           (icon == Icon::full_screen && s.window.full_screen) ||
           (icon == Icon::help && s.window.panels.help) || (icon == Icon::expert && s.window.panels.expert);
}

}  // namespace

void visitor_bar(Controls& c, Session& s, const Renderer& renderer, const View& view, const Area& area,
                 double now) {
    const float em = ImGui::GetFontSize();
    begin_docked("##bar", area, ImVec2(0.5f * em, 0.35f * em), ImGuiWindowFlags_NoDecoration);
    const std::vector<Tool> shown = shown_tools(s.window, renderer);
    const float gap = 0.5f * em;
    const bool labels = width_of(shown, true, gap) + 2 * gap < float(area.width);
    const auto right = std::ranges::find(shown, false, &Tool::left);
    float language_button = 0, share_button = 0;
    for (auto tool = shown.begin(); tool != shown.end(); ++tool) {
        if (tool == right)
            ImGui::SameLine(float(area.width) - width_of({right, shown.end()}, labels, gap));
        else if (tool != shown.begin())
            ImGui::SameLine(0, gap);
        if (c.icon_button(tool->name, tool->icon, is_lit(tool->icon, s), labels))
            use(*tool, s, renderer, view, now);
        if (tool->icon == Icon::language) language_button = ImGui::GetItemRectMin().x;
        if (tool->icon == Icon::share) share_button = ImGui::GetItemRectMin().x;
        if (!s.window.kiosk) c.explain(tool->help);  // names keys
    }
    languages(c, s.window, area, language_button);
    page_on_the_web(c, s.window, area, share_button);
    ImGui::End();
}

}  // namespace vantage

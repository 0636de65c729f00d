#include "player/interface/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "player/interface/controls.h"
#include "player/render/blend_table.h"
#include "points/point_cloud.h"
#include "scene/package_shape.h"

namespace vantage {
namespace {

constexpr float MiB = 1024 * 1024;

void section(const char* title) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", title);
    ImGui::Separator();
}

template <class Enum, int count>
void choice(Controls& c, const char* name, Enum& value, const char* const (&names)[count]) {
    static_assert(count == int(Enum::count));
    int index = int(value);
    if (c.combo(name, &index, names, count)) value = Enum(index);
}

void blend_section(Controls& c, RenderSettings& r) {
    int blend = int(r.blend);
    for (const BlendRow& row : blend_table()) {
        if (&row != &blend_table().front()) ImGui::SameLine();
        c.radio(row.label, &blend, int(row.blend));
        c.explain(row.help);
    }
    r.blend = Blend(blend);
    c.slider("Sharpness", &r.weights.sharpness, 0.01, 1.0, "%.3f rad", ImGuiSliderFlags_Logarithmic);
    c.explain(
        "Small: each point mainly from the photo whose ray is closest to yours. Large: more of the others.");
    ImGui::BeginDisabled(r.blend != Blend::average);
    c.slider("Exponent", &r.weights.exponent, 0.0, 32.0, "%.1f");
    ImGui::EndDisabled();
    c.explain("How strongly near photos are preferred. For Average.");
    c.checkbox("Consensus", &r.consensus);
    c.explain("Leaves out colors that differ from those of most photos.");
    ImGui::SameLine();
    c.checkbox("Fill holes", &r.fill_holes);
    c.explain("Continues colors into surface that no photo sees.");
}

void weight_section(Controls& c, Session& s, const Renderer& renderer) {
    WeightSettings& w = s.settings.weights;
    const bool average = s.settings.blend == Blend::average;
    ImGui::BeginDisabled(!average);
    c.checkbox("Distance", &w.distance);
    ImGui::EndDisabled();
    c.explain("Prefers photos taken close to your position. For Average.");
    ImGui::SameLine(150);
    c.checkbox("Angle", &w.angle);
    c.explain("Prefers photos whose rays are close to yours.");
    ImGui::BeginDisabled(!average);
    c.checkbox("Angle mask", &w.angle_mask);
    ImGui::EndDisabled();
    c.explain("Prefers photos that face the surface. For Average.");
    ImGui::SameLine(150);
    c.checkbox("Depth mask", &w.depth_mask);
    c.explain("Leaves out what is hidden from a photo.");
    c.checkbox("Border mask", &w.border_mask);
    c.explain("Fades photos out towards their edges and towards silhouettes.");
    ImGui::SameLine(150);
    ImGui::BeginDisabled(!effect_on(renderer.package().scene(), Effect::consensus));
    c.checkbox("Consensus mask", &w.consensus_mask);
    ImGui::EndDisabled();
    c.explain("Gives little weight to a photo where prepare found that it disagrees with the others.");
    c.checkbox("Angle by photo", &w.angle_per_photo);
    c.explain("One angle for each photo, instead of one for each point.");
    ImGui::SameLine(150);
    c.checkbox("Field of view", &w.fov_normalization);
    c.explain("Compares distances as if all photos had your field of view.");
    c.checkbox("Corrected", &w.corrected_directions);
    c.explain("A photo's direction is that to the middle of what it sees, not that of its lens.");
    if (c.checkbox("Freeze weights", &s.freeze)) {
        s.settings.weights_from.reset();
        if (s.freeze) s.settings.weights_from = view_of(s.camera, 1280, 720);
    }
}

void photo_section(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    static const char* const choices[] = {"cover the view", "nearest", "direction", "direction and normals"};
    choice(c, "Choose", r.choice, choices);
    c.slider("Photos", &r.photos, 1, std::max(1, int(renderer.scene().photos.size())));
    c.slider("Per pass", &r.photos_per_pass, 1, most_photos_per_pass);
    c.slider("Angle limit", &r.angle_limit, 10.0, 180.0, "%.0f deg");
    static const char* const coordinates[] = {"as the scene asks", "per vertex", "per fragment"};
    ImGui::BeginDisabled(!has_coordinates(renderer.package()));
    choice(c, "Coordinates", r.coordinates, coordinates);
    ImGui::EndDisabled();
}

/// Only if the package's exposures were refined.
void exposure_section(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    const package::SceneRecord& scene = renderer.package().scene();
    if (!effect_on(scene, Effect::exposure) && !effect_on(scene, Effect::falloff)) return;
    c.checkbox("Equal exposure", &r.refined_colors);
    ImGui::SameLine(150);
    bool own = r.exposure.has_value();
    if (c.checkbox("This photo's", &own)) r.exposure.reset();
    if (own) r.exposure = s.standing_at;
}

void light_section(Controls& c, Session& s) {
    LightSettings& l = s.settings.light;
    static const char* const lights[] = {"the photos' own", "lamp at the viewer", "raking light", "normals"};
    choice(c, "Light", l.light, lights);
    if (l.light == Light::lamp || l.light == Light::raking) c.checkbox("On the photos", &l.on_photos);
    if (l.light != Light::raking) return;
    ImGui::SameLine(150);
    c.checkbox("Follows pointer", &s.lamp_follows);
    if (c.slider("Lamp azimuth", &l.azimuth, 0.0, 360.0, "%.0f deg")) s.lamp_follows = false;
    if (c.slider("Lamp elevation", &l.elevation, 1.0, 90.0, "%.0f deg")) s.lamp_follows = false;
}

void show_section(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    exposure_section(c, s, renderer);
    static const char* const shows[] = {"photos", "which photo", "how many photos"};
    choice(c, "Show", r.show, shows);
    if (renderer.scene().has_surroundings()) {
        static const char* const surroundings[] = {"shown", "dimmed", "hidden"};
        choice(c, "Surroundings", r.surroundings, surroundings);
    }
    if (renderer.scene().has_transparency()) {
        static const char* const transparent[] = {"exact", "approximate", "hidden"};
        choice(c, "Transparency", r.transparency, transparent);
    }
    if (!points_only(renderer.package().scene())) light_section(c, s);
    static const char* const compares[] = {"nothing", "side by side", "wiper", "difference"};
    choice(c, "Compare", r.compare, compares);
    if (r.compare != Compare::nothing) r.bands.how = BandView::mix;  // one comparison at a time
    if (r.compare == Compare::wiper) c.slider("Wiper", &r.wiper, 0.0, 1.0);
}

struct Shortcuts {
    std::string keys, labels;
};

/// "1 2 3" and "lumigraph, average, best photo".
Shortcuts blend_shortcuts() {
    Shortcuts out;
    int key = 1;
    for (const BlendRow& row : blend_table()) {
        std::string label = row.label;
        label[0] = char(std::tolower(label[0]));
        out.keys += (key > 1 ? " " : "") + std::to_string(key);
        out.labels += (key > 1 ? ", " : "") + label;
        ++key;
    }
    return out;
}

void budget_bar(const char* name, double held, double budget) {
    char text[64];
    std::snprintf(text, sizeof text, "%.0f of %.0f MiB", held / double(MiB), budget / double(MiB));
    ImGui::ProgressBar(float(budget > 0 ? held / budget : 0), ImVec2(-70, 0), text);
    ImGui::SameLine();
    ImGui::TextUnformatted(name);
}

}  // namespace

void set_style() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.FramePadding = ImVec2(7, 2);
    style.ItemSpacing = ImVec2(8, 4);
    style.WindowTitleAlign = ImVec2(0.02f, 0.5f);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.12f, 0.90f);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.11f, 0.12f, 0.14f, 0.97f);
    style.Colors[ImGuiCol_MenuBarBg] = ImVec4(0.09f, 0.10f, 0.12f, 0.95f);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.19f, 0.21f, 0.25f, 1);
    style.Colors[ImGuiCol_TitleBg] = style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.13f, 0.17f, 0.23f, 1);
    for (const int color :
         {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram})
        style.Colors[color] = ImVec4(0.36f, 0.62f, 0.92f, 1);
    for (const char* font : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"})
        if (std::filesystem::exists(font)) {
            ImGui::GetIO().Fonts->AddFontFromFileTTF(font, 14);
            return;
        }
}

void menu_bar(Controls& c, Session& s, const Renderer& renderer, double now) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (c.menu("File")) {
        if (c.menu_item("Open...", "O")) s.open_asked = true;
        if (c.menu_item("Screenshot", "P")) s.screenshot = true;
        if (c.menu_item("Quit", "Ctrl+Q")) s.quit = true;
        ImGui::EndMenu();
    }
    if (c.menu("View")) {
        const auto toggle = [&](const char* name, const char* key, bool& shown) {
            if (c.menu_item(name, key, shown)) shown = !shown;
        };
        toggle("Blending", "F2", s.panels.blending);
        toggle("Status", "F3", s.panels.status);
        toggle("Photo strip", "F4", s.panels.photos);
        toggle("Cameras in the scene", "F5", s.panels.frusta);
        toggle("Radar", "F6", s.panels.radar);
        if (!renderer.layers().empty()) toggle("Layers", "F7", s.panels.layers);
        if (renderer.points()) toggle("Point cloud", "F8", s.panels.points);
        if (renderer.scene().bands.size() > 1) toggle("Bands", "F9", s.panels.bands);
        toggle("Objects", "F10", s.panels.objects);
        ImGui::EndMenu();
    }
    if (c.menu("Path")) {
        if (c.menu_item("Record", "R", s.recording)) {
            s.recording = !s.recording;
            if (s.recording) s.recorded.clear();
        }
        if (c.menu_item("Replay", "T")) replay(s, now);
        ImGui::EndMenu();
    }
    if (c.menu("Help")) {
        if (c.menu_item("Mouse and keys", "F1", s.panels.help)) s.panels.help = !s.panels.help;
        ImGui::EndMenu();
    }
    ImGui::TextDisabled("   %s", renderer.package().path().filename().c_str());
    if (s.recording) ImGui::TextColored(ImVec4(1, 0.4f, 0.35f, 1), "   recording");
    ImGui::EndMainMenuBar();
}

void blending_panel(Controls& c, Session& s, const Renderer& renderer) {
    ImGui::SetNextWindowPos(ImVec2(12, 40), ImGuiCond_FirstUseEver);
    // As high as the space above the photo strip; the rest scrolls.
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(0, 0), ImVec2(FLT_MAX, std::max(120.0f, ImGui::GetIO().DisplaySize.y - 150)));
    if (ImGui::Begin("Blending", &s.panels.blending, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(190);
        blend_section(c, s.settings);
        section("Weights");
        weight_section(c, s, renderer);
        section("Photos");
        photo_section(c, s, renderer);
        section("Show");
        show_section(c, s, renderer);
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

namespace {

/// Of a package on a server.
void transfer_lines(const Renderer& renderer) {
    const auto traffic = renderer.package().traffic();
    if (!traffic) return;
    ImGui::Text("network %.0f kB/s, %.1f MB; cache %.1f MB", traffic->bytes_per_second / 1e3,
                double(traffic->bytes_received) / 1e6, double(traffic->bytes_from_cache) / 1e6);
    if (const std::string failure = renderer.failure(); !failure.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.5f, 0.4f, 1));
        ImGui::TextWrapped("%s", failure.c_str());
        ImGui::PopStyleColor();
    } else if (traffic->offline) {
        ImGui::TextUnformatted("the server cannot be reached: shown from the cache");
    }
}

}  // namespace

void status_panel(Session& s, const Renderer& renderer, std::uint64_t graphics_budget) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x - 352, 40), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(340, 0), ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Status", &s.panels.status, ImGuiWindowFlags_AlwaysAutoResize)) {
        const float highest = *std::ranges::max_element(s.frame_ms);
        ImGui::PlotLines("##frames", s.frame_ms.data(), int(s.frame_ms.size()), 0, "", 0,
                         std::max(1.0f, highest * 1.1f), ImVec2(322, 56));
        const FrameStatistics& f = s.statistics;
        ImGui::Text("%.1f ms per frame, median %.1f", f.mean, f.median);
        ImGui::Text("99 %% below %.1f, 99.9 %% below %.1f", f.p99, f.p999);
        const FrameReport& r = s.report;
        ImGui::Text("%zu photos in %zu passes, %zu draws", r.photos, r.passes, r.draws);
        ImGui::Text("%zu tiles, %zu missing; %.1f MiB uploaded", r.tiles, r.tiles_missing,
                    double(r.uploaded) / double(MiB));
        if (renderer.scene().has_transparency())
            ImGui::Text("%zu transparent fragments, %zu approximated", r.fragments, r.fragments_approximated);
        const Residency& held = renderer.store().residency();
        ImGui::Text("graphics memory: %.0f of %.0f MiB", double(gl::memory_held()) / double(MiB),
                    double(graphics_budget) / double(MiB));
        budget_bar("tiles", double(held.color_held() + 2 * held.masks_held()) * 256 * 1024,
                   double(held.layout().bytes()));
        transfer_lines(renderer);
        if (r.tiles_damaged)
            ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), "%zu damaged tiles not shown", r.tiles_damaged);
    }
    ImGui::End();
}

void help_panel(Session& s) {
    const Shortcuts blends = blend_shortcuts();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(1);
    if (ImGui::Begin("Mouse and keys", &s.panels.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) {
        const char* const lines[][2] = {{"drag", "orbit the model"},
                                        {"drag, right or middle button", "pan"},
                                        {"Ctrl and drag", "look around"},
                                        {"wheel", "move closer or away"},
                                        {"W A S D, Q E", "fly; faster with Shift"},
                                        {"N, B", "fly to the next or previous photo"},
                                        {"C", "compare: side by side, wiper, difference"},
                                        {"V", "show photos, which photo, how many photos"},
                                        {"X", "show the next band of photos"},
                                        {blends.keys.c_str(), blends.labels.c_str()},
                                        {"R, T", "record a path, replay it"},
                                        {"O", "open another package (or drop it here)"},
                                        {"P", "screenshot"},
                                        {"F1 to F10", "help and panels"},
                                        {"Esc", "close help, stop a flight or a comparison"},
                                        {"Ctrl+Q", "quit"}};
        for (const auto& line : lines) {
            ImGui::TextColored(ImVec4(0.55f, 0.75f, 1, 1), "%s", line[0]);
            ImGui::SameLine(220);
            ImGui::TextUnformatted(line[1]);
        }
    }
    ImGui::End();
}

void message_line(const Session& s, double now) {
    if (s.message.empty() || now > s.message_until) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, 44), ImGuiCond_Always, ImVec2(0.5f, 0));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(s.message.c_str());
    ImGui::End();
}

}  // namespace vantage

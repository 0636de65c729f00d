#include "player/interface/sections/picture_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/text/translation.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

void lamp_controls(Controls& c, Session& s) {
    LightSettings& l = s.settings.light;
    const bool raking = l.light == Light::raking;
    check_boxes(c, {{marked("On the photos"), &l.on_photos,
                     marked("Applies the light to the photos instead of the bare surface."),
                     raking || l.light == Light::lamp}});
    if (!raking) return;
    c.slider("Lamp azimuth", &l.azimuth, 0.0, 360.0, "%.0f°");
    c.explain("0: from the right, 90: from above.");
    c.slider("Lamp height", &l.elevation, 1.0, 90.0, "%.0f°");
    c.explain("Over the plane of the picture: the lower, the longer the shadows.");
}

void surface_controls(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    if (renderer.scene().has_transparency()) {
        static const char* const transparent[] = {MARKED_IN("transparency", "exact"),
                                                  MARKED_IN("transparency", "approximate"),
                                                  MARKED_IN("transparency", "hidden")};
        choice(c, "Transparency", r.transparency, transparent);
        c.explain("Glass: sorted at each pixel, blended by weights (faster), or hidden.");
    }
    const package::SceneRecord& scene = renderer.package().scene();
    const bool refined = effect_on(scene, Effect::exposure) || effect_on(scene, Effect::vignetting);
    bool own = r.exposure.has_value();
    check_boxes(c,
                {{marked("Triangles"), &r.light.wireframe,
                  marked("Draws the edges of the mesh's triangles over the picture."), !points_only(scene)},
                 {marked("Equal exposure"), &r.refined_colors,
                  marked("Shows all photos as if they had been exposed alike."), refined},
                 {marked("Like this photo"), &own,
                  marked("Shows the model with the exposure of the photo you flew to last."),
                  refined && r.refined_colors}});
    if (own != r.exposure.has_value())
        r.exposure = own ? std::optional(s.viewpoint.standing_at) : std::nullopt;
}

void comparison_choice(Controls& c, Session& s, const PlanScene& scene, double now) {
    RenderSettings& r = s.settings;
    static const char* const compares[] = {MARKED_IN("comparison", "nothing"), marked("side by side"),
                                           marked("swipe"), marked("difference")};
    if (choice(c, MARKED_IN("setting", "Compare"), r.compare, compares) && r.compare != Compare::nothing) {
        r.image_sets.how = ImageSetView::mix;  // one comparison at a time
        if (r.compare_photo < scene.photos.size())
            fly_to(s, r.compare_photo, scene.photos[r.compare_photo], now);
    }
    c.explain(
        "Compares the photo you flew to last with the model as blended from the other photos. Drag the line "
        "in the picture.");
}

void stereo_controls(Controls& c, StereoSettings& stereo) {
    static const char* const modes[] = {MARKED_IN("stereo", "off"), marked("side by side"),
                                        marked("above each other"), marked("red and cyan glasses"),
                                        marked("checkerboard")};
    choice(c, "Stereo", stereo.mode, modes);
    c.explain("Pictures for the left and the right eye, for 3D displays and glasses.");
    if (stereo.mode == StereoMode::off) return;
    double percent = 100 * stereo.eyes.share;
    if (c.slider("Eye separation", &percent, 0.2, 20.0, "%.1f %%", ImGuiSliderFlags_Logarithmic))
        stereo.eyes.share = percent / 100, stereo.eyes.distance = 0;
    c.explain("In percent of the viewing distance. A larger separation looks deeper but is harder to view.");
}

/// The hemisphere over the picture on which the lamp moves, in pixels.
struct Hemisphere {
    Eigen::Vector2d center;
    double radius;
};

Hemisphere around_picture(const Area& free) {
    const double margin = 1.5 * double(ImGui::GetFontSize());
    return {{free.left + free.width / 2, free.top + free.height / 2},
            std::max(1.0, std::min(free.width, free.height) / 2 - margin)};
}

constexpr double degrees = 180 / std::numbers::pi;

}  // namespace

void aim_lamp(Session& s, const Eigen::Vector2d& pixel) {
    constexpr double lowest = 5;  // degrees
    const auto [center, radius] = around_picture(s.window.free);
    const double x = (pixel.x() - center.x()) / radius, y = (center.y() - pixel.y()) / radius;
    LightSettings& l = s.settings.light;
    l.azimuth = std::fmod(degrees * std::atan2(y, x) + 360, 360);
    l.elevation = std::max(lowest, degrees * std::acos(std::min(std::hypot(x, y), 1.0)));
}

void lamp_handle(Controls& c, Session& s) {
    const LightSettings& l = s.settings.light;
    if (l.light != Light::raking) return;
    const auto [center, radius] = around_picture(s.window.free);
    const double out = radius * std::cos(l.elevation / degrees), azimuth = l.azimuth / degrees;
    const float em = ImGui::GetFontSize();
    const ImVec2 at(float(center.x() + out * std::cos(azimuth)), float(center.y() - out * std::sin(azimuth)));
    c.begin_handle("Lamp", ImVec2(at.x - 1.3f * em, at.y - 1.3f * em), ImVec2(2.6f * em, 2.6f * em));
    if (!ImGui::IsMouseDown(0))
        c.explain("Drag the lamp to move the light; or hold Shift and drag anywhere.");
    const bool used = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0))
        aim_lamp(s, {double(ImGui::GetIO().MousePos.x), double(ImGui::GetIO().MousePos.y)});
    ImGui::End();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircleFilled(at, 1.2f * em, IM_COL32(15, 18, 22, used ? 230 : 170));
    draw_icon(list, Icon::light, at, 1.7f * em, IM_COL32(255, 215, 90, 255));
}

void picture_content(Controls& c, Session& s, const Renderer& renderer, bool more) {
    RenderSettings& r = s.settings;
    if (renderer.scene().has_background()) {
        static const char* const background[] = {MARKED_IN("background", "shown"),
                                                 MARKED_IN("background", "dimmed"),
                                                 MARKED_IN("background", "hidden")};
        choice(c, "Background", r.background, background);
        c.explain("The photographed background.");
    }
    if (!points_only(renderer.package().scene())) {
        static const char* const lights[] = {marked("the photos' own"), marked("lamp at the viewer"),
                                             marked("raking light"), marked("normals")};
        choice(c, MARKED_IN("setting", "Light"), r.light.light, lights);
        c.explain("Light on the bare surface shows its shape.");
        if (more) lamp_controls(c, s);
    }
    if (more) surface_controls(c, s, renderer);
}

void picture_section(Controls& c, Session& s, const Renderer& renderer, bool more, double now) {
    picture_content(c, s, renderer, more);
    if (!more) return;
    if (!renderer.scene().photos.empty()) comparison_choice(c, s, renderer.scene(), now);
    if (!s.viewpoint.orthographic && s.settings.compare == Compare::nothing) stereo_controls(c, s.stereo);
}

void movement_section(Controls& c, MovementSettings& movement) {
    c.slider("Flying speed", &movement.flying_speed, 0.1, 10.0, "%.1f", ImGuiSliderFlags_Logarithmic);
    c.explain("Speed for the keys W A S D, Q and E. Shift is four times as fast.");
    check_boxes(c, {{marked("Inertia"), &movement.inertia,
                     marked("If you release a drag while moving, the view glides on for a moment.")},
                    {marked("Stay near photos"), &movement.near_photos,
                     marked("Orbits return to the directions of the photos, and zooming out ends while the "
                            "model is still visible.")}});
}

}  // namespace vantage

#include "player/interface/picture_section.h"

#include <imgui.h>

#include "points/point_cloud.h"

namespace vantage {
namespace {

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

}  // namespace

}  // namespace vantage

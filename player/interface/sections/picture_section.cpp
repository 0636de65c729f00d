#include "player/interface/sections/picture_section.h"

#include <imgui.h>

#include "base/text/translation.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// Shown only if the package's exposures were refined.
void exposure_controls(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    const package::SceneRecord& scene = renderer.package().scene();
    if (!effect_on(scene, Effect::exposure) && !effect_on(scene, Effect::vignetting)) return;
    c.checkbox("Equal exposure", &r.refined_colors);
    c.explain("Shows all photos as if they had been exposed alike.");
    in_second_column("This photo's");
    bool own = r.exposure.has_value();
    if (c.checkbox("This photo's", &own)) r.exposure.reset();
    if (own) r.exposure = s.viewpoint.standing_at;
    c.explain("Shows the model with the exposure of the photo you flew to last.");
}

void light_controls(Controls& c, Session& s) {
    LightSettings& l = s.settings.light;
    static const char* const lights[] = {marked("the photos' own"), marked("lamp at the viewer"),
                                         marked("raking light"), marked("normals")};
    choice(c, MARKED_IN("setting", "Light"), l.light, lights);
    c.explain("Light on the bare surface shows its shape.");
    if (l.light == Light::lamp || l.light == Light::raking) {
        c.checkbox("On the photos", &l.on_photos);
        c.explain("Applies the light to the photos instead of the bare surface.");
    }
    if (l.light != Light::raking) return;
    if (s.window.keyboard) {
        in_second_column("Follows pointer");
        c.checkbox("Follows pointer", &s.lamp_follows);
        c.explain("The lamp follows the pointer over the picture: low near the edges.");
    }
    if (c.slider("Lamp azimuth", &l.azimuth, 0.0, 360.0, "%.0f°")) s.lamp_follows = false;
    c.explain("0: from the right, 90: from above.");
    if (c.slider("Lamp height", &l.elevation, 1.0, 90.0, "%.0f°")) s.lamp_follows = false;
    c.explain("Over the plane of the picture: the lower, the longer the shadows.");
}

void comparison_controls(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    ImGui::BeginDisabled(renderer.scene().photos.empty());
    static const char* const compares[] = {MARKED_IN("comparison", "nothing"), marked("side by side"),
                                           marked("swipe"), marked("difference")};
    choice(c, MARKED_IN("setting", "Compare"), r.compare, compares);
    ImGui::EndDisabled();
    c.explain(
        "Compares the photo you flew to last with the model as blended from the other photos. Drag the line "
        "in the picture.");
    if (r.compare != Compare::nothing) r.image_sets.how = ImageSetView::mix;  // one comparison at a time
}

void stereo_controls(Controls& c, Session& s) {
    StereoSettings& stereo = s.stereo;
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

}  // namespace

void picture_content(Controls& c, Session& s, const Renderer& renderer) {
    RenderSettings& r = s.settings;
    static const char* const shows[] = {marked("photos"), marked("which photo"), marked("how many photos")};
    choice(c, "Show", r.show, shows);
    c.explain(
        "The photos, or false colors: the photo with the largest weight, or the number of blended photos "
        "that see each point.");
    exposure_controls(c, s, renderer);
    if (renderer.scene().has_background()) {
        static const char* const background[] = {MARKED_IN("background", "shown"),
                                                 MARKED_IN("background", "dimmed"),
                                                 MARKED_IN("background", "hidden")};
        choice(c, "Background", r.background, background);
        c.explain("The photographed background.");
    }
    if (renderer.scene().has_transparency()) {
        static const char* const transparent[] = {MARKED_IN("transparency", "exact"),
                                                  MARKED_IN("transparency", "approximate"),
                                                  MARKED_IN("transparency", "hidden")};
        choice(c, "Transparency", r.transparency, transparent);
        c.explain("Glass: sorted at each pixel, blended by weights (faster), or hidden.");
    }
    if (!points_only(renderer.package().scene())) {
        light_controls(c, s);
        c.checkbox("Triangles", &r.light.wireframe);
        c.explain("Draws the edges of the mesh's triangles over the picture.");
    }
}

void picture_section(Controls& c, Session& s, const Renderer& renderer) {
    picture_content(c, s, renderer);
    comparison_controls(c, s, renderer);
    stereo_controls(c, s);
    c.checkbox("Orthographic", &s.viewpoint.orthographic);
    c.explain("Without perspective: equal lengths appear equal at any distance.");
    c.slider("Flying speed", &s.steering.flying_speed, 0.1, 10.0, "%.1f", ImGuiSliderFlags_Logarithmic);
    c.explain("Speed for the keys W A S D, Q and E. Shift is four times as fast.");
    c.checkbox("Inertia", &s.steering.inertia);
    c.explain("If you release a drag while moving, the view glides on for a moment.");
    c.checkbox("Stay near photos", &s.steering.near_photos);
    c.explain(
        "Orbits return to the directions of the photos, and zooming out ends while the model is still "
        "visible.");
}

}  // namespace vantage

#include "player/interface/blending_section.h"

#include <imgui.h>

#include <algorithm>

#include "player/render/blend_table.h"
#include "scene/package_shape.h"

namespace vantage {
namespace {

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

}  // namespace

}  // namespace vantage

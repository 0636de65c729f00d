#include "player/interface/sections/blending_section.h"

#include <imgui.h>

#include <algorithm>

#include "base/text/translation.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "player/render/passes/blend_table.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

void blend_controls(Controls& c, RenderSettings& r) {
    int blend = int(r.blend);
    for (const BlendRow& row : blend_table()) {
        if (&row != &blend_table().front()) behind_the_last(row.label);
        c.radio(row.label, &blend, int(row.blend));
        c.explain(row.help);
    }
    r.blend = Blend(blend);
    c.slider("Sharpness", &r.weights.sharpness, 0.01, 1.0, "%.3f rad", ImGuiSliderFlags_Logarithmic);
    c.explain(
        "Small: each point comes mainly from the photo whose ray is closest to yours. Large: the other "
        "photos contribute more.");
    ImGui::BeginDisabled(r.blend != Blend::average);
    c.slider("Prefer near", &r.weights.exponent, 0.0, 32.0, "%.1f");
    ImGui::EndDisabled();
    c.explain("How strongly near photos are preferred. For Average.");
    c.checkbox("Reject outliers", &r.transients);
    c.explain("Excludes colors that differ from those of most photos.");
    in_second_column("Fill holes");
    c.checkbox("Fill holes", &r.fill_holes);
    c.explain("Extends colors to surfaces that no photo sees.");
}

void weights_of_average(Controls& c, WeightSettings& w, bool average) {
    ImGui::BeginDisabled(!average);
    c.checkbox("Near photos", &w.distance);
    ImGui::EndDisabled();
    c.explain("Prefers photos taken close to your position. For Average.");
    in_second_column("Facing photos");
    ImGui::BeginDisabled(!average);
    c.checkbox("Facing photos", &w.angle_weight);
    ImGui::EndDisabled();
    c.explain("Prefers photos that face the surface. For Average.");
}

void weight_controls(Controls& c, Session& s, const Renderer& renderer) {
    WeightSettings& w = s.settings.weights;
    weights_of_average(c, w, s.settings.blend == Blend::average);
    c.checkbox("Similar rays", &w.angle);
    c.explain("Prefers photos whose rays are close to yours.");
    in_second_column("One ray per photo");
    c.checkbox("One ray per photo", &w.angle_per_photo);
    c.explain("Compares one ray per photo instead of one ray per point.");
    c.checkbox("Occlusion", &w.depth_weight);
    c.explain("Excludes surfaces that are hidden from a photo.");
    in_second_column("Soft borders");
    c.checkbox("Soft borders", &w.border_weight);
    c.explain("Fades photos out towards their edges and towards silhouettes.");
    ImGui::BeginDisabled(!effect_on(renderer.package().scene(), Effect::transients));
    c.checkbox("Passers-by", &w.transient_mask);
    ImGui::EndDisabled();
    c.explain(
        "Gives little weight to parts of a photo that disagree with the other photos, as found by prepare.");
    in_second_column("Field of view");
    c.checkbox("Field of view", &w.fov_normalization);
    c.explain("Compares distances as if all photos had your field of view.");
    c.checkbox("Aim at visible part", &w.corrected_directions);
    c.explain(
        "Uses the direction to the center of a photo's visible surface instead of its viewing direction.");
    in_second_column("Freeze weights");
    if (c.checkbox("Freeze weights", &s.freeze)) {
        s.settings.weights_from.reset();
        if (s.freeze) s.settings.weights_from = view_of(s.viewpoint.camera, 1280, 720);
    }
    c.explain("Keeps the weights of this view while you move, to see where each photo is used.");
}

void photo_controls(Controls& c, RenderSettings& r, const Renderer& renderer) {
    static const char* const choices[] = {marked("cover the view"), MARKED_IN("photos", "nearest")};
    choice(c, "Select by", r.choice, choices);
    c.explain("The blended photos: those that together cover the view, or those nearest to you.");
    c.slider(MARKED_IN("number", "Photos"), &r.photos, 1, std::max(1, int(renderer.scene().photos.size())));
    c.explain("Number of blended photos. More photos take more time.");
    c.slider("Per pass", &r.photos_per_pass, 1, max_photos_per_pass);
    c.explain("Number of photos drawn at once. Does not change the picture.");
    c.slider("Angle limit", &r.angle_limit, 10.0, 180.0, "%.0f°");
    c.explain("Excludes photos whose direction differs from yours by more than this angle.");
    static const char* const coordinates[] = {marked("as the scene requires"), marked("per vertex"),
                                              marked("per fragment")};
    ImGui::BeginDisabled(!has_coordinates(renderer.package()));
    choice(c, "Coordinates", r.coordinates, coordinates);
    ImGui::EndDisabled();
    c.explain("Projects the mesh's vertices or every pixel into the photos.");
}

}  // namespace

void blending_section(Controls& c, Session& s, const Renderer& renderer) {
    blend_controls(c, s.settings);
    ImGui::TextDisabled("%s", tr("Weights"));
    weight_controls(c, s, renderer);
    ImGui::TextDisabled("%s", tr("Which photos"));
    photo_controls(c, s.settings, renderer);
}

}  // namespace vantage

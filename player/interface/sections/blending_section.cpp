#include "player/interface/sections/blending_section.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "base/text/translation.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "player/render/passes/blend_table.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

void mode_choice(Controls& c, Blend& blend) {
    const std::span<const BlendRow> rows = blend_table();
    std::vector<const char*> labels;
    for (const BlendRow& row : rows) labels.push_back(row.label);
    int mode = int(&blend_row(blend) - rows.data());
    if (c.choice("Mode", &mode, labels.data(), int(labels.size()))) blend = rows[std::size_t(mode)].blend;
    c.explain(blend_row(blend).help);
}

void blend_controls(Controls& c, RenderSettings& r) {
    const WeightSettings& w = r.weights;
    const bool average = r.blend == Blend::average, mixes = !takes_one(r.blend);
    if (mixes && w.angle && !w.angle_per_photo) {
        c.slider("Sharpness", &r.weights.sharpness, 0.01, 1.0, "%.3f rad", ImGuiSliderFlags_Logarithmic);
        c.explain(
            "Small: each point comes mainly from the photo whose ray is closest to yours. Large: the other "
            "photos contribute more.");
    }
    if (average && (w.distance || (w.angle && w.angle_per_photo))) {
        c.slider("Prefer near", &r.weights.exponent, 0.0, 32.0, "%.1f");
        c.explain("How strongly near photos are preferred.");
    }
    check_boxes(
        c, {{marked("Reject outliers"), &r.transients,
             marked("Excludes colors that differ from those of most photos."), mixes},
            {marked("Fill holes"), &r.fill_holes, marked("Extends colors to surfaces that no photo sees.")}});
}

void weight_controls(Controls& c, Session& s, const Renderer& renderer) {
    WeightSettings& w = s.settings.weights;
    const bool average = s.settings.blend == Blend::average, mixes = !takes_one(s.settings.blend);
    bool frozen = s.settings.weights_from.has_value();
    check_boxes(
        c,
        {{marked("Near photos"), &w.distance, marked("Prefers photos taken close to your position."),
          average},
         {marked("Facing photos"), &w.angle_weight, marked("Prefers photos that face the surface."), average},
         {marked("Similar rays"), &w.angle, marked("Prefers photos whose rays are close to yours."), mixes},
         {marked("One ray per photo"), &w.angle_per_photo,
          marked("Compares one ray per photo instead of one ray per point."), average && w.angle},
         {marked("Aim at visible part"), &w.corrected_directions,
          marked("Uses the direction to the center of a photo's visible surface instead of its viewing "
                 "direction."),
          average && w.angle && w.angle_per_photo},
         {marked("Occlusion"), &w.depth_weight, marked("Excludes surfaces that are hidden from a photo."),
          mixes},
         {marked("Soft borders"), &w.border_weight,
          marked("Fades photos out towards their edges and towards silhouettes."), mixes},
         {marked("Passers-by"), &w.transient_mask,
          marked("Gives little weight to parts of a photo that disagree with the other photos, as found by "
                 "prepare."),
          effect_on(renderer.package().scene(), Effect::transients)},
         {marked("Field of view"), &w.fov_normalization,
          marked("Compares distances as if all photos had your field of view."), average && w.distance},
         {marked("Freeze weights"), &frozen,
          marked("Keeps the weights of this view while you move, to see where each photo is used.")}});
    if (frozen == s.settings.weights_from.has_value()) return;
    s.settings.weights_from.reset();
    if (frozen) s.settings.weights_from = view_of(s.viewpoint.camera, 1280, 720);
}

void photo_controls(Controls& c, RenderSettings& r, const Renderer& renderer) {
    static const char* const choices[] = {marked("cover the view"), MARKED_IN("photos", "nearest")};
    choice(c, "Select by", r.choice, choices);
    c.explain("The blended photos: those that together cover the view, or those nearest to you.");
    c.slider(MARKED_IN("number", "Photos"), &r.photos, 1, std::max(1, int(renderer.scene().photos.size())));
    c.explain("Number of blended photos. More photos take more time.");
    c.slider("Angle limit", &r.angle_limit, 10.0, 180.0, "%.0f°");
    c.explain("Excludes photos whose direction differs from yours by more than this angle.");
    if (!has_coordinates(renderer.package())) return;
    static const char* const coordinates[] = {marked("as the scene requires"), marked("per vertex"),
                                              marked("per fragment")};
    choice(c, "Coordinates", r.coordinates, coordinates);
    c.explain("Projects the mesh's vertices or every pixel into the photos.");
}

}  // namespace

void blending_section(Controls& c, Session& s, const Renderer& renderer, bool more) {
    mode_choice(c, s.settings.blend);
    if (!more) return;
    blend_controls(c, s.settings);
    ImGui::TextDisabled("%s", tr("Weights"));
    weight_controls(c, s, renderer);
    ImGui::TextDisabled("%s", tr("Which photos"));
    photo_controls(c, s.settings, renderer);
}

}  // namespace vantage

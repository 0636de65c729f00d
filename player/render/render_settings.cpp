#include "player/render/render_settings.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text/translation.h"
#include "player/render/passes/blend_table.h"
#include "scene/package/package_reader.h"

namespace vantage {

PlanSettings plan_settings(const RenderSettings& s, int anisotropy) {
    PlanSettings p;
    p.choice = s.choice;
    p.photos = s.reduced && s.photos > 0 ? 1 : s.photos;
    p.reduced = s.reduced;
    p.tiles = !s.thumbnails;
    p.background = s.background != ShowBackground::off;
    p.complete = is_complete(s.loading);
    p.angle_limit = s.photos > 0 ? s.angle_limit * std::numbers::pi / 180 : 0;
    // Plans allow footprints up to 4 times as long as they are wide at full sharpness; more taps read finer
    // levels.
    p.samples = std::exp2(-s.lod_bias) * std::max(1.0, anisotropy / 4.0);
    // 0.1 halves the bytes that are read, and frames still agree to at least 47 dB with frames drawn from all
    // tiles that may be sampled. With 0.01, pictures agree to at least 60 dB.
    p.worth = s.loading == Loading::complete ? 0.01 : 0.1;
    if (!waits_for_tiles(s.loading)) p.margin = 0.1;
    const bool falls = s.weights.angle && !s.weights.angle_per_photo && s.show != Show::coverage;
    if (falls && blend_row(s.blend).by_angle) p.sharpness = s.weights.sharpness;
    p.own_views = p.complete && p.sharpness > 0 && s.blend == Blend::lumigraph;
    return p;
}

FieldLegend field_legend(const ScalarField& field, const FieldSettings& s) {
    const ValueRange whole = s.range.value_or(whole_range(field, false, s.logarithmic));
    const ColorMap map = chosen_map(s.map, whole.low, whole.high);
    const bool diverges = map == ColorMap::coolwarm && !s.logarithmic;
    const ValueRange range = s.range.value_or(whole_range(field, diverges, s.logarithmic));
    const bool has_zero = diverges && range.low < 0 && range.high > 0;
    return {map, range, has_zero ? range.low / (range.low - range.high) : 0.5};
}

const char* unit_of(const ScalarField& field) {
    if (field.name.starts_with("deviation-from-")) return marked("input units");  // by prepare
    if (!field.measure) return nullptr;
    return *field.measure == PhotoMeasure::count ? marked("photos that see the surface")
                                                 : marked("pixels per input unit, of the finest photo");
}

PlainBackground plain_background_of(const package::SceneRecord& scene) {
    constexpr float darkest = 0.02f, brightest = 0.5f, gray = 0.6f, top = 0.7f;
    const Eigen::Array3f shade = Eigen::Map<const Eigen::Array3d>(scene.shade).cast<float>();
    const float light = (shade * Eigen::Array3f(0.2126f, 0.7152f, 0.0722f)).sum();
    if (effect_on(scene, Effect::background) || !(light > 0)) return {};
    const Eigen::Array3f calm =
        (gray * light + (1 - gray) * shade) * (std::clamp(light, darkest, brightest) / light);
    PlainBackground out;
    Eigen::Map<Eigen::Array3f>(out.bottom.data()) = calm;
    Eigen::Map<Eigen::Array3f>(out.top.data()) = top * calm;
    return out;
}

}  // namespace vantage

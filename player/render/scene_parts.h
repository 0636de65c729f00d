#pragma once
#include "player/render/render_settings.h"

namespace vantage {

/// The parts that a package has.
struct SceneParts {
    bool mesh = false, photos = false, points = false, background = false;
};

/// Restricts settings to those that apply: a point-only scene has only points, and no surface for light or
/// scalar fields.
RenderSettings usable(RenderSettings settings, const SceneParts& parts);

/// Whether points are colored by photos.
bool photos_on_points(const RenderSettings& settings, const SceneParts& parts);
bool shows_points(const RenderSettings& settings, const SceneParts& parts);
/// Whether photos are needed. Points shown alone do not need photos, and neither does light, unless a
/// background is shown.
bool shows_photos(const RenderSettings& settings, const SceneParts& parts);
bool shows_background(const RenderSettings& settings, const SceneParts& parts);
/// Whether holes are filled with surrounding colors. They are filled only in color pictures, since filling
/// would falsify counts and false colors.
bool fills_holes(const RenderSettings& settings, const SceneParts& parts);

}  // namespace vantage

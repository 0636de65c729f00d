#pragma once
#include "player/render/render_settings.h"

namespace vantage {

/// The parts that a package has.
struct SceneParts {
    bool mesh = false, photos = false, points = false, background = false;
};

/// The settings that apply: in a scene of points only there is nothing but points, and no surface to put
/// light or scalar fields on.
RenderSettings usable(RenderSettings settings, const SceneParts& parts);

/// Whether points have the photos' colors where photos show them.
bool photos_on_points(const RenderSettings& settings, const SceneParts& parts);
bool shows_points(const RenderSettings& settings, const SceneParts& parts);
/// Whether photos are needed: points alone need none, and neither does light, unless there is a
/// background to show.
bool shows_photos(const RenderSettings& settings, const SceneParts& parts);
bool shows_background(const RenderSettings& settings, const SceneParts& parts);
/// Whether holes get the colors around them. Only in colors: between counts or false colors, others would say
/// what is not so.
bool fills_holes(const RenderSettings& settings, const SceneParts& parts);

}  // namespace vantage

#pragma once
#include "player/camera/panorama.h"
#include "player/objects/object_set.h"

namespace vantage {

/// Renders all directions around an eye: a cube's faces, with `side` * `side` samples per pixel, of which
/// each pixel of the panorama then takes four. Throws Error(usage) for a size that the graphics card cannot
/// draw.
Picture take_panorama(ObjectSet& objects, const Panorama& panorama, const RenderSettings& settings,
                      std::span<const std::uint32_t> photos, int side);

}  // namespace vantage

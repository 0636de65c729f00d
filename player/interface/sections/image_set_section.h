#pragma once
#include "player/interface/sections/controls.h"
#include "player/render/renderer.h"

namespace vantage {

/// Chooses the image sets to show of a package with several: one, or two mixed, side by side or with a swipe.
void image_set_section(Controls& controls, RenderSettings& settings, const Renderer& renderer);

/// Whether a photo is of an image set that the settings show.
bool is_shown(const ImageSetSettings& settings, const package::PhotoRecord& photo);

/// Shows the image set that follows, or the first one after the last.
void show_next_image_set(ImageSetSettings& settings, std::size_t image_sets);

}  // namespace vantage

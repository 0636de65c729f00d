#pragma once
#include "player/interface/sections/controls.h"
#include "player/render/renderer.h"

namespace vantage {

/// For a package with several image sets, selects one, and if `more`, a second one, which is mixed with it,
/// shown beside it or divided from it by a swipe.
void image_set_section(Controls& controls, RenderSettings& settings, const Renderer& renderer,
                       bool more = true);

/// Whether a photo belongs to a shown image set.
bool is_shown(const ImageSetSettings& settings, const package::PhotoRecord& photo);

/// Shows the next image set, or the first one after the last.
void show_next_image_set(ImageSetSettings& settings, std::size_t image_sets);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The photo of a shown image set, with pixels, whose camera agrees best with this view; none without photos.
std::optional<std::uint32_t> agreeing_photo(const PlanScene& scene, const View& view,
                                            const ImageSetSettings& image_sets);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// Among the photos with pixels in the shown image sets, the one whose camera agrees best with this view.
/// Returns nullopt if there are no such photos.
std::optional<std::uint32_t> agreeing_photo(const PlanScene& scene, const View& view,
                                            const ImageSetSettings& image_sets);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The photo with pixels, of an image set that is shown, whose view agrees best with this one; none without
/// photos.
std::optional<std::uint32_t> agreeing_photo(const PlanScene& scene, const View& view,
                                            const ImageSetSettings& image_sets);

}  // namespace vantage

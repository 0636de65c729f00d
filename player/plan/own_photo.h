#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage {

/// The photo, if any, that was taken from the viewer's position and covers the view's frame. This photo sees
/// everything that the viewer sees, and near its own camera it outweighs all others (shaders/blend.frag).
std::optional<std::uint32_t> own_photo(const PlanScene& scene, const View& view,
                                       std::span<const std::uint32_t> photos);

}  // namespace vantage

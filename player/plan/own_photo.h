#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage {

/// The photo, if one of these was taken from where the viewer is, and shows all that is in the view's frame:
/// what the viewer sees, it sees, and near its own camera it outweighs all others (shaders/blend.frag).
std::optional<std::uint32_t> own_photo(const PlanScene& scene, const View& view,
                                       std::span<const std::uint32_t> photos);

}  // namespace vantage

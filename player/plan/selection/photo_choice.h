#pragma once
#include <cstdint>
#include <span>

#include "player/plan/plan_settings.h"
#include "player/plan/selection/chosen_photos.h"
#include "player/plan/visible_surface.h"

namespace vantage {

/// Chooses among the `allowed` photos, with a slight preference for those in `previous`, to avoid flicker.
PhotoChoice choose_photos(const VisibleSurface& surface, const PlanSettings& settings,
                          std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous);

}  // namespace vantage

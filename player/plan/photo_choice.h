#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_settings.h"
#include "player/plan/visible_surface.h"

namespace vantage {

struct ChosenPhoto {
    std::uint32_t photo;
    double agreement;  ///< with the view, see agreement()
};
struct PhotoChoice {
    std::vector<ChosenPhoto> photos;  ///< by decreasing agreement
    double uncovered = 0;             ///< see uncovered_share()
};

/// Chooses among the photos `allowed`, with a slight preference for those in `previous`, to avoid flicker.
PhotoChoice choose_photos(const VisibleSurface& surface, const PlanSettings& settings,
                          std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_settings.h"
#include "player/plan/sight.h"

namespace vantage {

struct ChosenPhoto {
    std::uint32_t photo;
    double agreement;  ///< with the view, as agreement()
};
struct PhotoChoice {
    std::vector<ChosenPhoto> photos;  ///< by falling agreement
    double uncovered = 0;             ///< as uncovered_share()
};

/// Chooses among the photos `allowed`; those in `previous` are preferred a little, so that the choice does
/// not flicker.
PhotoChoice choose_photos(const Sight& sight, const PlanSettings& settings,
                          std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous);

}  // namespace vantage

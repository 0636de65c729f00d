#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

struct ChosenPhoto {
    std::uint32_t photo;
    double agreement;  ///< agreement with the view, see agreement()
    bool operator==(const ChosenPhoto&) const = default;
};

/// Result of choose_photos().
struct PhotoChoice {
    std::vector<ChosenPhoto> photos;  ///< in order of decreasing agreement
    double uncovered = 0;             ///< see uncovered_share()
};

}  // namespace vantage

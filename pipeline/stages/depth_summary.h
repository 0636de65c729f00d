#pragma once
#include <optional>
#include <span>

namespace vantage {

/// Of the finite depths of a map; the median is of some 16,000 of them.
struct DepthSummary {
    float nearest, farthest, median;
};
/// Depths are positive, +inf where nothing is seen; nothing where nothing is.
std::optional<DepthSummary> summarize_depths(std::span<const float> z);

}  // namespace vantage

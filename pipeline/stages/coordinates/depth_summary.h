#pragma once
#include <optional>
#include <span>

namespace vantage {

/// Summary of a map's finite depths. The median is computed from a sample of about 16,000 pixels.
struct DepthSummary {
    float nearest, farthest, median;
};
/// Depths are positive, +inf where nothing is visible. Returns nullopt if no depth is finite.
std::optional<DepthSummary> summarize_depths(std::span<const float> z);

}  // namespace vantage

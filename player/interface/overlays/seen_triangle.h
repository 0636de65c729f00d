#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "player/plan/views/view_plan.h"

namespace vantage {

/// The triangle visible at a pixel (0, 0: the frame's upper left corner), numbered from 1; 0 for none.
std::uint32_t seen_triangle(const SeenTriangles& seen, const Eigen::Vector2d& pixel);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <vector>

#include "base/gl/program.h"

namespace vantage {

/// Exact Euclidean distance in pixels to the center of the nearest border pixel; +inf if there is no border
/// (OpenCV; Felzenszwalb and Huttenlocher 2012). `borders`: width x height, nonzero on a border.
std::vector<float> exact_distance(const std::vector<std::uint8_t>& borders, int width, int height);

/// The compute program for flood_distance.
gl::Program jump_flood_program();

/// The same by jump flooding, with all steps done twice, in the current OpenGL context (Rong and Tan 2006).
/// Distances are never too small and rarely too large.
std::vector<float> flood_distance(const gl::Program& jump_flood, const std::vector<std::uint8_t>& borders,
                                  int width, int height);

}  // namespace vantage

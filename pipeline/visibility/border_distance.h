#pragma once
#include <cstdint>
#include <vector>

#include "base/gl/program.h"

namespace vantage {

/// Exact Euclidean distance in pixels to the center of the nearest border pixel; +inf if there is no border
/// (OpenCV; Felzenszwalb and Huttenlocher 2012). `borders`: width x height bytes, nonzero on a border.
std::vector<float> exact_distance(const std::vector<std::uint8_t>& borders, int width, int height);

/// The compute program for flood_distance.
gl::Program jump_flood_program();

/// Computes the distance by jump flooding in the current OpenGL context, performing every step twice (Rong
/// and Tan 2006). Distances are never too small and rarely too large.
std::vector<float> flood_distance(const gl::Program& jump_flood, const std::vector<std::uint8_t>& borders,
                                  int width, int height);

}  // namespace vantage

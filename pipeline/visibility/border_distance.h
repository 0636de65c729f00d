#pragma once
#include <cstdint>
#include <vector>

#include "gl/program.h"
#include "pipeline/settings/settings.h"

namespace vantage {

/// Exact Euclidean distance in pixels to the nearest border pixel's centre (OpenCV, Felzenszwalb), +inf with
/// no border.
std::vector<float> exact_distance(const std::vector<std::uint8_t>& borders, int width, int height);

/// The program that flood_distance runs.
gl::Program jump_flood_program();

/// Jump flooding in compute, on the current OpenGL context. Same result as exact_distance up to the variant's
/// error.
std::vector<float> flood_distance(const gl::Program& jump_flood, const std::vector<std::uint8_t>& borders,
                                  int width, int height, DistanceMethod variant);

}  // namespace vantage

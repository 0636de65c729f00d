#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads the points of a LAS file, versions 1.0 to 1.4, point formats 0 to 10 (ASPRS 2019), with coordinates
/// in double precision. Colors of 16 bits become 8 bits; files that hold 8 bits in 16 are recognized. Without
/// colors, intensities become grays, the brightest hundredth white. Points marked as withheld are dropped and
/// counted in `warnings`. Throws Error(input): damaged or cut off, or compressed (LAZ).
Mesh read_las(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace vantage

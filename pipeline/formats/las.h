#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads the points of a LAS file (ASPRS 2019; versions 1.0 to 1.4, point formats 0 to 10) with coordinates
/// in double precision. 16-bit colors are reduced to 8 bits; files that store 8-bit values in 16 bits are
/// recognized. Without colors, intensities become grays, and the brightest hundredth becomes white. Points
/// marked as withheld are dropped and counted in `warnings`. Throws Error(input) if the file is damaged,
/// truncated or compressed (LAZ).
Mesh read_las(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace vantage

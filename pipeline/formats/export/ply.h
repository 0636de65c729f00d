#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <span>

namespace vantage {

/// Writes a binary little-endian PLY file: `origin` + position in double precision and a float normal per
/// vertex, and the triangles. `normals` is as long as `positions`. Throws Error(storage).
void write_ply(const std::filesystem::path& file, const Eigen::Vector3d& origin,
               std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace vantage

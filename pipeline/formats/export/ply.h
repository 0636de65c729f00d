#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <span>

namespace vantage {

/// Writes a binary PLY: positions in double precision plus `origin`, float normals, triangles. Throws
/// Error(storage).
void write_ply(const std::filesystem::path& file, const Eigen::Vector3d& origin,
               std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace vantage

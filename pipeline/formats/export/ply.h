#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <span>
#include <string>

namespace vantage {

/// A scalar property of the vertices.
struct PlyLayer {
    std::string name;
    std::span<const float> values;  ///< one per vertex
};

/// Writes a binary little-endian PLY file: `origin` + position in double precision, a float normal and a
/// float per layer for each vertex, and the triangles. `normals` is as long as `positions`. In names, what is
/// not printable ASCII becomes '_'. Throws Error(storage).
void write_ply(const std::filesystem::path& file, const Eigen::Vector3d& origin,
               std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
               std::span<const std::array<std::uint32_t, 3>> triangles,
               std::span<const PlyLayer> layers = {});

}  // namespace vantage

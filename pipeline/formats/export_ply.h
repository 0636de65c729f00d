#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace vantage {

/// A scalar property of the vertices.
struct PlyField {
    std::string name;
    std::span<const float> values;  ///< one per vertex
};

/// `normals` is as long as `positions`, and so is `colors` unless it is empty.
struct PlyMesh {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the positions
    std::span<const Eigen::Vector3f> positions, normals;
    std::span<const std::array<std::uint32_t, 3>> triangles;
    std::span<const PlyField> fields{};
    std::span<const std::array<std::uint8_t, 4>> colors{};
};

/// Writes a binary little-endian PLY file with vertices and triangles. Each vertex has `origin` + position in
/// double precision, a normal in single precision, red, green, blue and alpha if there are `colors`, and one
/// float per field. In names, characters other than printable ASCII become '_'. Throws Error(storage).
void write_ply(const std::filesystem::path& file, const PlyMesh& mesh);

/// A colored point, in the coordinates of the input.
struct PlyPoint {
    Eigen::Vector3d position;
    std::array<std::uint8_t, 3> color;
};

/// Writes a cloud of `count` points as binary little-endian PLY. `each` must pass the points, one by one, to
/// the function that it receives. Throws Error(storage).
void write_points_ply(const std::filesystem::path& file, std::uint64_t count,
                      const std::function<void(const std::function<void(const PlyPoint&)>&)>& each);

}  // namespace vantage

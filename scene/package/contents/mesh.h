#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vantage {

/// A scalar field that a mesh file has in addition to positions, normals and colors.
struct VertexField {
    std::string name;
    std::vector<float> values;  ///< one per vertex
};

/// An indexed triangle mesh, or a point cloud if it has no triangles, in input units.
struct Mesh {
    std::vector<Eigen::Vector3d> positions;
    std::vector<Eigen::Vector3f> normals;  ///< unit length, one per vertex; empty for points without normals
    std::vector<std::array<std::uint8_t, 4>> colors;  ///< sRGB and alpha, one per vertex; may be empty
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<VertexField> scalars;

    bool points_only() const { return triangles.empty(); }
};

}  // namespace vantage

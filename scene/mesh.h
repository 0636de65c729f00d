#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vantage {

/// Per-vertex scalar that a mesh file carried besides positions, normals and colours.
struct ScalarLayer {
    std::string name;
    std::vector<float> values;  ///< one a vertex
};

/// An indexed triangle mesh (or, with no triangles, a point cloud) in input units, double precision.
struct Mesh {
    std::vector<Eigen::Vector3d> positions;
    std::vector<Eigen::Vector3f> normals;             ///< unit length, one a vertex
    std::vector<std::array<std::uint8_t, 4>> colors;  ///< sRGB and alpha, one a vertex, or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<ScalarLayer> scalars;

    bool points_only() const { return triangles.empty(); }
};

}  // namespace vantage

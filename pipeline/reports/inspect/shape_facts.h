#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The contents of a mesh or a cloud.
struct ShapeFacts {
    std::size_t vertices = 0, triangles = 0;
    Eigen::Vector3d low, high;        ///< bounding box in input units, without strays
    std::size_t strays = 0;           ///< vertices far from all others (base/values/main_box.h)
    bool colors = false;              ///< of vertices
    std::vector<std::string> fields;  ///< scalar fields, UTF-8

    double diagonal() const { return (high - low).norm(); }
};

ShapeFacts shape_facts(const Mesh& mesh);

}  // namespace vantage

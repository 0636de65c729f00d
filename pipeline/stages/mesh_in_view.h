#pragma once
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// A photo sees the mesh if the mesh's visible part spans at least this fraction of its frame.
inline constexpr double least_share_of_frame = 0.001;

/// The names of the photos that do not see the mesh. Occlusion is ignored.
std::vector<std::string> photos_not_seeing_mesh(const SceneInput& scene);

/// Throws Error(misplaced) with the bounding boxes of mesh and cameras if more than half of the photos do not
/// see the mesh. In that case, the scale, position or coordinate frame of the mesh differs from that of the
/// cameras. `blind`: the number of photos that do not see the mesh.
void expect_mesh_in_view(const SceneInput& scene, std::size_t blind);

}  // namespace vantage

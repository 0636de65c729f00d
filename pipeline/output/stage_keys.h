#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "pipeline/input/file_identity.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/output/stage_table.h"
#include "scene/package/package_format.h"

namespace vantage {

/// XXH3-64 of a pose relative to the origin.
std::uint64_t pose_checksum(const Pose& cam_from_origin);

/// XXH3-64 of the model data that the per-photo stages read.
std::uint64_t model_checksum(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals);

/// One key per stage of a photo, computed from all of the stage's inputs, the settings that it reads and its
/// version. The result also contains the checksums of the inputs themselves. The keys exclude the pose, which
/// PhotoState stores separately, because pose refinement changes it after all other inputs are known. `mask`
/// is zero if the photo has none. `skipped`, `record` and the stages' contents are left empty.
package::PhotoState stage_keys(const SceneKey& scene, const PhotoInput& photo, const Pose& cam_from_origin,
                               const FileIdentity& file, const FileIdentity& mask);

/// Sets the checksums of the record and of the state itself.
void seal(package::PhotoState& state, const package::PhotoRecord& record);
/// Whether the state is intact and belongs to this record.
bool sealed(const package::PhotoState& state, const package::PhotoRecord& record);

}  // namespace vantage

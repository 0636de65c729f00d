#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/file_identity.h"
#include "pipeline/package_layout.h"
#include "scene/package_format.h"

namespace vantage {

inline constexpr std::size_t stage_count = std::size_t(package::Stage::count);
const char* name(package::Stage stage);

/// The scene-wide inputs of the photos' stages.
struct SceneKey {
    const PrepareSettings& settings;
    DistanceMethod distance;       ///< settled, not automatic
    bool opengl;                   ///< renders, else the processor
    bool undistortion;             ///< the effect is on
    std::uint64_t model;           ///< XXH3-64 of geometry and clusters, see model_checksum
    double reference_density = 1;  ///< of the depth mask
};

/// XXH3-64 of a pose relative to the origin.
std::uint64_t pose_checksum(const Pose& cam_from_origin);

/// The stage looks at the model from the photo's pose. Its key leaves the pose out, PhotoState has it apart:
/// registration changes it after everything else is known.
bool depends_on_pose(package::Stage stage);

/// XXH3-64 of what the photos' stages read of the model.
std::uint64_t model_checksum(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals);

/// What the stages of one photo are made from: a key a stage, over all its inputs, the settings that it reads
/// and its own version, and the inputs' checksums besides. `stencil`: all 0 where the photo has none.
/// `left_out`, `record` and contents are left empty.
package::PhotoState stage_keys(const SceneKey& scene, const PhotoInput& photo, const Pose& cam_from_origin,
                               const FileIdentity& file, const FileIdentity& stencil);

/// The settings that a stage reads, named as META's configuration names them.
std::vector<std::string> settings_of(package::Stage stage);

/// The chunks that a stage makes for a photo of `levels` levels: type and level.
std::vector<std::pair<package::Type, std::uint32_t>> chunks_of(package::Stage stage, int levels);

/// Seals record checksum and own checksum.
void seal(package::PhotoState& state, const package::PhotoRecord& record);
/// Whole, and belonging to this record.
bool sealed(const package::PhotoState& state, const package::PhotoRecord& record);

}  // namespace vantage

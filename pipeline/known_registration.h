#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/former.h"
#include "pipeline/refine/registration.h"
#include "pipeline/scene_input.h"

namespace vantage {

/// The poses that a scene comes with, relative to the origin.
std::vector<Pose> given_poses(const SceneInput& scene, const Eigen::Vector3d& origin);

/// What a finished package there found about all photos together, where it was made of the very same.
std::optional<Registration> known_registration(const SceneKey& key, const SceneInput& scene,
                                               std::span<const package::PhotoRecord> records,
                                               std::span<const Pose> given, IdentityCache& identities,
                                               const std::vector<std::unique_ptr<Former>>& formers);

/// All pairs that finished packages there measured.
std::vector<package::PairRecord> pairs_of_formers(const std::vector<std::unique_ptr<Former>>& formers);

}  // namespace vantage

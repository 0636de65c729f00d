#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/input/identity_cache.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/refine/poses/pose_refinement.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// The poses of the scene's cameras, relative to the origin.
std::vector<Pose> given_poses(const SceneInput& scene, const Eigen::Vector3d& origin);
/// The poses given to `prepare`, as stored in a package.
std::vector<Pose> given_poses(const PackageReader& package);

/// For each photo, the XXH3-64 hash of the inputs to its pose refinement: tiles, camera, model, given pose,
/// renderer and image set.
std::vector<std::uint64_t> pose_refinement_fingerprints(std::span<const package::PhotoState> states,
                                                        std::span<const package::PhotoRecord> photos,
                                                        std::span<const Pose> given, bool opengl);
/// The XXH3-64 hash of all fingerprints, of the choice, and of whether the result is validated.
std::uint64_t pose_refinement_key(std::span<const std::uint64_t> fingerprints, EffectChoice choice,
                                  bool validate);

/// The pose refinement stored in a package; empty if its key differs or if it is damaged.
std::optional<PoseRefinement> pose_refinement_of(const PackageReader& package, std::uint64_t key);
/// The pairs of photos stored in a package; empty if they are damaged.
std::vector<package::PairRecord> pairs_of(const PackageReader& package);
/// The pairs of photos stored in all finished earlier packages.
std::vector<package::PairRecord> pairs_of(const EarlierPackages& earlier);

/// The pose refinement of a finished earlier package, if it was made from exactly these inputs.
std::optional<PoseRefinement> earlier_pose_refinement(const SceneKey& key, const SceneInput& scene,
                                                      std::span<const package::PhotoRecord> records,
                                                      std::span<const Pose> given, IdentityCache& identities,
                                                      const EarlierPackages& earlier);

/// Writes REGI and PAIR.
void write_pose_refinement(PackageWriter& writer, const PoseRefinement& found, std::span<const Pose> given,
                           std::uint64_t key);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/formats/export_colmap.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/building.h"
#include "pipeline/synth/spec.h"

namespace vantage {

/// A camera held level; not for views straight up or down.
Pose look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

/// The specified cameras without error: on an arc in front of the facade, alternating between two heights.
/// With infrared photos, those in visible light come first, and each image set's names have a folder.
std::vector<NamedCamera> place_cameras(const SynthSpec& spec);

/// The file in the folder that no input of a user has: the gains per photo.
inline constexpr const char* synth_mark = "truth/exposure.csv";

/// The other files that synthesize() writes, relative to its folder.
std::vector<std::filesystem::path> synthesized_files(const SynthSpec& spec);

/// Renders a scene by ray casting and writes it to `folder`: the input that a user would have
/// (images/NAME.jpg, sparse/ in COLMAP text, mesh.ply) and the ground truth: truth/sparse/ (the cameras
/// without error), truth/exposure.csv (linear gains per photo) and truth/depth/NAME.exr (as cast_depth()).
/// The same specification gives the same files. `progress`, if set, may be called by several threads at once.
/// Throws Error(storage).
void synthesize(const SynthSpec& spec, const std::filesystem::path& folder,
                const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace vantage

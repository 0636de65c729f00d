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

/// A level camera. The view must not be straight up or down.
Pose look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

/// The specified cameras without errors, on an arc in front of the facade, alternating between two heights.
/// If there are infrared photos, the photos in visible light come first, and names include a folder per image
/// set.
std::vector<NamedCamera> place_cameras(const SynthSpec& spec);

/// A file that identifies a synthesized folder, because inputs from users never contain it: the gains per
/// photo.
inline constexpr const char* synth_mark = "truth/exposure.csv";

/// The other files written by synthesize(), relative to its folder.
std::vector<std::filesystem::path> synthesized_files(const SynthSpec& spec);

/// Renders a scene by ray casting and writes it to `folder`: an input like those provided by users
/// (images/NAME.jpg, sparse/ as COLMAP text, mesh.ply) and the ground truth, which consists of truth/sparse/
/// (the cameras without errors), truth/exposure.csv (linear gains per photo) and truth/depth/NAME.exr (the
/// result of cast_depth()). The same specification gives the same files. `progress`, if set, may be called by
/// several threads at once. Throws Error(storage).
void synthesize(const SynthSpec& spec, const std::filesystem::path& folder,
                const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/formats/export/colmap.h"
#include "pipeline/synth/building.h"
#include "pipeline/synth/ray_scene.h"
#include "pipeline/synth/spec.h"

namespace vantage {

/// The specified cameras, without error: on an arc before the facade, at two heights in turn.
std::vector<NamedCamera> place_cameras(const SynthSpec& spec);

/// Writes into `folder` what a user would have (images/NAME.jpg, sparse/ in COLMAP text, mesh.ply) and beside
/// it the truth: truth/sparse/ (the cameras that took the photos), truth/exposure.csv (linear gains a photo)
/// and truth/depth/NAME.exr (linear z at pixel centres of the pinhole camera, +inf beside the model).
/// Rendered by ray casting; the same specification gives the same files. Throws Error(storage).
void synthesize(const SynthSpec& spec, const std::filesystem::path& folder,
                const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace vantage

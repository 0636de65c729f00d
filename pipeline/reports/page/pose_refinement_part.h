#pragma once
#include <span>
#include <string>

#include "pipeline/refine/poses/pose_refinement.h"
#include "scene/package/package_format.h"

namespace vantage {

/// HTML about the displacements between photos of the same surface (for each photo, and as maps for the worst
/// pairs) and the cameras that were moved.
std::string pose_refinement_part(std::span<const package::PhotoRecord> photos,
                                 const PoseRefinement& pose_refinement);

}  // namespace vantage

#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/agreement/surface_discs.h"
#include "scene/camera/camera.h"

namespace vantage {

/// How the photos stand to the model.
enum class KindOfScan {
    object,  ///< all around something whose surface faces outward
    inside,  ///< among surfaces that face them: a room, a courtyard
    front    ///< before a facade or a relief, or above a site
};

/// Of photos with pixels: their poses, and their samples at `discs`.
KindOfScan kind_of_scan(std::span<const Pose> poses, Samples samples, std::span<const SurfaceDisc> discs,
                        const Eigen::Vector3d& up);

}  // namespace vantage

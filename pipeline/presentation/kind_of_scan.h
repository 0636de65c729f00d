#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/agreement/surface_discs.h"
#include "scene/camera/camera.h"

namespace vantage {

/// The arrangement of the photos around the model.
enum class KindOfScan {
    object,  ///< all around an outward-facing surface
    inside,  ///< among inward-facing surfaces: a room, a courtyard
    front    ///< in front of a facade or a relief, or above a site
};

/// `poses` and `samples` (at `discs`) cover only the photos that have pixels.
KindOfScan kind_of_scan(std::span<const Pose> poses, Samples samples, std::span<const SurfaceDisc> discs,
                        const Eigen::Vector3d& up);

}  // namespace vantage

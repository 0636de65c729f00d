#pragma once
#include <Eigen/Core>
#include <span>

#include "pipeline/presentation/first_view.h"

namespace vantage {

/// How a scene is presented.
struct Presentation {
    Eigen::Vector3d up{0, 0, 1};
    KindOfScan kind = KindOfScan::front;
    FirstView first{};
};

/// Determines the up direction, the kind of scan and the first view. `samples`: the samples of each photo at
/// `discs`.
Presentation presentation_of(std::span<const package::PhotoRecord> photos, Samples samples,
                             std::span<const SurfaceDisc> discs);

}  // namespace vantage

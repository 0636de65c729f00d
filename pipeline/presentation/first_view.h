#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "pipeline/presentation/kind_of_scan.h"
#include "scene/agreement/shared_discs.h"
#include "scene/agreement/surface_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The view that the player opens: from the place of the photo with the best mix of detail in sight, of other
/// photos nearby, and of a usual distance; upright. It is turned and zoomed so that the model fills three
/// quarters of a frame's height or width; from inside, it is what the photo shows.
struct FirstView {
    std::uint64_t photo = 0;          ///< from whose place; the number of photos if there is none with pixels
    Eigen::Vector3d target{0, 0, 0};  ///< in the middle of the frame; relative to the origin
    double fov = 45;                  ///< vertical, degrees
    double aspect = 1;                ///< width over height of what is to be in the frame
};

/// `samples`: of each photo at `discs`; without any for those that have no pixels.
FirstView first_view(std::span<const package::PhotoRecord> photos, Samples samples,
                     std::span<const SurfaceDisc> discs, const Eigen::Vector3d& up, KindOfScan kind);

}  // namespace vantage

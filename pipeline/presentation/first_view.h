#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "pipeline/presentation/kind_of_scan.h"
#include "scene/agreement/shared_discs.h"
#include "scene/agreement/surface_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The initial view of the player: upright, from the camera with the best combination of visible detail,
/// nearby photos, and a typical distance. The view is turned and zoomed so that the model fills three
/// quarters of the frame's height or width. Inside a model, the view is that of the photo.
struct FirstView {
    std::uint64_t photo = 0;  ///< photo that provides the viewpoint; the number of photos if none has pixels
    Eigen::Vector3d target{0, 0, 0};  ///< at the center of the frame; relative to the origin
    double fov = 45;                  ///< vertical, degrees
    double aspect = 1;                ///< ratio of width to height of the part that is framed
};

/// `samples`: the samples of each photo at `discs`; empty for photos without pixels.
FirstView first_view(std::span<const package::PhotoRecord> photos, Samples samples,
                     std::span<const SurfaceDisc> discs, const Eigen::Vector3d& up, KindOfScan kind);

}  // namespace vantage

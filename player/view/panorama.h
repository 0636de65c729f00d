#pragma once
#include <array>
#include <string>

#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// A picture of all directions around an eye: longitudes along its rows, -180 to 180 degrees, and latitudes
/// along its columns, 90 to -90 (equirectangular). Twice as wide as high.
struct Panorama {
    Eigen::Vector3d eye;
    Eigen::Matrix3d R;  ///< from the origin's axes to right, down and ahead, the middle of the picture
    FrameSize size;
};

/// From the eye of a view, level, with what the view looks at in the middle. `up`: of the scene. Throws
/// Error(usage) for a size that is not twice as wide as high.
Panorama panorama_at(const View& view, const Eigen::Vector3d& up, FrameSize size);

/// Where a direction, along the axes of R, is in the picture: pixels from its upper left corner.
Eigen::Vector2d pixel_of(const Panorama& panorama, const Eigen::Vector3d& direction);

/// The views of a cube's faces around the eye: ahead, to the right, behind, to the left, above and below.
/// Each shows 90 degrees and a margin, a share of that, of at least two pixels. In the middle of a face, they
/// are `finer` times as fine as the panorama.
std::array<View, 6> cube_views(const Panorama& panorama, double finer, double margin);
/// From the panorama's axes to those of each face.
std::array<Eigen::Matrix3d, 6> cube_axes();

/// The XMP packet by which viewers know a panorama (Google's Photo Sphere metadata, GPano).
std::string panorama_xmp(FrameSize size);

}  // namespace vantage

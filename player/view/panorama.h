#pragma once
#include <array>
#include <string>

#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// An equirectangular picture of all directions around an eye: longitudes along its rows, -180 to 180
/// degrees, and latitudes along its columns, 90 to -90. It is twice as wide as it is high.
struct Panorama {
    Eigen::Vector3d eye;
    Eigen::Matrix3d R;  ///< rotates the origin's axes to right, down and forward (the picture's center)
    FrameSize size;
};

/// A level panorama at the eye of a view, with the view's target in the center. `up`: the scene's up
/// direction. Throws Error(usage) if the size is not twice as wide as it is high.
Panorama panorama_at(const View& view, const Eigen::Vector3d& up, FrameSize size);

/// The position in the picture of a direction that is given along the axes of R; in pixels from the upper
/// left corner.
Eigen::Vector2d pixel_of(const Panorama& panorama, const Eigen::Vector3d& direction);

/// The views of a cube's faces around the eye: front, right, back, left, top and bottom. Each view shows 90
/// degrees plus a margin on each side: the fraction `margin` of the face's width, but at least two pixels. At
/// the center of a face, the resolution is `finer` times that of the panorama.
std::array<View, 6> cube_views(const Panorama& panorama, double finer, double margin);
/// The rotations from the panorama's axes to those of each face.
std::array<Eigen::Matrix3d, 6> cube_axes();

/// The XMP packet that identifies a panorama to viewers (Google's Photo Sphere metadata, GPano).
std::string panorama_xmp(FrameSize size);

}  // namespace vantage

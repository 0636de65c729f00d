#pragma once
#include "player/composition/object_set.h"
#include "player/composition/stereo_picture.h"
#include "player/view/stereo_panorama.h"

namespace vantage {

/// Renders all directions around an eye using the faces of a cube, with the samples per pixel given in
/// `spec`. Each pixel of the panorama then takes four samples of the faces. Throws Error(usage) if the
/// graphics card cannot draw a panorama of this size.
Picture take_panorama(ObjectSet& objects, const Panorama& panorama, const PictureSpec& spec);

/// Renders a panorama in stereo, with both eyes in one picture: the eyes turn with the viewing direction.
/// `finished`: called after each slice, with the number of finished slices and the total.
Picture take_stereo_panorama(ObjectSet& objects, StereoPicture& stereo, StereoMode mode,
                             const StereoPanorama& panorama, const PictureSpec& spec,
                             const std::function<void(std::size_t done, std::size_t count)>& finished);

/// The distance from a point, given relative to the scene's origin, to the nearest surface around it, found
/// by casting rays in all directions. Returns `otherwise` if no ray meets a surface.
double nearest_around(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& point, double otherwise);

}  // namespace vantage

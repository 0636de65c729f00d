#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

#include "scene/camera.h"
#include "scene/package_format.h"

namespace vantage {

/// How a view shows colours: times `gain` of the mean photo's exposure, and darker towards the corner by a
/// lens's falloff, as PhotoRecord has it.
struct Exposure {
    std::array<float, 3> gain{1, 1, 1}, falloff{0, 0, 0};
};
/// As the photo was exposed, through its lens.
Exposure exposure_of(const package::PhotoRecord& photo);

/// A camera to render from; positions are relative to the package's origin.
struct View {
    Intrinsics intrinsics;
    Pose cam_from_origin;
    Exposure exposure{};
};

/// The photo's own camera and exposure, its frame resized to `scale` times the photo (rounded, at least one
/// pixel).
View view_of_photo(const package::PhotoRecord& photo, double scale);

/// From `eye` towards `target`, with `up` on top; vertical field of view in degrees. Looking along `up` picks
/// another up. Eye and target relative to the origin; throws Error(usage) where they coincide.
View view_towards(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up,
                  double fov, int width, int height);

/// Maps pixels of one view to those of another from the same place, both homogeneous.
Eigen::Matrix3d pixels_from_pixels(const Intrinsics& to, const Eigen::Matrix3d& to_R, const View& from);

/// Mean of the photos' up directions; +y where they cancel out.
Eigen::Vector3d mean_up(std::span<const package::PhotoRecord> photos);

}  // namespace vantage

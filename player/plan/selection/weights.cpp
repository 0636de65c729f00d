#include "player/plan/selection/weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/values/angle_between.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

/// The center of a photo's camera, moved along its viewing direction until the camera sees the same width of
/// its surface with the view's field of view ([M] 4.1 to 4.3). d is the distance of the surface that the
/// photo sees, so a camera at the model's center needs no special case.
Eigen::Vector3d normalized_center(const package::PhotoRecord& photo, const View& view) {
    const Pose pose = cam_from_origin(photo);
    const double own = photo.fx / photo.width, wanted = view.intrinsics.fx / view.intrinsics.width;
    return pose.center() + pose.direction() * photo.seen_distance * (1 - wanted / own);
}

}  // namespace

std::vector<double> nearest_is_one(const std::vector<double>& values, double floor, double indistinct) {
    std::vector<double> weights(values.size(), 1);
    if (values.empty()) return weights;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double range = std::max(*high - *low, indistinct);
    if (!(range > 0)) return weights;
    for (std::size_t i = 0; i < values.size(); ++i)
        weights[i] = std::max(floor, 1 - (values[i] - *low) / range);
    return weights;
}

ViewWeights view_weights(const View& view, std::span<const package::PhotoRecord> photos,
                         const WeightSettings& s) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::vector<double> distances, angles;
    for (const package::PhotoRecord& p : photos) {
        const Eigen::Vector3d center =
            s.fov_normalization ? normalized_center(p, view) : cam_from_origin(p).center();
        const Eigen::Vector3d direction =
            s.corrected_directions ? Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(p.corrected_direction))
                                   : cam_from_origin(p).direction();
        distances.push_back((center - eye).norm());
        angles.push_back(angle_between(view.cam_from_origin.direction(), direction));
    }
    // The rounding errors of distances are proportional to the coordinates; those of angles are the rounding
    // errors of unit vectors.
    double reach = eye.norm();
    for (const double d : distances) reach = std::max(reach, d);
    return {nearest_is_one(distances, 1e-3, 1e-9 * reach), nearest_is_one(angles, 1e-3, 1e-9)};
}

std::vector<double> dynamic_weights(const View& view, std::span<const package::PhotoRecord> photos,
                                    const WeightSettings& s) {
    const ViewWeights parts = view_weights(view, photos, s);
    std::vector<double> weights(photos.size(), 1);
    const auto apply = [&](const std::vector<double>& factor) {
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= std::pow(factor[i], s.exponent);
    };
    if (s.distance) apply(parts.distance);
    if (s.angle && s.angle_per_photo) apply(parts.angle);
    // Even when multiplied by the static weights, this value is far above the smallest float, so that a
    // single photo yields a color.
    for (double& w : weights) w = std::max(w, 1e-9);
    return weights;
}

}  // namespace vantage

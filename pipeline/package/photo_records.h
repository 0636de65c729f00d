#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/settings/settings.h"
#include "scene/package_format.h"

namespace vantage {

/// Into a photo's or a registration's record: a pose relative to the origin.
template <class Record>
void set_pose(const Pose& pose, Record& r) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.R) = pose.R;
    Eigen::Map<Eigen::Vector3d>(r.t) = pose.t;
}

/// A record a photo, in the scene's order; what the photos' stages find out is left empty. Throws
/// Error(usage) for a photo to hold out that the scene has not.
std::vector<package::PhotoRecord> photo_records(const SceneInput& scene, const PrepareSettings& settings,
                                                const Eigen::Vector3d& origin);

/// XXH3-64 of the photos' names, in order.
std::uint64_t names_checksum(std::span<const package::PhotoRecord> photos);

}  // namespace vantage

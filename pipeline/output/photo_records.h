#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Stores a pose, relative to the origin, in a photo or pose refinement record.
template <class Record>
void set_pose(const Pose& pose, Record& r) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.R) = pose.R;
    Eigen::Map<Eigen::Vector3d>(r.t) = pose.t;
}

/// For each photo of the scene, whether `names` (each with or without extension) lists it as held out. Throws
/// Error(usage) if a name matches no photo of the scene, or several.
std::vector<bool> held_out(const SceneInput& scene, std::span<const std::string> names);

/// One record per photo, in the scene's order; fields measured by the per-photo stages are left empty. Throws
/// Error(usage) in the same cases as held_out().
std::vector<package::PhotoRecord> photo_records(const SceneInput& scene, const PrepareSettings& settings,
                                                const Eigen::Vector3d& origin);

/// XXH3-64 of the photos' names, in order.
std::uint64_t names_checksum(std::span<const package::PhotoRecord> photos);

}  // namespace vantage

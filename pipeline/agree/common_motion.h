#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/agree/surface_matches.h"
#include "scene/camera.h"

namespace vantage {

/// A similarity of space, x -> scale * R * x + t.
struct Similarity {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    double scale = 1;
};

/// The camera that shows x where `pose` shows S(x).
Pose moved_with(const Pose& pose, const Similarity& s);
Similarity inverse(const Similarity& s);

/// What all cameras did together: the similarity S for which the given cameras show S(x) most nearly where
/// the new ones show x, least squares over the tracks' points, linear (motions of a few pixels).
Similarity common_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> given,
                         std::span<const Pose> now, std::span<const Track> tracks);

/// Median of how far, in pixels, the tracks of photos (of one, or of all) lie from each other under two sets
/// of cameras; 0 without any.
double median_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> a, std::span<const Pose> b,
                     std::span<const Track> tracks, std::optional<std::uint32_t> photo = {});

}  // namespace vantage

#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/pair_matching.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// Input of register_photos.
struct PoseRefinementInput {
    const PackageReader& package;                  ///< package with tiles, depth and samples
    const MatchViews& views;                       ///< of that package
    std::span<const package::PhotoRecord> photos;  ///< records with the given poses
    Samples samples;
    std::span<const SurfaceDisc> discs;           ///< one per sample of a photo
    std::span<const std::uint64_t> fingerprints;  ///< a fingerprint of each photo's content and pose
    std::span<const package::PairRecord> known;   ///< pairs measured earlier, reused if their keys match
    unsigned threads = 0;
    bool validate = true;   ///< whether held-out photos must confirm that cameras move
    OnProgress progress{};  ///< called in each round of matching; may be empty
};

/// The refined pose of one photo's camera.
struct PhotoPoseRefinement {
    std::optional<Pose> pose;      ///< relative to the origin; nullopt: the given pose is kept
    double motion_px = 0;          ///< median motion of the surface in the photo
    double before = 0, after = 0;  ///< median displacement of held-out corners, px
    double uncertainty = 0;        ///< standard error of the motion, px
};

/// The pose of a refined camera, estimated without one photo's matches.
struct LeaveOneOutPose {
    std::uint32_t without, photo;
    Pose pose;
};

/// How well the photos agree through the model, and the poses that improve this agreement.
struct PoseRefinement {
    EffectDecision decision;
    std::vector<PhotoPoseRefinement> photos;
    std::vector<package::PairRecord> pairs;  ///< measured with the given cameras
    std::vector<LeaveOneOutPose> without;    ///< see leave_one_out_poses; empty if no camera moved on its own
    std::vector<std::string> warnings;       ///< one line per misplaced photo, camera swap or lens error
};

/// A photo is odd if it is displaced by at least `min_outlier` px and at least `outlier_ratio` times as much
/// as the others.
inline constexpr double min_outlier = 0.75, outlier_ratio = 2;

/// The disagreement of the pairs, relative to three limits: corners displaced by 1 px (median), a pair
/// shifted by 1.5 px, and one photo displaced by twice as much as the others. If it exceeds 1, pose
/// refinement is needed. `found` receives a description, unless it is null.
double disagreement(const PoseRefinementInput& input, std::span<const package::PairRecord> pairs,
                    std::string* found = nullptr);

/// Unless pose refinement is off, matches each photo with the two photos that have the most surface in common
/// with it, at 800 px on the longer side. If they disagree, decides which cameras move; see choose_poses.
/// Throws Error(damaged).
PoseRefinement register_photos(const PoseRefinementInput& input, EffectChoice choice);

}  // namespace vantage

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
    const PackageReader& package;                  ///< with tiles, depth and samples
    const MatchViews& views;                       ///< of that package
    std::span<const package::PhotoRecord> photos;  ///< with the given poses
    Samples samples;
    std::span<const SurfaceDisc> discs;           ///< one per sample of a photo
    std::span<const std::uint64_t> fingerprints;  ///< of each photo's content and pose
    std::span<const package::PairRecord> known;   ///< measured earlier, reused if their keys match
    double border_width = 0;                      ///< as in SceneRecord
    unsigned threads = 0;
    bool validate = true;   ///< whether held-out photos must confirm that cameras move
    OnProgress progress{};  ///< of each round of matching; may be empty
};

/// Pose refinement of one photo's camera.
struct PhotoPoseRefinement {
    std::optional<Pose> pose;      ///< relative to the origin; nullopt: the given pose is kept
    double motion_px = 0;          ///< median motion of the surface in the photo
    double before = 0, after = 0;  ///< median displacement of holdout corners, px
    double uncertainty = 0;        ///< standard error of the motion, px
};

/// The pose of a camera that pose refinement moved, without what one photo shows.
struct LeaveOneOutPose {
    std::uint32_t without, photo;
    Pose pose;
};

/// How well the photos agree through the model, and the poses with which they agree better.
struct PoseRefinement {
    EffectDecision decision;
    std::vector<PhotoPoseRefinement> photos;
    std::vector<package::PairRecord> pairs;  ///< under the given cameras
    std::vector<LeaveOneOutPose> without;    ///< see leave_one_out_poses; empty if no camera moved on its own
    std::vector<std::string> warnings;       ///< one line each: misplaced photos, swapped cameras
};

/// A photo is odd if it is displaced by at least `min_outlier` px and by `outlier_ratio` times as much as the
/// others.
inline constexpr double min_outlier = 0.75, outlier_ratio = 2;

/// How much pairs disagree, relative to the limits: corners displaced by 1 px (median), a pair shifted by 1.5
/// px, one photo displaced by twice as much as the others. Above 1, pose refinement is needed. `found`
/// describes it; may be null.
double disagreement(const PoseRefinementInput& input, std::span<const package::PairRecord> pairs,
                    std::string* found = nullptr);

/// Matches each photo with the two that share the most with it, at 800 px on the longer side, unless
/// pose refinement is off. If they disagree, decides which cameras move; see choose_poses. Throws
/// Error(damaged).
PoseRefinement register_photos(const PoseRefinementInput& input, EffectChoice choice);

}  // namespace vantage

#pragma once
#include <mutex>
#include <span>
#include <vector>

#include "pipeline/refine/poses/common_motion.h"
#include "pipeline/refine/poses/pose_fit.h"
#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// Poses that improve the agreement of the photos.
struct PoseSolution {
    std::vector<PhotoPoseRefinement> photos;
    std::vector<Pose> poses;            ///< poses of all photos, including those not moved
    std::vector<FittedCamera> cameras;  ///< cameras that were not moved are `fixed`
    Matching matched;                   ///< under these poses
    double before = 0, after = 0;       ///< median displacement of held-out corners, px
    double sigma = 1;                   ///< standard deviation of the anchor in the fit of the poses, px
    /// Common motion of all cameras that was removed, median in px; 0 if some cameras were fixed from the
    /// start.
    double common_motion = 0;
};

/// The effort of matching: a trial shows in a tenth of the time whether a fit is worthwhile.
enum class Effort { trial, full };

/// Alternates between matching photos and fitting their poses.
class PoseRounds {
  public:
    explicit PoseRounds(const PoseRefinementInput& input, Effort effort = Effort::full);

    /// Fits the poses of the given photos to all others, which are fixed. Throws Error(damaged).
    PoseSolution fit_some(std::span<const std::uint32_t> photos) const;
    /// Fits all poses. Their common motion is a gauge freedom: all cameras can slide along the model together
    /// without pairs disagreeing. The frame belongs to the survey, so this motion is removed. Throws
    /// Error(damaged).
    PoseSolution fit_all() const;
    /// The given poses, all moved by `common`; `uncertainty`: standard error of that motion, px. Throws
    /// Error(damaged).
    PoseSolution moved_together(const Similarity& common, double uncertainty) const;

    /// The solution's poses, fitted again with the same anchor to the same matches except those of one photo.
    std::vector<Pose> poses_without(const PoseSolution& solution, std::uint32_t photo) const;
    /// The solution's poses, with those of a few cameras changed by the difference that the photo's matches
    /// make in a fit to the others, which are fixed. Empty if the photo has no match with any of them.
    std::vector<Pose> poses_without(const PoseSolution& solution, std::uint32_t photo,
                                    std::span<const std::uint32_t> fitted) const;
    /// A photo's pose, fitted to its matches with the other photos, which are fixed. Uses the matches found
    /// under the given poses (null) or under a solution's. Returns the pose in `poses` if there are no
    /// matches.
    Pose resection(const PoseSolution* solution, std::span<const Pose> poses, std::uint32_t photo) const;
    const std::vector<Pose>& given() const { return given_; }
    /// Median distance in px between a photo's content under two poses of its camera.
    double motion(const PoseSolution& solution, std::span<const Pose> a, std::span<const Pose> b,
                  std::uint32_t photo) const;

  private:
    using Poses = std::vector<Pose>;
    using Pairs = std::vector<PhotoPair>;
    /// The matches under the given poses, computed on first use, by any thread.
    const Matching& as_given() const;
    int finest() const { return long_sides_.back(); }
    /// The error of the given poses in px, from the displacement of held-out corners.
    double expected_error(const Matching& matched) const;
    Matching match(const Poses& poses, const Pairs& pairs, int long_side) const;
    std::vector<PoseChange> solve(const std::vector<FittedCamera>& cameras, const Pairs& pairs,
                                  std::vector<PoseChange> change, double sigma,
                                  std::span<const int> long_sides) const;
    std::vector<Pose> fit_without(const PoseSolution& solution, std::span<const FittedCamera> cameras,
                                  std::span<const Track> tracks, bool free) const;
    void take_back_common_motion(PoseSolution& solution) const;
    void keep_improved(PoseSolution& solution, const Pairs& pairs, std::vector<PoseChange> change,
                       const Matching& before) const;

    const PoseRefinementInput& in_;
    Pairs pairs_;
    std::vector<Intrinsics> intrinsics_;
    std::vector<FittedCamera> cameras_;
    Poses given_;
    int corners_;                      ///< per photo
    std::span<const int> long_sides_;  ///< sizes for the rounds, px; the last one is the finest
    mutable std::once_flag matched_;
    mutable Matching before_;  ///< see as_given()
};

}  // namespace vantage

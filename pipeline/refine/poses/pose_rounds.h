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
    Matching matched;                   ///< with these poses
    double before = 0, after = 0;       ///< median displacement of held-out corners, px
    double sigma = 1;                   ///< standard deviation of the anchor in the fit of the poses, px
    /// The common motion of all cameras that was removed (median, px); 0 if some cameras were fixed from the
    /// start.
    double common_motion = 0;
};

/// The effort spent on matching. A trial shows in a tenth of the time whether a fit is worthwhile.
enum class Effort { trial, full };

/// Alternates between matching photos and fitting their poses.
class PoseRounds {
  public:
    explicit PoseRounds(const PoseRefinementInput& input, Effort effort = Effort::full);

    /// Fits the poses of the given photos to those of all other photos, which are fixed. Throws
    /// Error(damaged).
    PoseSolution fit_some(std::span<const std::uint32_t> photos) const;
    /// Fits all poses. Their common motion is a gauge freedom, because all cameras can slide along the model
    /// together without any disagreement between photos. The frame is that of the survey, so this motion is
    /// removed. Throws Error(damaged).
    PoseSolution fit_all() const;
    /// The given poses, all moved by `common`. `uncertainty`: the standard error of this motion, px. Throws
    /// Error(damaged).
    PoseSolution moved_together(const Similarity& common, double uncertainty) const;

    /// The solution's poses, fitted again with the same anchor and the same matches except those of one
    /// photo.
    std::vector<Pose> poses_without(const PoseSolution& solution, std::uint32_t photo) const;
    /// The solution's poses, but with the influence of the photo's matches removed from the poses of the
    /// cameras `fitted`: they are changed by the difference between fits with and without these matches, in
    /// which the other cameras are fixed. Empty if the photo has no match with any camera in `fitted`.
    std::vector<Pose> poses_without(const PoseSolution& solution, std::uint32_t photo,
                                    std::span<const std::uint32_t> fitted) const;
    /// A photo's pose, fitted to its matches with the other photos, which are fixed. The matches are those
    /// found with the solution's poses, or with the given poses if `solution` is null. If there are no
    /// matches, returns the pose in `poses`.
    Pose resection(const PoseSolution* solution, std::span<const Pose> poses, std::uint32_t photo) const;
    const std::vector<Pose>& given() const { return given_; }
    /// Median distance, in px, by which a photo's content moves between two poses of its camera.
    double motion(const PoseSolution& solution, std::span<const Pose> a, std::span<const Pose> b,
                  std::uint32_t photo) const;

  private:
    using Poses = std::vector<Pose>;
    using Pairs = std::vector<PhotoPair>;
    /// The matches found with the given poses. They are computed on first use, by whichever thread needs
    /// them.
    const Matching& as_given() const;
    int finest() const { return long_sides_.back(); }
    /// The error of the given poses in px, estimated from the displacement of held-out corners.
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
    std::span<const int> long_sides_;  ///< photo sizes for the rounds, px; the last is the finest
    mutable std::once_flag matched_;
    mutable Matching before_;  ///< see as_given()
};

}  // namespace vantage

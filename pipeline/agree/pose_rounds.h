#pragma once
#include <string>
#include <vector>

#include "pipeline/agree/pose_fit.h"
#include "pipeline/agree/registration.h"

namespace vantage {

/// Alternates between matching photos and fitting their poses.
class PoseRounds {
  public:
    explicit PoseRounds(const RegistrationInput& input);
    /// New poses for the photos whose holdout corners they improve. Appends the common motion to `evidence`.
    /// Throws Error(damaged).
    std::vector<PhotoRegistration> run(std::string& evidence) const;

  private:
    using Poses = std::vector<Pose>;
    Matching match(const Poses& poses, int long_side) const;
    std::vector<PoseChange> solve(const std::vector<FittedCamera>& cameras, std::vector<PoseChange> change,
                                  std::span<const int> long_sides) const;
    /// Poses, the matches under them, and the common motion of all cameras.
    struct Solution {
        Poses poses;
        Matching matched;
        double common_motion;  ///< px, median
        bool common_kept;      ///< false: it was removed from `poses`
    };
    Solution without_common_motion(const Poses& now) const;  ///< kept if holdout corners support it

    const RegistrationInput& in_;
    std::vector<PhotoPair> pairs_;
    std::vector<Intrinsics> intrinsics_;
    std::vector<FittedCamera> cameras_;
    Poses given_;
    Matching before_;  ///< under the given poses
    double sigma_;     ///< px, expected error of the given poses
};

}  // namespace vantage

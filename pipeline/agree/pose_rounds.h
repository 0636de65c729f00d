#pragma once
#include <string>
#include <vector>

#include "pipeline/agree/pose_fit.h"
#include "pipeline/agree/registration.h"

namespace vantage {

/// Solves for cameras: matching, fitting, and matching again with what was found.
class PoseRounds {
  public:
    explicit PoseRounds(const RegistrationInput& input);
    /// A photo's new pose, where it makes others agree better with it; adds to `evidence` what all cameras
    /// did together.
    std::vector<PhotoRegistration> registered(std::string& evidence) const;

  private:
    using Poses = std::vector<Pose>;
    Matching match(const Poses& poses, int long_side) const;
    std::vector<PoseChange> solve(const std::vector<FittedCamera>& cameras, std::vector<PoseChange> change,
                                  std::span<const int> long_sides) const;
    /// Cameras, what matching finds under them, and the slide along the model that was or was not taken back.
    struct Placed {
        Poses poses;
        Matching matched;
        double common;  ///< px, median
        bool common_kept;
    };
    Placed without_common_motion(const Poses& now) const;

    const RegistrationInput& in_;
    std::vector<PhotoPair> pairs_;
    std::vector<Intrinsics> intrinsics_;
    std::vector<FittedCamera> cameras_;
    Poses given_;
    Matching before_;
    double sigma_;  ///< px, how far cameras may well be off
};

}  // namespace vantage

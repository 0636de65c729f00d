#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/agree/pair_matching.h"
#include "pipeline/run/progress.h"
#include "scene/effects.h"

namespace vantage {

/// Input of register_photos.
struct RegistrationInput {
    const PackageReader& package;                  ///< with tiles, depth and samples
    std::span<const package::PhotoRecord> photos;  ///< with the given poses
    Samples samples;
    std::span<const SurfaceDisc> discs;           ///< one per sample of a photo
    std::span<const std::uint64_t> fingerprints;  ///< of each photo's content and pose
    std::span<const package::PairRecord> known;   ///< measured earlier, reused if their keys match
    unsigned threads = 0;
    OnProgress progress{};  ///< of each round of matching; may be empty
};

/// Registration of one photo's camera.
struct PhotoRegistration {
    std::optional<Pose> pose;      ///< relative to the origin; nullopt: the given pose is kept
    double by = 0;                 ///< median motion of the surface in the photo, px
    double before = 0, after = 0;  ///< median displacement of holdout corners, px
};

/// How well the photos agree through the model, and the poses with which they agree better.
struct Registration {
    EffectDecision decision;
    std::vector<PhotoRegistration> photos;
    std::vector<package::PairRecord> pairs;  ///< under the given cameras
    std::vector<std::string> warnings;       ///< one line each: misplaced photos, swapped cameras
};

/// Matches each photo with the two that share the most with it, at 800 px on the longer side, unless
/// registration is off. Registration is needed if corners are displaced by 1 px (median), a pair is shifted
/// by 1.5 px, or one photo is displaced by twice as much as the others.
///
/// Cameras are then solved for, coarse to fine. Their common motion is a gauge freedom, because all cameras
/// can slide along the model together without pairs disagreeing; it is removed unless holdout corners support
/// it. A photo keeps its new camera only if holdout corners agree better than before. Throws Error(damaged).
Registration register_photos(const RegistrationInput& input, EffectChoice choice);

}  // namespace vantage

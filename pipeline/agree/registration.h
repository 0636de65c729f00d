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

/// What registration starts from.
struct RegistrationInput {
    const PackageReader& package;                  ///< its tiles, depth and samples
    std::span<const package::PhotoRecord> photos;  ///< with the poses as given
    Samples samples;
    std::span<const SurfaceDisc> discs;           ///< as many as samples a photo
    std::span<const std::uint64_t> fingerprints;  ///< of what each photo shows, and from where
    std::span<const package::PairRecord> known;   ///< pairs that were measured before, by their keys
    unsigned threads = 0;
    OnProgress progress{};  ///< of every matching; may be empty
};

/// What registration made of one photo's camera.
struct PhotoRegistration {
    std::optional<Pose> pose;      ///< relative to the origin; none where the given one stays
    double by = 0;                 ///< pixels by which what the photo shows has moved, median
    double before = 0, after = 0;  ///< displacement of corners that were not solved for, median px
};

/// How well the photos fit each other through the model, and the cameras that make them fit better.
struct Registration {
    EffectDecision decision;
    std::vector<PhotoRegistration> photos;
    std::vector<package::PairRecord> pairs;  ///< under the given cameras
    std::vector<std::string> warnings;  ///< a line each: photos that do not fit, cameras that are swapped
};

/// Measures, always: each photo with the two that are most alike, at 800 pixels along the longer side.
/// Registration is called for where corners lie 1 px (median) from where the cameras expect them, a pair is
/// shifted by 1.5 px as a whole, or one photo lies twice as far off as the others.
///
/// Then cameras are solved for, coarse to fine. What all of them did together is taken back, unless photos
/// notice: a whole frame can slide along the model with no pair disagreeing. A photo keeps its new
/// camera only where corners that were not solved for lie nearer each other than before. Throws
/// Error(damaged).
Registration register_photos(const RegistrationInput& input, EffectChoice choice);

}  // namespace vantage

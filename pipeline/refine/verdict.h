#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/prediction.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// A photo that is held out of all estimates and predicted from the others, both with and without an effect.
struct ValidatedPhoto {
    std::string name;
    ValidationScore without, with;
};

/// Photos with fewer scored pixels than this are not counted.
inline constexpr std::size_t fewest_pixels = 200;

/// Summarizes the photos with at least `fewest_pixels` scored pixels; without photos, all values are 0.
/// `noise` is the standard error that the mean would have if gains were as likely as losses of the same size.
/// It is used because the spread of gains is not always noise: after one wrong camera is fixed, a few photos
/// gain much and none loses.
Judgment summarize(std::span<const ValidatedPhoto> photos);

/// Minimum number of photos for validating an effect.
inline constexpr int min_validated_photos = 3;

/// Whether an effect is worthwhile. Held-out photos must gain more than twice the noise or twice the standard
/// error of the mean, whichever is smaller. Alternatively, seams must decrease by a tenth, and the photos may
/// lose at most the standard error. In either case, no photo may lose more than 0.75 dB. Returns false if
/// there are fewer than three photos.
bool is_called_for(const Judgment& judgment);

/// Validates an effect that is on: adds the judgment and its sentence to the decision, and turns the effect
/// off if it is not worthwhile. The effect stays on if it is forced or if there are too few photos.
void confirm(EffectDecision& decision, const Judgment& judgment);

/// A sentence about the judgment, such as "held-out photos gain 0.21 dB (+-0.05; 1 of 10 worse)".
std::string sentence(const Judgment& judgment);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/prediction.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// A photo held out of all estimates and predicted from the others: without an effect, and with it.
struct ValidatedPhoto {
    std::string name;
    ValidationScore without, with;
};

/// Photos with fewer scored pixels are not counted.
inline constexpr std::size_t fewest_pixels = 200;

/// Summarizes photos of at least `fewest_pixels`; no photos: all 0. `noise` is the standard error of the mean
/// if gains were as likely as losses of the same size: after one wrong camera is fixed, few photos gain much
/// and none loses, and the spread of the gains is not noise.
Judgment summarize(std::span<const ValidatedPhoto> photos);

/// Minimum number of photos to validate an effect.
inline constexpr int min_validated_photos = 3;

/// Whether an effect is worthwhile: held-out photos gain (more than twice the noise, or twice the standard
/// error of the mean), or do not lose within that error while seams fall by a tenth; and no photo loses more
/// than 0.75 dB. False for fewer than three photos.
bool is_called_for(const Judgment& judgment);

/// Validates an effect that is on: adds the judgment and its sentence to the decision, and turns the effect
/// off if it is not worthwhile. It stays on if forced, or with too few photos.
void confirm(EffectDecision& decision, const Judgment& judgment);

/// One sentence about a judgment, such as "held-out photos gain 0.21 dB (+-0.05; 1 of 10 worse)".
std::string sentence(const Judgment& judgment);

}  // namespace vantage

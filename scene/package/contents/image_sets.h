#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A set of photos that is shown by itself, such as those in infrared.
struct ImageSet {
    std::string name;
    EffectSet effects = 0;  ///< of the scene, and those that this image set's photos decided
};

/// The image sets of a package, the default one first; one without a name if the effect is off. Throws
/// Error(damaged).
std::vector<ImageSet> read_image_sets(const PackageReader& package);

/// The number of the image set of this name; upper and lower case are the same. Throws Error(usage), naming
/// the package and its image sets, if it has none.
std::uint32_t image_set_named(const PackageReader& package, const std::string& name);

/// The effects that each image set's photos decide.
EffectSet effects_of_image_sets();

}  // namespace vantage

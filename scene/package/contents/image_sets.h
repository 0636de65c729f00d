#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A set of photos that is shown separately, such as infrared photos.
struct ImageSet {
    std::string name;
    EffectSet effects = 0;  ///< effects of the scene, and those decided from the photos of this image set
};

/// The image sets of a package, default first; a single one without a name if the effect is off. Throws
/// Error(damaged).
std::vector<ImageSet> read_image_sets(const PackageReader& package);

/// The number of the image set with this name, ignoring case. Throws Error(usage) naming the package and its
/// image sets if there is none.
std::uint32_t image_set_named(const PackageReader& package, const std::string& name);

/// The effects that are decided separately for each image set.
EffectSet effects_of_image_sets();

}  // namespace vantage

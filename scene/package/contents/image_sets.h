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
    EffectSet effects = 0;  ///< effects decided for the whole scene, and those decided for this image set
};

/// The image sets of a package, with the default one first. If the effect is off, there is a single image set
/// without a name. Throws Error(damaged).
std::vector<ImageSet> read_image_sets(const PackageReader& package);

/// The number of the image set with this name, ignoring case. If there is none, throws Error(usage), which
/// names the package and its image sets.
std::uint32_t image_set_named(const PackageReader& package, const std::string& name);

/// The effects that are decided separately for each image set.
EffectSet effects_of_image_sets();

}  // namespace vantage

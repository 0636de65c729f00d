#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A set of photos that is shown by itself, such as those in infrared.
struct Band {
    std::string name;
    EffectSet effects = 0;  ///< of the scene, and those that this band's photos decided
};

/// The bands of a package, the default one first; one without a name if the effect is off. Throws
/// Error(damaged).
std::vector<Band> read_bands(const PackageReader& package);

/// The number of the band of this name; upper and lower case are the same. Throws Error(usage), naming the
/// package and its bands, if it has none.
std::uint32_t band_named(const PackageReader& package, const std::string& name);

/// The effects that each band's photos decide.
EffectSet effects_of_bands();

}  // namespace vantage

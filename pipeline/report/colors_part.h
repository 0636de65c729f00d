#pragma once
#include <string>

#include "scene/package_reader.h"

namespace vantage {

/// HTML: how far the photos' colours disagree, what makes them agree, photo by photo, and the lenses'
/// falloff. Throws Error(damaged).
std::string colors_part(const PackageReader& package);

}  // namespace vantage

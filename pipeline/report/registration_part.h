#pragma once
#include <span>
#include <string>

#include "pipeline/agree/registration.h"
#include "scene/package_format.h"

namespace vantage {

/// HTML: how far photos of one surface lie from each other, photo by photo and pair by pair, with maps of the
/// worst pairs, and which cameras were moved.
std::string registration_part(std::span<const package::PhotoRecord> photos, const Registration& registration);

}  // namespace vantage

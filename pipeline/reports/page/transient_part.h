#pragma once
#include <span>
#include <string>

#include "pipeline/prepare/finish.h"
#include "scene/package/package_format.h"

namespace vantage {

/// HTML about the photos with content that others contradict, the worst first.
std::string transient_part(std::span<const package::PhotoRecord> photos, const TransientMasks& transients);

}  // namespace vantage

#pragma once
#include <span>
#include <string>

#include "pipeline/prepare/finish.h"
#include "scene/package/package_format.h"

namespace vantage {

/// HTML: the photos with content that others contradict, worst first.
std::string transient_part(std::span<const package::PhotoRecord> photos, const TransientMasks& transients);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <span>

#include "scene/package_format.h"

namespace vantage {

/// The photo in the middle of those of a band; of all if it has none. The player opens at it.
std::uint32_t middle_photo(std::span<const package::PhotoRecord> photos, std::uint32_t band);

}  // namespace vantage

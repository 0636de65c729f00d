#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vantage {

/// The ICC profile in a JPEG, put together from its segments (ICC.1, Annex B.4); no bytes if segments are
/// missing, nullopt if there is no profile. `jpeg`: the file, or its beginning up to the first scan.
std::optional<std::vector<std::byte>> jpeg_profile(std::span<const std::byte> jpeg);

}  // namespace vantage

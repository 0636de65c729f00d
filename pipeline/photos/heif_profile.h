#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

namespace vantage {

/// The ICC profile of a HEIC or AVIF file, which OpenImageIO 2.4 ignores; empty if there is none.
std::vector<std::byte> heif_profile(const std::filesystem::path& file);

}  // namespace vantage

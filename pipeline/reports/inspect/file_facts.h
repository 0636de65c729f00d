#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// The format of a file according to its extension: "JPEG" for .jpg, "PLY" for .ply; empty if there is no
/// extension.
std::string format_of(const std::filesystem::path& file);

/// The length of a file in bytes, or the total length of several; unknown lengths count as 0.
std::uint64_t length_of(const std::filesystem::path& file);
std::uint64_t length_of(const std::vector<std::filesystem::path>& files);

}  // namespace vantage

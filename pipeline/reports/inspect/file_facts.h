#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// A file's format by its extension: "JPEG" for .jpg, "PLY" for .ply; empty without extension.
std::string format_of(const std::filesystem::path& file);

/// The total length of files in bytes; unknown lengths count as 0.
std::uint64_t length_of(const std::filesystem::path& file);
std::uint64_t length_of(const std::vector<std::filesystem::path>& files);

}  // namespace vantage

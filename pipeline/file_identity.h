#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace vantage {

/// Length and XXH3-64 of a file's bytes: how a package knows its inputs again. Throws Error(input).
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(const std::filesystem::path& file);

/// The camera files behind `cameras`: itself, or for a folder the COLMAP files in it, by name.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& cameras);

}  // namespace vantage

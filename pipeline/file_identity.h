#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// Length and XXH3-64 of a file's bytes: how a package knows its inputs again. Throws Error(input).
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(std::span<const std::byte> bytes);
FileIdentity identify(const std::filesystem::path& file);

/// The bytes of a file, or its first `most`. Throws Error(input).
std::vector<std::byte> read_file(const std::filesystem::path& file,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());

/// All of a file as characters. Throws Error(input).
std::string read_text(const std::filesystem::path& file);

/// The camera files behind `cameras`: itself, or for a folder the COLMAP files in it, by name.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& cameras);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace vantage {

/// Length in bytes and XXH3-64 of a file's content, by which a package recognizes its inputs.
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(std::span<const std::byte> bytes);
/// Reads the whole file. Throws Error(input).
FileIdentity identify(const std::filesystem::path& file);

}  // namespace vantage

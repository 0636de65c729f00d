#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace vantage {

/// Length and XXH3-64 of a file's bytes: how a package knows its inputs again. Throws Error(input).
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(std::span<const std::byte> bytes);
FileIdentity identify(const std::filesystem::path& file);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace vantage {

/// XXH3-64 of the bytes, with seed 0.
std::uint64_t checksum(std::span<const std::byte> bytes);

/// The length in bytes and the XXH3-64 of a file's content, which together identify an input of a package.
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(std::span<const std::byte> bytes);

}  // namespace vantage

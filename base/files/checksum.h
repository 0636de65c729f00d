#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace vantage {

/// XXH3-64 of the bytes, seed 0.
std::uint64_t checksum(std::span<const std::byte> bytes);

/// Length in bytes and XXH3-64 of a file's content, which identify the inputs of a package.
struct FileIdentity {
    std::uint64_t bytes = 0, checksum = 0;
    bool operator==(const FileIdentity&) const = default;
};
FileIdentity identify(std::span<const std::byte> bytes);

}  // namespace vantage

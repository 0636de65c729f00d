#pragma once
#include <cstdint>
#include <filesystem>

#include "scene/package/package_writer.h"

namespace vantage {

/// The result of disk_space_for() if the file system does not report its free space.
inline constexpr std::uint64_t unknown_space = ~std::uint64_t(0);

/// The maximum number of bytes on disk during preparation. For compact chunks, this is an estimate that
/// includes both the part and the package, which then exist at the same time.
std::uint64_t disk_space_needed(const PackageLayout& layout);

/// Bytes available on disk for the package `out`, including those that its part already occupies.
std::uint64_t disk_space_for(const std::filesystem::path& out);

/// Whether the folder of `out` is in memory, so that no disk limits the writing.
bool is_in_memory(const std::filesystem::path& out);

/// Makes sure that the package fits on the disk. A finished package stays until the new one is complete. Only
/// if the disk cannot hold both does the old file itself become the part to be resumed, provided that it has
/// the same layout and no process has it open. Throws Error(storage).
void ensure_disk_space(const std::filesystem::path& out, const PackageLayout& layout);

}  // namespace vantage

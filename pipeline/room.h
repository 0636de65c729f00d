#pragma once
#include <cstdint>
#include <filesystem>

#include "scene/package_writer.h"

namespace vantage {

/// Bytes that the disk has for the package `out` of this layout, what its part takes already included.
std::uint64_t room_for(const std::filesystem::path& out);

/// Sees to it that there is room for the package, or refuses. A finished one that is there stays until the
/// new one is whole; only where the disk has not the room for both, the old one itself becomes the part that
/// is gone on with, if it has the same layout and nobody has it open. Throws Error(storage).
void make_room(const std::filesystem::path& out, const PackageLayout& layout);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/package_writer.h"
#include "scene/tiling.h"

namespace vantage {

/// Cuts a level of 4-byte texels into its tiles, into the package.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agreement/read_level.h"
#include "pipeline/pixels/rgba_image.h"
#include "scene/package_reader.h"
#include "scene/package_writer.h"
#include "scene/tiling.h"

namespace vantage {

/// Cuts a level of 4-byte texels into tiles and writes them to the package.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size);

/// A level of a photo's TILE or MASK as an image; see read_level.
RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& record,
                           std::uint32_t photo, package::Type type, int level);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/rgba_image.h"
#include "base/values/tiling.h"
#include "pipeline/stages/stage_input.h"
#include "scene/agreement/read_level.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// Maximum quality, 1 to 100, of color JPEGs other than the photo's own.
inline constexpr int color_quality = 97;
/// JPEG quality for a level. Its quantization is that of the photo's own JPEG, halved per level, because the
/// mean of four pixels has half their error. `jpeg` is empty if the photo is not a JPEG.
int level_quality(std::span<const std::byte> jpeg, std::uint32_t level);

/// Texels of 4 bytes each, row by row.
struct LevelTexels {
    std::span<const std::byte> texels;
    Level size;
};

/// Cuts a level into tiles and writes them to the package. If the chunk is compact, tiles are compressed:
/// opaque color as JPEG, depth rounded, weight maps and other color without loss.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 const LevelTexels& of, int quality = color_quality);

/// A level of color as it is read back after write_tiles(), with compression errors if it is stored as JPEG.
/// Results computed from it equal those computed later from the package.
RgbaImage as_stored(const PackageWriter& writer, std::uint32_t photo, std::uint32_t level,
                    const RgbaImage& image, int quality);

/// Writes the finest level of a photo with the coefficients of the photo's own JPEG. Returns false if the
/// chunk is not compact, or if the JPEG cannot be divided into tiles.
bool write_own_jpeg(PackageWriter& writer, std::uint32_t photo, std::span<const std::byte> jpeg);

/// Writes a photo's thumbnail from RGBA texels; it may be stored as JPEG.
void write_thumbnail(PackageWriter& writer, std::uint32_t photo, const LevelTexels& of);

/// The tile stage.
void make_tiles(LevelInput& in);
/// The thumbnail stage. The thumbnail is made from the coarsest level with enough detail, because that level
/// is the cheapest to reduce.
void make_thumbnail(LevelInput& in);

}  // namespace vantage

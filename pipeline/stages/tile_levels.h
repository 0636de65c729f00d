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
/// Quality of a level: its quantization is that of the photo's own JPEG (empty: none), halved per level,
/// because the mean of four pixels has half their error.
int level_quality(std::span<const std::byte> jpeg, std::uint32_t level);

/// Texels of 4 bytes each, row by row.
struct LevelTexels {
    std::span<const std::byte> texels;
    Level size;
};

/// Cuts a level into tiles and writes them to the package; compressed if the chunk is compact: opaque color
/// as JPEG, depth rounded, weight maps and other color without loss.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 const LevelTexels& of, int quality = color_quality);

/// A level of color as it is read after write_tiles(): rounded, if it is stored as JPEG. Results computed
/// from it then equal those computed later from the package.
RgbaImage as_stored(const PackageWriter& writer, std::uint32_t photo, std::uint32_t level,
                    const RgbaImage& image, int quality);

/// Writes the finest level of a photo with its JPEG's own coefficients. False if the chunk is not compact, or
/// the JPEG cannot be divided into tiles.
bool write_own_jpeg(PackageWriter& writer, std::uint32_t photo, std::span<const std::byte> jpeg);

/// Writes a photo's thumbnail: RGBA texels, which may be stored as JPEG.
void write_thumbnail(PackageWriter& writer, std::uint32_t photo, const LevelTexels& of);

/// The stage of tiles.
void make_tiles(LevelInput& in);
/// The stage of thumbnails, made from the coarsest level with enough detail, which is the cheapest to reduce.
void make_thumbnail(LevelInput& in);

}  // namespace vantage

#pragma once
#include <cstddef>
#include <cstdint>

namespace vantage {

/// Tiles are stored with their border, ready to upload as one layer of an array texture.
inline constexpr int tile_size = 256;                             ///< texels per side of a stored tile
inline constexpr int tile_border = 4;                             ///< texels repeated from the neighbors
inline constexpr int tile_content = tile_size - 2 * tile_border;  ///< texels without the border

/// Size in bytes of a stored tile of 4-byte texels (RGBA8 color, RGBA8 weight maps or R32F depth).
inline constexpr std::size_t tile_bytes = std::size_t(tile_size) * tile_size * 4;

/// One level of a pyramid. Level l is ceil(width / 2^l) by ceil(height / 2^l) texels, so that a full-size
/// pixel coordinate divided by 2^l is exact on every level, even if sizes are odd.
struct Level {
    int width = 0, height = 0;
    int columns() const { return (width + tile_content - 1) / tile_content; }
    int rows() const { return (height + tile_content - 1) / tile_content; }
    int tiles() const { return columns() * rows(); }
};

inline Level level_size(int width, int height, int level) {
    return {int((std::int64_t(width) + (1LL << level) - 1) >> level),
            int((std::int64_t(height) + (1LL << level) - 1) >> level)};
}

/// The part of a tile that lies within its level, in texels of the tile.
struct TilePart {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

/// The position of a tile's first texel in its level; negative in the border of the first tile.
inline int tile_left(const Level& level, std::size_t tile) {
    return int(tile % std::size_t(level.columns())) * tile_content - tile_border;
}
inline int tile_top(const Level& level, std::size_t tile) {
    return int(tile / std::size_t(level.columns())) * tile_content - tile_border;
}
inline TilePart inner_part(const Level& level, std::size_t tile) {
    const int x = tile_left(level, tile), y = tile_top(level, tile);
    return {x < 0 ? -x : 0, y < 0 ? -y : 0, level.width - x < tile_size ? level.width - x : tile_size,
            level.height - y < tile_size ? level.height - y : tile_size};
}

/// Number of levels, from full size to the first level that fits in one tile.
inline int level_count(int width, int height) {
    int n = 1;
    while (level_size(width, height, n - 1).tiles() > 1) ++n;
    return n;
}

/// Weight maps and depth are stored from this pyramid level (half size) to the coarsest.
inline constexpr int weight_map_level = 1;

/// One past the coarsest level at which a photo with `levels` levels has weight maps and depth.
inline int weight_map_levels_end(int levels) {
    return levels > weight_map_level ? levels : weight_map_level + 1;
}

}  // namespace vantage

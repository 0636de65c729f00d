#include "scene/package/contents/stored_tile.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "scene/codec/byte_planes.h"
#include "scene/codec/depth_values.h"
#include "scene/codec/jpeg_cells.h"
#include "scene/codec/jpeg_pixels.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
using package::Form;

constexpr std::size_t texel = 4;

/// Copies the packed texels of the inner part to the tile and repeats the edge of that part in the remaining
/// texels.
void place(std::span<const std::byte> packed, const TilePart& inner, std::span<std::byte> tile) {
    constexpr std::size_t row = texel * tile_size;
    const auto width = texel * std::size_t(inner.width());
    const auto repeat = [&](std::byte* to, const std::byte* from, int count) {
        for (int i = 0; i < count; ++i) std::memcpy(to + texel * std::size_t(i), from, texel);
    };
    for (int y = 0; y < inner.height(); ++y) {
        std::byte* to = &tile[row * std::size_t(inner.top + y)];
        std::byte* first = to + texel * std::size_t(inner.left);
        std::memcpy(first, &packed[width * std::size_t(y)], width);
        repeat(to, first, inner.left);
        repeat(first + width, first + width - texel, tile_size - inner.right);
    }
    for (int y = 0; y < inner.top; ++y)
        std::memcpy(&tile[row * std::size_t(y)], &tile[row * std::size_t(inner.top)], row);
    for (int y = inner.bottom; y < tile_size; ++y)
        std::memcpy(&tile[row * std::size_t(y)], &tile[row * std::size_t(inner.bottom - 1)], row);
}

/// The position of a tile's inner part in its level.
codec::PixelRect in_level(const Level& level, std::size_t tile) {
    const TilePart inner = inner_part(level, tile);
    const int x = tile_left(level, tile), y = tile_top(level, tile);
    return {x + inner.left, y + inner.top, x + inner.right, y + inner.bottom};
}

bool fits(const codec::CellGrid& grid, const Level& level, std::size_t blocks) {
    return grid.header.width == level.width && grid.header.height == level.height && grid.cells() == blocks;
}

bool decode_from_cells(const PackageReader& package, const DirectoryEntry& chunk, const Level& level,
                       std::size_t tile, std::span<std::byte> packed) {
    const auto header = package.shared(chunk);
    const auto grid = codec::cell_grid(header);
    if (!grid || !fits(*grid, level, package.blocks(chunk))) return false;
    const codec::PixelRect part = in_level(level, tile);
    for (const std::size_t cell : cells_of(*grid, part))
        if (!package.block_valid(chunk, cell)) return false;
    return decode_cells(
        header, *grid, part, [&](std::size_t cell) { return package.block(chunk, cell); }, packed);
}

bool decode_from_jpeg(std::span<const std::byte> shared, std::span<const std::byte> block, int width,
                      int height, std::span<std::byte> packed) {
    thread_local std::vector<std::byte> jpeg;
    const auto header = codec::parse_jpeg_header(shared);
    if (!header) return false;
    jpeg = codec::resized_header(shared, *header, width, height);
    jpeg.insert(jpeg.end(), block.begin(), block.end());
    return codec::decode_jpeg(jpeg, width, height, packed);
}

bool decode(const PackageReader& package, const DirectoryEntry& chunk, const Level& level, std::size_t tile,
            const TilePart& inner, std::span<std::byte> packed) {
    if (chunk.form == Form::cells)
        return package.head_valid(chunk) && decode_from_cells(package, chunk, level, tile, packed);
    if (!package.block_valid(chunk, tile)) return false;
    const auto block = package.block(chunk, tile);
    switch (chunk.form) {
        case Form::jpeg:
            return package.head_valid(chunk) &&
                   decode_from_jpeg(package.shared(chunk), block, inner.width(), inner.height(), packed);
        case Form::planes:
            return codec::decode_planes(block, inner.width(), inner.height(), packed);
        case Form::depth:
            return codec::decode_depth(block, inner.width(), inner.height(), packed);
        default:
            return false;
    }
}

}  // namespace

std::optional<std::vector<std::byte>> own_jpeg(const PackageReader& package, const DirectoryEntry& chunk) {
    if (!package.head_valid(chunk)) return {};
    for (std::size_t cell = 0; cell < package.blocks(chunk); ++cell)
        if (!package.block_valid(chunk, cell)) return {};
    return codec::joined_jpeg(package.shared(chunk),
                              [&](std::size_t cell) { return package.block(chunk, cell); });
}

bool holds_level(const PackageReader& package, const DirectoryEntry& chunk, const Level& level) {
    const std::size_t blocks = package.blocks(chunk), tiles = std::size_t(level.tiles());
    switch (chunk.form) {
        case Form::raw:
            return blocks == tiles && chunk.block_length == tile_bytes;
        case Form::jpeg:
        case Form::planes:
        case Form::depth:
            return blocks == tiles;
        case Form::cells: {
            // Reading a tile checks this as well, so heads are not fetched from a server for this check.
            if (package.remote()) return true;
            const auto grid = codec::cell_grid(package.shared(chunk));
            return grid && fits(*grid, level, blocks);
        }
        default:
            return false;
    }
}

namespace {

bool copy_or_decode(const PackageReader& package, const DirectoryEntry& chunk, const Level& level,
                    std::size_t tile, std::span<std::byte> to) {
    if (chunk.form == Form::raw) {
        if (!package.block_valid(chunk, tile)) return false;
        std::ranges::copy(package.block(chunk, tile), to.begin());
        return true;
    }
    thread_local std::vector<std::byte> packed(tile_bytes);
    const TilePart inner = inner_part(level, tile);
    if (!decode(package, chunk, level, tile, inner, packed)) return false;
    place(packed, inner, to);
    return true;
}

}  // namespace

Held hold_tiles(const PackageReader& package, std::span<const TilePlace> tiles, std::stop_token stop) {
    if (!package.remote()) return package.hold({});
    std::vector<std::span<const std::byte>> parts;
    for (const TilePlace& t : tiles) parts.push_back(package.head(*t.chunk));
    Held heads = package.hold(parts, stop);
    parts.clear();
    for (const TilePlace& t : tiles) {
        const auto pieces = stored_pieces(package, *t.chunk, t.level, t.tile);
        parts.insert(parts.end(), pieces.begin(), pieces.end());
    }
    Held blocks = package.hold(parts, std::move(stop));
    return std::make_shared<std::pair<Held, Held>>(std::move(heads), std::move(blocks));
}

bool read_tile(const PackageReader& package, const DirectoryEntry& chunk, const Level& level,
               std::size_t tile, std::span<std::byte> to, std::stop_token stop) {
    const TilePlace place{&chunk, level, tile};
    Held held = hold_tiles(package, {&place, 1}, stop);
    if (copy_or_decode(package, chunk, level, tile, to)) return true;
    if (!package.remote()) return false;
    auto parts = stored_pieces(package, chunk, level, tile);
    parts.push_back(package.head(chunk));
    package.discard(parts);
    held = hold_tiles(package, {&place, 1}, std::move(stop));
    return copy_or_decode(package, chunk, level, tile, to);
}

std::vector<std::span<const std::byte>> stored_pieces(const PackageReader& package,
                                                      const DirectoryEntry& chunk, const Level& level,
                                                      std::size_t tile) {
    if (chunk.form != Form::cells) return {package.block(chunk, tile)};
    std::vector<std::span<const std::byte>> out;
    if (const auto grid = codec::cell_grid(package.shared(chunk));
        grid && fits(*grid, level, package.blocks(chunk)))
        for (const std::size_t cell : cells_of(*grid, in_level(level, tile)))
            out.push_back(package.block(chunk, cell));
    return out;
}

namespace {

bool decode_thumbnail(const PackageReader& package, const DirectoryEntry& chunk,
                      const package::PhotoRecord& p, std::span<std::byte> to) {
    if (!package.head_valid(chunk)) return false;
    if (chunk.form == Form::jpeg)
        return package.blocks(chunk) == 1 && package.block_valid(chunk, 0) &&
               to.size() == texel * p.thumbnail_width * p.thumbnail_height &&
               decode_from_jpeg(package.shared(chunk), package.block(chunk, 0), int(p.thumbnail_width),
                                int(p.thumbnail_height), to);
    const auto content = package.bytes(&chunk);
    if (content.size() != to.size()) return false;
    std::ranges::copy(content, to.begin());
    return true;
}

}  // namespace

bool read_thumbnail(const PackageReader& package, std::uint32_t photo, std::span<std::byte> to) {
    const package::PhotoRecord& p = package.photos()[photo];
    const DirectoryEntry* chunk = package.find(package::Type::thumbnail, photo);
    if (!chunk) return false;
    const auto whole = package.raw(*chunk);
    const Held held = package.hold({&whole, 1});
    return decode_thumbnail(package, *chunk, p, to) ||
           (package.fetch_again(*chunk) && decode_thumbnail(package, *chunk, p, to));
}

std::string describe_damaged_tile(const PackageReader& package, const DirectoryEntry& chunk,
                                  const Level& level, std::size_t tile) {
    const bool valid = std::ranges::all_of(stored_pieces(package, chunk, level, tile),
                                           [&](const auto& piece) { return !piece.empty(); });
    return describe(chunk, package) + ": tile " + std::to_string(tile) + " of " +
           std::to_string(level.tiles()) + (valid ? ": checksum does not match" : ": is damaged");
}

}  // namespace vantage

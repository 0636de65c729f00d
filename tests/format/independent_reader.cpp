// independent_reader COMPACT RAW
//
// Reads two packages of one scene with code that was written only from scene/package/FORMAT.md and shares no
// code with the project. This proves that the document is sufficient. RAW is the output of `vantage repack
// COMPACT -o RAW --tiles raw`, so it must contain the decoded chunks of COMPACT byte for byte.

#include <algorithm>
#include <cstdint>
#include <exception>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "coded_forms.h"
#include "package_bytes.h"

using namespace independent;

namespace {

constexpr uint64_t tile_size = 256, own_size = 248, border = 4;

// The part of a tile that lies inside its level.
Area part_of(uint64_t tile, Size level) {
    const uint64_t columns = divided_up(level.w, own_size), x = tile % columns * own_size,
                   y = tile / columns * own_size;
    const uint64_t left = x - std::min(x, border), top = y - std::min(y, border);
    return {left, top, std::min(level.w, x + own_size + border) - left,
            std::min(level.h, y + own_size + border) - top};
}

Buffer decode_tile(const Entry& entry, const Chunk& chunk, Size level, uint64_t tile) {
    if (entry.form == 0) return Buffer(chunk.blocks[tile].begin(), chunk.blocks[tile].end());
    const uint64_t columns = divided_up(level.w, own_size), left = tile % columns * own_size,
                   top = tile / columns * own_size;
    const Area area = part_of(tile, level);
    std::map<uint64_t, Buffer> parts;
    Buffer texels;
    for (uint64_t i = 0; i < tile_size * tile_size; ++i) {
        // Texels outside the level repeat its edge. The border is subtracted last, so that no value becomes
        // negative.
        const uint64_t right = area.x + area.w - 1, bottom = area.y + area.h - 1;
        const uint64_t x = std::clamp(left + i % tile_size, area.x + border, right + border) - border;
        const uint64_t y = std::clamp(top + i / tile_size, area.y + border, bottom + border) - border;
        // Raw borders repeat the texels of the neighbors exactly. In form 2, they are therefore the
        // neighbors' texels and not those of the block.
        const uint64_t owner = entry.form == 2 ? y / own_size * columns + x / own_size : tile;
        const Area part = part_of(owner, level);
        if (!parts.contains(owner)) parts[owner] = decode_area(entry, chunk, level, owner, part);
        const uint8_t* from = &parts[owner][4 * ((y - part.y) * part.w + x - part.x)];
        texels.insert(texels.end(), from, from + 4);
    }
    return texels;
}

Size size_in_photo_record(Bytes photos, uint32_t photo, uint64_t offset) {
    const Bytes record = slice(photos, uint64_t{472} * photo, 472);
    const Size size = {number_at<uint32_t>(record, offset), number_at<uint32_t>(record, offset + 4)};
    require(size.w > 0 && size.h > 0, "a photo has no size");
    return size;
}

// ---- Comparison

struct Tally {
    uint64_t chunks = 0, compared = 0, different = 0;
};

void compare(Bytes a, Bytes b, Tally& tally) {
    require(a.size() == b.size(), "the lengths differ");
    ++tally.compared;
    for (size_t i = 0; i < a.size(); ++i) tally.different += a[i] != b[i];
}

void compare_thumbnail(const Entry& compact, const Entry& raw, Bytes photos, Tally& tally) {
    const Buffer expected = read_content(raw);
    if (compact.form == 0) return compare(read_content(compact), expected, tally);
    const Size size = size_in_photo_record(photos, compact.photo, 208);
    const Chunk chunk = open_chunk(compact);
    require(compact.form == 2 && chunk.blocks.size() == 1, "not one JPEG");
    require(expected.size() == 4 * size.w * size.h, "a raw thumbnail has the wrong size");
    compare(decode_jpeg_block(chunk.shared, chunk.blocks[0], {0, 0, size.w, size.h}), expected, tally);
}

void compare_tiles(const Entry& compact, const Entry& raw, Bytes photos, Tally& tally) {
    const Size photo = size_in_photo_record(photos, compact.photo, 192);
    require(compact.level < 32, "a level is too high");
    const uint64_t scale = uint64_t{1} << compact.level;
    const Size level = {divided_up(photo.w, scale), divided_up(photo.h, scale)};
    const uint64_t n = divided_up(level.w, own_size) * divided_up(level.h, own_size);
    const std::set<std::pair<std::string, uint32_t>> forms = {{"TILE", 0}, {"TILE", 2}, {"TILE", 3},
                                                              {"TILE", 4}, {"MASK", 0}, {"MASK", 4},
                                                              {"DPTH", 0}, {"DPTH", 5}};
    require(forms.contains({compact.type, compact.form}), "this type does not support this form");

    const Chunk chunk = open_chunk(compact), expected = open_chunk(raw);
    require(raw.form == 0 && expected.blocks.size() == n, "the numbers of raw blocks and tiles differ");
    require(compact.form == 3 || chunk.blocks.size() == n, "the numbers of blocks and tiles differ");
    for (const uint64_t tile : std::set<uint64_t>{0, n / 2, n - 1})
        compare(decode_tile(compact, chunk, level, tile), expected.blocks[tile], tally);
}

void compare_chunk(const Entry& compact, const Package& raw_package, Bytes photos, Tally& tally) {
    const Entry& raw = chunk_of(raw_package, compact.type, compact.photo, compact.level);
    ++tally.chunks;
    if (compact.form == 1) return compare(read_content(compact), read_content(raw), tally);
    if (compact.type == "THMB") return compare_thumbnail(compact, raw, photos, tally);
    compare_tiles(compact, raw, photos, tally);
}

std::map<uint32_t, Tally> compare_packages(const Package& compact, const Package& raw) {
    const Buffer photos = read_content(chunk_of(compact, "PHOT", UINT32_MAX, 0));
    std::map<uint32_t, Tally> tallies;  // by form
    for (const auto& [key, entry] : compact) {
        if (entry.form != 1 && !std::set<std::string>{"TILE", "MASK", "DPTH", "THMB"}.contains(entry.type))
            continue;
        try {
            compare_chunk(entry, raw, photos, tallies[entry.form]);
        } catch (const std::exception& error) {
            throw std::runtime_error(entry.type + " of photo " + std::to_string(entry.photo) + ", level " +
                                     std::to_string(entry.level) + ": " + error.what());
        }
    }
    return tallies;
}

}  // namespace

int main(int argc, char** argv) try {
    require(argc == 3, "usage: independent_reader COMPACT RAW");
    const Package compact = read_package(argv[1]), raw = read_package(argv[2]);
    std::map<uint32_t, Tally> tallies = compare_packages(compact, raw);
    for (const auto& [form, tally] : tallies)
        std::cout << "form " << form << ": " << tally.chunks << " chunks, " << tally.compared
                  << (form == 1 ? " contents" : " tiles") << " compared, " << tally.different
                  << " bytes differ\n";
    for (const auto& [form, tally] : tallies) require(tally.different == 0, "bytes differ");
    for (uint32_t form = 1; form <= 5; ++form)
        require(tallies[form].compared > 0, "form " + std::to_string(form) + " does not occur");
    return 0;
} catch (const std::exception& error) {
    std::cerr << "independent_reader: " << error.what() << '\n';
    return 1;
}

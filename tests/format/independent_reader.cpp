// independent_reader COMPACT RAW
//
// Reads two packages of one scene with nothing but what scene/package/FORMAT.md says, to prove that the text
// is sufficient: it shares no line with the project. RAW is COMPACT after `vantage repack COMPACT -o RAW
// --tiles raw`, so what the chunks of COMPACT decode to must be found there byte for byte.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csetjmp>
#include <cstdint>
#include <cstdio>  // before jpeglib.h, which lacks it
#include <exception>
#include <iostream>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "jpeglib.h"
#include "xxhash.h"
#include "zstd.h"

namespace {

using Bytes = std::span<const uint8_t>;
using Buffer = std::vector<uint8_t>;

constexpr uint64_t tile_size = 256, own_size = 248, border = 4;

void require(bool condition, const std::string& what) {
    if (!condition) throw std::runtime_error(what);
}

Bytes slice(Bytes bytes, uint64_t offset, uint64_t length) {
    require(offset <= bytes.size() && length <= bytes.size() - offset,
            "something extends outside what contains it");
    return bytes.subspan(offset, length);
}

template <typename T>
T number_at(Bytes bytes, uint64_t offset) {
    T value = 0;
    const Bytes field = slice(bytes, offset, sizeof(T));
    for (size_t i = 0; i < sizeof(T); ++i) value = static_cast<T>(value | T{field[i]} << 8 * i);
    return value;
}

uint64_t divided_up(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

uint64_t checksum(Bytes bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

// ---- Header, directory, chunks

struct Entry {
    std::string type;
    uint32_t version, photo, level, form, blocks;
    uint64_t head_length, block_length, checksum;
    Bytes bytes;
};

using Package = std::map<std::tuple<std::string, uint32_t, uint32_t>, Entry>;  // by type, photo, level

struct Chunk {
    Bytes head, shared;
    std::vector<Bytes> blocks;
};

// The file stays mapped until the program ends.
Bytes map_file(const char* path) {
    const int file = open(path, O_RDONLY);
    struct stat status = {};
    require(file >= 0 && fstat(file, &status) == 0 && status.st_size > 0, "cannot be read, or is empty");
    const auto size = static_cast<size_t>(status.st_size);
    const void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    close(file);
    require(data != MAP_FAILED, "cannot be mapped");
    return {static_cast<const uint8_t*>(data), size};
}

Entry read_entry(Bytes file, Bytes bytes) {
    const auto offset = number_at<uint64_t>(bytes, 16);
    const Entry entry = {.type = std::string(bytes.begin(), bytes.begin() + 4),
                         .version = number_at<uint32_t>(bytes, 4),
                         .photo = number_at<uint32_t>(bytes, 8),
                         .level = number_at<uint32_t>(bytes, 12),
                         .form = number_at<uint32_t>(bytes, 56),
                         .blocks = number_at<uint32_t>(bytes, 60),
                         .head_length = number_at<uint64_t>(bytes, 32),
                         .block_length = number_at<uint64_t>(bytes, 40),
                         .checksum = number_at<uint64_t>(bytes, 48),
                         .bytes = slice(file, offset, number_at<uint64_t>(bytes, 24))};
    const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    require(std::ranges::all_of(entry.type, letter), "a type is not of letters");
    require(offset % (entry.form == 0 ? 4096 : 8) == 0, "a chunk is not aligned");
    return entry;
}

Package read_package(const char* path) try {
    const Bytes file = map_file(path), header = slice(file, 0, 64);
    const std::string_view magic = "VANTAGE\n";
    require(std::equal(magic.begin(), magic.end(), header.begin()), "not a finished package");
    require(number_at<uint32_t>(header, 8) == 7, "not of version 7");
    require(number_at<uint64_t>(header, 56) == checksum(header.first(56)), "the header is damaged");
    require(number_at<uint64_t>(header, 24) == file.size(), "the file does not have its size");
    const Bytes directory =
        slice(file, number_at<uint64_t>(header, 16), uint64_t{64} * number_at<uint32_t>(header, 12));
    require(number_at<uint64_t>(header, 32) == checksum(directory), "the directory is damaged");
    Package package;
    for (size_t at = 0; at < directory.size(); at += 64) {
        const Entry entry = read_entry(file, directory.subspan(at, 64));
        package.try_emplace({entry.type, entry.photo, entry.level}, entry);
    }
    return package;
} catch (const std::exception& error) {
    throw std::runtime_error(std::string(path) + ": " + error.what());
}

const Entry& chunk_of(const Package& package, const std::string& type, uint32_t photo, uint32_t level) {
    const auto found = package.find({type, photo, level});
    require(found != package.end(), "there is no such chunk of type " + type);
    return found->second;
}

// Checks the checksums, too.
Chunk open_chunk(const Entry& entry) {
    require(entry.version == 1 && entry.form <= 5, "unknown version or form");
    Chunk chunk = {.head = slice(entry.bytes, 0, entry.head_length), .shared = {}, .blocks = {}};
    require(checksum(chunk.head) == entry.checksum, "the head is damaged");
    const Bytes behind = entry.bytes.subspan(entry.head_length);
    const bool raw_form = entry.form == 0;
    const uint64_t raw_blocks = entry.block_length > 0 ? behind.size() / entry.block_length : 0;
    const uint64_t n = raw_form ? raw_blocks : entry.blocks;
    const Bytes table = slice(chunk.head, 0, (raw_form ? 8 : 16) * n);
    uint64_t end = 0;
    for (uint64_t i = 0; i < n; ++i) {
        const uint64_t begin =
            std::exchange(end, raw_form ? end + entry.block_length : number_at<uint64_t>(table, 8 * (n + i)));
        require(begin <= end, "a block ends before it begins");
        chunk.blocks.push_back(slice(behind, begin, end - begin));
        require(number_at<uint64_t>(table, 8 * i) == checksum(chunk.blocks.back()), "a block is damaged");
    }
    require(end == behind.size(), "there are bytes that belong to no block");
    chunk.shared = chunk.head.subspan(table.size());
    return chunk;
}

Buffer unzip(Bytes bytes, uint64_t most, bool padded) {
    const size_t length = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
    require(!ZSTD_isError(length) && length <= bytes.size(), "not a zstd frame");
    const Bytes rest = bytes.subspan(length);
    require(std::ranges::count(rest, 0) == std::ssize(rest) && (padded || rest.empty()),
            "bytes follow a frame");
    Buffer content(most);
    const size_t written = ZSTD_decompress(content.data(), content.size(), bytes.data(), length);
    require(!ZSTD_isError(written), "a zstd frame is damaged or too long");
    content.resize(written);
    return content;
}

// Of a chunk without blocks.
Buffer read_content(const Entry& entry) {
    const Bytes head = open_chunk(entry).head;
    require(entry.form <= 1 && head.size() == entry.bytes.size(), "a chunk should have no blocks");
    if (entry.form == 0) return Buffer(head.begin(), head.end());
    const auto length = number_at<uint64_t>(head, 0);
    // Before memory is taken for it.
    require(length / 32 <= head.size(), "a content is too long for its chunk");
    Buffer content = unzip(head.subspan(8), length, true);
    require(content.size() == length, "a content does not have its length");
    return content;
}

// ---- JPEG

struct Size {
    uint64_t w, h;
};

struct Area {
    uint64_t x, y, w, h;
};

struct JpegHeader {
    size_t size_at = 0;  // of the height in SOF0, which the width follows
    Size size = {0, 0}, mcu = {8, 8};
    uint64_t interval = 0;
};

uint64_t read_big_endian(Bytes bytes, size_t offset) {
    const Bytes field = slice(bytes, offset, 2);
    return uint64_t{field[0]} << 8 | field[1];
}

void read_frame_header(Bytes bytes, size_t at, JpegHeader& header) {
    header.size_at = at + 5;
    header.size = {read_big_endian(bytes, at + 7), read_big_endian(bytes, at + 5)};
    const size_t components = slice(bytes, at + 9, 1)[0];
    if (components == 1) return;  // then an MCU is one block, whatever the sampling
    for (size_t i = 0; i < components; ++i) {
        const uint64_t sampling = slice(bytes, at + 10 + 3 * i, 3)[1];
        header.mcu = {std::max(header.mcu.w, 8 * (sampling >> 4)),
                      std::max(header.mcu.h, 8 * (sampling & 15))};
    }
}

JpegHeader read_jpeg_header(Bytes bytes) {
    JpegHeader header;
    uint64_t marker = 0;
    for (size_t at = 2; at < bytes.size();) {
        require(marker != 0xffda, "a JPEG's header does not end with its scan header");
        marker = read_big_endian(bytes, at);
        const uint64_t length = read_big_endian(bytes, at + 2);
        require(marker >= 0xff01 && length >= 2, "a JPEG's header is damaged");
        slice(bytes, at + 2, length);
        if (marker == 0xffc0) read_frame_header(bytes, at, header);
        if (marker == 0xffdd) header.interval = read_big_endian(bytes, at + 4);
        at += 2 + length;
    }
    require(header.size_at > 0 && marker == 0xffda, "a JPEG's header lacks something");
    return header;
}

Buffer with_size(Bytes shared, const JpegHeader& header, Size size) {
    require(size.w <= 65535 && size.h <= 65535, "too large for a JPEG");
    Buffer file(shared.begin(), shared.end());
    for (size_t i = 0; i < 4; ++i)
        file[header.size_at + i] = static_cast<uint8_t>((i < 2 ? size.h : size.w) >> (i % 2 == 0 ? 8 : 0));
    return file;
}

struct JpegDecoder {
    jpeg_decompress_struct info = {};
    jpeg_error_mgr errors = {};
    std::jmp_buf failed = {};
};

void fail(j_common_ptr info) { std::longjmp(static_cast<JpegDecoder*>(info->client_data)->failed, 1); }

void count_warning(j_common_ptr info, int level) { info->err->num_warnings += level < 0; }

// Owns nothing, because longjmp runs no destructors.
bool decode_rows(JpegDecoder& decoder, Bytes file, Size size, uint8_t* rgb) {
    jpeg_decompress_struct& info = decoder.info;
    if (setjmp(decoder.failed)) return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, file.data(), static_cast<unsigned long>(file.size()));
    jpeg_read_header(&info, TRUE);
    if (info.image_width != size.w || info.image_height != size.h) return false;
    info.out_color_space = JCS_RGB;
    info.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&info);
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = rgb + 3 * size.w * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return decoder.errors.num_warnings == 0;
}

// An area of a JPEG, as RGBA.
Buffer decode_jpeg(Bytes file, Size size, Area area) {
    require(area.x + area.w <= size.w && area.y + area.h <= size.h, "an area is outside its JPEG");
    Buffer rgb(3 * size.w * size.h);
    JpegDecoder decoder;
    decoder.info.err = jpeg_std_error(&decoder.errors);
    decoder.info.client_data = &decoder;
    decoder.errors.error_exit = fail;
    decoder.errors.emit_message = count_warning;
    const bool decoded = decode_rows(decoder, file, size, rgb.data());
    jpeg_destroy_decompress(&decoder.info);
    require(decoded, "a JPEG is damaged");

    Buffer rgba(4 * area.w * area.h, 255);
    for (uint64_t i = 0; i < area.w * area.h; ++i)
        std::copy_n(&rgb[3 * ((area.y + i / area.w) * size.w + area.x + i % area.w)], 3, &rgba[4 * i]);
    return rgba;
}

// ---- Forms 2 to 5: each gives the texels of an area, four bytes each

Buffer decode_jpeg_block(Bytes shared, Bytes block, Area area) {
    Buffer file = with_size(shared, read_jpeg_header(shared), {area.w, area.h});
    file.insert(file.end(), block.begin(), block.end());
    return decode_jpeg(file, {area.w, area.h}, {0, 0, area.w, area.h});
}

struct Cells {
    Size cell, count;         // in pixels, in cells
    uint64_t rows, mcu_rows;  // rows of MCUs in a cell, in the photo
};

Cells lay_out_cells(const JpegHeader& header, size_t blocks) {
    const uint64_t mcus = divided_up(header.size.w, header.mcu.w),
                   mcu_rows = divided_up(header.size.h, header.mcu.h);
    require(header.interval > 0 && mcus % header.interval == 0, "cells do not fill a row");
    const uint64_t rows = divided_up(128, header.mcu.h);
    const Cells cells = {.cell = {header.interval * header.mcu.w, rows * header.mcu.h},
                         .count = {mcus / header.interval, divided_up(mcu_rows, rows)},
                         .rows = rows,
                         .mcu_rows = mcu_rows};
    require(cells.count.w * cells.count.h == blocks, "there are not as many blocks as cells");
    return cells;
}

Bytes segment_of(const Cells& cells, const Chunk& chunk, uint64_t mcu_row, uint64_t column) {
    const uint64_t row = mcu_row / cells.rows, rows = std::min(cells.rows, cells.mcu_rows - row * cells.rows);
    const Bytes cell = chunk.blocks[row * cells.count.w + column];
    uint64_t at = 2 * rows;
    for (uint64_t i = 0; i < mcu_row % cells.rows; ++i) at += number_at<uint16_t>(cell, 2 * i);
    return slice(cell, at, number_at<uint16_t>(cell, 2 * (mcu_row % cells.rows)));
}

// The first and last of the units that a range touches, with a margin for the chroma to interpolate.
std::pair<uint64_t, uint64_t> touched(uint64_t begin, uint64_t length, uint64_t margin, uint64_t end,
                                      uint64_t unit) {
    return {(begin - std::min(begin, margin)) / unit, (std::min(begin + length + margin, end) - 1) / unit};
}

Buffer decode_cells(const Chunk& chunk, Size level, Area area) {
    const JpegHeader header = read_jpeg_header(chunk.shared);
    require(header.size.w == level.w && header.size.h == level.h,
            "a photo's JPEG does not have its level's size");
    const Cells cells = lay_out_cells(header, chunk.blocks.size());
    const auto [left, right] = touched(area.x, area.w, header.mcu.w / 4, level.w, cells.cell.w);
    const auto [top, bottom] = touched(area.y, area.h, header.mcu.h / 4, level.h, header.mcu.h);
    const uint64_t x = left * cells.cell.w, y = top * header.mcu.h;
    const Size window = {std::min((right + 1) * cells.cell.w, level.w) - x,
                         std::min((bottom + 1) * header.mcu.h, level.h) - y};

    Buffer file = with_size(chunk.shared, header, window);
    for (uint64_t row = top, i = 0; row <= bottom; ++row) {
        for (uint64_t column = left; column <= right; ++column, ++i) {
            const Bytes segment = segment_of(cells, chunk, row, column);
            file.insert(file.end(), segment.begin(), segment.end());
            file.insert(file.end(), {0xff, static_cast<uint8_t>(0xd0 + i % 8)});  // RST0 to RST7
        }
    }
    file.back() = 0xd9;  // EOI
    return decode_jpeg(file, window, {area.x - x, area.y - y, area.w, area.h});
}

int median(int a, int b, int c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

// Replaces folded differences by the values.
void unfold(std::vector<int>& values, uint64_t width, int modulus) {
    for (size_t i = 0; i < values.size(); ++i) {
        const bool has_left = i % width > 0, has_above = i >= width;
        const int a = has_left ? values[i - 1] : 0, b = has_above ? values[i - width] : 0;
        const int expected = has_left && has_above ? median(a, b, a + b - values[i - width - 1]) : a + b;
        const int difference = values[i] % 2 == 0 ? values[i] / 2 : -(values[i] + 1) / 2;
        values[i] = (expected + difference + modulus) % modulus;
    }
}

Buffer decode_planes(Bytes block, Area area) {
    const uint64_t n = area.w * area.h;
    const Buffer content = unzip(block, 4 + 4 * n, false);
    Buffer texels(4 * n);
    uint64_t at = 4;
    for (size_t channel = 0; channel < 4; ++channel) {
        const bool single = number_at<uint8_t>(content, channel) == 1;
        const Bytes plane = slice(content, at, single ? 1 : n);
        at += plane.size();
        std::vector<int> values(plane.begin(), plane.end());
        if (single)
            values.resize(n, plane[0]);
        else
            unfold(values, area.w, 256);
        for (size_t i = 0; i < n; ++i) texels[4 * i + channel] = static_cast<uint8_t>(values[i]);
    }
    require(at == content.size(), "bytes follow the planes");
    return texels;
}

Buffer decode_depth(Bytes block, Area area) {
    const uint64_t n = area.w * area.h;
    const Buffer content = unzip(block, 4 + 2 * n, false);
    require(content.size() == 4 + 2 * n, "there are not as many depths as texels");
    std::vector<int> values(n);
    for (size_t i = 0; i < n; ++i) values[i] = content[4 + i] | content[4 + n + i] << 8;
    unfold(values, area.w, 1 << 16);

    constexpr uint64_t infinity = 0x7f800;
    Buffer texels(4 * n);
    for (size_t i = 0; i < n; ++i) {
        const uint64_t q = values[i] == 0
                               ? infinity
                               : number_at<uint32_t>(content, 0) + static_cast<uint64_t>(values[i]) - 1;
        require(q <= infinity, "a depth is not a number");
        for (size_t k = 0; k < 4; ++k) texels[4 * i + k] = static_cast<uint8_t>(q << 12 >> 8 * k);
    }
    return texels;
}

Buffer decode_area(const Entry& entry, const Chunk& chunk, Size level, uint64_t tile, Area area) {
    if (entry.form == 2) return decode_jpeg_block(chunk.shared, chunk.blocks[tile], area);
    if (entry.form == 3) return decode_cells(chunk, level, area);
    return entry.form == 4 ? decode_planes(chunk.blocks[tile], area) : decode_depth(chunk.blocks[tile], area);
}

// ---- Tiles

// The part of a tile that lies in its level.
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
        // Texels outside the level repeat the edge. The border is subtracted last, so that nothing is
        // negative.
        const uint64_t right = area.x + area.w - 1, bottom = area.y + area.h - 1;
        const uint64_t x = std::clamp(left + i % tile_size, area.x + border, right + border) - border;
        const uint64_t y = std::clamp(top + i / tile_size, area.y + border, bottom + border) - border;
        // Raw borders repeat the neighbors exactly. In form 2 they are thus the neighbors' texels, not the
        // block's.
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
    require(expected.size() == 4 * size.w * size.h, "a raw thumbnail does not have its size");
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
    require(forms.contains({compact.type, compact.form}), "this type has no such form");

    const Chunk chunk = open_chunk(compact), expected = open_chunk(raw);
    require(raw.form == 0 && expected.blocks.size() == n, "there are not as many raw blocks as tiles");
    require(compact.form == 3 || chunk.blocks.size() == n, "there are not as many blocks as tiles");
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

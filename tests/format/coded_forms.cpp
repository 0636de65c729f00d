#include "coded_forms.h"

#include <algorithm>
#include <utility>

namespace independent {

Buffer decode_jpeg_block(Bytes shared, Bytes block, Area area) {
    Buffer file = with_size(shared, read_jpeg_header(shared), {area.w, area.h});
    file.insert(file.end(), block.begin(), block.end());
    return decode_jpeg(file, {area.w, area.h}, {0, 0, area.w, area.h});
}

namespace {

struct Cells {
    Size cell, count;         // in pixels; in cells
    uint64_t rows, mcu_rows;  // rows of MCUs in a cell; in the photo
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
    require(cells.count.w * cells.count.h == blocks, "the numbers of blocks and cells differ");
    return cells;
}

Bytes segment_of(const Cells& cells, const Chunk& chunk, uint64_t mcu_row, uint64_t column) {
    const uint64_t row = mcu_row / cells.rows, rows = std::min(cells.rows, cells.mcu_rows - row * cells.rows);
    const Bytes cell = chunk.blocks[row * cells.count.w + column];
    uint64_t at = 2 * rows;
    for (uint64_t i = 0; i < mcu_row % cells.rows; ++i) at += number_at<uint16_t>(cell, 2 * i);
    return slice(cell, at, number_at<uint16_t>(cell, 2 * (mcu_row % cells.rows)));
}

// The first and last unit touched by a range, with a margin for chroma interpolation.
std::pair<uint64_t, uint64_t> touched(uint64_t begin, uint64_t length, uint64_t margin, uint64_t end,
                                      uint64_t unit) {
    return {(begin - std::min(begin, margin)) / unit, (std::min(begin + length + margin, end) - 1) / unit};
}

Buffer decode_cells(const Chunk& chunk, Size level, Area area) {
    const JpegHeader header = read_jpeg_header(chunk.shared);
    require(header.size.w == level.w && header.size.h == level.h,
            "a photo's JPEG does not have the size of its level");
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

// Replaces folded differences with the values themselves.
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
    require(at == content.size(), "there are bytes after the planes");
    return texels;
}

Buffer decode_depth(Bytes block, Area area) {
    const uint64_t n = area.w * area.h;
    const Buffer content = unzip(block, 4 + 2 * n, false);
    require(content.size() == 4 + 2 * n, "the numbers of depths and texels differ");
    std::vector<int> values(n);
    for (size_t i = 0; i < n; ++i) values[i] = content[4 + i] | content[4 + n + i] << 8;
    unfold(values, area.w, 1 << 16);

    constexpr uint64_t infinity = 0x7f800;
    Buffer texels(4 * n);
    for (size_t i = 0; i < n; ++i) {
        const uint64_t q = values[i] == 0
                               ? infinity
                               : number_at<uint32_t>(content, 0) + static_cast<uint64_t>(values[i]) - 1;
        require(q <= infinity, "a depth is NaN");
        for (size_t k = 0; k < 4; ++k) texels[4 * i + k] = static_cast<uint8_t>(q << 12 >> 8 * k);
    }
    return texels;
}

}  // namespace

Buffer decode_area(const Entry& entry, const Chunk& chunk, Size level, uint64_t tile, Area area) {
    if (entry.form == 2) return decode_jpeg_block(chunk.shared, chunk.blocks[tile], area);
    if (entry.form == 3) return decode_cells(chunk, level, area);
    return entry.form == 4 ? decode_planes(chunk.blocks[tile], area) : decode_depth(chunk.blocks[tile], area);
}

}  // namespace independent

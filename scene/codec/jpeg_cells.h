#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "scene/codec/jpeg_header.h"

namespace vantage::codec {

/// The division of a photo's DCT coefficients into cells of `interval` MCUs by `band` MCU rows, so that parts
/// of the photo can be decoded independently. A cell holds the length of each of its MCU rows' entropy-coded
/// data, as a u16, and then the data of all rows. Each row starts as if after a restart marker. The grid
/// follows from the header, whose restart interval is the width of the cells.
struct CellGrid {
    JpegHeader header;
    int columns = 0, rows = 0;
    int band = 0;  ///< MCU rows in a cell; the last row of cells may have fewer

    int cell_width() const { return header.restart_interval * header.mcu_width; }
    std::size_t cells() const { return std::size_t(columns) * std::size_t(rows); }
};

/// The grid of a photo that is stored in cells; empty if `header` is not the header of such a photo.
std::optional<CellGrid> cell_grid(std::span<const std::byte> header);

/// A photo divided into cells, which are stored row by row; cell i ends at ends[i] in `bytes`.
struct JpegCells {
    std::vector<std::byte> header, bytes;
    std::vector<std::uint64_t> ends;

    std::span<const std::byte> cell(std::size_t i) const {
        const std::size_t from = i ? ends[i - 1] : 0;
        return std::span(bytes).subspan(from, ends[i] - from);
    }
};

/// Divides a JPEG without changing its coefficients. Empty if the JPEG is damaged or is neither 8-bit gray
/// nor 8-bit color with three channels.
std::optional<JpegCells> divide_jpeg(std::span<const std::byte> jpeg);

/// Joins the coefficients of all cells into a JPEG with the same pixels as the original. Empty if a cell is
/// damaged.
using CellAt = std::function<std::span<const std::byte>(std::size_t cell)>;
std::optional<std::vector<std::byte>> joined_jpeg(std::span<const std::byte> header, const CellAt& cell);

/// A part of a photo, in pixels.
struct PixelRect {
    int left, top, right, bottom;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

/// The cells needed to decode a part, row by row.
std::vector<std::size_t> cells_of(const CellGrid& grid, const PixelRect& part);

/// Decodes a part, which must lie within the photo, to width * height * 4 bytes. The pixels are identical to
/// those of the whole JPEG. Returns false if a cell is damaged.
bool decode_cells(std::span<const std::byte> header, const CellGrid& grid, const PixelRect& part,
                  const CellAt& cell, std::span<std::byte> rgba);

}  // namespace vantage::codec

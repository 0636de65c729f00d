#include "scene/codec/jpeg_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "scene/codec/jpeg_failure.h"
#include "scene/codec/jpeg_pixels.h"
#include "scene/codec/scan_division.h"

namespace vantage::codec {
namespace {

constexpr int wanted_width = 64, wanted_height = 128;  ///< approximate size of a cell in pixels
constexpr int max_interval = 16;  ///< in MCUs, so that a row of a cell fits into 65535 bytes

int divided_up(int a, int b) { return (a + b - 1) / b; }

/// The width of cells in MCUs: a divisor of the photo's width in MCUs, so that every row of MCUs begins with
/// a cell.
int interval_for(int mcus, int mcu_width) {
    int best = 1;
    const auto distance = [&](int n) { return std::abs(std::log(double(n * mcu_width) / wanted_width)); };
    for (int n = 1; n <= max_interval; ++n)
        if (mcus % n == 0 && distance(n) < distance(best)) best = n;
    return best;
}

struct Buffer {
    unsigned char* data = nullptr;
    unsigned long bytes = 0;
    Buffer() = default;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() { std::free(data); }
    std::span<const std::byte> span() const { return {reinterpret_cast<const std::byte*>(data), bytes}; }
};

bool can_divide(const jpeg_decompress_struct& from) {
    const J_COLOR_SPACE space = from.jpeg_color_space;
    return from.data_precision == 8 &&
           (from.num_components == 1 ? space == JCS_GRAYSCALE
                                     : from.num_components == 3 && (space == JCS_YCbCr || space == JCS_RGB));
}

unsigned restart_interval(const jpeg_decompress_struct& from) {
    const bool single = from.num_components == 1;
    const int width = single ? 8 : 8 * from.max_h_samp_factor;
    return unsigned(interval_for(divided_up(int(from.image_width), width), width));
}

/// Re-encodes the coefficients in one scan with restarts. Returns false if the JPEG is damaged or
/// unsupported. This function has no destructors to run, because libjpeg leaves it with longjmp on an error.
bool transcode(std::span<const std::byte> jpeg, Buffer& out) {
    jpeg_decompress_struct from{};
    jpeg_compress_struct to{};
    JpegFailure failure{};
    from.err = to.err = jumping_errors(failure);
    volatile bool done = false;
    if (setjmp(failure.jump) == 0) {
        jpeg_create_decompress(&from);
        jpeg_create_compress(&to);
        jpeg_mem_src(&from, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
        if (jpeg_read_header(&from, TRUE) == JPEG_HEADER_OK && can_divide(from)) {
            jvirt_barray_ptr* coefficients = jpeg_read_coefficients(&from);
            const bool valid = failure.errors.num_warnings == 0;  // later calls reset the count
            jpeg_copy_critical_parameters(&from, &to);
            to.optimize_coding = TRUE;
            to.restart_interval = restart_interval(from);
            jpeg_mem_dest(&to, &out.data, &out.bytes);
            jpeg_write_coefficients(&to, coefficients);
            jpeg_finish_compress(&to);
            jpeg_finish_decompress(&from);
            done = valid && failure.errors.num_warnings == 0;
        }
    }
    jpeg_destroy_compress(&to);
    jpeg_destroy_decompress(&from);
    return done;
}

/// The entropy-coded data between the scan's header and the end of the image, split at restart markers.
std::vector<std::span<const std::byte>> split_scan(std::span<const std::byte> scan) {
    std::vector<std::span<const std::byte>> out;
    std::size_t first = 0, at = 0;
    while (at + 1 < scan.size()) {
        const void* found = std::memchr(&scan[at], 0xff, scan.size() - at - 1);
        if (!found) break;
        at = std::size_t(static_cast<const std::byte*>(found) - scan.data());
        const int marker = std::to_integer<int>(scan[at + 1]);
        if (marker == 0) {
            at += 2;
            continue;
        }
        out.push_back(scan.subspan(first, at - first));
        if (marker < JPEG_RST0 || marker > JPEG_RST0 + 7) break;
        first = at += 2;
    }
    return out;
}

void append_word(std::vector<std::byte>& out, std::size_t value) {
    out.push_back(std::byte(value & 0xff));
    out.push_back(std::byte(value >> 8));
}

/// The number of MCU rows in the cells of row `row`.
int rows_in_cell(const CellGrid& g, int row) { return std::min(g.band, g.header.mcu_rows() - row * g.band); }

/// The MCU row `row` of a cell that has `rows` MCU rows; empty if the cell is damaged.
std::optional<std::span<const std::byte>> row_of_cell(std::span<const std::byte> cell, int rows, int row) {
    std::size_t at = 2 * std::size_t(rows), length = 0;
    if (cell.size() < at) return std::nullopt;
    for (int r = 0; r <= row; ++r) {
        at += length;
        length = std::to_integer<std::size_t>(cell[2 * std::size_t(r)]) |
                 std::to_integer<std::size_t>(cell[2 * std::size_t(r) + 1]) << 8;
    }
    if (at > cell.size() || length > cell.size() - at) return std::nullopt;
    return cell.subspan(at, length);
}

/// A half-open range of cell columns and a half-open range of MCU rows.
struct Window {
    int first_column, last_column, first_row, last_row;
};

Window whole(const CellGrid& g) { return {0, g.columns, 0, g.header.mcu_rows()}; }

/// The window needed to decode a part, including the neighbors from which its chroma is interpolated.
Window window_of(const CellGrid& g, const PixelRect& part) {
    const int beside = g.header.mcu_width / 4, above = g.header.mcu_height / 4;
    return {std::max(0, part.left - beside) / g.cell_width(),
            std::min(g.columns, divided_up(part.right + beside, g.cell_width())),
            std::max(0, part.top - above) / g.header.mcu_height,
            std::min(g.header.mcu_rows(), divided_up(part.bottom + above, g.header.mcu_height))};
}

PixelRect pixels_of(const CellGrid& g, const Window& w) {
    return {w.first_column * g.cell_width(), w.first_row * g.header.mcu_height,
            std::min(g.header.width, w.last_column * g.cell_width()),
            std::min(g.header.height, w.last_row * g.header.mcu_height)};
}

/// Assembles a JPEG from a window of cells.
bool assemble(std::span<const std::byte> header, const CellGrid& g, const Window& w, const CellAt& cell,
              std::vector<std::byte>& jpeg) {
    const PixelRect pixels = pixels_of(g, w);
    jpeg = resized_header(header, g.header, pixels.width(), pixels.height());
    unsigned restarts = 0;
    const auto marker = [&](unsigned code) { jpeg.insert(jpeg.end(), {std::byte(0xff), std::byte(code)}); };
    for (int y = w.first_row; y < w.last_row; ++y)
        for (int x = w.first_column; x < w.last_column; ++x) {
            const int row = y / g.band;
            const auto found =
                row_of_cell(cell(std::size_t(row * g.columns + x)), rows_in_cell(g, row), y % g.band);
            if (!found) return false;
            if (y > w.first_row || x > w.first_column) marker(unsigned(JPEG_RST0) + restarts++ % 8);
            jpeg.insert(jpeg.end(), found->begin(), found->end());
        }
    marker(JPEG_EOI);
    return true;
}

/// Puts segments, which come MCU row by MCU row, into cells. Empty if the segments do not match the header's
/// grid.
std::optional<JpegCells> in_cells(std::vector<std::byte> header,
                                  std::span<const std::span<const std::byte>> segments) {
    const auto grid = cell_grid(header);
    if (!grid) return std::nullopt;
    const auto columns = std::size_t(grid->columns);
    if (segments.size() != columns * std::size_t(grid->header.mcu_rows())) return std::nullopt;
    JpegCells out{std::move(header), {}, {}};
    for (int row = 0; row < grid->rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const auto segment = [&](int r) {
                return segments[std::size_t(row * grid->band + r) * columns + column];
            };
            const int rows = rows_in_cell(*grid, row);
            for (int r = 0; r < rows; ++r) {
                if (segment(r).size() > 0xffff) return std::nullopt;
                append_word(out.bytes, segment(r).size());
            }
            for (int r = 0; r < rows; ++r)
                out.bytes.insert(out.bytes.end(), segment(r).begin(), segment(r).end());
            out.ends.push_back(out.bytes.size());
        }
    return out;
}

/// The header of a baseline JPEG without its metadata, but with restarts and these tables.
std::vector<std::byte> plain_header(std::span<const std::byte> jpeg, const JpegHeader& header, int interval,
                                    std::span<const std::byte> tables) {
    constexpr int first_app = 0xe0, jfif = 0xe0, adobe = 0xee, last_app = 0xef, comment = 0xfe,
                  restarts = 0xdd;
    std::vector<std::byte> out(jpeg.begin(), jpeg.begin() + 2);
    for (const JpegSegment& s : segments_of(jpeg, header)) {
        // These two markers determine the color space.
        const bool kept =
            (s.marker == jfif && s.content.size() == 16) || (s.marker == adobe && s.content.size() == 14);
        if (s.at + 2 + s.content.size() == header.bytes) {
            out.insert(out.end(), tables.begin(), tables.end());
            for (const int b : {0xff, restarts, 0, 4, interval >> 8, interval & 0xff})
                out.push_back(std::byte(b));
        }
        if (!kept &&
            ((s.marker >= first_app && s.marker <= last_app) || s.marker == comment || s.marker == restarts))
            continue;
        out.insert(out.end(), {std::byte(0xff), std::byte(s.marker)});
        out.insert(out.end(), s.content.begin(), s.content.end());
    }
    return out;
}

std::optional<JpegCells> divide_codes(std::span<const std::byte> jpeg) {
    const auto header = parse_jpeg_header(jpeg);
    if (!header) return std::nullopt;
    const int interval = interval_for(header->mcu_columns(), header->mcu_width);
    const auto divided = divide_scan(jpeg, *header, interval);
    if (!divided) return std::nullopt;
    std::vector<std::span<const std::byte>> segments;
    for (std::size_t i = 0; i < divided->ends.size(); ++i) {
        const std::size_t first = i ? divided->ends[i - 1] : 0;
        segments.push_back(std::span(divided->bytes).subspan(first, divided->ends[i] - first));
    }
    return in_cells(plain_header(jpeg, *header, interval, divided->tables), segments);
}

/// Divides a JPEG with libjpeg, which supports every kind of JPEG.
std::optional<JpegCells> divide_coefficients(std::span<const std::byte> jpeg) {
    Buffer buffer;
    if (!transcode(jpeg, buffer)) return std::nullopt;
    const auto header = parse_jpeg_header(buffer.span());
    if (!header) return std::nullopt;
    const auto bytes = std::ptrdiff_t(header->bytes);
    return in_cells({buffer.span().begin(), buffer.span().begin() + bytes},
                    split_scan(buffer.span().subspan(header->bytes)));
}

}  // namespace

std::optional<CellGrid> cell_grid(std::span<const std::byte> bytes) {
    const auto header = parse_jpeg_header(bytes);
    if (!header || header->bytes != bytes.size() || header->restart_interval < 1 ||
        header->restart_interval > max_interval)
        return std::nullopt;
    CellGrid g{.header = *header, .band = divided_up(wanted_height, header->mcu_height)};
    if (header->mcu_columns() % header->restart_interval) return std::nullopt;
    g.columns = header->mcu_columns() / header->restart_interval;
    g.rows = divided_up(g.header.mcu_rows(), g.band);
    return g;
}

std::optional<JpegCells> divide_jpeg(std::span<const std::byte> jpeg) {
    auto cells = divide_codes(jpeg);
    return cells ? cells : divide_coefficients(jpeg);
}

std::optional<std::vector<std::byte>> joined_jpeg(std::span<const std::byte> header, const CellAt& cell) {
    const auto grid = cell_grid(header);
    std::vector<std::byte> jpeg;
    if (!grid || !assemble(header, *grid, whole(*grid), cell, jpeg)) return std::nullopt;
    return jpeg;
}

std::vector<std::size_t> cells_of(const CellGrid& g, const PixelRect& part) {
    const Window w = window_of(g, part);
    std::vector<std::size_t> out;
    for (int row = w.first_row / g.band; row <= (w.last_row - 1) / g.band; ++row)
        for (int column = w.first_column; column < w.last_column; ++column)
            out.push_back(std::size_t(row * g.columns + column));
    return out;
}

bool decode_cells(std::span<const std::byte> header, const CellGrid& g, const PixelRect& part,
                  const CellAt& cell, std::span<std::byte> rgba) {
    thread_local std::vector<std::byte> jpeg, decoded;
    const Window w = window_of(g, part);
    const PixelRect around = pixels_of(g, w);
    if (!assemble(header, g, w, cell, jpeg)) return false;
    decoded.resize(4 * std::size_t(around.width()) * std::size_t(around.height()));
    if (!decode_jpeg(jpeg, around.width(), around.height(), decoded)) return false;
    const auto width = 4 * std::size_t(part.width());
    for (int y = 0; y < part.height(); ++y) {
        const std::size_t row = std::size_t(part.top - around.top + y) * std::size_t(around.width());
        std::memcpy(&rgba[width * std::size_t(y)], &decoded[4 * (row + std::size_t(part.left - around.left))],
                    width);
    }
    return true;
}

}  // namespace vantage::codec

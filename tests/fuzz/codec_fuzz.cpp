// Decodes tiles and photos. An input is a byte that selects the decoder, the width and height, and the data.
// Checks that a divided JPEG can be reassembled. Pictures are small, because most of the time for large ones
// would be spent in code that does not depend on their content.
#include <turbojpeg.h>

#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "scene/codec/byte_planes.h"
#include "scene/codec/depth_values.h"
#include "scene/codec/jpeg_cells.h"
#include "scene/codec/jpeg_pixels.h"
#include "tests/fuzz/support/fuzz_target.h"

using namespace vantage::codec;

namespace {

constexpr int max_pixels = 4096;

bool small(int width, int height) { return std::int64_t(width) * height <= max_pixels; }

/// Decodes data whose header is followed by cells of equal length.
void decode_equal_cells(std::span<const std::byte> data, std::span<std::byte> out) {
    const auto header = parse_jpeg_header(data);
    if (!header) return;
    const auto grid = cell_grid(data.first(header->bytes));
    if (!grid || !small(header->width, header->height)) return;
    const auto cells = data.subspan(header->bytes);
    const std::size_t each = cells.size() / grid->cells();
    const PixelRect part{header->width / 3, header->height / 3, header->width, header->height};
    decode_cells(
        data.first(header->bytes), *grid, part,
        [&](std::size_t i) {
            if (i >= grid->cells()) std::abort();
            return cells.subspan(i * each, each);
        },
        out);
}

void divide_and_join(std::span<const std::byte> data) {
    static const tjhandle reader = tjInitDecompress();
    int width = 0, height = 0, sampling = 0, space = 0;
    if (tjDecompressHeader3(reader, reinterpret_cast<const unsigned char*>(data.data()), data.size(), &width,
                            &height, &sampling, &space) != 0 ||
        !small(width, height))
        return;
    const auto cells = divide_jpeg(data);
    if (!cells) return;
    if (!joined_jpeg(cells->header, [&](std::size_t i) { return cells->cell(i); })) std::abort();
}

}  // namespace

FUZZ_TARGET(codec)(const std::uint8_t* bytes, std::size_t size) {
    if (size < 3) return 0;
    const int width = 1 + bytes[1] % 64, height = 1 + bytes[2] % 64;
    const std::span<const std::byte> data(reinterpret_cast<const std::byte*>(bytes) + 3, size - 3);
    static std::vector<std::byte> out(4 * std::size_t(max_pixels));
    const std::span texels = std::span(out).first(std::size_t(width) * std::size_t(height) * 4);
    switch (bytes[0] % 5) {
        case 0:
            decode_planes(data, width, height, texels);
            break;
        case 1:
            decode_depth(data, width, height, texels);
            break;
        case 2:
            decode_jpeg(data, width, height, texels);
            break;
        case 3:
            decode_equal_cells(data, out);
            break;
        default:
            divide_and_join(data);
    }
    return 0;
}

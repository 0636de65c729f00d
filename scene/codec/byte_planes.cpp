#include "scene/codec/byte_planes.h"

#include <algorithm>

#include "scene/codec/median_prediction.h"
#include "scene/codec/zstd_bytes.h"

namespace vantage::codec {
namespace {

constexpr std::size_t planes = 4;

/// Appends the differences modulo 256, folded into bytes.
void append_plane(const Grid<const std::uint8_t>& plane, std::byte* out) {
    std::vector<std::int16_t> row(std::size_t(plane.width));
    for (int y = 0; y < plane.height; ++y) {
        differences_of_row(plane, y, row);
        for (const std::int16_t d : row) *out++ = std::byte(std::uint8_t(folded(std::int8_t(d))));
    }
}

}  // namespace

std::vector<std::byte> encode_planes(std::span<const std::byte> texels, int width, int height) {
    const std::size_t n = std::size_t(width) * std::size_t(height);
    std::vector<std::uint8_t> values(n);
    std::vector<std::byte> out(planes + planes * n);
    std::size_t at = planes;
    for (std::size_t p = 0; p < planes; ++p) {
        for (std::size_t i = 0; i < n; ++i) values[i] = std::to_integer<std::uint8_t>(texels[planes * i + p]);
        const bool one = std::ranges::all_of(values, [&](std::uint8_t v) { return v == values[0]; });
        out[p] = std::byte(one);
        if (one)
            out[at] = std::byte(values[0]);
        else
            append_plane({values.data(), width, height}, &out[at]);
        at += one ? 1 : n;
    }
    return compress(std::span(out).first(at), tile_effort);
}

bool decode_planes(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels) {
    const std::size_t n = std::size_t(width) * std::size_t(height);
    thread_local std::vector<std::byte> bytes;
    thread_local std::vector<std::uint8_t> values;
    bytes.resize(planes + planes * n);
    values.resize(n);
    const auto used = decompress_up_to(coded, bytes);
    if (!used || *used < planes) return false;
    std::size_t at = planes;
    for (std::size_t p = 0; p < planes; ++p) {
        const bool one = bytes[p] != std::byte(0);
        if (*used - at < (one ? 1 : n)) return false;
        if (one) {
            std::ranges::fill(values, std::to_integer<std::uint8_t>(bytes[at]));
        } else {
            const std::byte* from = &bytes[at];
            const Grid<std::uint8_t> plane{values.data(), width, height};
            predict_each(plane, [&](int expected) {
                return std::uint8_t(expected + unfolded(std::to_integer<std::uint32_t>(*from++)));
            });
        }
        at += one ? 1 : n;
        for (std::size_t i = 0; i < n; ++i) texels[planes * i + p] = std::byte(values[i]);
    }
    return at == *used;
}

}  // namespace vantage::codec

#include "scene/codec/depth_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/codec/median_prediction.h"
#include "scene/codec/zstd_bytes.h"

namespace vantage::codec {
namespace {

constexpr int dropped = 24 - depth_bits;  ///< dropped bits of a float's 24 significant bits (one is implicit)
constexpr std::uint32_t infinite = 0x7f800000u >> dropped;
constexpr std::uint32_t max_steps = 0xffff;

/// The stored bits of a positive, finite depth. They stand for a depth that is also positive and finite.
std::uint32_t kept_bits(float z) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(z);
    return std::clamp((bits + (1u << (dropped - 1))) >> dropped, 1u, infinite - 1);
}

float depth_of(std::uint32_t kept) { return std::bit_cast<float>(kept << dropped); }

/// Depths as numbers of steps, 0 for +inf. The steps are not valid if a value is not a depth or if the range
/// is too large.
struct Steps {
    std::uint32_t least = infinite;
    std::vector<std::uint16_t> values;
    bool valid = false;
};

Steps steps_of(std::span<const std::byte> texels, std::size_t n) {
    Steps out;
    std::vector<std::uint32_t> kept(n);
    std::uint32_t most = 0;
    for (std::size_t i = 0; i < n; ++i) {
        float z;
        std::memcpy(&z, &texels[4 * i], sizeof z);
        if (!(z > 0)) return out;
        kept[i] = std::isinf(z) ? infinite : kept_bits(z);
        if (kept[i] == infinite) continue;
        out.least = std::min(out.least, kept[i]);
        most = std::max(most, kept[i]);
    }
    if (out.least != infinite && most - out.least >= max_steps) return out;
    out.values.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        out.values[i] = kept[i] == infinite ? std::uint16_t(0) : std::uint16_t(kept[i] - out.least + 1);
    out.valid = true;
    return out;
}

}  // namespace

float kept_depth(float z) { return std::isinf(z) ? z : depth_of(kept_bits(z)); }

std::vector<std::byte> encode_depth(std::span<const std::byte> texels, int width, int height) {
    const std::size_t n = std::size_t(width) * std::size_t(height);
    Steps steps = steps_of(texels, n);
    if (!steps.valid) return {};
    std::vector<std::byte> out(4 + 2 * n);
    std::memcpy(out.data(), &steps.least, 4);
    std::byte* low = out.data() + 4;
    std::byte* high = low + n;
    const Grid<const std::uint16_t> values{steps.values.data(), width, height};
    std::vector<std::int16_t> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        differences_of_row(values, y, row);  // modulo 2^16, so that every difference fits
        for (const std::int16_t difference : row) {
            const std::uint32_t d = folded(difference);
            *low++ = std::byte(d & 0xff);
            *high++ = std::byte(d >> 8 & 0xff);
        }
    }
    return compress(out, tile_effort);
}

bool decode_depth(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels) {
    const std::size_t n = std::size_t(width) * std::size_t(height);
    thread_local std::vector<std::byte> bytes;
    thread_local std::vector<std::uint16_t> steps;
    bytes.resize(4 + 2 * n);
    steps.resize(n);
    if (!decompress(coded, bytes)) return false;
    std::uint32_t least;
    std::memcpy(&least, bytes.data(), sizeof least);
    if (least == 0 || least > infinite) return false;
    const std::byte* low = bytes.data() + 4;
    const std::byte* high = low + n;
    const Grid<std::uint16_t> values{steps.data(), width, height};
    predict_each(values, [&](int expected) {
        const std::uint32_t d =
            std::to_integer<std::uint32_t>(*low++) | std::to_integer<std::uint32_t>(*high++) << 8;
        return std::uint16_t(expected + unfolded(d));
    });
    for (std::size_t i = 0; i < n; ++i) {
        const float z = steps[i] ? depth_of(std::min(least + steps[i] - 1, infinite - 1))
                                 : std::numeric_limits<float>::infinity();
        std::memcpy(&texels[4 * i], &z, sizeof z);
    }
    return true;
}

}  // namespace vantage::codec

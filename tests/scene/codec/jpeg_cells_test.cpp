#include "scene/codec/jpeg_cells.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cmath>

#include "scene/codec/jpeg_header.h"
#include "scene/codec/jpeg_pixels.h"

using namespace vantage::codec;

namespace {

using Bytes = std::vector<std::byte>;

/// An image with gradients, edges and noise.
Bytes picture(int width, int height) {
    Bytes out;
    std::uint32_t state = 1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            state = state * 1664525 + 1013904223;
            const int noise = int(state >> 28), edge = (x / 37 + y / 23) % 2 ? 90 : 0;
            for (const int v :
                 {(x * 3 + noise) % 256, edge + noise, int(120 + 100 * std::sin(x * .1 + y * .03)), 255})
                out.push_back(std::byte(std::clamp(v, 0, 255)));
        }
    return out;
}

struct Kind {
    int sampling, flags;
};

Bytes jpeg_of(int width, int height, const Kind& kind, int quality) {
    tjhandle coder = tjInitCompress();
    unsigned char* to = nullptr;
    unsigned long n = 0;
    const Bytes rgba = picture(width, height);
    EXPECT_EQ(tjCompress2(coder, reinterpret_cast<const unsigned char*>(rgba.data()), width, 0, height,
                          TJPF_RGBA, &to, &n, kind.sampling, quality, kind.flags),
              0);
    const auto* first = reinterpret_cast<const std::byte*>(to);
    Bytes out(first, first + n);
    tjFree(to);
    tjDestroy(coder);
    return out;
}

CellAt cells_in(const JpegCells& cells) {
    return [&cells](std::size_t i) { return cells.cell(i); };
}

Bytes decoded(std::span<const std::byte> jpeg, int width, int height) {
    Bytes out(std::size_t(width) * std::size_t(height) * 4);
    EXPECT_TRUE(decode_jpeg(jpeg, width, height, out));
    return out;
}

/// A rectangle from a decoded photo, row by row.
Bytes cut(const Bytes& whole, int width, const PixelRect& part) {
    Bytes out;
    for (int y = part.top; y < part.bottom; ++y) {
        const auto row = whole.begin() + 4 * (std::ptrdiff_t(y) * width + part.left);
        out.insert(out.end(), row, row + 4 * part.width());
    }
    return out;
}

}  // namespace

TEST(JpegCells, EveryPartHasThePixelsOfTheWholePhoto) {
    const Kind kinds[] = {{TJSAMP_420, 0},
                          {TJSAMP_422, 0},
                          {TJSAMP_444, 0},
                          {TJSAMP_440, 0},
                          {TJSAMP_411, 0},
                          {TJSAMP_GRAY, 0},
                          {TJSAMP_420, TJFLAG_PROGRESSIVE}};
    // The widths in MCUs include a composite number, a prime number, and a value less than one.
    const std::pair<int, int> sizes[] = {{320, 300}, {497, 263}, {5, 3}, {1072, 40}};
    for (const Kind& kind : kinds)
        for (const auto& [width, height] : sizes) {
            const Bytes jpeg = jpeg_of(width, height, kind, 90);
            const auto cells = divide_jpeg(jpeg);
            ASSERT_TRUE(cells) << kind.sampling << " " << width;
            const auto grid = cell_grid(cells->header);
            ASSERT_TRUE(grid);
            const Bytes whole = decoded(jpeg, width, height);
            for (int top = 0; top < height; top += 61)
                for (int left = 0; left < width; left += 83) {
                    const PixelRect part{left, top, std::min(width, left + 131), std::min(height, top + 97)};
                    Bytes pixels(std::size_t(part.width()) * std::size_t(part.height()) * 4);
                    ASSERT_TRUE(decode_cells(cells->header, *grid, part, cells_in(*cells), pixels));
                    EXPECT_EQ(pixels, cut(whole, width, part))
                        << kind.sampling << " at " << left << ", " << top;
                }
        }
}

TEST(JpegCells, JoinedTheyAreThePhotoAgain) {
    for (const int quality : {5, 75, 100}) {
        const Bytes jpeg = jpeg_of(497, 263, {TJSAMP_420, 0}, quality);
        const auto cells = divide_jpeg(jpeg);
        ASSERT_TRUE(cells);
        const auto joined = joined_jpeg(cells->header, cells_in(*cells));
        ASSERT_TRUE(joined);
        EXPECT_EQ(decoded(*joined, 497, 263), decoded(jpeg, 497, 263));
    }
}

TEST(JpegCells, TakeHardlyMoreSpaceThanThePhoto) {
    const Bytes jpeg = jpeg_of(1072, 800, {TJSAMP_420, 0}, 92);
    const auto cells = divide_jpeg(jpeg);
    ASSERT_TRUE(cells);
    EXPECT_LT(double(cells->bytes.size()), 1.05 * double(jpeg.size()));
}

TEST(JpegCells, NeedOnlyTheCellsTheyName) {
    const auto cells = divide_jpeg(jpeg_of(640, 640, {TJSAMP_420, 0}, 80));
    ASSERT_TRUE(cells);
    const auto grid = cell_grid(cells->header);
    const PixelRect part{200, 300, 330, 420};
    const auto needed = cells_of(*grid, part);
    EXPECT_LT(needed.size(), grid->cells() / 2);
    Bytes pixels(std::size_t(part.width()) * std::size_t(part.height()) * 4);
    const CellAt all = cells_in(*cells);
    EXPECT_TRUE(decode_cells(
        cells->header, *grid, part,
        [&](std::size_t i) {
            EXPECT_TRUE(std::ranges::count(needed, i)) << i;
            return all(i);
        },
        pixels));
}

TEST(JpegCells, WhatIsNoWholeJpegIsNotDivided) {
    const Bytes jpeg = jpeg_of(320, 200, {TJSAMP_420, 0}, 80);
    EXPECT_FALSE(divide_jpeg({}));
    EXPECT_FALSE(divide_jpeg(std::span(jpeg).first(300)));
    EXPECT_FALSE(divide_jpeg(std::span(jpeg).first(jpeg.size() / 2)));
    EXPECT_FALSE(divide_jpeg(picture(20, 20)));
}

TEST(JpegCells, AnMcuOfTooManyBlocksIsRefused) {
    Bytes jpeg = jpeg_of(320, 200, {TJSAMP_444, 0}, 100);
    const auto header = parse_jpeg_header(jpeg);
    ASSERT_TRUE(header);
    for (std::size_t c = 0; c < 3; ++c) jpeg[header->frame_at + 11 + 3 * c] = std::byte(0x44);
    EXPECT_FALSE(divide_jpeg(jpeg));
}

TEST(JpegCells, DamagedBytesAreRefusedOrDecodedButDoNoHarm) {
    const auto cells = divide_jpeg(jpeg_of(320, 200, {TJSAMP_420, 0}, 80));
    ASSERT_TRUE(cells);
    const PixelRect part{0, 0, 256, 200};
    Bytes pixels(256 * 200 * 4);
    for (std::size_t at = 0; at < cells->header.size() + cells->bytes.size(); at += 7) {
        JpegCells damaged = *cells;
        (at < cells->header.size() ? damaged.header[at] : damaged.bytes[at - cells->header.size()]) ^=
            std::byte(0x5a);
        const auto grid = cell_grid(damaged.header);
        if (!grid || grid->header.width != 320 || grid->header.height != 200 ||
            grid->cells() != cells->ends.size())
            continue;
        decode_cells(damaged.header, *grid, part, cells_in(damaged), pixels);
    }
}

TEST(JpegHeader, TellsHowCoarselyLuminanceIsRounded) {
    for (const int quality : {40, 60, 75, 88, 95})
        for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
            const double scale = quality < 50 ? 50.0 / quality : 2 - quality / 50.0;
            EXPECT_NEAR(quantization_of(jpeg_of(64, 48, {TJSAMP_420, flags}, quality)), scale,
                        0.01 + 0.01 * scale)
                << quality;
        }
    EXPECT_EQ(quantization_of({}), 0);
    const Bytes jpeg = jpeg_of(64, 48, {TJSAMP_420, 0}, 88);
    for (std::size_t n = 0; n < 200; ++n) {  // cut short
        const double found = quantization_of(std::span(jpeg).first(n));
        EXPECT_TRUE(found == 0 || std::abs(found - 0.24) < 0.01) << n;
    }
}

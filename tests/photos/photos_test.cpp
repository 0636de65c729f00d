// Photos of every supported format are decoded to RGBA.
#include "pipeline/photos/photos.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <turbojpeg.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "base/text/error.h"
#include "pipeline/input/file_identity.h"
#include "pipeline/photos/image_files.h"
#include "tests/image_file.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Photos : public TemporaryFolder {
  protected:
    /// Writes `width` x `height` copies of `pixel`, except that the first pixel is zero.
    template <class T>
    fs::path write(const char* name, int width, int height, std::initializer_list<T> pixel,
                   int orientation = 1) {
        OIIO::ImageSpec spec(width, height, int(pixel.size()), OIIO::BaseTypeFromC<T>::value);
        spec.attribute("Orientation", orientation);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        std::vector<T> pixels;
        for (int i = 0; i < width * height; ++i) pixels.insert(pixels.end(), pixel.begin(), pixel.end());
        std::fill_n(pixels.begin(), pixel.size(), T(0));
        const fs::path file = dir / name;
        EXPECT_TRUE(write_image_file(file, spec, OIIO::BaseTypeFromC<T>::value, pixels.data()));
        return file;
    }
};

/// Writes a camera raw file (DNG) from a sensor with a Bayer pattern. It has a single color, which is given
/// in linear sRGB.
void write_dng(const fs::path& file, int width, int height, const std::array<double, 3>& light) {
    constexpr float black = 256, white = 16383;
    // The matrix from XYZ to the colors of the sensor, whose primaries are those of sRGB.
    const std::array<float, 9> matrix{3.2404542f, -1.5371385f, -0.4985314f, -0.9692660f, 1.8760108f,
                                      0.0415560f, 0.0556434f,  -0.2040259f, 1.0572252f};
    TIFF* dng = TIFFOpen(file.c_str(), "w");
    const auto set = [&](std::uint32_t tag, const auto& values) {
        if (TIFFFieldPassCount(TIFFFieldWithTag(dng, tag)))
            TIFFSetField(dng, tag, int(std::size(values)), std::data(values));
        else
            TIFFSetField(dng, tag, std::data(values));
    };
    for (const auto& [tag, value] : {std::pair(TIFFTAG_IMAGEWIDTH, width),
                                     {TIFFTAG_IMAGELENGTH, height},
                                     {TIFFTAG_ROWSPERSTRIP, height},
                                     {TIFFTAG_BITSPERSAMPLE, 16},
                                     {TIFFTAG_SAMPLESPERPIXEL, 1},
                                     {TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_CFA},
                                     {TIFFTAG_COMPRESSION, COMPRESSION_NONE},
                                     {TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG},
                                     {TIFFTAG_CALIBRATIONILLUMINANT1, 21}})  // D65
        TIFFSetField(dng, std::uint32_t(tag), value);
    for (const auto& [tag, name] : {std::pair(TIFFTAG_MAKE, "Maker"),
                                    {TIFFTAG_MODEL, "Camera"},
                                    {TIFFTAG_UNIQUECAMERAMODEL, "Maker Camera"}})
        TIFFSetField(dng, std::uint32_t(tag), name);
    const std::array<std::uint8_t, 4> filters{0, 1, 1, 2};
    set(TIFFTAG_DNGVERSION, std::array<std::uint8_t, 4>{1, 4, 0, 0});
    set(TIFFTAG_CFAREPEATPATTERNDIM, std::array<std::uint16_t, 2>{2, 2});
    set(TIFFTAG_CFAPATTERN, filters);
    set(TIFFTAG_BLACKLEVEL, std::array{black});
    set(TIFFTAG_WHITELEVEL, std::array{std::uint32_t(white)});
    set(TIFFTAG_COLORMATRIX1, matrix);
    set(TIFFTAG_ASSHOTNEUTRAL, std::array{1.0f, 1.0f, 1.0f});
    std::vector<std::uint16_t> row(std::size_t(width), 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            row[std::size_t(x)] = std::uint16_t(
                black + float(light[filters[std::size_t(2 * (y % 2) + x % 2)]]) * (white - black));
        TIFFWriteScanline(dng, row.data(), std::uint32_t(y), 0);
    }
    TIFFClose(dng);
}

using Pixel = std::array<int, 4>;

Pixel pixel(const RgbaImage& p, int x, int y) {
    const std::uint8_t* at = p.rgba.data() + (std::size_t(y) * std::size_t(p.width) + std::size_t(x)) * 4;
    return {at[0], at[1], at[2], at[3]};
}

}  // namespace

TEST_F(Photos, GraySixteenBitsAndAlpha) {
    using u8 = std::uint8_t;
    using u16 = std::uint16_t;
    const PhotoSize size{3, 2};
    EXPECT_EQ(pixel(read_photo(write<u8>("g.png", 3, 2, {100}), size), 2, 1), (Pixel{100, 100, 100, 255}));
    EXPECT_EQ(pixel(read_photo(write<u16>("s.png", 3, 2, {51400, 25700, 257}), size), 2, 1),
              (Pixel{200, 100, 1, 255}));
    EXPECT_EQ(pixel(read_photo(write<u8>("a.png", 3, 2, {200, 100, 50, 128}), size), 2, 1),
              (Pixel{200, 100, 50, 128}));
    EXPECT_EQ(pixel(read_photo(write<u8>("ga.png", 3, 2, {90, 60}), size), 2, 1), (Pixel{90, 90, 90, 60}));
    EXPECT_EQ(pixel(read_photo(write<u8>("t.tif", 3, 2, {9, 8, 7}), size), 2, 1), (Pixel{9, 8, 7, 255}));
}

/// Writes a TIFF with one strip or tile of 16 x 16 pixels. All its samples have the value `sample`.
void write_tiff(const fs::path& file, std::initializer_list<std::pair<int, int>> tags, int samples,
                std::uint16_t sample, bool tiled = false) {
    TIFF* tiff = TIFFOpen(file.c_str(), "w");
    constexpr std::uint16_t unspecified = EXTRASAMPLE_UNSPECIFIED;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 16);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, samples);
    for (const auto& [tag, value] : tags) TIFFSetField(tiff, std::uint32_t(tag), value);
    if (samples == 4 && !tiled) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &unspecified);
    if (tiled) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 16);
    }
    std::vector<std::uint16_t> pixels(std::size_t(16 * 16 * samples), sample);
    const auto bytes = tmsize_t(pixels.size() * 2);
    EXPECT_EQ(tiled ? TIFFWriteEncodedTile(tiff, 0, pixels.data(), bytes)
                    : TIFFWriteEncodedStrip(tiff, 0, pixels.data(), bytes),
              bytes);
    TIFFClose(tiff);
}

TEST_F(Photos, ManyThreadsMayReadOneFile) {
    const fs::path file = write<std::uint8_t>("a.png", 4, 4, {200, 100, 50});
    const RgbaImage alone = read_photo(file, {4, 4});
    std::vector<std::jthread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&] {
            for (int n = 0; n < 3000; ++n) ASSERT_TRUE(read_photo(file, {4, 4}).rgba == alone.rgba);
        });
}

TEST_F(Photos, TiffsMayCountFromWhiteOrHaveOtherChannels) {
    const fs::path file = dir / "t.tif";
    write_tiff(file, {{TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE}}, 1, 0x3fff);
    EXPECT_EQ(pixel(read_photo(file, {16, 16}), 1, 1), (Pixel{191, 191, 191, 255}));
    write_tiff(file, {{TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB}}, 4, 0x4040);
    EXPECT_EQ(pixel(read_photo(file, {16, 16}), 1, 1), (Pixel{64, 64, 64, 255})) << "near infrared";
}

TEST_F(Photos, LinearPngIsConvertedToSrgb) {
    OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "Linear");
    const std::vector<std::uint8_t> pixels(12, 55);
    ASSERT_TRUE(write_image_file(dir / "l.png", spec, OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_TRUE(read_photo_header(dir / "l.png").linear);
    EXPECT_NEAR(pixel(read_photo(dir / "l.png", {2, 2}), 1, 1)[0], 128, 1);
}

TEST_F(Photos, TiffsThatWouldBeReadWronglyAreRejected) {
    const auto flaw = [&] {
        try {
            read_photo_header(dir / "t.tif");
        } catch (const Error& e) {
            return reason_of(e, dir / "t.tif");
        }
        return std::string();
    };
    write_tiff(dir / "t.tif", {{TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_SEPARATED}}, 4, 0x4040, true);
    EXPECT_EQ(flaw(), "its CMYK colors are in tiles, expected strips, or RGB");
    // The directory comes first, as in the files of some programs, and some pixels are missing.
    std::string bytes("II*\0\x08\0\0\0\x09\0", 10);
    const auto entry = [&](int tag, std::uint32_t value) {
        for (const std::uint32_t word : {std::uint32_t(tag) | 4u << 16, 1u, value})
            for (int shift = 0; shift < 32; shift += 8) bytes += char(word >> shift & 0xff);
    };
    entry(TIFFTAG_IMAGEWIDTH, 16), entry(TIFFTAG_IMAGELENGTH, 16), entry(TIFFTAG_BITSPERSAMPLE, 8);
    entry(TIFFTAG_COMPRESSION, COMPRESSION_NONE), entry(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    entry(TIFFTAG_STRIPOFFSETS, 122), entry(TIFFTAG_SAMPLESPERPIXEL, 1), entry(TIFFTAG_ROWSPERSTRIP, 16);
    entry(TIFFTAG_STRIPBYTECOUNTS, 256);
    bytes.append(4, '\0');
    std::ofstream(dir / "t.tif", std::ios::binary) << bytes << std::string(256, 'x');
    EXPECT_EQ(flaw(), "");
    std::ofstream(dir / "t.tif", std::ios::binary) << bytes << std::string(250, 'x');
    EXPECT_EQ(flaw(), "is cut off: the file ends before its pixels");
}

TEST_F(Photos, AdobeCmykIsInverted) {
    // Adobe stores CMYK inverted, so that 255 means no ink.
    const std::vector<unsigned char> cmyk{255, 128, 0, 255, 255, 128, 0, 255};
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const tjhandle encoder = tjInitCompress();
    ASSERT_EQ(tjCompress2(encoder, cmyk.data(), 2, 0, 1, TJPF_CMYK, &bytes, &size, TJSAMP_444, 100, 0), 0);
    std::ofstream(dir / "c.jpg", std::ios::binary)
        .write(reinterpret_cast<char*>(bytes), std::streamsize(size));
    tjFree(bytes);
    tjDestroy(encoder);
    const Pixel p = pixel(read_photo(dir / "c.jpg", {2, 1}), 1, 0);
    EXPECT_NEAR(p[0], 255, 2);
    EXPECT_NEAR(p[1], 128, 2);
    EXPECT_NEAR(p[2], 0, 2);
    EXPECT_EQ(p[3], 255);
}

TEST_F(Photos, CameraRawIsDevelopedToSrgb) {
    const std::array<double, 3> light{0.2, 0.4, 0.1};
    write_dng(dir / "r.dng", 64, 48, light);
    const PhotoHeader header = read_photo_header(dir / "r.dng");
    EXPECT_EQ(header.size.width, 64);
    EXPECT_EQ(header.size.height, 48);
    EXPECT_FALSE(header.linear);
    const Pixel p = pixel(read_photo(dir / "r.dng", {64, 48}), 32, 24);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(p[c], 255 * (1.055 * std::pow(light[c], 1 / 2.4) - 0.055), 1);
    EXPECT_EQ(p[3], 255);
}

TEST_F(Photos, AreRotatedOnlyIfTheCameraExpectsIt) {
    // The positions of the first stored pixel in EXIF orientations 5 to 8.
    const std::pair<int, std::array<int, 2>> where[] = {{5, {0, 0}}, {6, {1, 0}}, {7, {1, 2}}, {8, {0, 2}}};
    for (const auto& [orientation, at] : where) {
        const fs::path file = write<std::uint8_t>("o.tif", 3, 2, {200, 200, 200}, orientation);
        EXPECT_EQ(pixel(read_photo(file, {3, 2}), 0, 0)[0], 0) << "as stored";
        const RgbaImage turned = read_photo(file, {2, 3});
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x)
                EXPECT_EQ(pixel(turned, x, y)[0], x == at[0] && y == at[1] ? 0 : 200)
                    << orientation << " " << x << y;
    }
}

TEST_F(Photos, WrongSizeTruncatedOrBrokenAreRejected) {
    const fs::path png = write<std::uint8_t>("p.png", 40, 30, {1, 2, 3});
    EXPECT_THROW(read_photo(png, {41, 30}), Error);
    const fs::path jpeg = write<std::uint8_t>("j.jpg", 40, 30, {100, 150, 200});
    EXPECT_NO_THROW(read_photo(jpeg, {40, 30}));
    for (const fs::path& file : {png, jpeg}) {
        fs::resize_file(file, fs::file_size(file) / 2);
        EXPECT_THROW(read_photo(file, {40, 30}), Error) << file;
    }
    std::ofstream(dir / "x.jpg") << "no photo";
    EXPECT_THROW(read_photo(dir / "x.jpg", {1, 1}), Error);
    EXPECT_THROW(read_photo_header(dir / "x.jpg"), Error);
    EXPECT_THROW(read_photo(dir / "none.jpg", {1, 1}), Error);
}

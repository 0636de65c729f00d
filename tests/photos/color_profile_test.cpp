// Photos with color profiles, checked against the equations of their color spaces.
#include "pipeline/photos/color_profile.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <libheif/heif.h>

#include <cmath>

#include "pipeline/photos/photos.h"
#include "tests/icc_profile.h"
#include "tests/photos/stored_colors.h"

using namespace vantage;
using namespace vantage::stored_colors;

namespace {

/// Returns false if no encoder is installed.
bool write_heic(const fs::path& file, const std::vector<std::uint8_t>& rgb, const std::string& icc) {
    heif_context* context = heif_context_alloc();
    heif_encoder* encoder = nullptr;
    const bool encodes =
        heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder).code == heif_error_Ok;
    if (encodes) {
        heif_image* image = nullptr;
        heif_image_create(side, side, heif_colorspace_RGB, heif_chroma_interleaved_RGB, &image);
        heif_image_add_plane(image, heif_channel_interleaved, side, side, 8);
        int stride = 0;
        std::uint8_t* to = heif_image_get_plane(image, heif_channel_interleaved, &stride);
        for (int y = 0; y < side; ++y)
            std::copy_n(&rgb[std::size_t(3 * side * y)], 3 * side, to + y * stride);
        heif_image_set_raw_color_profile(image, "prof", icc.data(), icc.size());
        heif_image_handle* handle = nullptr;
        heif_context_encode_image(context, image, encoder, nullptr, &handle);
        heif_context_write_to_file(context, file.c_str());
        heif_image_handle_release(handle);
        heif_image_release(image);
        heif_encoder_release(encoder);
    }
    heif_context_free(context);
    return encodes;
}

/// The largest difference between a photo's bytes and the colors that were written.
template <class T>
double error_of(const RgbaImage& photo, const RgbSpace& space, const std::vector<T>& stored, int channels) {
    double most = 0;
    for (std::size_t i = 0; i < std::size_t(side) * side; ++i) {
        const T* s = &stored[i * std::size_t(channels)];
        const Eigen::Vector3d light = srgb_light(space, Eigen::Vector3d(s[0], s[1], s[2]) / top<T>);
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(photo.rgba[4 * i + std::size_t(c)] - srgb_value(light[c])));
    }
    return most;
}

}  // namespace

TEST_F(ColorProfiles, AdobeRgbDisplayP3AndProPhotoFollowTheirEquations) {
    const auto bytes = colors<std::uint8_t>(3);
    const auto words = colors<std::uint16_t>(3);
    for (const RgbSpace& space : {adobe_rgb, display_p3, prophoto_rgb}) {
        const std::string icc = icc_profile(space);
        for (const char* name : {"a.png", "a.tif"}) {
            const fs::path file = write(name, 3, bytes, icc);
            EXPECT_EQ(use_of(file).name, space.name);
            EXPECT_TRUE(use_of(file).converts);
            EXPECT_LE(error_of(read_photo(file, size), space, bytes, 3), 0.55) << space.name << " " << name;
            EXPECT_LE(error_of(read_photo(write(name, 3, words, icc), size), space, words, 3), 0.55)
                << space.name << " of 16 bits " << name;
        }
        const fs::path jpeg = write("a.jpg", 3, bytes, icc);
        const RgbaImage stored = read_unprofiled(jpeg, size);
        EXPECT_LE(error_of(read_photo(jpeg, size), space, stored.rgba, 4), 0.55) << space.name << " JPEG";
    }
}

TEST_F(ColorProfiles, AreFoundInHeicFiles) {
    const fs::path file = dir / "p.heic";
    if (!write_heic(file, colors<std::uint8_t>(3), icc_profile(display_p3))) GTEST_SKIP() << "no encoder";
    EXPECT_EQ(use_of(file).name, "Display P3");
    const RgbaImage stored = read_unprofiled(file, size);
    EXPECT_LE(error_of(read_photo(file, size), display_p3, stored.rgba, 4), 0.55);
}

TEST_F(ColorProfiles, ThatOfSrgbLeavesEveryByte) {
    const auto bytes = colors<std::uint8_t>(3);
    // The table is like the one in Hewlett-Packard's profile, which is the most common.
    std::vector<cmsUInt16Number> table;
    for (int i = 0; i < 1024; ++i)
        table.push_back(
            cmsUInt16Number(std::lround(65535 * cmsEvalToneCurveFloat(curve_of(0).get(), float(i) / 1023))));
    const Curve tabulated(cmsBuildTabulatedToneCurve16(nullptr, 1024, table.data()), cmsFreeToneCurve);
    const std::array curves{tabulated.get(), tabulated.get(), tabulated.get()};
    const cmsCIExyY white{d65[0], d65[1], 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
    cmsHPROFILE old = cmsCreateRGBProfile(&white, &primaries, curves.data());
    cmsSetProfileVersion(old, 2.1);
    RgbSpace simple = srgb;
    simple.gamma = 2.2;
    for (const std::string& icc : {icc_profile(srgb), icc_bytes(cmsCreate_sRGBProfile(), "c2"),
                                   icc_bytes(old, "sRGB"), icc_profile(simple)})
        for (const char* name : {"s.png", "s.jpg"}) {
            const fs::path with = write((std::string("with-") + name).c_str(), 3, bytes, icc);
            EXPECT_FALSE(use_of(with).converts);
            EXPECT_EQ(use_of(with).flaw, "");
            EXPECT_TRUE(read_photo(with, size).rgba == read_photo(write(name, 3, bytes), size).rgba) << name;
        }
    EXPECT_FALSE(use_of(write("none.png", 3, bytes)).converts);
}

TEST_F(ColorProfiles, LinearLightCalledSrgbIsConverted) {
    RgbSpace linear = srgb;
    linear.name = "Linear sRGB";
    linear.gamma = 1;
    const auto words = colors<std::uint16_t>(3);
    EXPECT_LE(error_of(read_photo(write("l.tif", 3, words, icc_profile(linear)), size), linear, words, 3),
              0.55);
}

TEST_F(ColorProfiles, SixteenBitsAreRoundedAfterwards) {
    // Dark tones in linear light. With 8 bits, the first two would become 0 and 13.
    RgbSpace linear = adobe_rgb;
    linear.gamma = 1;
    std::vector<std::uint16_t> ramp;
    for (int i = 0; i < side * side; ++i)
        for (int c = 0; c < 3; ++c) ramp.push_back(std::uint16_t(i));
    const RgbaImage photo = read_photo(write("r.png", 3, ramp, icc_profile(linear)), size);
    for (std::size_t i = 4; i < photo.rgba.size(); i += 4)
        ASSERT_LE(photo.rgba[i] - photo.rgba[i - 4], 1) << "at value " << i / 4;
    EXPECT_GT(int(photo.rgba[photo.rgba.size() - 4]), 60);
}

TEST_F(ColorProfiles, GraysFollowTheirCurve) {
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint16_t> words;
    for (int i = 0; i < side * side; ++i)
        bytes.push_back(std::uint8_t(i)), words.push_back(std::uint16_t(16 * i));
    const auto check = [&](const fs::path& file, const RgbaImage& stored, auto value) {
        EXPECT_TRUE(use_of(file).converts) << file;
        const RgbaImage photo = read_photo(file, size);
        for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
            ASSERT_NEAR(photo.rgba[i], srgb_value(std::pow(value(i), 1.8)), 0.55) << file;
            ASSERT_EQ(photo.rgba[i], photo.rgba[i + 1]);
            ASSERT_EQ(photo.rgba[i], photo.rgba[i + 2]);
            ASSERT_EQ(photo.rgba[i + 3], stored.rgba[i + 3]);
        }
    };
    for (const char* name : {"g.tif", "g.png", "g.jpg"}) {
        const fs::path file = write(name, 1, bytes, gray_profile(1.8));
        const RgbaImage stored = read_unprofiled(file, size);
        check(file, stored, [&](std::size_t i) { return stored.rgba[i] / 255.0; });
    }
    const fs::path file = write("w.tif", 1, words, gray_profile(1.8));
    check(file, read_unprofiled(file, size), [&](std::size_t i) { return words[i / 4] / 65535.0; });
    // Other programs keep a color profile when they convert a photo to gray.
    RgbSpace space = adobe_rgb;
    space.gamma = 1.8;
    const fs::path jpeg = write("c.jpg", 1, bytes, icc_profile(space));
    const RgbaImage stored = read_unprofiled(jpeg, size);
    check(jpeg, stored, [&](std::size_t i) { return stored.rgba[i] / 255.0; });
}

TEST_F(ColorProfiles, EveryGrayStaysNeutral) {
    const std::string icc = gray_profile(1.8);
    std::vector<std::uint16_t> grays;
    for (int v = 0; v < 65536; ++v) grays.insert(grays.end(), 4, std::uint16_t(v));
    const auto rgba = color_profile(std::as_bytes(std::span(icc)), PixelColors::gray)->converted(grays);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        ASSERT_TRUE(rgba[i] == rgba[i + 1] && rgba[i] == rgba[i + 2]) << grays[i];
}

TEST_F(ColorProfiles, AlphaAndOrientationAreKept) {
    const std::string icc = icc_profile(adobe_rgb);
    const auto bytes = colors<std::uint8_t>(4);
    const auto words = colors<std::uint16_t>(4);
    const RgbaImage photo = read_photo(write("a.png", 4, bytes, icc), size),
                    deep = read_photo(write("w.tif", 4, words, icc), size);
    EXPECT_LE(error_of(photo, adobe_rgb, bytes, 4), 0.55);
    EXPECT_LE(error_of(deep, adobe_rgb, words, 4), 0.55);
    for (std::size_t i = 3; i < photo.rgba.size(); i += 4) {
        ASSERT_EQ(photo.rgba[i], bytes[i]);
        ASSERT_EQ(int(deep.rgba[i]), std::lround(words[i] / 257.0));
    }
    // A quarter turn: the first stored row becomes the last column.
    const auto rows = std::vector(words.begin(), words.begin() + 4 * side * 16);
    const fs::path turned = write("t.tif", 4, rows, icc, 6);
    const RgbaImage stored = read_photo(turned, {side, 16}), upright = read_photo(turned, {16, side});
    for (std::size_t x = 0; x < side; ++x)
        for (std::size_t c = 0; c < 4; ++c)
            ASSERT_EQ(upright.rgba[4 * (16 * x + 15) + c], stored.rgba[4 * x + c]);
}

TEST_F(ColorProfiles, AreIgnoredInMasks) {
    const auto bytes = colors<std::uint8_t>(1);
    const fs::path mask = write("s.png", 1, bytes, gray_profile(1.8));
    EXPECT_TRUE(use_of(mask).converts);
    const RgbaImage values = read_unprofiled(mask, size);
    for (std::size_t i = 0; i < bytes.size(); ++i) ASSERT_EQ(values.rgba[4 * i], bytes[i]);
}

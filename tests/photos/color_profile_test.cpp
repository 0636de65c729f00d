// Photos with color profiles, against the equations of their color spaces.
#include "pipeline/photos/color_profile.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <libheif/heif.h>
#include <turbojpeg.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include "pipeline/photos/photos.h"
#include "tests/icc_profile.h"
#include "tests/image_file.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

constexpr int side = 64;
constexpr PhotoSize size{side, side};

template <class T>
constexpr double top = double(std::numeric_limits<T>::max());

/// Values of side * side colors: all over the cube of `channels`, its corners among them.
template <class T>
std::vector<T> colors(int channels) {
    std::vector<T> out;
    std::mt19937 random(3);
    for (int i = 0; i < side * side; ++i)
        for (int c = 0; c < channels; ++c)
            out.push_back(i < 2048 ? T(random()) : T((i >> (4 * c) & 15) * top<T> / 15));
    return out;
}

class ColorProfiles : public TemporaryFolder {
  protected:
    /// Writes side * side pixels.
    template <class T>
    fs::path write(const char* name, int channels, const std::vector<T>& pixels, const std::string& icc = {},
                   int orientation = 1) {
        OIIO::ImageSpec spec(side, int(pixels.size()) / side / channels, channels,
                             OIIO::BaseTypeFromC<T>::value);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("Orientation", orientation);
        spec.attribute("Compression", std::string(name).ends_with(".jpg") ? "jpeg:100" : "zip");
        if (!icc.empty())
            spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(icc.size())), icc.data());
        const fs::path file = dir / name;
        EXPECT_TRUE(write_image_file(file, spec, OIIO::BaseTypeFromC<T>::value, pixels.data())) << file;
        return file;
    }
    fs::path put(const char* name, const std::string& bytes) {
        std::ofstream(dir / name, std::ios::binary) << bytes;
        return dir / name;
    }
};

/// A JPEG of side * side pixels of inverted inks.
std::string cmyk_jpeg(const std::vector<std::uint8_t>& inks) {
    unsigned char* bytes = nullptr;
    unsigned long length = 0;
    const tjhandle encoder = tjInitCompress();
    tjCompress2(encoder, inks.data(), side, 0, side, TJPF_CMYK, &bytes, &length, TJSAMP_444, 100, 0);
    const std::string jpeg(reinterpret_cast<char*>(bytes), length);
    tjFree(bytes);
    tjDestroy(encoder);
    return jpeg;
}

/// False if no encoder is installed.
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

/// A JPEG with a profile in segments of 60000 bytes; `claimed`: how many there seem to be, if not as many.
std::string with_profile(std::string jpeg, const std::string& icc, std::size_t claimed = 0) {
    constexpr std::size_t most = 60000;
    const std::size_t count = (icc.size() + most - 1) / most;
    std::string segments;
    for (std::size_t n = 0; n < count; ++n) {
        const std::string part = icc.substr(n * most, most);
        const std::size_t length = part.size() + 16;
        segments += {char(0xff), char(0xe2), char(length >> 8), char(length)};
        segments += std::string("ICC_PROFILE", 12) + char(n + 1) + char(claimed ? claimed : count) + part;
    }
    return jpeg.insert(2, segments);
}

/// The largest error of a photo's bytes, of the colors that were written.
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

ProfileUse use_of(const fs::path& file) { return read_photo_header(file).profile; }

/// A photo's profile with a table of colors, as scanners and presses have: `lab_of` gives CIE L*a*b*,
/// relative to D50, of values in [0, 1].
std::string table_profile(cmsColorSpaceSignature space, cmsProfileClassSignature device, int points,
                          cmsSAMPLER16 lab_of) {
    cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, device);
    cmsSetColorSpace(profile, space);
    cmsSetPCS(profile, cmsSigLabData);
    const auto channels = cmsUInt32Number(space == cmsSigCmykData ? 4 : 3);
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, cmsUInt32Number(points), channels, 3, nullptr);
    cmsStageSampleCLut16bit(table, lab_of, nullptr, 0);
    const std::unique_ptr<cmsPipeline, decltype(&cmsPipelineFree)> pipeline(
        cmsPipelineAlloc(nullptr, channels, 3), cmsPipelineFree);
    for (cmsStage* stage : {cmsStageAllocToneCurves(nullptr, channels, nullptr), table,
                            cmsStageAllocToneCurves(nullptr, 3, nullptr)})
        cmsPipelineInsertStage(pipeline.get(), cmsAT_END, stage);
    cmsWriteTag(profile, cmsSigAToB0Tag, pipeline.get());
    cmsLinkTag(profile, cmsSigAToB1Tag, cmsSigAToB0Tag);
    cmsWriteTag(profile, cmsSigMediaWhitePointTag, cmsD50_XYZ());
    return icc_bytes(profile, "Table");
}

/// L*a*b* of linear light of sRGB, in 16 bits.
void write_lab(const Eigen::Vector3d& light, cmsUInt16Number* out) {
    // Of sRGB to XYZ relative to D50 (Lindbloom).
    Eigen::Matrix3d to_xyz;
    to_xyz << 0.4360747, 0.3850649, 0.1430804, 0.2225045, 0.7168786, 0.0606169, 0.0139322, 0.0971045,
        0.7141733;
    const Eigen::Vector3d xyz = to_xyz * light;
    const cmsCIEXYZ from{xyz[0], xyz[1], xyz[2]};
    cmsCIELab lab;
    cmsXYZ2Lab(cmsD50_XYZ(), &lab, &from);
    cmsFloat2LabEncoded(out, &lab);
}

/// A scanner that interchanges red and green, and whose black is a fiftieth of white.
cmsInt32Number scanner(const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    const auto light = [&](int c) { return 0.02 + 0.98 * std::pow(in[c] / 65535.0, 2.2); };
    write_lab({light(1), light(0), light(2)}, out);
    return TRUE;
}

/// A press with weak inks: each takes nine tenths of a light away, black of all.
cmsInt32Number press(const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    const auto left = [&](int ink) { return 1 - 0.9 * in[ink] / 65535.0; };
    write_lab({left(0) * left(3), left(1) * left(3), left(2) * left(3)}, out);
    return TRUE;
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
    // As in the profile of Hewlett-Packard, the most common one.
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
    // Dark tones in linear light: of 8 bits, the first two would be 0 and 13.
    RgbSpace linear = adobe_rgb;
    linear.gamma = 1;
    std::vector<std::uint16_t> ramp;
    for (int i = 0; i < side * side; ++i)
        for (int c = 0; c < 3; ++c) ramp.push_back(std::uint16_t(i));
    const RgbaImage photo = read_photo(write("r.png", 3, ramp, icc_profile(linear)), size);
    for (std::size_t i = 4; i < photo.rgba.size(); i += 4)
        ASSERT_LE(photo.rgba[i] - photo.rgba[i - 4], 1) << "of value " << i / 4;
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
    // Other programs leave the profile of the colors that a gray photo once had.
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

TEST_F(ColorProfiles, TablesOfColorsAreUsedAndBlackIsBlack) {
    const std::string icc = table_profile(cmsSigRgbData, cmsSigInputClass, 33, scanner);
    const auto look = [&](const fs::path& file, const auto& values, double top_value) {
        EXPECT_TRUE(use_of(file).converts) << use_of(file).flaw;
        const RgbaImage photo = read_photo(file, size);
        for (std::size_t i = 0; i < values.size(); i += 4) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double value = values[i + (c == 2 ? 2 : 1 - c)] / top_value;
                ASSERT_NEAR(photo.rgba[i + c], srgb_value(std::pow(value, 2.2)), 3) << file << " " << value;
            }
            ASSERT_EQ(int(photo.rgba[i + 3]), std::lround(values[i + 3] / top_value * 255));
        }
    };
    const auto bytes = colors<std::uint8_t>(4);
    const auto words = colors<std::uint16_t>(4);
    look(write("t.png", 4, bytes, icc), bytes, 255);
    look(write("w.png", 4, words, icc), words, 65535);
}

TEST_F(ColorProfiles, InksAreThoseOfTheirPress) {
    const auto inks = colors<std::uint8_t>(4);
    const std::string jpeg = cmyk_jpeg(inks);
    const std::string icc = table_profile(cmsSigCmykData, cmsSigOutputClass, 17, press);
    const fs::path file = put("c.jpg", with_profile(jpeg, icc));
    EXPECT_TRUE(use_of(file).converts) << use_of(file).flaw;
    const RgbaImage photo = read_photo(file, size);
    std::vector<std::uint8_t> stored(inks.size());
    const tjhandle decoder = tjInitDecompress();
    tjDecompress2(decoder, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size(), stored.data(),
                  side, 0, side, TJPF_CMYK, TJFLAG_ACCURATEDCT);
    tjDestroy(decoder);
    for (std::size_t i = 0; i < stored.size(); i += 4) {
        const auto left = [&](std::size_t c) { return 0.1 + 0.9 * stored[i + c] / 255.0; };  // 255: no ink
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(photo.rgba[i + c], srgb_value(left(c) * left(3)), 3);
        ASSERT_EQ(int(photo.rgba[i + 3]), 255);
    }
}

TEST_F(ColorProfiles, WhatCannotBeUsedIsNamedAndTakenAsSrgb) {
    const auto bytes = colors<std::uint8_t>(3);
    const std::string adobe = icc_profile(adobe_rgb), gray = gray_profile(1.8),
                      inks = table_profile(cmsSigCmykData, cmsSigOutputClass, 5, press);
    cmsHPROFILE profile = cmsOpenProfileFromMem(adobe.data(), cmsUInt32Number(adobe.size()));
    cmsWriteTag(profile, cmsSigRedTRCTag, nullptr);
    const std::string without_curve = icc_bytes(profile, "Without a curve");
    const auto expect_flaw = [&](const fs::path& file, const fs::path& without, const std::string& flaw) {
        EXPECT_EQ(use_of(file).flaw, flaw) << file;
        EXPECT_FALSE(use_of(file).converts);
        EXPECT_TRUE(read_photo(file, size).rgba == read_photo(without, size).rgba) << file;
    };
    for (const std::string name : {"f.tif", "f.jpg"}) {
        const fs::path without = write(("without-" + name).c_str(), 3, bytes);
        const auto with = [&](const std::string& icc) { return write(name.c_str(), 3, bytes, icc); };
        expect_flaw(with(std::string(400, 'x')), without, "it is damaged");
        expect_flaw(with(adobe.substr(0, 20)), without, "it is damaged");
        expect_flaw(with(without_curve), without, "it is incomplete");
        expect_flaw(with(gray), without, "it is not for RGB");
        expect_flaw(with(inks), without, "it is not for RGB");
    }
    const std::string jpeg = slurp(dir / "without-f.jpg"), cmyk = cmyk_jpeg(colors<std::uint8_t>(4));
    // The first of two segments.
    expect_flaw(put("part.jpg", with_profile(jpeg, adobe, 2)), dir / "without-f.jpg", "it is damaged");
    expect_flaw(put("rgb.jpg", with_profile(cmyk, adobe)), put("cmyk.jpg", cmyk), "it is not for CMYK");
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
    // A quarter turn: what is stored in the first row is the last column.
    const auto rows = std::vector(words.begin(), words.begin() + 4 * side * 16);
    const fs::path turned = write("t.tif", 4, rows, icc, 6);
    const RgbaImage stored = read_photo(turned, {side, 16}), upright = read_photo(turned, {16, side});
    for (std::size_t x = 0; x < side; ++x)
        for (std::size_t c = 0; c < 4; ++c)
            ASSERT_EQ(upright.rgba[4 * (16 * x + 15) + c], stored.rgba[4 * x + c]);
}

TEST_F(ColorProfiles, AreIgnoredInStencils) {
    const auto bytes = colors<std::uint8_t>(1);
    const fs::path stencil = write("s.png", 1, bytes, gray_profile(1.8));
    EXPECT_TRUE(use_of(stencil).converts);
    const RgbaImage values = read_unprofiled(stencil, size);
    for (std::size_t i = 0; i < bytes.size(); ++i) ASSERT_EQ(values.rgba[4 * i], bytes[i]);
}

TEST_F(ColorProfiles, GiveTheSameBytesOnManyThreads) {
    const auto bytes = colors<std::uint8_t>(3);
    const auto words = colors<std::uint16_t>(3);
    std::vector<fs::path> files;
    std::vector<RgbaImage> alone;
    for (const RgbSpace& space : {adobe_rgb, display_p3, prophoto_rgb})
        files.push_back(write((std::string(space.name) + ".tif").c_str(), 3, words, icc_profile(space)));
    files.push_back(write("table.png", 3, bytes, table_profile(cmsSigRgbData, cmsSigInputClass, 9, scanner)));
    files.push_back(write("p3.jpg", 3, bytes, icc_profile(display_p3)));
    for (const fs::path& file : files) alone.push_back(read_photo(file, size));
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 8; ++t)
        threads.emplace_back([&, t] {
            for (std::size_t n = 0; n < 2 * files.size(); ++n) {
                const std::size_t i = (n + t) % files.size();
                EXPECT_TRUE(read_photo(files[i], size).rgba == alone[i].rgba) << files[i];
            }
        });
}

// Color profiles with tables, like those of scanners and printing presses, and unusable profiles.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <thread>

#include "pipeline/photos/photos.h"
#include "tests/icc_profile.h"
#include "tests/photos/stored_colors.h"

using namespace vantage;
using namespace vantage::stored_colors;

namespace {

/// A CMYK JPEG of side * side pixels with inverted inks.
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

/// Adds a profile to a JPEG, in segments of 60000 bytes. `claimed`: the number of segments stated in the
/// JPEG, if it should be wrong.
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

/// A profile with a table of colors, like those of scanners and printing presses. `lab_of` maps values in [0,
/// 1] to CIE L*a*b* relative to D50.
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

/// Converts linear sRGB to L*a*b* in 16 bits.
void write_lab(const Eigen::Vector3d& light, cmsUInt16Number* out) {
    // The matrix from sRGB to XYZ relative to D50 (Lindbloom).
    Eigen::Matrix3d to_xyz;
    to_xyz << 0.4360747, 0.3850649, 0.1430804, 0.2225045, 0.7168786, 0.0606169, 0.0139322, 0.0971045,
        0.7141733;
    const Eigen::Vector3d xyz = to_xyz * light;
    const cmsCIEXYZ from{xyz[0], xyz[1], xyz[2]};
    cmsCIELab lab;
    cmsXYZ2Lab(cmsD50_XYZ(), &lab, &from);
    cmsFloat2LabEncoded(out, &lab);
}

/// A scanner that swaps red and green. Its black is a fiftieth as bright as its white.
cmsInt32Number scanner(const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    const auto light = [&](int c) { return 0.02 + 0.98 * std::pow(in[c] / 65535.0, 2.2); };
    write_lab({light(1), light(0), light(2)}, out);
    return TRUE;
}

/// A printing press with weak inks. Each color ink absorbs nine tenths of one primary, and black absorbs nine
/// tenths of all three.
cmsInt32Number press(const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    const auto left = [&](int ink) { return 1 - 0.9 * in[ink] / 65535.0; };
    write_lab({left(0) * left(3), left(1) * left(3), left(2) * left(3)}, out);
    return TRUE;
}

}  // namespace

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
    // The file holds only the first of two segments.
    expect_flaw(put("part.jpg", with_profile(jpeg, adobe, 2)), dir / "without-f.jpg", "it is damaged");
    expect_flaw(put("rgb.jpg", with_profile(cmyk, adobe)), put("cmyk.jpg", cmyk), "it is not for CMYK");
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

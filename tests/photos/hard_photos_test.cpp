// Photos of all sizes and formats, intact, truncated or mislabeled.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>

#include "base/text/error.h"
#include "base/values/halve.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/file_identity.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/stages/tile_levels.h"
#include "tests/icc_profile.h"
#include "tests/image_file.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class HardPhotos : public TemporaryFolder {
  protected:
    template <class T>
    fs::path write(const std::string& name, int width, int height, int channels, const std::vector<T>& pixels,
                   int orientation = 1) {
        OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<T>::value);
        spec.attribute("Orientation", orientation);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        const fs::path file = dir / name;
        EXPECT_TRUE(write_image_file(file, spec, OIIO::BaseTypeFromC<T>::value, pixels.data())) << file;
        return file;
    }
    static std::vector<std::uint8_t> noise(int width, int height, int channels) {
        std::mt19937 random(8);
        std::vector<std::uint8_t> out(std::size_t(width) * std::size_t(height) * std::size_t(channels));
        for (auto& v : out) v = std::uint8_t(random());
        return out;
    }
    /// The decoder's error without the path of the file; "" if the decoder accepts the photo.
    static std::string rejection(const fs::path& file, PhotoSize expected) {
        try {
            const RgbaImage p = read_photo(file, expected);
            EXPECT_EQ(p.rgba.size(), std::size_t(p.width) * std::size_t(p.height) * 4);
            return {};
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_TRUE(std::string(e.what()).starts_with(file.string() + ": ")) << e.what();
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            return reason_of(e, file);
        }
    }
    fs::path put(const std::string& name, const std::string& bytes) {
        std::ofstream(dir / name, std::ios::binary) << bytes;
        return dir / name;
    }
};

}  // namespace

// Decoders fill missing parts with gray.
TEST_F(HardPhotos, TruncatedAtEveryPercentIsRejectedOrWhole) {
    for (const char* name : {"p.jpg", "p.png", "p.tif"}) {
        const fs::path whole = write(name, 64, 48, 3, noise(64, 48, 3));
        const std::string bytes = slurp(whole);
        ASSERT_EQ(rejection(whole, {64, 48}), "");
        const RgbaImage truth = read_photo(whole, {64, 48});
        for (int percent = 0; percent < 100; ++percent) {
            const fs::path cut =
                put(std::string("cut-") + name, bytes.substr(0, bytes.size() * std::size_t(percent) / 100));
            // The photo may be accepted only if all pixels are intact.
            EXPECT_TRUE(!rejection(cut, {64, 48}).empty() || read_photo(cut, {64, 48}).rgba == truth.rgba)
                << name << " at " << percent << " %";
        }
    }
}

TEST_F(HardPhotos, FlippedBitsNeverCrash) {
    std::mt19937 random(4);
    for (const char* name : {"p.jpg", "p.png", "p.tif"}) {
        const std::string bytes = slurp(write(name, 40, 30, 3, noise(40, 30, 3)));
        for (int trial = 0; trial < 300; ++trial) {
            std::string broken = bytes;
            for (int n = 0; n < 1 + trial % 5; ++n)
                broken[random() % broken.size()] ^= char(1 << random() % 8);
            rejection(put(std::string("flipped-") + name, broken),
                      {40, 30});  // rejected, or decoded to that size
        }
    }
}

TEST_F(HardPhotos, FlippedBitsInAColorProfileNeverCrash) {
    std::mt19937 random(6);
    const std::string adobe = icc_profile(adobe_rgb), gray = gray_profile(2.2);
    for (int trial = 0; trial < 30; ++trial) {
        std::string icc = trial % 3 ? adobe : gray;
        for (int n = 0; n < 1 + trial % 5; ++n) icc[random() % icc.size()] ^= char(1 << random() % 8);
        if (trial % 7 == 0) icc.resize(random() % icc.size());
        const auto profile =
            color_profile(std::as_bytes(std::span(icc)), trial % 3 ? PixelColors::rgb : PixelColors::gray);
        EXPECT_FALSE(profile->use.converts && !profile->use.flaw.empty());
        std::vector<std::uint8_t> pixels = noise(10, 10, 4);
        if (profile->use.converts) profile->convert(pixels);
    }
}

TEST_F(HardPhotos, SizeMismatchIsRejectedBeforeAllocating) {
    std::string bytes = slurp(write("p.jpg", 64, 48, 3, noise(64, 48, 3)));
    // The frame header consists of the marker, length, precision, height and width.
    const std::size_t at = bytes.find("\xff\xc0");
    ASSERT_NE(at, std::string::npos);
    for (std::size_t i = 5; i < 9; i += 2) bytes[at + i] = char(0xfd), bytes[at + i + 1] = char(0xe8);
    const std::string why = rejection(put("huge.jpg", bytes), {64, 48});  // would be 17 GB
    EXPECT_NE(why.find("65000x65000, but its camera expects 64x48"), std::string::npos) << why;
}

TEST_F(HardPhotos, ContentDecidesTheFormatNotTheExtension) {
    const std::string jpeg = slurp(write("p.jpg", 20, 10, 3, noise(20, 10, 3)));
    const std::string png = slurp(write("p.png", 20, 10, 3, noise(20, 10, 3)));
    EXPECT_EQ(rejection(put("jpeg.png", jpeg), {20, 10}), "");
    EXPECT_EQ(rejection(put("png.jpg", png), {20, 10}), "");
    const RgbaImage p = read_photo(put("png.jpg", png), {20, 10});
    EXPECT_EQ(p.rgba, read_photo(dir / "p.png", {20, 10}).rgba);
    EXPECT_NE(rejection(put("text.jpg", "hello"), {20, 10}), "");
    EXPECT_NE(rejection(put("empty.jpg", ""), {20, 10}), "");
    EXPECT_NE(rejection(put("marker.jpg", "\xff\xd8"), {20, 10}), "");
}

TEST_F(HardPhotos, ExifOrientationIsIgnoredUnlessTheCameraExpectsIt) {
    std::vector<std::uint8_t> pixels(3 * 2 * 3, 200);
    std::fill_n(pixels.begin(), 3, std::uint8_t(0));
    for (int o = 1; o <= 8; ++o) {
        const fs::path file = write("o.tif", 3, 2, 3, pixels, o);
        const RgbaImage stored = read_photo(file, {3, 2});
        EXPECT_EQ(int(stored.rgba[0]), 0) << "cameras are calibrated on stored pixels; orientation " << o;
        if (o < 5) {
            EXPECT_NE(rejection(file, {2, 3}), "")
                << "orientation " << o << " does not swap width and height";
        }
        // 5 to 8: Photos.AreRotatedOnlyIfTheCameraExpectsIt
    }
}

TEST_F(HardPhotos, NonFiniteAndHugeFloatsAreClamped) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    std::vector<float> pixels(4 * 2 * 3, 0.5f);
    const float odd[] = {inf, -inf, nan, 1e30f, -1e30f, 1e-40f};
    std::copy(std::begin(odd), std::end(odd), pixels.begin());
    for (const char* name : {"f.exr", "f.tif"}) {
        const RgbaImage p = read_photo(write(name, 4, 2, 3, pixels), {4, 2});
        EXPECT_EQ(int(p.rgba[0]), 255) << name;
        EXPECT_EQ(int(p.rgba[1]), 0) << name;
        EXPECT_EQ(int(p.rgba[4]), 255) << name;
        EXPECT_EQ(int(p.rgba[5]), 0) << name;
        EXPECT_EQ(int(p.rgba[6]), 0) << name;
        EXPECT_EQ(int(p.rgba[3]), 255) << name;
    }
}

TEST_F(HardPhotos, SinglePixelsRowsAndColumnsHaveAPyramid) {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 700}, {700, 1}, {2, 513}, {505, 505}}) {
        RgbaImage p{width, height, noise(width, height, 4)};
        for (std::size_t i = 3; i < p.rgba.size(); i += 4) p.rgba[i] = 255;
        double mean = 0;
        for (std::size_t i = 0; i < p.rgba.size(); i += 4) mean += p.rgba[i];
        mean /= double(p.rgba.size() / 4);
        while (p.width > 1 || p.height > 1) {
            const RgbaImage half = halve(p);
            ASSERT_EQ(half.width, (p.width + 1) / 2);
            ASSERT_EQ(half.height, (p.height + 1) / 2);
            p = half;
        }
        EXPECT_NEAR(p.rgba[0], mean, 80) << "averages linear light, not encoded values";
        EXPECT_EQ(int(p.rgba[3]), 255);
    }
}

// A width of 100,000 pixels exceeds the limits of JPEG and of textures, but not that of tiles.
TEST_F(HardPhotos, PreparesPhotosWiderThanAnyTexture) {
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 1;
    spec.photos.samples = 1;
    const int width = 100000, height = 3;
    spec.photos.width = 1000;  // replaced below by a wider one
    spec.photos.height = 3;
    copy_scene(spec, dir / "scene");
    fs::remove_all(dir / "scene" / "images");
    fs::create_directories(dir / "scene" / "images");
    std::vector<std::uint8_t> pixels(std::size_t(width) * height * 3);
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
        const auto x = i / 3 % std::size_t(width);
        pixels[i] = std::uint8_t(x >> 9);
        pixels[i + 1] = std::uint8_t(x >> 1);
    }
    write("scene/images/0000.png", width, height, 3, pixels);
    SceneInput scene = read_scene([&] {
        std::ofstream(dir / "scene" / "sparse" / "cameras.txt")
            << "1 PINHOLE 100000 3 100000 100000 50000 1.5\n";
        std::ofstream(dir / "scene" / "sparse" / "images.txt") << "1 1 0 0 0 0 0 20 1 0000.png\n\n";
        return discover(dir / "scene");
    }());
    ASSERT_EQ(scene.photos.size(), 1u);
    const fs::path file = dir / "wide.vantage";
    prepare(scene, {}, file, [](const Progress&) {});
    for (const Issue& i : check_package(file, {.deep = true})) ADD_FAILURE() << i.text;
    const PackageReader package(file);
    const RgbaImage level = read_level_image(package, package.photos()[0], 0, package::Type::tiles, 0);
    ASSERT_EQ(level.width, width);
    for (const int x : {0, 1, 503, 504, 505, 65535, 65536, 99999}) {
        EXPECT_NEAR(int(level.rgba[4 * std::size_t(x)]), (x >> 9) & 255, 2) << x;
        EXPECT_NEAR(int(level.rgba[4 * std::size_t(x) + 1]), (x >> 1) & 255, 2) << x;
    }
}

TEST_F(HardPhotos, AspectRatioMismatchIsSkippedAndListed) {
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 3;
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    const fs::path second = dir / "scene" / "images" / "0001.jpg";
    fs::remove(second);
    write("scene/images/0001.jpg", 50, 70, 3, noise(50, 70, 3));
    const PrepareResult result =
        prepare(read_scene(discover(dir / "scene")), {}, dir / "a.vantage", [](const Progress&) {});
    ASSERT_EQ(result.skipped.size(), 1u);
    EXPECT_EQ(result.skipped[0].photo, "0001.jpg");
    EXPECT_NE(result.skipped[0].why.find("50x70"), std::string::npos) << result.skipped[0].why;
}

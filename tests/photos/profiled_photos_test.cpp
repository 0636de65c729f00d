// Packages made from photos with color profiles.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/output/staleness.h"
#include "pipeline/photos/photos.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/stages/tile_levels.h"
#include "tests/icc_profile.h"
#include "tests/image_file.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

void unreported(const Progress&) {}

void write_image(const fs::path& file, int width, int height, int channels, const std::vector<float>& values,
                 OIIO::TypeDesc type, const std::string& icc) {
    OIIO::ImageSpec spec(width, height, channels, type);
    spec.attribute("Compression", file.extension() == ".jpg" ? "jpeg:100" : "zip");
    spec.attribute("jpeg:subsampling", "4:4:4");
    if (!icc.empty())
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(icc.size())), icc.data());
    ASSERT_TRUE(write_image_file(file, spec, OIIO::TypeDesc::FLOAT, values.data())) << file;
}

class ProfiledPhotos : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        spec.photos.count = 3;
        copy_scene(spec, dir / "srgb");
        fs::remove_all(dir / "srgb" / "truth");
    }
    /// A copy of the scan with the same colors in this color space: two 16-bit photos and a JPEG.
    fs::path copied_to(const RgbSpace& space) const {
        const fs::path scan = dir / space.name;
        fs::copy(dir / "srgb", scan, fs::copy_options::recursive);
        fs::remove_all(scan / "images");
        fs::create_directories(scan / "images");
        Eigen::Matrix3d to_srgb;
        for (int c = 0; c < 3; ++c) to_srgb.col(c) = srgb_light(space, Eigen::Vector3d::Unit(c));
        const Eigen::Matrix3d from_srgb = to_srgb.inverse();
        for (const char* name : {"0000", "0001", "0002"}) {
            const RgbaImage photo = read_photo(dir / "srgb" / "images" / (std::string(name) + ".jpg"), size_);
            std::vector<float> values;
            for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
                const Eigen::Vector3d color(photo.rgba[i], photo.rgba[i + 1], photo.rgba[i + 2]);
                const Eigen::Vector3d light = from_srgb * srgb_light(srgb, color / 255);
                for (const double l : light)
                    values.push_back(float(std::pow(std::max(l, 0.0), 1 / space.gamma)));
            }
            const bool jpeg = std::string(name) == "0002";
            write_image(scan / "images" / (std::string(name) + (jpeg ? ".jpg" : ".tif")), size_.width,
                        size_.height, 3, values, jpeg ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16,
                        icc_profile(space));
        }
        return scan;
    }
    const PhotoSize size_{331, 250};
};

RgbaImage finest(const PackageReader& package, std::uint32_t photo) {
    return read_level_image(package, package.photos()[photo], photo, package::Type::tiles, 0);
}

double mean_difference(const RgbaImage& a, const RgbaImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
    return sum / double(a.rgba.size()) * 4 / 3;
}

const PrepareResult::Stage& made(const PrepareResult& result, package::Stage stage) {
    return result.stages[std::size_t(stage)];
}

}  // namespace

TEST_F(ProfiledPhotos, MakeThePackageOfTheSamePhotosInSrgb) {
    const fs::path adobe = copied_to(adobe_rgb);
    PrepareSettings settings;
    settings.effects[Effect::compact] = EffectChoice::on;
    prepare(read_scene(discover(dir / "srgb")), settings, dir / "srgb.vantage", unreported);
    const SceneInput scene = read_scene(discover(adobe));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(
        scene.warnings[0],
        "0000.tif and 2 other photos hold the color profile 'Adobe RGB (1998)': converted to sRGB; colors "
        "outside sRGB are clipped");
    prepare(scene, settings, dir / "adobe.vantage", unreported);
    const PackageReader a(dir / "srgb.vantage"), b(dir / "adobe.vantage");
    ASSERT_EQ(b.photos().size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        // Tiles are JPEGs of quality 97, except those of an sRGB JPEG; the third photo was encoded once more.
        EXPECT_LT(mean_difference(finest(a, i), finest(b, i)), i < 2 ? 0.4 : 1.2) << i;
        EXPECT_GT(mean_difference(finest(a, i), read_unprofiled(scene.photos[i].file, size_)), 2)
            << "without the profile";
    }
}

TEST_F(ProfiledPhotos, MasksKeepTheirThreshold) {
    // Half of the mask is dark as stored, but bright when it is converted with the profile.
    std::vector<float> values;
    for (int i = 0; i < size_.width * size_.height; ++i)
        values.push_back(i < size_.width * size_.height / 2 ? 100 / 255.0f : 1.0f);
    write_image(dir / "srgb" / "images" / "0001.mask.png", size_.width, size_.height, 1, values,
                OIIO::TypeDesc::UINT8, gray_profile(1));
    prepare(read_scene(discover(dir / "srgb")), {}, dir / "a.vantage", unreported);
    const RgbaImage photo = finest(PackageReader(dir / "a.vantage"), 1);
    EXPECT_EQ(int(photo.rgba[3]), 0);
    EXPECT_EQ(int(photo.rgba.back()), 255);
}

TEST_F(ProfiledPhotos, ThatAnEarlierVersionDidNotConvertAreMadeAgain) {
    const fs::path adobe = copied_to(adobe_rgb);
    SceneInput earlier = read_scene(discover(adobe));
    for (PhotoInput& photo : earlier.photos) photo.profile = {};
    earlier.warnings = {"0000.tif: has the color profile 'Adobe RGB (1998)', treated as sRGB"};
    prepare(earlier, {}, dir / "a.vantage", unreported);
    EXPECT_FALSE(changed_settings(PackageReader(dir / "a.vantage"), {}).empty());
    const PrepareResult again = prepare(read_scene(discover(adobe)), {}, dir / "a.vantage", unreported);
    EXPECT_EQ(made(again, package::Stage::tiles).made, 3u);
    EXPECT_EQ(made(again, package::Stage::thumbnail).made, 3u);
    EXPECT_EQ(made(again, package::Stage::samples).made, 3u);
    EXPECT_EQ(made(again, package::Stage::coverage).kept, 3u);
    EXPECT_TRUE(changed_settings(PackageReader(dir / "a.vantage"), {}).empty());
    const PrepareResult last = prepare(read_scene(discover(adobe)), {}, dir / "a.vantage", unreported);
    EXPECT_EQ(made(last, package::Stage::tiles).kept, 3u);
}

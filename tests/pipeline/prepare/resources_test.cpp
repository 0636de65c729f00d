#include "pipeline/prepare/resources.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

/// Each test has its own cache, which contains no stored speed of this machine.
class Estimate : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        if (const char* was = std::getenv("XDG_CACHE_HOME")) cache_ = was;
        ::setenv("XDG_CACHE_HOME", dir.c_str(), 1);
    }
    void TearDown() override {
        if (cache_)
            ::setenv("XDG_CACHE_HOME", cache_->c_str(), 1);
        else
            ::unsetenv("XDG_CACHE_HOME");
        TemporaryFolder::TearDown();
    }

  private:
    std::optional<std::string> cache_;
};

/// Photos that are reduced to 6 MP from files of 24 MP.
SceneInput reduced(std::size_t photos, const char* file) {
    SceneInput scene;
    scene.photos.resize(photos);
    for (PhotoInput& p : scene.photos) {
        p.file = file;
        p.decoded = {6000, 4000};
        p.camera.intrinsics = {3000, 2000, 3000, 3000, 1500, 1000};
    }
    return scene;
}

double seconds(const SceneInput& scene, std::uint32_t triangles) {
    package::SceneRecord model{};
    model.triangles = triangles;
    return expected_seconds(scene, {}, model, 1, 0).photos;
}

}  // namespace

TEST_F(Estimate, GrowsWithPhotosTrianglesAndPixels) {
    const SceneInput one = reduced(1, "a.jpg"), four = reduced(4, "a.jpg");
    const double none = seconds(one, 0), million = seconds(one, 1000000);
    EXPECT_GT(none, 0);
    EXPECT_GT(million, none);
    EXPECT_NEAR(seconds(one, 5000000) - none, 5 * (million - none), 1e-9);
    EXPECT_NEAR(seconds(four, 1000000), 4 * million, 1e-9);
    EXPECT_GT(seconds(reduced(1, "a.png"), 0), 1.5 * none) << "PNG takes longer to decode";
    SceneInput small = one;
    small.photos[0].decoded = {3000, 2000};
    EXPECT_LT(seconds(small, 0), none) << "reduced photos are decoded at full size";
}

TEST_F(Estimate, CountsTheBytesThatGoToADisk) {
    const SceneInput scene = reduced(4, "a.jpg");
    const auto with = [&](std::uint64_t bytes) { return expected_seconds(scene, {}, {}, 1, bytes).photos; };
    EXPECT_EQ(with(1000000), with(0)) << "the package is written while photos are decoded";
    EXPECT_GT(with(10000000000), 10) << "10 GB at 1 GB/s";
    EXPECT_LT(with(10000000000), 100) << "at 0.1 GB/s";
}

TEST_F(Estimate, CountsTheBytesOfFilesWithoutCompression) {
    const auto memory = [&](const char* name, std::uintmax_t bytes) {
        const std::filesystem::path file = dir / name;
        std::ofstream(file).flush();
        std::filesystem::resize_file(file, bytes);
        return double(photo_memory(reduced(1, file.c_str()), {}, true));
    };
    const double jpeg = memory("a.jpg", 8'000'000), tiff = memory("a.tif", 144'000'000);
    EXPECT_NEAR(tiff - jpeg, 2 * 144e6 - 24e6, 1e6) << "the file, and its 16-bit values";
    EXPECT_EQ(memory("b.jpg", 10'000'000), jpeg);
}

TEST_F(Estimate, LearnsFromRunsLongEnoughToTell) {
    const SceneInput scene = reduced(4, "a.jpg");
    const double before = seconds(scene, 1000000);
    remember_speed(0.01, 0.3);
    EXPECT_EQ(seconds(scene, 1000000), before) << "a short run";
    remember_speed(before, 9 * before);
    EXPECT_NEAR(seconds(scene, 1000000), 3 * before, 1e-3 * before) << "a single slow run";
    for (int run = 0; run < 12; ++run) remember_speed(seconds(scene, 1000000), 9 * before);
    EXPECT_NEAR(seconds(scene, 1000000), 9 * before, 0.01 * before) << "a slow machine";
}

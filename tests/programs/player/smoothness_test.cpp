#include "player/measure/bench/smoothness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/run/settings.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

constexpr FrameSize size{256, 192};
constexpr double exposure = 1.35;  ///< factor by which the changed photo is brightened

class SmoothnessOfFlights : public TemporaryFolder {
  protected:
    fs::path file = dir / "scene.vantage";
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.arc = 60;
        copy_scene(spec, dir / "scene");
    }
    void make_package(EffectChoice gains = EffectChoice::off) {
        PrepareSettings settings;
        settings.effects[Effect::pose_refinement] = EffectChoice::off;
        settings.effects[Effect::exposure] = gains;
        settings.effects[Effect::vignetting] = EffectChoice::off;
        settings.effects[Effect::transients] = EffectChoice::off;
        copy_package(dir / "scene", settings, file);
    }
    /// Brightens photo 2, which is the middle one of five.
    void brighten() {
        const fs::path photo = read_scene(discover(dir / "scene")).photos[2].file;
        const RgbaImage image = image_files().read(photo);
        std::vector<std::byte> rgb;
        for (std::size_t i = 0; i < image.rgba.size(); ++i) {
            const double light = std::min(1.0, exposure * linear_of_srgb_byte()[image.rgba[i]]);
            if (i % 4 < 3) rgb.push_back(std::byte(std::lround(255 * srgb_from_linear(light))));
        }
        image_files().write(photo, image.width, image.height, 3, Sample::u8, rgb);
    }
    /// Flies from one photo's camera to another's.
    std::vector<FrameStep> fly(std::uint32_t from, std::uint32_t to, const SmoothnessOptions& o = {}) {
        const PackageReader package(file);
        const gl::HeadlessContext context(gl::Debug::on);
        const std::vector<Navigation> path =
            in_steps({stand_at(package.photos()[from], up_of(package.scene())),
                      stand_at(package.photos()[to], up_of(package.scene()))},
                     2 * std::numbers::pi / 180);
        std::vector<ShownStep> shown;
        return fly_in_steps(package, o, path, size, shown);
    }
    /// The surface's mean 8-bit value as seen from a photo's camera.
    double brightness_at(std::uint32_t photo) {
        const PackageReader package(file);
        const gl::HeadlessContext context(gl::Debug::on);
        Renderer renderer(package, {});
        const View view =
            view_of(stand_at(package.photos()[photo], up_of(package.scene())), size.width, size.height);
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        const Picture p = take_picture(renderer, view, {}, photos, 1);
        double sum = 0, n = 0;
        for (std::size_t i = 0; i < p.rgba.size(); ++i)
            if (i % 4 < 3 && p.rgba[i / 4 * 4 + 3] > 0) sum += p.rgba[i], ++n;
        return sum / n;
    }
};
class SmoothnessOfFlightsAtLength : public SmoothnessOfFlights {};

double sum_of_means(const std::vector<FrameStep>& steps) {
    double sum = 0;
    for (const FrameStep& s : steps) sum += s.color.mean;
    return sum;
}

double largest_mean(const std::vector<FrameStep>& steps) { return smoothness_of(steps).mean.max; }

}  // namespace

TEST_F(SmoothnessOfFlightsAtLength, PhotoOfAnotherExposureIsFoundWhereItTakesOver) {
    make_package();
    const double consistent = sum_of_means(fly(1, 2)), dark = brightness_at(2);
    brighten();
    make_package();
    const double jump = brightness_at(2) - dark;
    ASSERT_GT(jump, 10) << "gray levels";
    const double toward = sum_of_means(fly(1, 2)), beside = sum_of_means(fly(3, 4));
    std::printf(
        "jump %.2f; sum of the steps: toward the photo %.2f, elsewhere %.2f, with consistent photos "
        "%.2f\n",
        jump, toward, beside, consistent);
    EXPECT_NEAR(toward, jump, 0.2 * jump);
    EXPECT_LT(consistent, 0.2 * jump);
    EXPECT_LT(beside, 0.25 * jump);
    make_package(EffectChoice::on);
    const double corrected = sum_of_means(fly(1, 2));
    std::printf("with gains %.2f\n", corrected);
    EXPECT_LT(corrected, 0.3 * toward);
}

TEST_F(SmoothnessOfFlightsAtLength, AbruptChangesAreMeasuredAsLargerSteps) {
    const double dark = (make_package(), brightness_at(2));
    brighten();
    make_package();
    const double jump = brightness_at(2) - dark;
    SmoothnessOptions best, one, at_once;
    best.blending.render.blend = Blend::best;
    one.blending.photos = 1;
    one.blending.render.choice = Choice::nearest;
    at_once = one;
    at_once.fades = false;
    const double shipped = largest_mean(fly(1, 2)), chosen = largest_mean(fly(1, 2, best)),
                 fading = largest_mean(fly(1, 2, one)), replaced = largest_mean(fly(1, 2, at_once));
    std::printf(
        "jump %.2f; largest step: default settings %.2f, best photo %.2f, one photo with fading %.2f, "
        "without fading %.2f\n",
        jump, shipped, chosen, fading, replaced);
    EXPECT_GT(chosen, 1.5 * shipped);
    EXPECT_LT(fading, 0.25 * jump) << "one photo should replace another over nine frames";
    EXPECT_NEAR(replaced, jump, 0.3 * jump) << "the full jump should occur in one frame";
}

TEST_F(SmoothnessOfFlightsAtLength, ProgramWritesTheSameTwice) {
    make_package();
    const auto run = [&](const std::string& options) {
        const std::string command = std::string(VANTAGE_PLAYER) + " smoothness " + file.string() + " " +
                                    options + " > " + (dir / "output").string() + " 2>&1";
        return std::system(command.c_str());
    };
    const std::string common = "--size 160x120 --step 4 --worst 2 -o ";
    ASSERT_EQ(run(common + (dir / "a").string()), 0) << slurp(dir / "output");
    ASSERT_EQ(run(common + (dir / "b").string()), 0) << slurp(dir / "output");
    EXPECT_EQ(slurp(dir / "a" / "steps.csv"), slurp(dir / "b" / "steps.csv"));
    const nlohmann::json summary = nlohmann::json::parse(slurp(dir / "a" / "summary.json"));
    EXPECT_GT(summary["degrees"].get<double>(), 60) << "the surface should be nearer than the arc's center";
    EXPECT_LT(summary["degrees"].get<double>(), 120) << "the flight should pass through all cameras in order";
    EXPECT_EQ(summary["frames_with_tiles_missing"], 0);
    EXPECT_TRUE(fs::exists(dir / "a" / "steps.svg"));
    std::size_t pictures = 0;
    for (const auto& entry : fs::directory_iterator(dir / "a"))
        pictures += entry.path().extension() == ".png";
    EXPECT_EQ(pictures, 2u);
    std::ofstream(dir / "one.path") << "0 -10 1 0 0 1\n";
    EXPECT_EQ(run("--path " + (dir / "one.path").string()), 3 << 8);
    EXPECT_NE(slurp(dir / "output").find("one.path: a path with one view, expected at least two views"),
              std::string::npos);
}

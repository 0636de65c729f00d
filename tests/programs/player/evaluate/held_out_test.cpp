// Tests pictures that are predicted without the photo that they are compared with, their scores, and the
// output of evaluate.
#include "player/measure/evaluation/held_out.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "player/measure/evaluation/colors_without.h"
#include "player/measure/evaluation/evaluate.h"
#include "player/measure/evaluation/photo_pixels.h"
#include "scene/agreement/registered_without.h"
#include "tests/made_scenes.h"
#include "tests/programs/player/evaluate/evaluated_scene.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

void replace_by_noise(const fs::path& file) {
    std::mt19937 random(1);
    repaint(file, [&](std::array<std::uint8_t, 3>& color, int, int) {
        for (std::uint8_t& v : color) v = std::uint8_t(random());
    });
}

/// The effects that depend on all photos are forced on, because validation could decide differently without
/// one of the photos.
PrepareSettings all_but_pose_refinement() {
    PrepareSettings settings;
    for (const Effect e : {Effect::exposure, Effect::vignetting, Effect::transients})
        settings.effects[e] = EffectChoice::on;
    settings.effects[Effect::pose_refinement] = EffectChoice::off;
    return settings;
}

}  // namespace

TEST_F(EvaluateAtLength, ComparesWithThePhotoItselfWhateverTheFormOfTiles) {
    const auto truth = [&](EffectChoice compact, int level) {
        PrepareSettings settings;
        settings.effects[Effect::compact] = compact;
        return photo_at_level(PackageReader(made_package(dir / "scene", settings)), 1, level).rgba;
    };
    for (const int level : {0, 2})
        EXPECT_TRUE(truth(EffectChoice::on, level) == truth(EffectChoice::off, level)) << level;
}

TEST_F(EvaluateAtLength, HolesAreWhereTheMeshEndsOrNoOtherPhotoLooks) {
    const PhotoEvaluation whole = evaluate_photo(2);
    const auto& positions = scene.mesh.positions;
    std::erase_if(scene.mesh.triangles, [&](const auto& t) {  // the upper floor and the roof
        return std::max({positions[t[0]].z(), positions[t[1]].z(), positions[t[2]].z()}) > 3.5;
    });
    fs::remove(file);
    const PhotoEvaluation holed = evaluate_photo(2);
    EXPECT_GT(holed.causes.of(Cause::no_surface), 1.2 * whole.causes.of(Cause::no_surface));
    EXPECT_LT(holed.frame.psnr_gain, whole.frame.psnr_gain - 0.5)
        << "holes anywhere in the frame should reduce the gain";

    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    std::vector<RegionError> regions;
    EvaluationPictures pictures;
    const PhotoEvaluation alone =
        evaluate_held_out(renderer, {}, {2, 2, std::array{2u}, package.photos()}, regions, pictures);
    EXPECT_GT(alone.causes.of(Cause::unseen), 0);
    EXPECT_EQ(alone.causes.colored(), 0);
    EXPECT_EQ(alone.score.pixels, 0u);
    EXPECT_GT(alone.frame.psnr, 0);
}

TEST_F(EvaluateAtLength, WholeFrameIsThatOfTheWindow) {
    copy_package(dir / "scene", {}, file);
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const View view = view_of_level(package.photos()[2], 1);
    RenderSettings settings;
    const std::vector<std::uint32_t> others{0, 1, 3, 4};
    const Picture rendered = take_picture(renderer, view, settings, others, 2);
    const Picture completed = as_in_window(renderer, view, settings, rendered, 2);
    settings.fill_holes = true;
    const Picture window = take_picture(renderer, view, settings, others, 2);
    std::size_t holes = 0, partial = 0;
    for (std::size_t i = 0; i < rendered.rgba.size(); i += 4) {
        const int alpha = rendered.rgba[i + 3];
        holes += alpha == 0;
        partial += alpha > 0 && alpha < 255;
        for (std::size_t c = 0; c < 4 && (alpha == 0 || alpha == 255); ++c)
            ASSERT_EQ(completed.rgba[i + c], window.rgba[i + c]) << "pixel " << i / 4;
    }
    EXPECT_GT(holes, 100u);
    EXPECT_LT(partial, rendered.rgba.size() / 4 / 50);
    EXPECT_GT(score(window, completed, std::vector<bool>(rendered.rgba.size() / 4, true)).psnr, 40);
}

TEST_F(Evaluate, WritesTablePagePicturesAndRegions) {
    copy_package(dir / "scene", {}, file);
    const PackageReader package(file);
    EvaluateOptions options;
    options.folder = dir / "evaluation";
    options.level = 2;
    options.every = 2;
    EXPECT_EQ(run_evaluate(package, options), 0);
    const std::string csv = slurp(options.folder / "photos.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4) << "a header and lines for photos 0, 2 and 4";
    for (const char* column : {",ssim_gain,", ",frame_psnr_gain,", ",frame_ssim_gain,", ",error_odd_photo"})
        EXPECT_NE(csv.find(column), csv.npos) << column;
    const std::string page = slurp(options.folder / "index.html");
    EXPECT_NE(page.find("Causes of the error"), page.npos);
    EXPECT_EQ(page.find("nan"), page.npos);
    std::size_t crops = 0;
    for (const fs::directory_entry& e : fs::directory_iterator(options.folder))
        for (const CauseRow& row : cause_table())
            if (e.path().filename().string().ends_with("-" + std::string(row.file) + ".png")) {
                ++crops;
                EXPECT_NE(page.find(e.path().filename().string()), page.npos);
            }
    EXPECT_GE(crops, 3u) << "there should be at least one crop per photo";
    for (const char* name : {"0000", "0002", "0004"})
        for (const char* kind : {"-photo.png", "-rendered.png", "-difference.png", "-causes.png"}) {
            EXPECT_TRUE(fs::exists(options.folder / (std::string(name) + kind)));
            EXPECT_NE(page.find(std::string(name) + kind), page.npos);
        }
    std::ifstream ply(options.folder / "regions.ply");
    std::string line;
    std::size_t lines = 0, header = 0;
    while (std::getline(ply, line)) {
        ++lines;
        if (line == "end_header") header = lines;
    }
    EXPECT_EQ(lines, header + package.scene().vertices + package.scene().triangles);
}

TEST_F(EvaluateAtLength, ComparesWithAnEarlierEvaluation) {
    copy_package(dir / "scene", {}, file);
    const PackageReader package(file);
    EvaluateOptions options;
    options.folder = dir / "before";
    options.level = 2;
    options.package.photos = {"0002"};
    ASSERT_EQ(run_evaluate(package, options), 0);
    options.against = options.folder;
    EXPECT_THROW(run_evaluate(package, options), Error) << "the earlier evaluation would be overwritten";
    options.folder = dir / "same";
    ASSERT_EQ(run_evaluate(package, options), 0);
    EXPECT_NE(slurp(options.folder / "index.html").find("<td>+0.00</td>"), std::string::npos);
    EXPECT_FALSE(fs::exists(options.folder / "0002-better.png") ||
                 fs::exists(options.folder / "0002-worse.png"));
    options.folder = dir / "average";
    options.blending.render.blend = Blend::average;
    ASSERT_EQ(run_evaluate(package, options), 0);
    EXPECT_TRUE(fs::exists(options.folder / "0002-worse.png"))
        << "the average blend should be worse, because it is more blurred";
    options.level = 1;
    EXPECT_THROW(run_evaluate(package, options), Error) << "of a different size";
    options.against = dir / "nowhere";
    EXPECT_THROW(run_evaluate(package, options), Error);
}

TEST_F(Evaluate, HeldOutPhotoHasNoPartInItsPicture) {
    repaint(scene.photos[1].file, paint_passer_by);
    EvaluateOptions options;
    options.level = 2;
    options.package.photos = {"0002"};
    const auto rendered = [&](const fs::path& folder) {
        fs::remove(file);
        prepare(scene, all_but_pose_refinement(), file, [](const Progress&) {});
        options.folder = folder;
        EXPECT_EQ(run_evaluate(PackageReader(file), options), 0);
        return slurp(folder / "0002-rendered.png");
    };
    const std::string before = rendered(dir / "before");
    replace_by_noise(scene.photos[2].file);
    EXPECT_EQ(rendered(dir / "noise"), before);
    EXPECT_NE(slurp(dir / "noise" / "0002-photo.png"), slurp(dir / "before" / "0002-photo.png"));
}

TEST_F(Evaluate, PictureIsThatOfAPackagePreparedWithoutThePhoto) {
    repaint(scene.photos[1].file, paint_passer_by);
    PrepareSettings settings = all_but_pose_refinement();
    prepare(scene, settings, file, [](const Progress&) {});
    EvaluateOptions options;
    options.folder = dir / "evaluation";
    options.package.photos = {"0002"};
    ASSERT_EQ(run_evaluate(PackageReader(file), options), 0);
    settings.hold_out = {"0002"};
    const fs::path without = dir / "without.vantage";
    prepare(scene, settings, without, [](const Progress&) {});
    const auto picture = [](const fs::path& package_file, bool transient_mask) {
        const PackageReader package(package_file);
        const gl::HeadlessContext context(gl::Debug::on);
        Renderer renderer(package, {});
        RenderSettings shown = render_settings(package, {}, Purpose::pictures);
        shown.fill_holes = false;
        shown.background = ShowBackground::off;  // as in evaluate
        shown.weights.transient_mask = transient_mask;
        return take_picture(renderer, view_of_level(package.photos()[2], 1), shown,
                            std::array{0u, 1u, 3u, 4u}, 2);
    };
    const Picture evaluated = read_png(options.folder / "0002-rendered.png");
    EXPECT_EQ(evaluated.rgba, picture(without, true).rgba);
    EXPECT_NE(evaluated.rgba, picture(without, false).rgba) << "the passer-by should be masked";
    EXPECT_NE(evaluated.rgba, picture(file, true).rgba)
        << "the weight maps of the full package depend on the held-out photo";
}

TEST_F(EvaluateAtLength, CamerasAreRegisteredWithoutTheHeldOutPhoto) {
    // The wrong camera is corrected by pose refinement; the held-out photo influences the correction.
    Pose& wrong = scene.photos[3].camera.cam_from_world;
    const Intrinsics k = scene.photos[3].camera.intrinsics;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(4 / k.fx, Eigen::Vector3d::UnitY()).toRotationMatrix();
    wrong.R = turn * wrong.R;
    wrong.t = turn * wrong.t;
    PrepareSettings settings;
    settings.effects[Effect::pose_refinement] = EffectChoice::on;
    const auto records = [&](const fs::path& package_file, bool without) {
        prepare(scene, settings, package_file, [](const Progress&) {});
        const PackageReader package(package_file);
        EXPECT_TRUE(effect_on(package.scene(), Effect::pose_refinement));
        std::vector<package::PhotoRecord> out(package.photos().begin(), package.photos().end());
        if (without) use_poses_without(package, 2, out);
        return out;
    };
    const auto stored = records(file, false), before = records(file, true);
    settings.hold_out = {"0002"};
    const auto held_out = records(dir / "without.vantage", false);
    const PackageReader package(file);
    const auto given = package.records<package::PoseRefinementRecord>(package::Type::pose_refinement);
    // The displacement of the photo's center in pixels.
    const auto apart = [&](const Pose& a, const Pose& b) {
        const Eigen::Vector3d x = a.R.transpose() * (Eigen::Vector3d(0, 0, stored[3].seen_distance) - a.t);
        const Eigen::Vector3d p = b.R * x + b.t;
        return k.fx * std::hypot(p.x(), p.y()) / p.z();
    };
    const auto pose = [](const auto& r) { return cam_from_origin(r[3]); };
    EXPECT_GT(apart(pose(stored), pose(given)), 3) << "the camera should have moved";
    EXPECT_GT(apart(pose(before), pose(stored)), 0) << "the photo should have influenced the pose";
    EXPECT_LT(apart(pose(before), pose(held_out)), 0.25);
    EXPECT_EQ(cam_from_origin(before[2]).t, cam_from_origin(given[2]).t)
        << "the photo should be viewed from its given camera";
}

TEST_F(EvaluateAtLength, JudgeFindsTheGainsThatThePlayerShows) {
    SynthSpec spec = close_photos();
    spec.exposure.stops = 0.3;
    copy_scene(spec, dir / "exposed");
    PrepareSettings corrected;
    corrected.effects[Effect::exposure] = EffectChoice::on;
    corrected.effects[Effect::vignetting] = EffectChoice::off;
    corrected.effects[Effect::pose_refinement] = EffectChoice::off;
    copy_package(dir / "exposed", corrected, file);
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const ColorsWithout colors(package);
    std::vector<std::uint32_t> photos(package.photos().size());
    std::iota(photos.begin(), photos.end(), 0u);
    std::vector<RegionError> regions;
    EvaluationPictures pictures;
    double gain = 0;
    for (const std::uint32_t p : photos) {
        const auto psnr = [&](bool refined) {
            RenderSettings settings;
            settings.refined_colors = refined;
            return evaluate_held_out(renderer, settings, {p, 2, photos, colors.records(p)}, regions, pictures)
                .score.psnr_gain;
        };
        gain += (psnr(true) - psnr(false)) / double(photos.size());
    }
    const auto exposure = parse_meta(package).at("effects").at(std::size_t(Effect::exposure)).at("judged");
    EXPECT_EQ(exposure.at("photos"), photos.size());
    EXPECT_GT(gain, 1) << "a difference of a third of a stop should be clearly visible";
    // Coarse pixels at silhouettes mix surfaces, which adds the same error with and without gains.
    EXPECT_GT(double(exposure.at("gain")), 0.3 * gain);
    EXPECT_LT(double(exposure.at("gain")), 1.2 * gain);
    EXPECT_LT(double(exposure.at("seams_after")), 0.9 * double(exposure.at("seams_before")));
}

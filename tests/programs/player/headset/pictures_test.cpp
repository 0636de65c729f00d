// Tests the pictures for both eyes of a headset, and their viewpoints.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/gl/context.h"
#include "player/composition/object_set.h"
#include "player/headset/runtime/eye_frustum.h"
#include "player/options/shown/blending_options.h"
#include "player/view/view.h"
#include "tests/programs/player/headset/headset_program.h"
#include "tests/programs/player/headset/seen_room.h"

using namespace vantage;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The offscreen renderer's picture of a view, rendered from thumbnails.
Picture offscreen_picture(const PackageReader& package, const View& view,
                          const std::vector<std::uint32_t>& photos, bool thumbnails) {
    BlendingOptions options;
    options.photos = 0;
    options.render.thumbnails = thumbnails;
    Renderer renderer(package, MemoryBudget{});
    return take_picture(renderer, view, render_settings(package, options, Purpose::window), photos, 1);
}

/// The pictures of two eyes, as a window renders them.
std::vector<Picture> window_pictures(const PackageReader& package, const std::vector<View>& eyes,
                                     const std::vector<std::uint32_t>& photos) {
    BlendingOptions options;
    options.photos = 0;
    options.render.thumbnails = true;
    RenderSettings settings = render_settings(package, options, Purpose::window);
    settings.loading = Loading::repeatable;
    Renderer renderer(package, MemoryBudget{});
    ObjectSet objects(renderer, {{"garden", package.path(), {}, true}}, MemoryBudget{});
    std::vector<Picture> out(2);
    for (int frame = 0; frame < 6; ++frame)
        objects.draw_eyes({eyes, settings, photos, {}, 10.0 * frame}, [&](std::size_t e) {
            out[e] = picture_of(frame_size(eyes[e]), [&](GLuint target) {
                objects.show(eyes[e], settings, {target, false, e});
            });
        });
    return out;
}

/// The number of pixels that differ, and the largest difference in 8-bit values.
struct Difference {
    std::size_t pixels = 0;
    int codes = 0;
};
Difference difference(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size()) return {a.rgba.size(), 256};
    Difference out;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a.rgba[i + c] - b.rgba[i + c]));
        out.pixels += most > 0;
        out.codes = std::max(out.codes, most);
    }
    return out;
}

/// The PSNR in dB.
double psnr(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size()) return 0;
    double squares = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) squares += std::pow(a.rgba[i] - b.rgba[i], 2);
    return -10 * std::log10(squares / double(a.rgba.size()) / (255.0 * 255));
}

/// The same view, but computed by the player's own functions, so that it is identical to the last bit.
View players_view(const package::PhotoRecord& photo, const Vector3d& up, const RoomPose& head, double scale,
                  const json& v) {
    const Pose camera = view_of_photo(photo, 1).cam_from_origin;
    const Vector3d ahead = camera.R.row(2);
    const Stance stance =
        standing(head, camera.center(), camera.center() + seen_distance(photo) * ahead, up, scale);
    const auto angle = [&](std::size_t i) { return double(v["fov"][i].get<float>()); };
    const auto frustum = eye_frustum(eye_pose(v), angle(0), angle(1), angle(2), angle(3));
    return view_of_eye(stance, *frustum, {v["rect"][2], v["rect"][3]});
}

}  // namespace

TEST_F(HeadsetProgram, ShowsToEachEyeWhatOffscreenPicturesShowToTheBit) {
    json s = scenario(40);
    s["eyes"] = {eye(160, 144, -52, 31, 47, -50, -0.032), eye(160, 144, -28, 55, 40, -53, 0.032)};
    for (const int e : {0, 1})  // canted outward
        s["eyes"][std::size_t(e)]["orientation"] = {0.0, (1 - 2 * e) * std::sin(5 * degree), 0.0,
                                                    std::cos(5 * degree)};
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Vector3d(1, 2, 0.5).normalized()));
    s["head"] = {pose({0.1, 1.5, -0.2}), pose({0.25, 1.4, 0.1}, turned)};
    s["head"][0]["frame"] = 0, s["head"][1]["frame"] = 20;
    s["save"] = {18, 38};
    for (const int frame : {14, 16, 34, 36})
        s["events"].push_back({{"frame", frame}, {"late", 180}});  // all fades in
    const Run run = play(s, "--fps 0 --max-photos 0 --thumbnails --meters-per-unit 0.5");
    expect_valid(run);
    const PackageReader package(file);
    const Room room(package.photos()[2], Vector3d::UnitZ(), {0.1, 1.5, -0.2}, 2);
    const gl::HeadlessContext context;
    const RoomPose head = head_between(run.frames.at(10)["layers"][0]["views"]);
    for (const int frame : {18, 38}) {
        const json& views = run.frames.at(std::size_t(frame - 1))["layers"][0]["views"];
        std::vector<View> exact, by_hand;
        for (const json& view : views) {
            exact.push_back(players_view(package.photos()[2], Vector3d::UnitZ(), head, 2, view));
            by_hand.push_back(room.view(view));
        }
        const std::vector<Picture> truth = window_pictures(package, exact, all(package));
        for (const std::size_t e : {0, 1}) {
            const Picture seen = saved(frame, e == 0 ? "left" : "right");
            ASSERT_EQ(seen.width, 160);
            EXPECT_EQ(difference(seen, truth[e]).codes, 0) << "frame " << frame << ", eye " << e;
            // Views computed by hand and pictures for a single eye are rounded differently.
            const Difference single =
                difference(seen, offscreen_picture(package, by_hand[e], all(package), true));
            EXPECT_LE(single.codes, 1);
            EXPECT_LT(single.pixels, 160u * 144 / 1000);
        }
    }
}

TEST_F(HeadsetProgramAtLength, FinePicturesAreThoseOfOffscreenRenderingToTheEye) {
    json s = scenario(40);
    s["save"] = {38};
    for (const int frame : {20, 34})
        s["events"].push_back({{"frame", frame}, {"late", 180}});  // all fades in
    const Run run = play(s, "--fps 0 --max-photos 0 --meters-per-unit 0.5");
    expect_valid(run);
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const json& views = run.frames.at(37)["layers"][0]["views"];
    const View view = players_view(package.photos()[2], Vector3d::UnitZ(), head_between(views), 2, views[0]);
    // Which tiles are resident depends on their order of arrival: where only a few pixels would show a tile,
    // a coarser tile stays.
    const Picture seen = saved(38, "left"), truth = offscreen_picture(package, view, all(package), false);
    EXPECT_GT(psnr(seen, truth), 45) << "dB";
}

TEST_F(HeadsetProgram, SticksTurnAndTeleportOntoTheFloor) {
    json s = scenario(90);
    s["eyes"] = {eye(97, 97, -45, 45, 45, -45, -0.032), eye(97, 97, -45, 45, 45, -45, 0.032)};
    // The user looks ahead, teleports ahead, looks down, turns by 30 degrees and looks ahead again.
    const Eigen::Quaterniond down(Eigen::AngleAxisd(-90 * degree, Vector3d::UnitX()));
    s["head"] = {pose({0, 1.6, 0}), pose({0, 1.6, 0}, down), pose({0, 1.6, 0})};
    s["head"][0]["frame"] = 0, s["head"][1]["frame"] = 40, s["head"][2]["frame"] = 60;
    const json upward = pointing({0.2, 1.2, -0.2}, {0.2, 1.2 + std::tan(35 * degree), -1.2});
    const auto stick = [&](int frame, double right, double ahead) {
        return hand(frame, "right", upward, {{"/input/thumbstick", {right, ahead}}});
    };
    const auto away = [](int frame) {  // the hand is not in the picture
        return json{{"frame", frame}, {"hand", "right"}, {"active", false}};
    };
    s["hands"] = {stick(10, 0, 0), stick(20, 0, 1), stick(26, 0, 0), away(30),
                  stick(60, 0, 0), stick(64, 1, 0), stick(70, 0, 0), away(74)};
    s["save"] = {38, 58, 88};
    for (const int frame : {34, 36, 84, 86}) s["events"].push_back({{"frame", frame}, {"late", 180}});
    const Run run = play(s, "--fps 0 --max-photos 0 --thumbnails --meters-per-unit 1");
    expect_valid(run);
    const auto distance = [&](int frame) {
        char name[40];
        std::snprintf(name, sizeof name, "%04d-left-depth.pfm", frame);
        return middle_distance(dir / "out" / name,
                               run.frames.at(std::size_t(frame - 1))["layers"][0]["views"][0]);
    };
    // The trajectory starts 1.2 m above the floor at a speed of 7.5 m/s, directed upward at 35 degrees, and
    // ends on the ground at height 0.
    const PackageReader package(file);
    Room room(package.photos()[2], Vector3d::UnitZ(), {0, 1.6, 0}, 1);
    const double ground = room.in_room({0, 0, -package.scene().origin[2]}).y();
    const double up = 7.5 * std::sin(35 * degree), g = 9.81;
    const double seconds = (up + std::sqrt(up * up + 2 * g * (1.2 - ground))) / g;
    const double thrown = 7.5 * std::cos(35 * degree) * seconds;
    EXPECT_GT(thrown, 6);
    room.at = room.in_scene({0.2, ground, -0.2 - thrown});
    const gl::HeadlessContext context;
    const View there = room.view(run.frames.at(37)["layers"][0]["views"][0]);
    EXPECT_GT(psnr(saved(38, "left"), offscreen_picture(package, there, all(package), true)), 35);
    EXPECT_NEAR(distance(58), 1.6, 0.03) << "the eyes should be 1.6 m above the ground";
    // The room is turned about the head, by 30 degrees to the right.
    room.axes = room.axes * Eigen::AngleAxisd(-30 * degree, Vector3d::UnitY()).toRotationMatrix();
    const View turned = room.view(run.frames.at(87)["layers"][0]["views"][0]);
    EXPECT_GT(psnr(saved(88, "left"), offscreen_picture(package, turned, all(package), true)), 35);
}

// Tests the depth that is passed to the compositor, and two-handed scaling of the model.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "player/view/view.h"
#include "scene/story/scene_file.h"
#include "tests/programs/player/headset/headset_program.h"
#include "tests/programs/player/headset/seen_room.h"

using namespace vantage;

TEST_F(HeadsetProgramAtLength, TwoHandsMakeTheModelTwiceAsLarge) {
    json s = scenario(60);
    s["eyes"] = {eye(97, 97, -45, 45, 45, -45, -0.032), eye(97, 97, -45, 45, 45, -45, 0.032)};
    const auto at = [&](int frame, const char* which, double x, bool closed) {
        return hand(frame, which, pointing({x, 1.6, 0}, {x, 1.6, -3}),
                    {{"/input/squeeze/value", closed ? 1 : 0}});
    };
    s["hands"] = {at(10, "left", -0.2, false), at(10, "right", 0.2, false), at(20, "left", -0.2, true),
                  at(20, "right", 0.2, true),  at(30, "left", -0.4, true),  at(30, "right", 0.4, true),
                  at(40, "left", -0.4, false), at(40, "right", 0.4, false)};
    s["save"] = {18, 58};
    const Run run = play(s, "--fps 0 --meters-per-unit 1");
    expect_valid(run);
    const double before =
        middle_distance(dir / "out" / "0018-left-depth.pfm", run.frames[17]["layers"][0]["views"][0]);
    const double after =
        middle_distance(dir / "out" / "0058-left-depth.pfm", run.frames[57]["layers"][0]["views"][0]);
    EXPECT_NEAR(after / before, 2, 0.01)
        << "the model should be scaled about the midpoint of the hands, where the eyes are";
}

TEST_F(HeadsetProgramAtLength, HandsOverTheDepthOfTheNearestObject) {
    const PackageReader package(file);
    const package::PhotoRecord& photo = package.photos()[2];
    const std::vector<Corners> mesh = triangles_of(make_plan_scene(package));
    // The second object is the same package, placed nearer to the viewer and to one side.
    const Eigen::Matrix3d axes = view_of_photo(photo, 1).cam_from_origin.R;
    const Vector3d moved = seen_distance(photo) * (0.2 * axes.row(0) - 0.3 * axes.row(2)).transpose();
    SceneObject other{"second", file, {}};
    other.placement.move = moved;
    file = dir / "both.toml";
    write_scene_file(file, {{"first", dir / package.path().filename(), {}}, other});
    json s = scenario(20);
    s["save"] = {18};
    const Run run = play(s, "--fps 0 --meters-per-unit 1");
    expect_valid(run);
    const json& submitted = run.frames[17]["layers"][0]["views"][0];
    const View view = Room(photo, Vector3d::UnitZ(), {0, 1.6, 0}, 1).view(submitted);
    int of_first = 0, of_second = 0;
    for (int y = 6; y < 108; y += 12)
        for (int x = 6; x < 96; x += 12) {
            const double first = distance_by_hand(view, x, y, mesh),
                         second = distance_by_hand(view, x, y, mesh, moved), truth = std::min(first, second);
            if (!std::isfinite(truth)) continue;
            ++(first < second ? of_first : of_second);
            EXPECT_NEAR(distance_at(dir / "out" / "0018-left-depth.pfm", submitted, x, y), truth,
                        0.02 * truth)
                << x << ", " << y;
        }
    EXPECT_GT(of_first, 3);
    EXPECT_GT(of_second, 3);
}

// Tests the menu in a headset as a visitor would use it: tours, measurements, settings.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "player/headset/menu_place.h"
#include "player/headset/runtime/eye_frustum.h"
#include "player/view/view.h"
#include "scene/story/story_file.h"
#include "tests/headset/menu_alone.h"
#include "tests/programs/player/headset/headset_program.h"
#include "tests/programs/player/headset/seen_room.h"

using namespace vantage;

namespace {

/// Actions of the right hand, frame by frame, with a headset at (0, 1.6, 0) that looks ahead.
struct Script {
    static constexpr int hold = 2;  ///< number of frames for which a button is held down, and then released
    json hands = json::array();
    int frame = 6;
    const Vector3d from{0.15, 1.3, -0.1};
    const MenuPlace menu = menu_in_front_of({Eigen::Quaterniond::Identity(), {0, 1.6, 0}});

    void press(const Vector3d& at, const char* button) {
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(false) : json(0)}}));
        frame += hold;
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(true) : json(1)}}));
        frame += hold;
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(false) : json(0)}}));
        frame += hold;
    }
    void open_or_close_menu() { press({0, 0, -5}, menu_button); }
    void select(const Vector3d& at) { press(at, "/input/trigger/value"); }
    /// Clicks a position on the menu, in panel pixels.
    void click(const Eigen::Vector2d& pixel) {
        const Panel panel = menu_panel(menu, {}, SceneInterface::width, SceneInterface::height);
        select(point_on(panel, pixel));
    }
    static constexpr const char* menu_button = "/input/b/click";
};

/// The centers of the menu's controls by name, read from a file of controls.
std::vector<std::pair<std::string, Eigen::Vector2d>> controls_in(const std::string& text) {
    std::vector<std::pair<std::string, Eigen::Vector2d>> out;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);  // the frame's number
    while (std::getline(lines, line)) {
        const auto tab = line.find('\t');
        double x = 0, y = 0, w = 0, h = 0;
        std::istringstream(line.substr(tab)) >> x >> y >> w >> h;
        const Eigen::Vector2d middle(x + std::min(w / 2, 60.0), y + h / 2);
        if (middle.x() < SceneInterface::width && middle.y() < SceneInterface::height)
            out.emplace_back(line.substr(0, tab), middle);
    }
    return out;
}

/// The centers of up to `wanted` triangles that are spread over the mesh, visible from a position, and
/// between two given distances from that position.
std::vector<Vector3d> seen_middles(const PlanScene& scene, const Vector3d& from, double nearest,
                                   double farthest, std::size_t wanted) {
    const std::vector<Corners> mesh = triangles_of(scene);
    std::vector<Vector3d> out;
    for (std::size_t i = 0; i < mesh.size() && out.size() < wanted; i += 37) {
        const Vector3d middle = (mesh[i][0] + mesh[i][1] + mesh[i][2]) / 3, along = middle - from;
        if (along.norm() < nearest || along.norm() > farthest) continue;
        double first = std::numeric_limits<double>::infinity();
        for (const Corners& c : mesh) first = std::min(first, meets(from, along, c));
        if (std::abs(first - 1) < 1e-9 && (out.empty() || (middle - out.back()).norm() > 0.5))
            out.push_back(middle);
    }
    return out;
}

}  // namespace

TEST_F(HeadsetProgramAtLength, TakesAVisitorFromStopToStopOfATour) {
    const PackageReader package(file);
    const std::vector<Corners> mesh = triangles_of(make_plan_scene(package));
    const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
    const auto looking = [&](std::size_t p) {
        const Pose camera = view_of_photo(package.photos()[p], 1).cam_from_origin;
        return StoryView{
            camera.center() + origin,
            camera.center() + origin + camera.R.row(2).transpose() * seen_distance(package.photos()[p])};
    };
    const std::array<StoryView, 2> stops{looking(0), looking(4)};
    Story story;
    story.notes = {{"gate", {"Gate", {}}, {"Of iron.", {}}, "", stops[1], {}}};
    story.tours = {{"round", {"Round", {}}, {{"", stops[0], 0.15, 0.3}, {"gate", {}, 0.15, 0.3}}}};
    write_story(story_file_of(file), story);
    MenuAlone menu(file, 1);
    Script script;
    script.open_or_close_menu();
    for (const char* name : {"Page Story", "Play Round"}) {
        script.click(menu.place(name));
        menu.press(name);
    }
    menu.active.open = 0;
    menu.frames(2);
    const std::array<int, 2> at{script.frame + 20, script.frame + 20 + 40};
    const auto played = [&](const Script& with) {
        json s = scenario(with.frame + 4);
        s["hands"] = with.hands;
        s["save"] = at;
        const Run run = play(s, "--fps 0 --meters-per-unit 1 --max-photos 1 --thumbnails --controls " +
                                    (dir / "controls").string());
        expect_valid(run);
        return run;
    };
    const auto has = [&](const std::string& name) {
        const auto controls = controls_in(slurp(dir / "controls"));
        return std::ranges::any_of(controls, [&](const auto& c) { return c.first == name; });
    };
    // The last stop's card stays open after the tour.
    Script whole = script;
    whole.frame = at[1] + 30;
    whole.click(menu.place("All notes"));
    const Run run = played(whole);
    EXPECT_TRUE(has("Play Round"));
    for (const std::size_t stop : {0, 1}) {
        const json& views = run.frames[std::size_t(at[stop]) - 1]["layers"][0]["views"];
        const Stance stance = standing(head_between(views), stops[stop].eye - origin,
                                       stops[stop].target - origin, Vector3d::UnitZ(), 1);
        const auto angle = [&](std::size_t i) { return double(views[0]["fov"][i].get<float>()); };
        const View view = view_of_eye(
            stance, *eye_frustum(eye_pose(views[0]), angle(0), angle(1), angle(2), angle(3)), {96, 108});
        char name[32];
        std::snprintf(name, sizeof name, "%04d-left-depth.pfm", at[stop]);
        int right = 0, all = 0;
        for (int y = 6; y < 108; y += 16)
            for (int x = 6; x < 96; x += 16) {
                const double truth = distance_by_hand(view, x, y, mesh);
                if (!std::isfinite(truth)) continue;
                ++all;
                right += std::abs(distance_at(dir / "out" / name, views[0], x, y) - truth) < 0.02 * truth;
            }
        EXPECT_GT(all, 8);
        EXPECT_GE(right, all - 2) << "stop " << stop << ": except at outlines";
    }
    // Flying away ends the tour before its note appears.
    for (const int y : {0, 1, 0}) {
        script.frame += 6;
        script.hands.push_back(hand(script.frame, "left", pointing({-0.2, 1.3, -0.1}, {-3, 1.3, -0.1}),
                                    {{"/input/thumbstick", {0, y}}}));
    }
    script.frame = at[1];
    played(script);
    EXPECT_TRUE(has("Play Round"));
}

TEST_F(HeadsetProgramAtLength, MeasuresBetweenTwoPointsToAMillimeter) {
    const PackageReader package(file);
    const PlanScene scene = make_plan_scene(package);
    const Room room(package.photos()[2], Vector3d::UnitZ(), {0, 1.6, 0}, 1);
    Script script;
    const auto points = seen_middles(scene, room.in_scene(script.from), 3, 20, 2);
    ASSERT_EQ(points.size(), 2u);
    script.open_or_close_menu();
    script.click(MenuAlone(file, 1).place("Page Measure"));
    script.open_or_close_menu();
    for (const Vector3d& p : points) script.select(room.in_room(p));
    json s = scenario(script.frame + 4);
    s["hands"] = script.hands;
    expect_valid(play(s, "--meters-per-unit 1"));
    const json survey = json::parse(slurp(fs::path(file).replace_extension(".measurements.json")));
    ASSERT_EQ(survey["measurements"].size(), 1u) << survey;
    const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
    for (const std::size_t i : {0, 1}) {
        const json& p = survey["measurements"][0]["points"][i]["position"];
        const Vector3d set(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
        EXPECT_LT((set - origin - points[i]).norm(), 0.001) << "point " << i;
    }
}

TEST_F(HeadsetProgramAtLength, EveryEntryOfTheMenuCanBePressed) {
    std::size_t pressed = 0;
    for (const auto& [page, at] : MenuAlone(file).places()) {
        if (!page.starts_with("Page ")) continue;
        MenuAlone menu(file);
        menu.press(page);
        Script script;
        script.open_or_close_menu();
        script.click(at);
        for (const auto& [name, place] : menu.places()) {
            if (name.starts_with("Page ") || name == "Leave" || name == "Tooltip") continue;
            script.click(place);
            ++pressed;
        }
        json s = scenario(script.frame + 4);
        s["hands"] = script.hands;
        expect_valid(play(s));
    }
    EXPECT_GT(pressed, 40u) << "those that apply";
}

TEST_F(HeadsetProgram, TheMenuDoesWhatItSays) {
    MenuAlone menu(file, 1);
    std::size_t pressed = 0, changed = 0;
    for (const auto& [page, at] : menu.places()) {
        if (!page.starts_with("Page ")) continue;
        menu.press(page);
        EXPECT_TRUE(menu.has(page)) << "all pages should stay selectable";
        std::set<std::string> done{"Leave", "Tooltip"};
        const auto next = [&] {  // a control may show others
            for (const auto& [name, place] : menu.places())
                if (!name.starts_with("Page ") && done.insert(name).second) return name;
            return std::string();
        };
        for (std::string name = next(); !name.empty(); name = next()) {
            const RenderSettings before = menu.session.settings;
            const auto photos = menu.session.photos;
            const auto shown = menu.places();
            menu.press(name);
            if (menu.popup_open) {  // a list: choose its last entry
                std::string entry = name;
                for (const auto& [other, at_other] : menu.places())
                    if (std::ranges::count(shown, other, [](const auto& c) { return c.first; }) == 0)
                        entry = other;
                menu.press(entry);
            }
            EXPECT_FALSE(menu.popup_open) << name;
            ++pressed;
            changed += !(before == menu.session.settings && photos == menu.session.photos);
        }
    }
    EXPECT_GT(pressed, 55u);
    EXPECT_GT(changed, 20u);
    menu.press("Page Move");
    menu.press("90");
    EXPECT_EQ(menu.locomotion.snap_degrees, 90);
    EXPECT_FALSE(holds<Quit>(menu.session.window.commands));
    menu.press("Leave");
    EXPECT_TRUE(holds<Quit>(menu.session.window.commands));
}

TEST_F(HeadsetProgram, LeavesByTheMenu) {
    Script script;
    script.open_or_close_menu();
    script.click(MenuAlone(file).place("Leave"));
    json s = scenario(10000);
    s["hands"] = script.hands;
    const Run run = play(s);
    expect_valid(run);
    EXPECT_LT(run.frames.size(), 200u);
}

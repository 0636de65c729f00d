// Every control of the window changes its setting, and the result is drawn without OpenGL errors.
#include <fmt/format.h>

#include <array>
#include <set>

#include "player/render/passes/blend_table.h"
#include "scene/story/scene_file.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowControls : public WindowTest {
  protected:
    /// Makes the window tall enough for all groups, and shows all controls.
    static void open_all(HeadlessWindow& w) {
        w.resize(1200, 3000);
        w.press("Bar Expert");
        EXPECT_TRUE(w.session.window.panels.expert);
        const std::vector<Controls::Place> places = w.controls.places();
        for (const Controls::Place& p : places)
            if (p.name.starts_with("More ")) w.press(p.name);
    }
    template <class Value>
    static void changes(HeadlessWindow& w, const std::string& name, const Value& value, double share = 0.5) {
        const Value before = value;
        w.press(name, share);
        EXPECT_NE(value, before) << name;
        w.draw();
    }
    /// Toggles a checkbox twice.
    static void toggles(HeadlessWindow& w, const std::string& name, const bool& value) {
        const bool before = value;
        w.press(name);
        EXPECT_EQ(value, !before) << name;
        w.draw();
        w.press(name);
        EXPECT_EQ(value, before) << name << ", again";
    }
    /// Chooses each entry of a list, the first entry last.
    template <class Enum>
    static void chooses(HeadlessWindow& w, const char* list, const Enum& value,
                        const std::vector<const char*>& entries) {
        for (std::size_t i = entries.size(); i-- > 0;) {
            w.choose(list, entries[i]);
            EXPECT_EQ(int(value), int(i)) << list << ": " << entries[i];
            w.draw();
        }
    }
};
class WindowControlsAtLength : public WindowControls {};

}  // namespace

TEST_F(WindowControls, OfBlending) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    open_all(w);
    RenderSettings& s = w.session.settings;
    WeightSettings& weights = s.weights;
    for (const BlendRow& row : blend_table()) {
        w.choose("Mode", row.label);
        EXPECT_EQ(s.blend, row.blend) << row.label;
    }
    EXPECT_FALSE(w.there("Sharpness") || w.there("Soft borders")) << "these do not apply to Best photo";
    w.choose("Mode", "Lumigraph");
    changes(w, "Sharpness", weights.sharpness, 0.6);
    for (const char* name : {"Prefer near", "Near photos", "Facing photos", "Field of view"})
        EXPECT_FALSE(w.there(name)) << name << " only applies to Average";
    w.choose("Mode", "Average");
    changes(w, "Prefer near", weights.exponent, 0.3);
    EXPECT_GT(weights.exponent, 5);
    EXPECT_LT(weights.exponent, 25) << "of 32";
    toggles(w, "Reject outliers", s.transients);
    toggles(w, "Fill holes", s.fill_holes);
    toggles(w, "Near photos", weights.distance);
    toggles(w, "Facing photos", weights.angle_weight);
    toggles(w, "Similar rays", weights.angle);
    toggles(w, "Occlusion", weights.depth_weight);
    toggles(w, "Soft borders", weights.border_weight);
    toggles(w, "Field of view", weights.fov_normalization);
    EXPECT_FALSE(w.there("Aim at visible part"));
    w.press("One ray per photo");
    EXPECT_TRUE(weights.angle_per_photo);
    toggles(w, "Aim at visible part", weights.corrected_directions);
    w.press("One ray per photo");
    EXPECT_FALSE(weights.angle_per_photo);
    EXPECT_FALSE(w.there("Passers-by")) << "this scene has none";
    w.press("Freeze weights");
    EXPECT_TRUE(s.weights_from);
    w.press("Freeze weights");
    EXPECT_FALSE(s.weights_from);
    chooses(w, "Select by", s.choice, {"cover the view", "nearest"});
    w.press("Photos", 0.02);
    EXPECT_EQ(s.photos, 1);
    w.press("Photos", 0.7);
    EXPECT_GE(s.photos, 4) << "of 5";
    changes(w, "Angle limit", s.angle_limit, 0.3);
    EXPECT_GT(s.angle_limit, 60);
    EXPECT_LT(s.angle_limit, 120) << "range 10 to 180 degrees";
    chooses(w, "Coordinates", s.coordinates, {"as the scene requires", "per vertex", "per fragment"});
}

TEST_F(WindowControls, OfThePicture) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    open_all(w);
    RenderSettings& s = w.session.settings;
    chooses(w, "Show", s.show, {"photos", "which photo", "how many photos"});
    chooses(w, "Light", s.light.light, {"the photos' own", "lamp at the viewer", "raking light", "normals"});
    EXPECT_FALSE(w.there("On the photos") || w.there("Lamp height")) << "these do not apply without a light";
    EXPECT_FALSE(w.there("Transparency") || w.there("Point size") || w.there("Image set"));
    w.choose("Light", "raking light");
    toggles(w, "On the photos", s.light.on_photos);
    toggles(w, "Triangles", s.light.wireframe);
    changes(w, "Lamp azimuth", s.light.azimuth, 0.2);
    changes(w, "Lamp height", s.light.elevation, 0.1);
    w.choose("Light", "the photos' own");
    w.press("Photo 2");
    w.wait(1);
    EXPECT_EQ(s.compare_photo, w.session.viewpoint.standing_at);
    chooses(w, "Compare", s.compare, {"nothing", "side by side", "swipe", "difference"});
    w.choose("Compare", "swipe");
    const Eigen::Vector2d before = w.place("Swipe");
    w.point_at(before);
    w.drag(0, 60, 0);
    EXPECT_NEAR(w.place("Swipe").x(), before.x() + 60, 0.51);
    w.choose("Compare", "nothing");
    chooses(w, "Stereo", w.session.stereo.mode,
            {"off", "side by side", "above each other", "red and cyan glasses", "checkerboard"});
    EXPECT_FALSE(w.there("Eye separation"));
    w.choose("Stereo", "side by side");
    changes(w, "Eye separation", w.session.stereo.eyes.share, 0.5);
    w.choose("Stereo", "off");
    changes(w, "Flying speed", w.session.movement.flying_speed, 0.1);
    toggles(w, "Inertia", w.session.movement.inertia);
}

TEST_F(WindowControls, OfMenus) {
    HeadlessWindow w(copy_of(WindowScene::tiny));
    w.press("Bar Expert");
    Panels& p = w.session.window.panels;
    const auto toggled = [&](const char* entry, const bool& value) {
        for (const bool wanted : {!value, bool(value)}) {
            w.choose("View", entry);
            EXPECT_EQ(value, wanted) << entry;
        }
    };
    toggled("Orthographic", w.session.viewpoint.orthographic);
    toggled("Photo strip", p.photos);
    toggled("Cameras in the scene", p.frusta);
    toggled("Radar", p.radar);
    toggled("Measure", p.measure);
    toggled("Notes and tours", p.story);
    toggled("Edit the story", p.story_editor);
    toggled("Full screen", w.session.window.full_screen);
    w.choose("View", "Larger text");
    EXPECT_GT(w.session.window.text_scale, 1);
    w.choose("View", "Smaller text");
    EXPECT_FLOAT_EQ(w.session.window.text_scale, 1);
    w.session.movement.near_photos = false;
    for (const char* side :
         {"From the front", "From the back", "From the left", "From the right", "From the top"}) {
        const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
        w.choose("View", side);
        w.wait(1);
        EXPECT_GT((w.session.viewpoint.camera.eye - eye).norm(), 1) << side;
    }
    EXPECT_LT(w.session.viewpoint.camera.R(2, 2), -0.99) << "the top view points down";
    w.choose("View", "Home");
    w.wait(1);
    EXPECT_EQ(w.session.viewpoint.camera.eye, w.session.viewpoint.home.eye);
    w.choose("Path", "Record");
    EXPECT_TRUE(w.session.path.recording);
    w.wait(1);
    w.choose("Path", "Record");
    EXPECT_FALSE(w.session.path.recording);
    EXPECT_TRUE(std::filesystem::exists(dir / "one-0001.path"));
    w.choose("Path", "Replay");
    EXPECT_TRUE(w.session.viewpoint.flight);
    w.choose("Help", "Mouse and keys");
    EXPECT_TRUE(w.there("Mouse, fingers and keys"));
    w.choose("File", "Screenshot");
    EXPECT_TRUE(take<SaveScreenshot>(w.session.window.commands));
    w.choose("File", "Open...");
    EXPECT_TRUE(w.there("File name"));
    w.press("Cancel");
    EXPECT_FALSE(w.there("File name"));
    w.choose("File", "Copy view");
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    w.key(GLFW_KEY_N);
    w.wait(1);
    w.choose("File", "Paste view");
    w.wait(1);
    EXPECT_LT((w.session.viewpoint.camera.eye - eye).norm(), 1e-3);
    w.choose("File", "Quit");
    EXPECT_TRUE(take<Quit>(w.session.window.commands));
}

TEST_F(WindowControls, OfTheBarAndTheRadar) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    toggles(w, "Bar Photos", w.session.window.panels.photos);
    toggles(w, "Bar Help", w.session.window.panels.help);
    toggles(w, "Bar Full screen", w.session.window.full_screen);
    toggles(w, "Bar Expert", w.session.window.panels.expert);
    w.press("Bar Compare");
    w.wait(1);
    EXPECT_EQ(w.session.settings.compare, Compare::swipe);
    EXPECT_TRUE(w.there("Swipe"));
    w.press("Bar Compare");
    EXPECT_EQ(w.session.settings.compare, Compare::nothing);
    const LightSettings& light = w.session.settings.light;
    EXPECT_FALSE(w.there("Lamp"));
    w.press("Bar Light");
    EXPECT_EQ(light.light, Light::raking);
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    const Area& free = w.session.window.free;
    const Eigen::Vector2d middle(free.left + free.width / 2, free.top + free.height / 2),
        lamp = w.place("Lamp");
    w.point_at(lamp);
    w.drag(0, 2 * (middle - lamp).x(), 0);
    EXPECT_NEAR(light.azimuth, 45, 1) << "the lamp is dragged from the left to the right";
    EXPECT_NEAR(light.elevation, 15, 1);
    w.point_at(middle);
    w.drag(0, 0, 0.3 * free.height);
    EXPECT_NEAR(light.azimuth, 45, 1) << "other drags orbit the model";
    EXPECT_NE(w.session.viewpoint.camera.eye, eye);
    w.wait(2);
    const Eigen::Vector3d orbited = w.session.viewpoint.camera.eye;
    ImGui::GetIO().KeyShift = true;
    w.point_at(middle);
    w.drag(0, 0, 0.3 * free.height);
    ImGui::GetIO().KeyShift = false;
    EXPECT_NEAR(light.azimuth, 270, 1) << "from below";
    EXPECT_EQ(w.session.viewpoint.camera.eye, orbited);
    w.press("Bar Light");
    EXPECT_EQ(light.light, Light::photos);
    for (const ShowBackground background : {ShowBackground::off, ShowBackground::on}) {
        w.press("Bar Only the object");
        EXPECT_EQ(w.session.settings.background, background);
    }
    // Each camera is on the map, and clicks up to a few pixels away select it.
    w.key(GLFW_KEY_F6);
    std::set<std::uint32_t> flown;
    const Controls::Place map = *w.find("Radar map");
    for (float y = map.low.y + 5; y < map.high.y; y += 12)
        for (float x = map.low.x + 5; x < map.high.x; x += 12) {
            w.point_at({double(x), double(y)});
            w.frames();
            w.click();
            if (w.session.viewpoint.flight) flown.insert(w.session.viewpoint.standing_at);
            w.session.viewpoint.flight.reset();
        }
    EXPECT_EQ(flown.size(), 5u);
    w.wait(1);
    w.press("Bar Home");
    w.wait(1);
    EXPECT_EQ(w.session.viewpoint.camera.eye, w.session.viewpoint.home.eye);
}

TEST_F(WindowControlsAtLength, OfBackgroundGlassLayersAndPoints) {
    HeadlessWindow w(package_of(WindowScene::garden));
    open_all(w);
    RenderSettings& s = w.session.settings;
    chooses(w, "Background", s.background, {"shown", "dimmed", "hidden"});
    chooses(w, "Transparency", s.transparency, {"exact", "approximate", "hidden"});
    w.choose("Field", "height");
    ASSERT_GE(s.field.index, 0);
    w.press("More Scalar fields");
    chooses(w, "Colors", s.field.map, {"automatic", "viridis", "magma", "cividis", "coolwarm"});
    changes(w, "Over photos", s.field.share, 0.3);
    changes(w, "Isolines", s.field.isolines, 0.3);
    toggles(w, "Logarithmic", s.field.logarithmic);
    w.press("Lowest", 0.2);
    ASSERT_TRUE(s.field.range);
    EXPECT_LT(s.field.range->low, s.field.range->high);
    w.press("Highest", 0.5);
    w.press("Whole range");
    EXPECT_FALSE(s.field.range);
    w.choose("Field", "none: photos only");
    EXPECT_EQ(s.field.index, -1);
    w.choose("Points", "hidden");
    EXPECT_FALSE(s.points.show);
    EXPECT_FALSE(w.there("Point size"));
    w.choose("Points", "alone");
    EXPECT_TRUE(s.points.show && s.points.alone);
    w.choose("Points", "with the model");
    EXPECT_TRUE(s.points.show && !s.points.alone);
    w.choose("Colors of points", "the photos'");
    EXPECT_EQ(s.points.color, PointColor::photos);
    w.choose("Colors of points", "their own");
    EXPECT_EQ(s.points.color, PointColor::own);
    chooses(w, "Point size by", s.points.by, {"fill gaps", "pixels", "input units"});
    changes(w, "Point size", s.points.size, 0.4);
    changes(w, "Eye-dome shading", s.points.eye_dome, 0.1);
    changes(w, "Million points", s.points.budget, 0.1);
}

TEST_F(WindowControls, OfImageSets) {
    HeadlessWindow w(package_of(WindowScene::image_sets));
    open_all(w);
    ImageSetSettings& b = w.session.settings.image_sets;
    w.choose("Image set", "infrared: 4 photos");
    EXPECT_EQ(w.scene().image_sets[b.shown].name, "infrared");
    EXPECT_TRUE(w.there("Photo 4"));
    EXPECT_FALSE(w.there("Photo 5")) << "this photo belongs to another image set";
    w.choose("Second image set", "visible");
    ASSERT_TRUE(b.other);
    EXPECT_EQ(w.scene().image_sets[*b.other].name, "visible");
    EXPECT_TRUE(w.there("Photo 9"));
    changes(w, "Share of the second", b.share, 0.25);
    EXPECT_FALSE(w.there("Divided at"));
    chooses(w, "Together", b.how, {"cross-fade", "beside each other", "divided"});
    w.choose("Together", "divided");
    changes(w, "Divided at", b.swipe, 0.2);
    const std::uint32_t shown = b.shown;
    w.key(GLFW_KEY_X);
    EXPECT_NE(b.shown, shown);
    EXPECT_EQ(b.other, shown) << "they swap";
    w.key(GLFW_KEY_X);
    EXPECT_EQ(b.shown, shown);
    w.choose("Compare", "swipe");
    EXPECT_EQ(b.how, ImageSetView::mix) << "one comparison at a time";
}

TEST_F(WindowControls, OfObjects) {
    const std::filesystem::path package = copy_of(WindowScene::tiny);
    SceneObject right{"right", package, {}, true};
    right.placement.move = {9, 0, 0};
    HeadlessWindow w(package, {}, {{"left", package, {}, true}, right});
    open_all(w);
    auto saved = [&, number = 0]() mutable {
        w.press("Save scene");
        const auto file = dir / fmt::format("scene-{:04}.toml", ++number);
        written(w, file, "right");
        w.wait(0.1);
        return read_scene_file(file, SceneUse::show);
    };
    std::vector<SceneObject> objects = saved();
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects[1].placement.move, Eigen::Vector3d(9, 0, 0));
    w.press("Only right");
    w.press("left");
    w.press("left");
    w.press("Opacity of right", 0.3);
    w.press("Position of right");
    const std::array axes{"x", "y", "z"};
    for (const char* axis : axes) w.press(fmt::format("Move {} of right", axis), 0.4);
    for (const char* axis : axes) w.press(fmt::format("Turn {} of right", axis), 0.2);
    w.press("Scale of right", 0.2);
    objects = saved();
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_FALSE(objects[0].shown) << "only the object on the right is shown";
    EXPECT_TRUE(objects[1].shown);
    EXPECT_EQ(objects[0].opacity, 1);
    EXPECT_LT(objects[1].opacity, 0.7);
    EXPECT_NE(objects[1].placement.scale, 1);
    for (const int axis : {0, 1, 2}) {
        EXPECT_NE(objects[1].placement.move[axis], axis == 0 ? 9 : 0) << axis;
        EXPECT_NE(objects[1].placement.turn[axis], 0) << axis;
    }
    w.press("Remove right");
    EXPECT_FALSE(w.there("Remove right"));
    w.key(GLFW_KEY_F10);
    EXPECT_FALSE(w.there("Save scene"));
}

TEST_F(WindowControls, OfACut) {
    HeadlessWindow w(copy_of(WindowScene::tiny));
    open_all(w);
    EXPECT_FALSE(w.there("Cut at") || w.there("Export section"));
    Cut& cut = w.session.cut;
    w.press("Cut the model");
    ASSERT_TRUE(cut.on);
    EXPECT_EQ(w.session.settings.sections.size(), 1u);
    chooses(w, "Across", cut.across, {"my view", "x", "y", "z"});
    w.choose("Across", "x");
    w.session.viewpoint.camera.up = {0, 0, -1};
    w.choose("Across", "z");
    EXPECT_TRUE(cut.other_side) << "z points down: what is in front of the plane is below it";
    w.press("Other side");
    changes(w, "Cut at", cut.share, 0.2);
    toggles(w, "Other side", cut.other_side);
    chooses(w, "Cut by", cut.by, {"a plane", "a box"});
    w.choose("Cut by", "a box");
    for (const std::size_t axis : {0, 1, 2}) {
        const char name = char('x' + axis);
        changes(w, fmt::format("{} from", name), cut.low[axis], 0.2);
        changes(w, fmt::format("{} to", name), cut.high[axis], 0.5);
        EXPECT_LT(cut.low[axis], cut.high[axis]);
    }
    EXPECT_EQ(w.session.settings.sections.size(), 6u);
    w.press("Whole model");
    EXPECT_EQ(cut.low, (std::array<double, 3>{0, 0, 0}));
    EXPECT_EQ(cut.high, (std::array<double, 3>{1, 1, 1}));
    w.press("Cut the model");
    EXPECT_TRUE(w.session.settings.sections.empty());
}

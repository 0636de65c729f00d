// The window's controls fit at every size and text scale, and in every language.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/translation.h"
#include "scene/story/story_file.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

/// Lists faults: controls of the bar, the menu and the strip's first photos that extend beyond the window or
/// overlap, and controls of the sidebar that are wider than its headers. The sidebar scrolls vertically.
std::string misplaced(const HeadlessWindow& w, float width, float height) {
    std::string out;
    std::vector<Controls::Place> checked;
    float side = 0;
    ImVec2 heading;  // the lower right corner of its text
    for (const Controls::Place& p : w.controls.places()) {
        const bool in_view = p.name.starts_with("Bar ") || p.name == "Photo 1" || p.name == "Photo 2" ||
                             p.name == "File" || p.name == "View" || p.name == "Path" || p.name == "Help";
        if (in_view) {
            if (p.low.x < -1 || p.low.y < -1 || p.high.x > width + 1 || p.high.y > height + 1)
                out += p.name + " is cut off; ";
            for (const Controls::Place& q : checked)
                if (p.low.x < q.high.x - 1 && q.low.x < p.high.x - 1 && p.low.y < q.high.y - 1 &&
                    q.low.y < p.high.y - 1)
                    out += p.name + " covers " + q.name + "; ";
            checked.push_back(p);
        } else if (p.name.starts_with("Section ")) {
            side = p.high.x;
            heading = ImVec2(p.low.x + ImGui::CalcTextSize(tr(p.name.c_str() + 8)).x, p.high.y);
        } else if ((p.name.starts_with("Reset ") || p.name.starts_with("More ")) && p.low.x < heading.x &&
                   p.low.y < heading.y) {
            out += p.name + " covers the heading; ";
        } else if (side > 0 && !p.name.starts_with("Photo ") && p.name != "Lamp" && p.high.x > side + 1) {
            out += p.name + " is wider than the sidebar; ";
        }
    }
    return out;
}

/// Shows all controls of the sidebar, with a Reset in every group.
void open_all_groups(HeadlessWindow& w) {
    Panels& p = w.session.window.panels;
    p.expert = p.picture = p.photo_list = p.blending = p.fields = p.points = p.image_sets = p.objects =
        p.surveying = p.movement = p.status = true;
    Session& s = w.session;
    s.settings.light.wireframe = s.settings.weights.angle_per_photo = true;
    s.settings.blend = Blend::average;
    s.settings.show = Show::sources;
    s.settings.points.size = s.movement.flying_speed = 3;
    s.settings.image_sets.share = 0.5;
}

/// The sidebar's controls, without headings.
std::vector<std::string> controls_of_sidebar(const HeadlessWindow& w) {
    std::vector<std::string> out;
    const ImVec2 low = w.find("Section Picture")->low, high = w.find("Section Status")->high;
    for (const Controls::Place& p : w.controls.places())
        if (p.low.y > low.y && p.high.x <= high.x && w.find("Bar Home")->low.y > p.high.y &&
            !p.name.starts_with("Section ") && !p.name.starts_with("More ") && !p.name.starts_with("Photo "))
            out.push_back(p.name);
    return out;
}

void press_every_more(HeadlessWindow& w) {
    const std::vector<Controls::Place> places = w.controls.places();
    for (const Controls::Place& p : places)
        if (p.name.starts_with("More ")) w.press(p.name);
}

/// The place of a panel whose name contains a text.
ImRect rect_of(const char* text) {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && std::string_view(window->Name).find(text) != std::string_view::npos)
            return window->Rect();
    ADD_FAILURE() << "no panel has the name " << text;
    return {};
}

class WindowSizes : public WindowTest {};

}  // namespace

TEST_F(WindowSizes, FitInEveryLanguageAndTextScale) {
    for (const char* language : {"en", "de", "fr"})
        for (const double scale : {1.0, 1.5, 2.0}) {
            ShowOptions options;
            options.window.language = language;
            options.window.text_scale = scale;
            HeadlessWindow w(package_of(WindowScene::tiny), options);
            // Larger text scales are meant for larger screens.
            for (const auto& [width, height] :
                 {std::pair{800, 600}, std::pair{600, 1000}, std::pair{1920, 1080}, std::pair{3840, 2160}}) {
                if (scale > 1.5 && width < 1920) continue;
                if (width == 800) open_all_groups(w), w.key(GLFW_KEY_TAB);
                w.resize(width, height);
                for (const bool expert : {true, false}) {
                    w.key(GLFW_KEY_TAB);
                    EXPECT_EQ(w.session.window.panels.expert, expert);
                    EXPECT_EQ(misplaced(w, float(width), float(height)), "") << fmt::format(
                        "{} x {}, text {}, {}, expert {}", width, height, scale, language, expert);
                    ASSERT_TRUE(w.there("Bar Home") && w.there("Photo 1"));
                    EXPECT_LT(w.find("Bar Home")->low.y - w.find("Photo 1")->high.y, 1.5 * 14 * scale)
                        << "an empty strip between the photos and the bar";
                }
            }
        }
}

TEST_F(WindowSizes, EverySectionFitsTheSidebar) {
    for (const WindowScene scene : {WindowScene::garden, WindowScene::image_sets, WindowScene::tiny})
        for (const char* language : {"en", "de", "fr"}) {
            ShowOptions options;
            options.window.language = language;
            std::vector<SceneObject> objects;
            if (scene == WindowScene::tiny) objects.assign(2, {"tiny", package_of(scene), {}, true});
            HeadlessWindow w(package_of(scene), options, objects);
            w.session.settings.field.index = scene == WindowScene::garden ? 0 : -1;
            w.session.settings.light.light = Light::raking;
            w.session.cut.on = true;
            open_all_groups(w);
            w.resize(1200, 4000);
            w.frames(3);
            EXPECT_TRUE(w.there("Export section") && w.there("Write the orthophoto"));
            EXPECT_EQ(w.there("Save scene"), scene == WindowScene::tiny);
            EXPECT_EQ(misplaced(w, 1200, 4000), "") << language;
        }
}

TEST_F(WindowSizes, TheHelpAndAllToolsFitASmallWindow) {
    for (const char* language : {"en", "de", "fr"}) {
        ShowOptions options;
        options.window.language = language;
        HeadlessWindow w(package_of(WindowScene::tiny), options);
        w.key(GLFW_KEY_F1);
        w.frames(3);
        const Controls::Place help = *w.find("Mouse, fingers and keys");
        EXPECT_GE(help.low.x, 0);
        EXPECT_LE(help.high.x, 900);
        EXPECT_LE(help.high.y - help.low.y, 700);
        EXPECT_GT(help.high.y - help.low.y, 20 * 14) << "a line per key";
    }
}

TEST_F(WindowSizes, TheStoryAndItsEditorStayInTheFreeArea) {
    const auto package = copy_of(WindowScene::tiny);
    Story story;
    for (const char* id : {"a", "b", "c", "d", "e", "f"}) story.notes.push_back({id, {id, {}}, {}});
    write_story(story_file_of(package), story);
    HeadlessWindow w(package);
    w.resize(1280, 800);
    const ImRect place = rect_of("###story");
    const auto turn_text = [&](int key) {
        for (int i = 0; i < 6; ++i) w.key(key, control);
    };
    turn_text(GLFW_KEY_EQUAL);
    EXPECT_GT(w.session.window.text_scale, 1.9);
    EXPECT_EQ(rect_of("###story").Max.x, place.Max.x);
    w.key(GLFW_KEY_E, control), w.press("List 1"), w.frames(3);
    const Area& free = w.session.window.free;
    const ImRect all(float(free.left), float(free.top), float(free.left + free.width),
                     float(free.top + free.height)),
        editor = rect_of("Edit the story"), list = rect_of("###story");
    EXPECT_TRUE(all.Contains(editor) && all.Contains(list));
    EXPECT_FALSE(list.Overlaps(editor));
    w.point_at(w.place("Title of the story")), w.wheel(-50), w.frames(3);
    EXPECT_TRUE(editor.Contains(w.find("Save the story")->high)) << "scrolled to its end";
    w.key(GLFW_KEY_E, control);
    turn_text(GLFW_KEY_MINUS), w.frames(3);
    EXPECT_EQ(rect_of("###story").Min.x, place.Min.x) << "back in its place";
}

TEST_F(WindowSizes, ThePictureDoesNotTintTheBarTheStripAndTheSidebar) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_TAB);
    const ImDrawData& drawn = *ImGui::GetDrawData();
    int backgrounds = 0;
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const std::string_view name = drawn.CmdLists[i]->_OwnerName;
        if (name != "##bar" && name != "##photos" && name != "##sidebar") continue;
        EXPECT_EQ(drawn.CmdLists[i]->VtxBuffer.front().col >> IM_COL32_A_SHIFT, 255u) << name;
        ++backgrounds;
    }
    EXPECT_EQ(backgrounds, 3);
}

TEST_F(WindowSizes, FewControlsAreShownUntilMoreIsPressed) {
    for (const auto& [scene, few] :
         {std::pair{WindowScene::tiny, std::vector<std::string>{"Background", "Light", "Show", "Mode",
                                                                "Measure", "Cut the model"}},
          std::pair{WindowScene::garden,
                    std::vector<std::string>{"Background", "Light", "Show", "Mode", "Field", "Points",
                                             "Measure", "Cut the model"}}}) {
        HeadlessWindow w(package_of(scene));
        w.resize(1200, 3000);
        w.key(GLFW_KEY_TAB);
        EXPECT_EQ(controls_of_sidebar(w), few);
        press_every_more(w);
        const std::vector<std::string> all = controls_of_sidebar(w);
        EXPECT_GT(all.size(), few.size() + 25);
        EXPECT_TRUE(w.there("Flying speed") && w.there("tiles")) << "of the movement, of the status";
        press_every_more(w);
        EXPECT_EQ(controls_of_sidebar(w), few) << "Less";
    }
}

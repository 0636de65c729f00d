// The window's controls fit at every size and text scale, and in every language.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "tests/window/window_test.h"

using namespace vantage;

namespace {

/// Lists faults: controls of the bar, the menu and the strip's first photos that extend beyond the window or
/// overlap, and controls of the sidebar that are wider than its headers. The sidebar scrolls vertically.
std::string misplaced(const HeadlessWindow& w, float width, float height) {
    std::string out;
    std::vector<Controls::Place> checked;
    float side = 0;
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
        } else if (side > 0 && !p.name.starts_with("Photo ") && p.high.x > side + 1) {
            out += p.name + " is wider than the sidebar; ";
        }
    }
    return out;
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
    for (const WindowScene scene : {WindowScene::garden, WindowScene::image_sets})
        for (const char* language : {"en", "de", "fr"}) {
            ShowOptions options;
            options.window.language = language;
            HeadlessWindow w(package_of(scene), options);
            w.session.settings.field.index = scene == WindowScene::garden ? 0 : -1;
            w.session.settings.light.light = Light::raking;
            w.session.cut.on = true;
            Panels& p = w.session.window.panels;
            p.expert = p.photo_list = p.cut = p.orthophoto = p.status = p.objects = p.fields = true;
            w.resize(1200, 4000);
            w.frames(3);
            EXPECT_TRUE(w.there("Export section") && w.there("Write the orthophoto") &&
                        w.there("Save scene"));
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

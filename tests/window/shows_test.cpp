// The window's displays: tooltips, languages, lists of photos, orthophotos, sections exported as drawings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "base/text/translation.h"
#include "player/interface/help_panel.h"
#include "player/render/passes/blend_table.h"
#include "player/render/picture.h"
#include "player/survey/picture_plane.h"
#include "player/window/orthophoto_writer.h"
#include "tests/generated_table.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowShows : public WindowTest {
  protected:
    static std::vector<std::string> listed(const HeadlessWindow& w) {
        std::vector<std::string> out;
        for (const auto& p : w.controls.places())
            if (p.name.starts_with("Fly to ")) out.push_back(p.name.substr(7));
        return out;
    }
    static void open_sidebar(HeadlessWindow& w) {
        w.resize(1200, 3000);
        w.key(GLFW_KEY_TAB);
    }
};

}  // namespace

TEST_F(WindowShows, TooltipsExplainWhatIsUnderThePointer) {
    HeadlessWindow w(package_of(WindowScene::garden));
    w.point_at({450, 200}), w.frames(3);
    EXPECT_FALSE(w.there("Tooltip"));
    for (const char* tool :
         {"Home", "Photos", "Compare", "Light", "Only the object", "Help", "Full screen", "Expert"}) {
        w.point_at(w.place(std::string("Bar ") + tool)), w.frames(3);
        ASSERT_TRUE(w.there("Tooltip")) << tool;
        EXPECT_LT(w.find("Tooltip")->high.y, w.find(std::string("Bar ") + tool)->low.y) << "covers tools";
    }
    w.session.settings.field.index = 0;
    w.session.settings.light.light = Light::raking;
    w.session.cut.on = true;
    open_sidebar(w);
    std::vector<Controls::Place> places = w.controls.places();
    for (const auto& p : places)
        if (p.name.starts_with("More ")) w.press(p.name);
    std::string unexplained;
    std::size_t controls = 0;
    places = w.controls.places();
    const Controls::Place first = *w.find("Section Picture"), last = *w.find("Section Status");
    for (const auto& p : places) {
        if (p.name.starts_with("Section ") || p.high.x > first.high.x || p.low.y < first.low.y ||
            p.high.y > last.high.y)
            continue;
        w.point_at({double(p.low.x) + 4, double(p.low.y + p.high.y) / 2}), w.frames(2);
        ++controls;
        if (!w.there("Tooltip") && !p.name.starts_with("Fly to ")) unexplained += p.name + ", ";
    }
    EXPECT_EQ(unexplained, "");
    EXPECT_GT(controls, 50u);
}

TEST(Shortcuts, AreThoseOfTheGuide) {
    std::string rows;
    for (const Shortcut& s : shortcuts())
        rows += "| " + s.keys + " | " + s.action + " | " + (s.for_public ? "yes" : "") + " |\n";
    expect_table(std::filesystem::path(VANTAGE_SOURCE_DIR) / "docs/window.md", "keys", rows);
}

TEST_F(WindowShows, FalseColorsSayWhichPhotosTheyCount) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_V), w.key(GLFW_KEY_V);
    EXPECT_NE(shown_text().find("blended photos (of 5) that show the surface: 0"), std::string::npos)
        << shown_text();
}

TEST_F(WindowShows, AComparisonLeavesThePhotoOutOfTheModelAndIsCroppedToIt) {
    const HeadlessWindow w(package_of(WindowScene::tiny));
    Renderer renderer(w.package(), {});
    const View own = view_of_photo(w.package().photos()[2], 1);
    const int width = own.intrinsics.width, margin = width / 2;
    const View view = widened(own, margin);
    const std::vector<std::uint32_t> all{0, 1, 2, 3, 4}, others{0, 1, 3, 4};
    const Picture with = take_picture(renderer, view, {}, all, 1),
                  without = take_picture(renderer, view, {}, others, 1);
    RenderSettings s;
    s.swipe = 2;  // the whole frame shows the model, without the line
    s.compare_photo = 2;
    for (const Compare compare : {Compare::swipe, Compare::difference}) {
        s.compare = compare;
        const Picture p = take_picture(renderer, view, s, all, 1);
        const auto same = [](const Picture& a, std::size_t at, const Picture& b, std::size_t in_b) {
            return std::equal(&a.rgba[at], &a.rgba[at] + 3, &b.rgba[in_b]);
        };
        std::size_t inside = 0, model = 0, blended = 0, beside = 0;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const std::size_t at = 4 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x));
                const bool in_photo =
                    x >= margin && x < margin + width && y >= margin && y < p.height - margin;
                if (!in_photo && !same(p, at, p, 0)) ++beside;
                if (!in_photo) continue;
                ++inside;
                model += same(p, at, without, at);
                blended += same(p, at, with, at);
            }
        EXPECT_EQ(beside, 0u) << "something is shown beside the photo";
        if (compare != Compare::swipe) continue;
        EXPECT_EQ(model, inside);
        EXPECT_LT(blended, inside);
    }
}

TEST_F(WindowShows, AComparisonEndsWhenTheViewLeavesThePhoto) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_C), w.wait(1);
    EXPECT_TRUE(w.there("Swipe") && !w.there("Message"));
    w.point_at({250, 200}), w.drag(0, 60, 0);
    EXPECT_FALSE(w.there("Swipe"));
    EXPECT_TRUE(w.there("Message"));
    const Compare& compare = w.session.settings.compare;
    w.key(GLFW_KEY_F12), w.choose("Compare", "side by side"), w.wait(1);
    EXPECT_EQ(compare, Compare::side_by_side) << "the list flies to the photo";
    w.key(GLFW_KEY_N), w.wait(1);
    EXPECT_EQ(compare, Compare::side_by_side) << "with the next photo";
    w.key(GLFW_KEY_U), w.frames(3);
    EXPECT_EQ(compare, Compare::nothing);
}

TEST_F(WindowShows, AComparisonReadsNothingAgain) {
    const HeadlessWindow w(package_of(WindowScene::tiny));
    Renderer renderer(w.package(), {});
    const View view = view_of_photo(w.package().photos()[2], 1);
    const std::vector<std::uint32_t> all{0, 1, 2, 3, 4};
    RenderSettings s;
    s.photos = 4;
    double now = 0;
    const auto draw = [&](Compare compare, Loading loading) {
        s.compare = compare, s.loading = loading;
        return renderer.draw(view, s, all, {}, now += 1);
    };
    const auto settle = [&](Compare compare) {
        FrameReport report;
        for (int i = 0; i < 10 && !report.settled; ++i) report = draw(compare, Loading::repeatable);
        EXPECT_TRUE(report.settled);
    };
    s.compare_photo = 2;
    settle(Compare::nothing);
    EXPECT_GE(draw(Compare::side_by_side, Loading::streamed).photos, 3u) << "the other photos remain";
    settle(Compare::side_by_side);
    const std::uint64_t read = renderer.resources().store.streamed().bytes;
    EXPECT_GE(draw(Compare::nothing, Loading::streamed).photos, 4u) << "the photo is back at once";
    settle(Compare::nothing);
    EXPECT_EQ(renderer.resources().store.streamed().bytes, read);
}

TEST_F(WindowShows, EveryLanguageIsThatOfItsCatalog) {
    for (const auto& [language, name] : {std::pair{"de", "Deutsch"}, std::pair{"fr", "Français"}}) {
        HeadlessWindow w(copy_of(WindowScene::tiny, std::string(language) + ".vantage"));
        w.key(GLFW_KEY_TAB);
        w.press("View"), w.press("Language"), w.press(name);
        EXPECT_EQ(w.session.window.language, language);
        EXPECT_EQ(shown_name("Blending"), std::string(tr("Blending")) + "###Blending");
        EXPECT_STRNE(tr("Blending"), "Blending") << "no catalog for " << language;
        w.key(GLFW_KEY_TAB), w.key(GLFW_KEY_M);
        w.choose("Measure", "height");
    }
}

TEST_F(WindowShows, PhotosAreListedByNameByPointAndByError) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    open_sidebar(w);
    w.press("More Photos");
    const std::vector<std::string> all = listed(w);
    EXPECT_EQ(all.size(), 5u);
    w.fill_in("Name contains", "0002");
    EXPECT_EQ(listed(w), (std::vector<std::string>{all[2]}));
    w.press("Use only these");
    EXPECT_EQ(w.session.photos, (std::vector<std::uint32_t>{2}));
    w.press("Use all");
    EXPECT_EQ(w.session.photos.size(), 5u);
    w.fill_in("Name contains", "");
    EXPECT_EQ(listed(w), all);
    w.press("Use " + all[1]);
    EXPECT_EQ(w.session.photos, (std::vector<std::uint32_t>{0, 2, 3, 4}));
    w.press("Use " + all[1]);
    EXPECT_EQ(w.session.photos.size(), 5u);
    w.press("Fly to " + all[3]);
    w.wait(1);
    EXPECT_EQ(w.session.viewpoint.camera.eye, w.scene().poses[3].center());
    EXPECT_FALSE(w.there("Worst first")) << "no displacements are known";
    w.session.photo_list.errors = {0.1, 0.5, {}, 0.4, 0.2};
    w.frames();
    w.press("Worst first");
    EXPECT_EQ(listed(w), (std::vector<std::string>{all[1], all[3], all[4], all[0], all[2]}));
    w.press("Worst first");
    w.press("Photos at point");
    w.resize(900, 700);
    const View& v = w.view();
    w.point_at({v.intrinsics.cx, v.intrinsics.cy}), w.frames();
    w.click();
    ASSERT_TRUE(w.session.photo_list.point);
    const auto hit = first_hit(w.scene(), ray_through(v, {v.intrinsics.cx, v.intrinsics.cy}));
    EXPECT_LT((*w.session.photo_list.point - hit->position).norm(), 1e-6);
    const auto& showing = w.session.photo_list.showing;
    ASSERT_FALSE(showing.empty());
    EXPECT_TRUE(std::ranges::is_sorted(showing, {}, &Footprint::size))
        << "photos with the finest pixels come first";
    w.resize(1200, 3000);
    EXPECT_EQ(listed(w).size(), showing.size());
    w.press("Photos at point");
    EXPECT_EQ(listed(w), all);
}

TEST_F(WindowShows, ACutIsWrittenAsADrawing) {
    HeadlessWindow w(copy_of(WindowScene::tiny));
    open_sidebar(w);
    w.press("Cut the model");
    w.choose("Across", "z");
    w.press("Export section");
    // Pairs of a group code and a value.
    const auto values = [&](const std::string& text, const std::set<int>& codes) {
        std::vector<double> out;
        std::istringstream in(text);
        for (std::string code, value; std::getline(in, code) && std::getline(in, value);)
            if (codes.contains(std::atoi(code.c_str()))) out.push_back(std::atof(value.c_str()));
        return out;
    };
    const auto heights = values(written(w, dir / "one-cut-0001.dxf", "EOF"), {30, 31});
    ASSERT_GT(heights.size(), 40u);
    const auto [lowest, highest] = std::ranges::minmax(heights);
    EXPECT_LT(highest - lowest, 1e-6) << "the section is not level";
    EXPECT_GT(lowest, 1);
    EXPECT_LT(highest, 6);
    w.choose("Cut by", "a box");
    w.press("x from", 0.2);
    w.press("Export section");
    const auto across = values(written(w, dir / "one-cut-0002.dxf", "EOF"), {10, 11});
    const double side = std::ranges::min(across);
    EXPECT_GT(side, -8);
    EXPECT_LT(side, 0);
    EXPECT_GT(std::ranges::count_if(across, [&](double x) { return x - side < 1e-6; }), 20)
        << "the box's side must be drawn where it cuts the walls";
}

TEST_F(WindowShows, OrthophotosAreAskedForAndReported) {
    HeadlessWindow w(copy_of(WindowScene::tiny));
    open_sidebar(w);
    w.press("More Surveying");
    OrthophotoRequest& o = w.session.orthophoto;
    for (const auto& [side, plane] : {std::pair{"top", OrthophotoRequest::Plane::top},
                                      std::pair{"my view", OrthophotoRequest::Plane::facing},
                                      std::pair{"front", OrthophotoRequest::Plane::front}}) {
        w.choose("Seen from", side);
        EXPECT_EQ(o.plane, plane);
    }
    w.fill_in("Size of a pixel", "0.05");
    EXPECT_EQ(o.pixel, 0.05);
    w.choose("Written as", "GeoTIFF");
    EXPECT_EQ(o.file, OrthophotoRequest::File::tiff);
    w.choose("Written as", "PNG and world file");
    EXPECT_FALSE(o.writing);
    w.press("Cut the model");
    w.choose("Across", "z");
    w.session.photos = {0, 1, 3, 4};
    w.session.settings.light.light = Light::raking;
    const std::vector<std::string> arguments = orthophoto_arguments(w.session, w.package(), "front.png");
    const auto value = [&](const std::string& option) {
        const auto at = std::ranges::find(arguments, option);
        return at == arguments.end() ? "none" : *(at + 1);
    };
    const std::vector<SectionPlane>& planes = w.session.settings.sections;
    ASSERT_EQ(planes.size(), 1u);
    const Eigen::Map<const Eigen::Vector3d> origin(w.package().scene().origin);
    EXPECT_NEAR(parse_section(value("--cut"), origin).offset, planes[0].offset, 1e-9) << "the cut is missing";
    EXPECT_EQ(value("--exclude"), w.package().photos()[2].name);
    EXPECT_EQ(value("--light"), "raking");
}

TEST_F(WindowShows, AFieldHasALegendWithoutTheSidebar) {
    ShowOptions options;
    options.field.name = "height";
    HeadlessWindow w(package_of(WindowScene::garden), options);
    w.resize(1200, 3000);
    EXPECT_FALSE(w.there("Legend")) << "the sidebar has it";
    w.press("More Scalar fields");
    EXPECT_TRUE(w.there("Logarithmic"));
    w.key(GLFW_KEY_TAB);
    EXPECT_TRUE(w.there("Legend"));
    EXPECT_NE(shown_text().find("height"), std::string::npos) << shown_text();
    w.session.settings.field.range = ValueRange{-1, 5};
    w.frames();
    EXPECT_NE(shown_text().find("-1 0 5"), std::string::npos) << "the place of zero: " << shown_text();
    w.session.settings.field.range = ValueRange{-1, 40};
    w.session.settings.field.map = ColorMap::viridis;
    w.frames();
    EXPECT_NE(shown_text().find("-1 40 0"), std::string::npos) << "on its own line: " << shown_text();
}

TEST_F(WindowShows, PointsAndComparisonsAreInPerspective) {
    {
        HeadlessWindow w(package_of(WindowScene::garden));
        w.session.viewpoint.orthographic = true;
        w.frames(3);
        EXPECT_FALSE(w.session.viewpoint.orthographic);
        EXPECT_TRUE(w.there("Message"));
    }
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.session.viewpoint.orthographic = true;
    w.frames(3);
    EXPECT_TRUE(w.session.viewpoint.orthographic);
    w.key(GLFW_KEY_C);
    EXPECT_TRUE(w.there("Swipe"));
    EXPECT_FALSE(w.session.viewpoint.orthographic);
}

TEST_F(WindowShows, ALineNamesSurfaceThatNoPhotoShows) {
    ShowOptions options;
    options.package.photos = {"0002.jpg"};
    HeadlessWindow w(package_of(WindowScene::tiny), options);
    const auto says = [&] {
        w.wait(1), w.draw(), w.draw(), w.frames();
        return shown_text().find("Gray or blurred surface was not photographed") != std::string::npos;
    };
    EXPECT_FALSE(says()) << "the photo shows all of the view";
    w.session.photos = {};
    EXPECT_TRUE(says());
    w.session.settings.light.light = Light::raking;
    EXPECT_FALSE(says()) << "all of it is gray";
}

TEST_F(WindowShows, TheRadarShowsTheModelWithoutItsBackground) {
    HeadlessWindow w(package_of(WindowScene::garden));
    w.key(GLFW_KEY_F6);
    const Controls::Place map = *w.find("Radar map");
    float left = map.high.x, right = map.low.x;  // of what is drawn in translucent gray
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int n = 0; n < drawn.CmdListsCount; ++n) {
        const ImDrawList& list = *drawn.CmdLists[n];
        if (!std::string_view(list._OwnerName).starts_with("Radar")) continue;
        for (const ImDrawVert& v : list.VtxBuffer) {
            const ImVec4 c = ImGui::ColorConvertU32ToFloat4(v.col);
            if (c.w == 0 || c.w == 1 || c.x < 0.4f || std::abs(c.x - c.z) > 0.15f) continue;
            left = std::min(left, v.pos.x), right = std::max(right, v.pos.x);
        }
    }
    const float share = (right - left) / (map.high.x - map.low.x);
    EXPECT_GT(share, 0.1) << "no model";
    EXPECT_LT(share, 0.9) << "the model, with its background, covers the map";
}

TEST_F(WindowShows, TheHelpHasEveryKey) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const auto help = [&] {
        ImGui::NewFrame();
        ImGui::LogToClipboard();  // until the window closes
        help_panel(w.controls, w.state);
        ImGui::Render();
        return std::string(ImGui::GetClipboardText());
    };
    help();
    const std::string all = help();
    for (const char* key : {"W A S D, Q E",
                            "H, Backspace",
                            "N, B",
                            "C ",
                            "V ",
                            "X ",
                            "R, T",
                            "M ",
                            "J ",
                            "Ctrl+E",
                            "O ",
                            "P ",
                            "Ctrl+C, Ctrl+V",
                            "Tab",
                            "F1 to F12",
                            "Ctrl with + or -",
                            "Esc",
                            "Ctrl+Q",
                            "double click",
                            "two fingers",
                            "wheel"})
        EXPECT_NE(all.find(key), all.npos) << key << " is not in\n" << all;
    for (const BlendRow& row : blend_table()) EXPECT_NE(all.find(row.label), all.npos) << row.label;
    w.session.window.kiosk = true;
    const std::string for_public = help();
    EXPECT_EQ(for_public.find("H, Backspace"), for_public.npos) << "a visitor has no keyboard";
    EXPECT_NE(for_public.find("two fingers"), for_public.npos);
}

// Measures known lengths of the synthetic building in the window.
#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>

#include "player/interface/sections/columns.h"
#include "player/survey/survey_file.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

class WindowMeasures : public WindowTest {
  protected:
    /// A window opening on the upper floor, whose corners are vertices of the mesh: 1.49333 m wide, 2.01 m
    /// high.
    static constexpr double left = 1.92, right = 3.41333, low = 3.54, high = 5.55;

    WindowMeasures() {
        std::filesystem::create_directories(dir);
        package = copy_of(WindowScene::tiny);
    }
    ShowOptions from_photo() const {
        ShowOptions options;
        options.package.photos = {"0002.jpg"};
        return options;
    }
    static Eigen::Vector2d pixel_of(HeadlessWindow& w, const Vector3d& place) {
        const Vector3d origin = Eigen::Map<const Vector3d>(w.package().scene().origin);
        return project(w.view().intrinsics, w.view().cam_from_origin, place - origin)->pixel;
    }
    static void click(HeadlessWindow& w, const Vector3d& place, const Eigen::Vector2d& beside = {0, 0}) {
        w.wait(1);  // no double click
        w.point_at(pixel_of(w, place) + beside);
        w.frames();
        w.click();
    }
    Survey survey() const {
        SurveyFile file = survey_file_of(package, false);
        return read_survey(file, {});
    }
    std::size_t count() const { return survey().measurements.size(); }
    /// The last measurement, once `wanted` measurements are stored.
    double value(HeadlessWindow& w, std::size_t wanted) const {
        written_until(w, survey_file(),
                      [&](const std::string& text) { return text.ends_with("\n") && count() >= wanted; });
        const Survey s = survey();
        EXPECT_EQ(s.measurements.size(), wanted);
        if (s.measurements.empty()) return 0;
        return evaluate(s.measurements.back(), s.scale, s.up).value.value_or(-1);
    }
    std::filesystem::path survey_file() const { return dir / "one.measurements.json"; }

    std::filesystem::path package;
};

}  // namespace

TEST_F(WindowMeasures, EveryMeasureOfTheOpening) {
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    ASSERT_TRUE(w.there("Snap to vertices"));
    std::size_t n = 0;
    click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
    EXPECT_NEAR(value(w, ++n), 1.6, 0.03) << "the point is on the wall, accurate to a pixel";
    w.press("Snap to vertices");
    click(w, {left, 0, low}, {-2, 1}), click(w, {left, 0, high}, {-2, -1});
    EXPECT_NEAR(value(w, ++n), 2.01, 1e-4) << "at vertices, exact";
    w.choose("Measure", "area");
    click(w, {left, 0, low}), click(w, {right, 0, low}), click(w, {right, 0, high}, {2, -1}),
        click(w, {left, 0, high});
    w.key(GLFW_KEY_ENTER);
    EXPECT_NEAR(value(w, ++n), 3.0016, 5e-4);
    w.frames();
    EXPECT_NE(shown_text().find("perimeter 7.01 units"), std::string::npos) << shown_text();
    for (float width = 20; width < 400; width += 5) {
        const std::vector<std::string> lines = wrapped("away from it; perimeter 10.25 m, in 2 parts", width);
        EXPECT_EQ(std::ranges::count_if(lines, [](const auto& l) { return l.find("10.25 m") != l.npos; }), 1)
            << width;
        EXPECT_LE(ImGui::CalcTextSize(lines.front().c_str()).x, std::max(width, 60.0f));
    }
    w.choose("Measure", "angle");
    click(w, {right, 0, low}), click(w, {left, 0, low}), click(w, {left, 0, high});
    EXPECT_NEAR(value(w, ++n), 90, 0.01);
    w.choose("Measure", "height");
    click(w, {right, 0, low}), click(w, {left, 0, high});
    EXPECT_NEAR(value(w, ++n), 2.01, 1e-4);
    w.choose("Measure", "point");
    click(w, {left, 0, low});
    value(w, ++n);
    EXPECT_LT((survey().measurements.back().points.at(0).position - Vector3d(left, 0, low)).norm(), 1e-4);
    w.choose("Measure", "polyline");
    click(w, {left, 0, low}), click(w, {left, 0, high}), click(w, {1.6, 0, 4});
    w.key(GLFW_KEY_BACKSPACE);
    w.wait(1);
    w.point_at(pixel_of(w, {right, 0, high})), w.frames();
    w.double_click();
    EXPECT_NEAR(value(w, ++n), 3.50333, 5e-4)
        << "Backspace removes the last point, and a double-click finishes";
    EXPECT_FALSE(w.session.viewpoint.flight) << "a double-click measures instead of flying";
    std::vector<Controls::Place> labels = w.controls.places();
    std::erase_if(labels, [](const Controls::Place& p) { return p.name != "Measurement label"; });
    EXPECT_EQ(labels.size(), n);
    for (const Controls::Place& a : labels)
        for (const Controls::Place& b : labels)
            EXPECT_TRUE(&a == &b || a.low.x >= b.high.x || b.low.x >= a.high.x || a.low.y >= b.high.y ||
                        b.low.y >= a.high.y)
                << "a label covers another one";
}

TEST_F(WindowMeasures, AProfileAcrossTheOpeningIsARecessInChartAndTable) {
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    w.choose("Measure", "profile");
    const double between = (low + high) / 2, from = 1.6, to = 3.6;
    click(w, {from, 0, between}), click(w, {to, 0, between});
    EXPECT_NEAR(value(w, 1), to - from, 0.03);
    w.point_at(w.place("Profile chart", 0.3)), w.frames(2);
    EXPECT_TRUE(std::regex_search(shown_text(), std::regex("at 0\\.[0-9]+ units: ")))
        << "the values under the pointer: " << shown_text();
    w.press("Export profile");
    std::istringstream table(written_until(w, dir / "one-profile-0001.csv",
                                           [](const std::string& s) { return s.ends_with("\n"); }));
    std::string line;
    std::getline(table, line);
    int in_wall = 0, in_recess = 0;
    for (double s, offset, x, y, z; std::getline(table, line);) {
        if (std::sscanf(line.c_str(), "%lf,%lf,units,%lf,%lf,%lf", &s, &offset, &x, &y, &z) != 5) continue;
        const bool recess = x > left + 0.01 && x < right - 0.01, wall = x < left - 0.01 || x > right + 0.01;
        in_recess += recess, in_wall += wall;
        if (!recess && !wall) continue;
        EXPECT_NEAR(y, recess ? 0.7 : 0, 1e-3) << line;
        EXPECT_NEAR(offset, -y, 1e-3) << line;
    }
    EXPECT_GT(in_recess, 280);
    EXPECT_GT(in_wall, 90);
    w.choose("Measure", "distance");
    click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
    EXPECT_FALSE(w.there("Profile chart")) << "another measurement is selected";
}

TEST_F(WindowMeasures, NothingBesideTheModelAndNothingAfterEsc) {
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    w.point_at({60, 60}), w.frames(), w.click();
    EXPECT_TRUE(w.there("Message")) << "no surface at this point";
    w.choose("Measure", "polyline");
    click(w, {left, 0, low}), click(w, {left, 0, high});
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(w.there("Snap to vertices")) << "Esc cancels the current measurement";
    w.key(GLFW_KEY_ENTER);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Snap to vertices")) << "a second Esc leaves measuring";
    click(w, {left, 0, low}), click(w, {left, 0, high});
    w.wait(0.5);
    EXPECT_FALSE(std::filesystem::exists(survey_file()));
}

TEST_F(WindowMeasures, NamesScaleAndTable) {
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    EXPECT_EQ(shown_text().find("saved in"), std::string::npos) << "nothing has been saved yet";
    w.press("Snap to vertices");
    click(w, {left, 0, low}), click(w, {left, 0, high});
    w.choose("Measure", "polyline");
    click(w, {left, 0, low}), click(w, {left, 0, high}), click(w, {right, 0, high});
    w.key(GLFW_KEY_ENTER);
    EXPECT_NEAR(value(w, 2), 3.50333, 5e-4);
    w.press("distance 1");
    EXPECT_NE(shown_text().find("saved in one.measurements.json"), std::string::npos) << shown_text();
    w.fill_in("Name", "Door");
    written(w, survey_file(), "\"name\": \"Door\"");
    w.fill_in("Known length", "6.03");
    w.press("Set scale");
    written(w, survey_file(), "\"unit\": \"m\"");
    w.choose("Shown in", "cm");
    written(w, survey_file(), "\"cm\"");
    EXPECT_NEAR(value(w, 2), 3.50333 * 3 * 100, 0.2);
    w.fill_in("Known length", "301.5");
    w.press("Set scale");
    w.press("Export table");
    const std::string table = written(w, dir / "one-measurements-0001.csv", "polyline");
    EXPECT_NE(table.find("\"Door\",distance,301.5"), table.npos) << table;
    w.press("polyline 1"), w.press("Delete");
    written_until(w, survey_file(), [&](const std::string&) { return count() == 1; });
    w.choose("Model's unit", "mm");
    written(w, survey_file(), "\"mm\"");
}

TEST_F(WindowMeasures, AScaleBarIsRightWhereTheViewTurns) {
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    EXPECT_FALSE(w.there("Drawn scale bar")) << "the unit is unknown";
    w.choose("Model's unit", "m");
    const auto expect_right = [&](const char* unit, double unit_length) {
        const Controls::Place* const bar = w.find("Drawn scale bar");
        ASSERT_TRUE(bar);
        const double pixels = double(bar->high.x - bar->low.x);
        EXPECT_TRUE(pixels > 60 && pixels < 170) << pixels;
        std::smatch length;
        const std::string text = shown_text();
        ASSERT_TRUE(
            std::regex_search(text, length, std::regex(std::string(" ((1|2|5|0\\.0*[125])0*) ") + unit)))
            << text;
        const Navigation& camera = w.session.viewpoint.camera;
        const Vector3d origin = Eigen::Map<const Vector3d>(w.package().scene().origin),
                       half = camera.R.row(0) * std::stod(length[1]) * unit_length / 2;
        const Eigen::Vector2d across =
            pixel_of(w, camera.target + half + origin) - pixel_of(w, camera.target - half + origin);
        EXPECT_NEAR(pixels, across.norm(), 0.01 * pixels) << length[0];
    };
    expect_right("m", 1);
    w.choose("Shown in", "cm");
    expect_right("cm", 0.01);
    w.point_at({1000, 400}), w.frames();
    for (int i = 0; i < 8; ++i) w.wheel(1), expect_right("cm", 0.01);
    w.session.viewpoint.orthographic = true, w.frames();
    expect_right("cm", 0.01);
    w.point_at(w.place("Drawn scale bar")), w.frames(3);
    EXPECT_NE(shown_text().find("the point about which the view turns"), std::string::npos);
    w.press("Scale bar");
    EXPECT_FALSE(w.there("Drawn scale bar"));
    w.press("Scale bar");
    EXPECT_TRUE(w.there("Drawn scale bar"));
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Drawn scale bar"));
}

TEST_F(WindowMeasures, AreThereAgainAndADamagedFileIsLeftAlone) {
    {
        HeadlessWindow w(package, from_photo());
        w.resize(1600, 900);  // the panel is beside the building
        w.key(GLFW_KEY_M);
        click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
        value(w, 1);
    }
    {
        HeadlessWindow w(package, from_photo());
        w.resize(1600, 900);  // the panel is beside the building
        w.key(GLFW_KEY_M);
        EXPECT_TRUE(w.there("distance 1"));
    }
    {
        SurveyFile file = survey_file_of(package, false);
        Survey many = read_survey(file, {});
        many.measurements.resize(30, many.measurements.front());
        write_survey(file, many);
        HeadlessWindow w(package, from_photo());
        w.resize(1280, 800);
        w.key(GLFW_KEY_TAB), w.key(GLFW_KEY_M);
        w.frames(3);
        EXPECT_LT(w.place("Export table").y(), w.place("Photo 1").y() - 40) << "in reach";
        w.key(GLFW_KEY_H), w.wait(1);
        const double left = w.find("Section Picture")->high.x, right = w.find("Snap to vertices")->low.x;
        EXPECT_NEAR(w.view().intrinsics.cx, (left + right) / 2, 15) << "between the sidebar and the panel";
        click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
        w.frames(3);
        EXPECT_LT(w.place("distance 2").y(), w.place("Export table").y()) << "the list shows the last one";
    }
    const std::string cut = slurp(survey_file()).substr(0, 100);
    std::ofstream(survey_file()) << cut;
    HeadlessWindow w(package, from_photo());
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    EXPECT_NE(w.session.message.text.find("one.measurements.json"), std::string::npos)
        << w.session.message.text;
    click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
    w.wait(0.5);
    EXPECT_EQ(slurp(survey_file()), cut);
    w.frames();
    EXPECT_NE(shown_text().find("not saved in one.measurements.json"), std::string::npos) << shown_text();
}

TEST_F(WindowMeasures, ThatCouldNotBeSavedAreAskedAbout) {
    HeadlessWindow w(package, from_photo());
    UserCommands& commands = w.session.window.commands;
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_M);
    std::ofstream(survey_file()) << "of another program";
    click(w, {left, 0, low}), click(w, {right, 0, low});
    w.key(GLFW_KEY_M), w.key(GLFW_KEY_M);
    EXPECT_TRUE(w.there("distance 1")) << "kept when the mode is left";
    w.key(GLFW_KEY_Q, control);
    EXPECT_FALSE(holds<Quit>(commands));
    EXPECT_NE(shown_text().find("Save the measurements in one.measurements.json?"), std::string::npos);
    w.press("Save");
    EXPECT_FALSE(w.there("Discard") || holds<Quit>(commands)) << "they still cannot be saved";
    std::filesystem::remove(survey_file());
    w.key(GLFW_KEY_Q, control), w.press("Save");
    EXPECT_TRUE(take<Quit>(commands));
    EXPECT_EQ(count(), 1u);
}

TEST_F(WindowMeasures, AreNamedInTheLanguageOfTheWindow) {
    for (const auto& [language, name] : {std::pair{"de-AT", "Abstand 1"}, std::pair{"fr", "distance 1"}}) {
        std::filesystem::remove(survey_file());
        ShowOptions options = from_photo();
        options.window.language = language;
        HeadlessWindow w(package, options);
        w.resize(1600, 900);  // the panel is beside the building
        w.key(GLFW_KEY_M);
        click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
        value(w, 1);
        EXPECT_EQ(survey().measurements.at(0).name, name);
        const std::regex shown("1,[0-9]+ ± 0,[0-9]+ (Einheiten|unités)");
        EXPECT_TRUE(std::regex_search(shown_text(), shown)) << shown_text();
        w.press("Export table");
        const std::string table = written(w, dir / "one-measurements-0001.csv", "distance");
        const std::regex with_points("distance,1\\.[0-9]+,0\\.[0-9]+,units,\"along x [^\"]* z 1\\.60* units");
        EXPECT_TRUE(std::regex_search(table, with_points)) << table;
        std::filesystem::remove(dir / "one-measurements-0001.csv");
    }
}

TEST_F(WindowMeasures, AreTheSameAtAllDepthsOrthographically) {
    HeadlessWindow w(package);
    w.resize(1600, 900);  // the panel is beside the building
    w.key(GLFW_KEY_TAB);
    w.choose("View", "Orthographic");
    w.choose("View", "From the top");  // a plan needs no photos from above
    w.wait(1);
    w.key(GLFW_KEY_TAB);
    w.key(GLFW_KEY_M);
    std::size_t n = 0;
    const Eigen::Vector2d middle(w.view().intrinsics.cx, w.view().intrinsics.cy);
    const auto length = [&](double row) {  // of 200 pixels, below the middle
        for (const double column : {-100, 100}) {
            w.wait(1);
            w.point_at({middle.x() + column, middle.y() + row}), w.frames(), w.click();
        }
        return value(w, ++n);
    };
    const double ground = length(68);
    EXPECT_GT(ground, 1);
    // The middle is 1.8 m in front of the facade; the roof's ridge runs 2.2 m behind the facade.
    const double ridge = -3.6 * 200 / ground, roof = length(ridge);
    EXPECT_NEAR(roof / ground, 1, 0.002) << "7 m above it";
    w.point_at({middle.x(), middle.y() + ridge}), w.frames();
    for (int i = 0; i < 3; ++i) w.wheel(1);
    EXPECT_NEAR(length(ridge) / roof, std::pow(0.9, 3), 0.002);
}

// Texts and numbers of the window in the languages that have a catalog.
#include <imgui.h>

#include <cstring>
#include <fstream>
#include <regex>
#include <set>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"
#include "player/interface/unit_texts.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowLanguages : public WindowTest {
  protected:
    void TearDown() override {
        use_language("");
        WindowTest::TearDown();
    }
    static ShowOptions in(const char* language) {
        ShowOptions options;
        options.window.language = language;
        return options;
    }
    /// The non-ASCII letters in the translations of a compiled catalog.
    static std::set<unsigned> letters_of_catalog(const std::string& language) {
        const auto share =
            std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "share";
        const std::string catalog = slurp(share / "locale" / language / "LC_MESSAGES/vantage.mo");
        const auto number = [&](std::size_t at) {
            std::uint32_t out = 0;
            std::memcpy(&out, catalog.data() + at, 4);
            return std::size_t(out);
        };
        std::string all;
        for (std::size_t i = 0; i < number(8); ++i)
            all += catalog.substr(number(number(16) + 8 * i + 4), number(number(16) + 8 * i));
        std::set<unsigned> out;
        const auto bits = [&](std::size_t at, unsigned mask) {
            return static_cast<unsigned char>(all[at]) & mask;
        };
        for (std::size_t i = 0; i < all.size(); ++i)
            if (bits(i, 0xe0) == 0xc0)
                out.insert(bits(i, 31) << 6 | bits(i + 1, 63));
            else if (bits(i, 0xf0) == 0xe0)
                out.insert(bits(i, 15) << 12 | bits(i + 1, 63) << 6 | bits(i + 2, 63));
        return out;
    }
};

}  // namespace

TEST_F(WindowLanguages, AWordIsTranslatedByItsSense) {
    use_language("fr");
    const std::set<std::string> hidden{tr_in("background", "hidden"), tr_in("transparency", "hidden"),
                                       tr_in("points", "hidden")};
    EXPECT_EQ(hidden, (std::set<std::string>{"masqué", "masquée", "masqués"}));
    EXPECT_STREQ(tr_in("image set", "none"), "aucun");
    EXPECT_STRNE(tr(MARKED_IN("tool", "Light")), tr(MARKED_IN("setting", "Light")));
    use_language("de");
    EXPECT_STREQ(tr(unit_texts[std::size_t(Unit::in)]), "Zoll");
    EXPECT_STREQ(tr_in("image set", "none"), "keiner");
    EXPECT_STREQ(tr_in("page", "Move"), "Fortbewegung");
    EXPECT_STREQ(tr_in("object", "Move"), "Verschieben");
}

TEST_F(WindowLanguages, MenusNameTheKeysOfTheKeyboard) {
    HeadlessWindow w(package_of(WindowScene::tiny), in("de"));
    w.key(GLFW_KEY_TAB);
    for (const char* menu : {"File", "Edit", "View"}) {
        w.press(menu);
        EXPECT_NE(shown_text().find("Strg+"), std::string::npos) << menu;
        EXPECT_EQ(shown_text().find("Ctrl"), std::string::npos) << menu;
        w.press(menu);
    }
}

TEST_F(WindowLanguages, AStoryIsWrittenInTheWindowsLanguageAndSetsThatOfAKiosk) {
    const std::filesystem::path package = copy_of(WindowScene::tiny);
    {
        HeadlessWindow w(package, in("de-AT"));
        w.key(GLFW_KEY_E, control);
        w.press("Set the opening view"), w.press("Save the story");
    }
    {
        const HeadlessWindow w(package, in("en"));
        EXPECT_NE(shown_text().find("Compare"), std::string::npos) << "chosen explicitly";
    }
    ShowOptions options;
    options.window.kiosk = true;
    options.window.home_after = 2;
    HeadlessWindow w(package, options);
    EXPECT_NE(shown_text().find("Vergleichen"), std::string::npos) << shown_text();
    w.choose("Bar Language", "Français");
    EXPECT_EQ(shown_text().find("Vergleichen"), std::string::npos) << shown_text();
    w.wait(4);
    EXPECT_NE(shown_text().find("Vergleichen"), std::string::npos) << "the next visitor's language";
}

TEST_F(WindowLanguages, ControlsAreKnownWithoutContexts) {
    for (const char* language : {"en", "de"}) {
        HeadlessWindow w(package_of(WindowScene::tiny), in(language));
        w.resize(1200, 3000);
        w.key(GLFW_KEY_F2);
        EXPECT_TRUE(w.there("Bar Light") && w.there("Light") && w.there("Photos")) << language;
        for (const Controls::Place& p : w.controls.places()) EXPECT_EQ(p.name.find('\4'), p.name.npos);
        w.choose("Light", "raking light");
        EXPECT_EQ(w.session.settings.light.light, Light::raking);
    }
}

TEST_F(WindowLanguages, NumbersHaveTheDecimalSeparatorOfTheLanguage) {
    const std::regex with_point("[0-9]\\.[0-9]"), with_comma("[0-9],[0-9]");
    for (const char* language : {"en", "de", "fr"}) {
        HeadlessWindow w(package_of(WindowScene::garden), in(language));
        w.session.settings.field.index = 0;
        w.session.settings.light.light = Light::raking;
        Cut& cut = w.session.cut;
        cut.on = true;
        cut.across = Cut::Across::x;
        const auto [low, high] = cut.extents.along(w.scene(), Eigen::Vector3d::UnitX());
        cut.share = (-1e-5 - w.package().scene().origin[0] - low) / (high - low);  // at -1e-5
        w.session.stereo.mode = StereoMode::checkerboard;
        Panels& p = w.session.window.panels;
        p.expert = p.picture = p.photo_list = p.blending = p.fields = p.points = p.surveying = p.movement =
            p.status = p.measure = true;
        w.resize(1200, 4000);
        w.frames(3);
        w.point_at(w.place("Section Status") + Eigen::Vector2d(0, 30)), w.frames(3);  // the curve of frames
        const std::string text = shown_text();
        EXPECT_FALSE(std::regex_search(text, std::regex("-0[.,]0+(?![0-9])"))) << language << text;
        std::smatch found;
        const bool english = std::string(language) == "en";
        EXPECT_TRUE(std::regex_search(text, english ? with_point : with_comma)) << text;
        EXPECT_FALSE(std::regex_search(text, found, english ? with_comma : with_point))
            << language << ": " << found.prefix().str().substr(found.prefix().length() - 40) << found.str();
    }
}

TEST_F(WindowLanguages, NumbersAreTypedWithAPointOrAComma) {
    for (const char* language : {"en", "de"}) {
        HeadlessWindow w(package_of(WindowScene::tiny), in(language));
        w.resize(1200, 4000);
        Panels& p = w.session.window.panels;
        p.expert = p.surveying = p.movement = true;
        w.frames(3);
        const double& pixel = w.session.orthophoto.pixel;
        w.fill_in("Size of a pixel", "0,05");
        EXPECT_EQ(pixel, 0.05) << language;
        w.fill_in("Size of a pixel", "0.06");
        EXPECT_EQ(pixel, 0.06) << language;
        for (const auto& [typed, value] :
             {std::pair{"2,5", 2.5}, std::pair{"3.25", 3.25}, std::pair{"99", 10.0}}) {
            w.hold_control(true);
            w.press("Flying speed");
            w.hold_control(false);
            w.frames(5);
            EXPECT_TRUE(ImGui::GetIO().WantTextInput) << language;
            w.key(GLFW_KEY_A, KeyPress::With::control);
            w.type(typed);
            w.key(GLFW_KEY_ENTER);
            w.frames(8);
            EXPECT_EQ(w.session.movement.flying_speed, value) << language;
            EXPECT_FALSE(ImGui::GetIO().WantTextInput) << language;
        }
        w.press("Flying speed", 0.2);
        EXPECT_LT(w.session.movement.flying_speed, 10) << "a slider again";
    }
}

TEST_F(WindowLanguages, TheFontHasEveryLetterOfTheCatalogs) {
    const HeadlessWindow w(package_of(WindowScene::tiny));
    const ImFont& font = *ImGui::GetFont();
    if (!font.FindGlyphNoFallback(0x2026)) GTEST_SKIP() << "DejaVu is not installed";
    for (const char* language : {"de", "fr"}) {
        const std::set<unsigned> letters = letters_of_catalog(language);
        EXPECT_TRUE(letters.contains(std::string(language) == "fr" ? 0x202f : 0xfc)) << language;
        for (const unsigned letter : letters)
            EXPECT_TRUE(font.FindGlyphNoFallback(ImWchar(letter))) << language << ": " << std::hex << letter;
    }
}

TEST_F(WindowLanguages, WhatFailsIsSaidInTheLanguage) {
    use_language("de");
    EXPECT_EQ(failure_text(formatted(tr("%s cannot be opened."), "a.vantage"),
                           Error(Exit::damaged, "a.vantage: is truncated")),
              "a.vantage lässt sich nicht öffnen. Die Datei ist beschädigt oder von anderer Art.\n"
              "a.vantage: is truncated");
    const std::filesystem::path cut = dir / "cut.vantage";
    std::ofstream(cut) << slurp(package_of(WindowScene::tiny)).substr(0, 3000);
    HeadlessWindow w(copy_of(WindowScene::tiny), in("fr"));
    w.session.window.commands.push_back(AddObject{cut.string()});
    w.frames(4);
    EXPECT_TRUE(w.session.message.text.starts_with("Impossible d’ajouter cut.vantage. Le fichier"))
        << w.session.message.text;
    EXPECT_NE(shown_text().find("Impossible"), std::string::npos) << shown_text();
    std::ofstream(dir / "one.measurements.json") << "{";
    w.key(GLFW_KEY_M);
    EXPECT_TRUE(w.session.message.text.starts_with("Impossible de lire les mesures. "))
        << w.session.message.text;
    w.key(GLFW_KEY_M);
    w.resize(500, 700);
    const Controls::Place* const message = w.find("Message");
    ASSERT_TRUE(message);
    EXPECT_GE(message->low.x, 0) << "a long message has several lines";
    EXPECT_LE(message->high.x, 500);
}

// Texts and numbers of the window in the languages that have a catalog.
#include <set>

#include "base/text/translation.h"
#include "player/interface/unit_texts.h"
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

TEST_F(WindowLanguages, ControlsAreKnownWithoutContexts) {
    for (const char* language : {"en", "de"}) {
        HeadlessWindow w(package_of(WindowScene::tiny), in(language));
        w.resize(1200, 3000);
        w.key(GLFW_KEY_TAB);
        EXPECT_TRUE(w.there("Bar Light") && w.there("Light") && w.there("Photos")) << language;
        for (const Controls::Place& p : w.controls.places()) EXPECT_EQ(p.name.find('\4'), p.name.npos);
        w.choose("Light", "raking light");
        EXPECT_EQ(w.session.settings.light.light, Light::raking);
    }
}

// Tests that vantage check reads the story next to a package.
#include <fstream>
#include <sstream>

#include "base/text/error.h"
#include "scene/package/package_reader.h"
#include "tests/programs/overnight.h"

using namespace vantage;

namespace {

class StoryCheck : public Overnight {
  protected:
    void SetUp() override {
        Overnight::SetUp();
        copy_package(scene, {}, file);
    }
    Outcome check(const std::string& story) const {
        std::ofstream(dir / "scene.story.json", std::ios::binary) << story;
        return run("check " + file.string());
    }
    /// A note with an anchor, as JSON.
    static std::string note(const std::string& id, double x, double y, double z) {
        std::ostringstream out;
        out << R"({"id": ")" << id << R"(", "anchor": [)" << x << ", " << y << ", " << z << "]}";
        return out.str();
    }
};

}  // namespace

TEST_F(StoryCheck, FindsWhatTheStoryNamesAndDoesNotHave) {
    EXPECT_EQ(run("check " + file.string()).code, 0) << "without a story";
    const PackageReader reader(file);
    const double* low = reader.scene().bounds_min;
    const double* high = reader.scene().bounds_max;
    const std::string on = note("on", high[0], high[1], high[2]),
                      off = note("off", 3 * high[0] - 2 * low[0], high[1], high[2]);
    const Outcome valid = check(R"({"format": "vantage-story-1", "notes": [)" + on + "]}");
    EXPECT_EQ(valid.code, 0) << valid.out;
    const Outcome found =
        check(R"({"format": "vantage-story-1", "mood": "calm", "notes": [)" + on + ", " + off +
              R"(, {"id": "c", "picture": "c.png"}], "tours": [{"id": "t", "stops": [{"note": "door"}]}]})");
    EXPECT_EQ(found.code, int(Exit::incomplete)) << found.out;
    for (const char* line :
         {"[story-reference]: scene.story.json: tours[0].stops[0].note: found \"door\", expected the id of a "
          "note\n",
          "[story-picture]: scene.story.json: notes[2].picture: c.png does not exist\n",
          "[story-anchor]: scene.story.json: notes[1].anchor: is ",
          "[story-unknown-key]: scene.story.json: unknown key \"mood\", expected "})
        EXPECT_NE(found.out.find(line), std::string::npos) << line << "is not in\n" << found.out;
    EXPECT_EQ(std::ranges::count(found.out, '\n'), 4) << found.out;
}

TEST_F(StoryCheck, SaysWhatIsWrongWithAStoryThatCannotBeRead) {
    const Outcome found = check(R"({"format": "vantage-story-1", "notes": [{"title": "The clock"}]})");
    EXPECT_EQ(found.code, int(Exit::input));
    EXPECT_EQ(
        found.out,
        file.string() + ": story unreadable [story-unreadable]: scene.story.json: notes[0].id: is missing\n");
    EXPECT_EQ(check("").code, int(Exit::input));
    std::filesystem::remove(dir / "scene.story.json");
    std::filesystem::create_symlink("nowhere", dir / "scene.story.json");
    EXPECT_EQ(run("check " + file.string()).code, int(Exit::input)) << "a dangling link";
}

#include "player/survey/survey_saver.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

Survey named(const std::string& name) {
    Survey s;
    s.measurements.push_back({name, Measure::point, {{{1, 2, 3}, {}, ""}}});
    return s;
}

class SurveySavers : public TemporaryFolder {
  protected:
    fs::path path = dir / "chapel.measurements.json";
    std::string saved() const {
        SurveyFile file{path};
        const Survey s = read_survey(file, {});
        return s.measurements.empty() ? "" : s.measurements.front().name;
    }
};

/// Polls `done` for up to ten seconds.
std::string trouble_of(SurveySaver& saver) {
    for (int i = 0; i < 1000; ++i) {
        if (std::string trouble = saver.take_trouble(); !trouble.empty()) return trouble;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return "";
}

}  // namespace

TEST_F(SurveySavers, HaveWrittenTheLastSurveyWhenTheyEnd) {
    {
        SurveySaver saver({path});
        for (int i = 0; i < 200; ++i) saver.save(named("after " + std::to_string(i)));
    }
    EXPECT_EQ(saved(), "after 199");
}

TEST_F(SurveySavers, ReadWhatWasSavedBefore) {
    SurveySaver saver({path});
    for (int i = 0; i < 20; ++i) {
        const std::string name = std::to_string(i);
        saver.save(named(name));
        EXPECT_EQ(saver.read({}).measurements.at(0).name, name);
    }
    EXPECT_EQ(saver.take_trouble(), "");
}

TEST_F(SurveySavers, SayWhyASurveyIsNotWrittenAndWriteTheNext) {
    SurveySaver saver({path});
    saver.save(named("mine"));
    EXPECT_EQ(saver.read({}).measurements.size(), 1u);
    fs::rename(path, dir / "away.json");
    std::ofstream(path) << "of another program";
    saver.save(named("lost"));
    EXPECT_NE(trouble_of(saver).find("was changed by another program"), std::string::npos);
    EXPECT_EQ(saver.take_trouble(), "") << "reported once";
    fs::remove(path);
    fs::rename(dir / "away.json", path);
    saver.save(named("again"));
    EXPECT_EQ(saver.read({}).measurements.at(0).name, "again");
}

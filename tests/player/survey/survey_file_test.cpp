#include "player/survey/survey_file.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <regex>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

Survey door() {
    const Eigen::Vector3d low(450000.123456789, 5400000.987654321, 1.0 / 3);
    Survey s{{0.5, Unit::m, Unit::cm, 0.001, {{low, {0, 0, 1}}}}, Eigen::Vector3d(-0.0, 0.6, 0.8), {}};
    s.measurements.push_back(
        {"Door \"west\", \u00e9tage 1",
         Measure::distance,
         {{low, 0.0021, "0003.jpg", 0.0125}, {{450000.123456789, 5400000.987654321, 2.5}, {}, ""}}});
    s.measurements.push_back({"", Measure::point, {{{0, -1e-17, 3}, 0.5, "a.jpg"}}});
    s.measurements.push_back({"", Measure::profile, {{{0, 0, 1}, {}, ""}, {{2, 0, 1}, {}, ""}}});
    return s;
}

class SurveyFiles : public TemporaryFolder {
  protected:
    fs::path path = dir / "chapel.measurements.json";
    void put(const std::string& text) const { std::ofstream(path) << text; }
    std::string trouble() const {
        SurveyFile file{path};
        try {
            read_survey(file, {});
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            return e.what();
        }
        return "";
    }
};

}  // namespace

TEST_F(SurveyFiles, KeepEveryDigit) {
    SurveyFile file{path};
    EXPECT_TRUE(read_survey(file, {}).measurements.empty());
    write_survey(file, door());
    const Survey read = read_survey(file, {});
    const Survey expected = door();
    EXPECT_EQ(read.scale, expected.scale);
    EXPECT_EQ(read.up, expected.up);
    ASSERT_EQ(read.measurements.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const Measurement &a = read.measurements[i], &b = expected.measurements[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.measure, b.measure);
        ASSERT_EQ(a.points.size(), b.points.size());
        for (std::size_t p = 0; p < a.points.size(); ++p) {
            EXPECT_EQ(a.points[p].position, b.points[p].position);
            EXPECT_EQ(a.points[p].uncertainty, b.points[p].uncertainty);
            EXPECT_EQ(a.points[p].photo, b.points[p].photo);
            EXPECT_EQ(a.points[p].pointing, b.points[p].pointing);
        }
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(dir), fs::directory_iterator()), 1)
        << "no other file must remain";
    std::string text = slurp(path);
    EXPECT_EQ(text.find("-0.0"), std::string::npos) << "a direction has no negative zeros";
    // Files of older versions lack these keys.
    text = std::regex_replace(text, std::regex(" *\"pointing\": [^,\n]*,?\n"), "");
    text = std::regex_replace(text, std::regex(",\\s*\"between\": \\[[^}]*"), "");
    put(std::regex_replace(text, std::regex(",(\\s*})"), "$1"));
    const Survey old = read_survey(file, {});
    EXPECT_FALSE(old.scale.between);
    EXPECT_EQ(uncertainty_of(old.measurements[0].points[0]), 0.0021) << "as before";
}

TEST_F(SurveyFiles, AreRefusedInOneLineAndLeftAlone) {
    std::string good = survey_text(door());
    std::vector<std::string> bad{"",
                                 "{",
                                 "[1,2]",
                                 "{\"format\":\"other\"}",
                                 good.substr(0, good.size() / 2),
                                 good.substr(0, good.size() - 3)};
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        bad.push_back(text.replace(at, from.size(), to));
    };
    with("\"version\": 1", "\"version\": 2");
    with("\"distance\"", "\"volume\"");
    with("0.0021", "-1");
    with("0.0021", "1e999");
    with("\"uncertainty\": 0.0021", "\"uncertainty\": \"small\"");
    with("\"length\": 0.5", "\"length\": 0");
    with("\"unit\": \"m\"", "\"unit\": \"furlong\"");
    with("450000.123456789,", "");
    with("\"points\"", "\"spots\"");
    for (const std::string& text : bad) {
        put(text);
        EXPECT_TRUE(!trouble().empty() && std::ranges::count(trouble(), '\n') == 0) << text << "\n"
                                                                                    << trouble();
        EXPECT_NE(trouble().find(path.string()), std::string::npos);
        SurveyFile file{path};
        EXPECT_THROW(write_survey(file, door()), Error) << "writing would replace an unreadable file";
        EXPECT_EQ(slurp(path), text);
    }
}

TEST_F(SurveyFiles, AreNotReplacedIfSomeoneElseChangedThem) {
    SurveyFile mine{path}, other{path};
    write_survey(mine, door());
    read_survey(other, {});
    write_survey(mine, {});
    EXPECT_THROW(write_survey(other, door()), Error);
    EXPECT_EQ(slurp(path), survey_text({}));
    fs::remove(path);
    EXPECT_THROW(write_survey(other, door()), Error) << "someone removed it";
}

TEST_F(SurveyFiles, ThatCannotBeWrittenLeaveNothingBehind) {
    SurveyFile nowhere{dir / "missing" / "a.measurements.json"};
    EXPECT_THROW(write_survey(nowhere, door()), Error);
    EXPECT_TRUE(fs::is_empty(dir));
}

TEST_F(SurveyFiles, LieBesideThePackage) {
    EXPECT_EQ(survey_file_of("collection/chapel.vantage", false).path, "collection/chapel.measurements.json");
    EXPECT_EQ(survey_file_of("https://example.org/chapel.vantage", true).path, "chapel.measurements.json");
}

TEST(Survey, BecomesATable) {
    const std::string table = survey_csv(door());
    EXPECT_NE(table.find("name,measure,value,uncertainty,unit,note,points\n"), std::string::npos);
    EXPECT_NE(table.find("\"Door \"\"west\"\", \u00e9tage 1\",distance,108.333333333,"), std::string::npos)
        << table;
    EXPECT_EQ(std::ranges::count(table, '\n'), 4);
}

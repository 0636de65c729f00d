#include "pipeline/costs/cost_statistics.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pipeline/costs/cost_answers.h"
#include "pipeline/costs/cost_table.h"

namespace vantage {
namespace {

TrialCosts trial(const std::string& setting, const std::string& value, double seconds, double bytes,
                 std::vector<double> psnr) {
    TrialCosts c;
    c.trial.setting = setting;
    c.trial.value = value;
    c.trial.usual = "usual";
    c.prepare_seconds = {seconds};
    c.package_bytes = bytes;
    c.psnr = std::move(psnr);
    return c;
}

/// Two scans with photos of different sizes. Halving the size saves half of the time on the first scan and
/// three quarters on the second.
std::vector<ScanCosts> two_scans() {
    std::vector<ScanCosts> scans(2);
    for (int i = 0; i < 2; ++i) {
        scans[i].name = i == 0 ? "large" : "small";
        scans[i].width = i == 0 ? 4000 : 1000;
        scans[i].trials.push_back(trial("", "", 8, 1e6, {30, 31}));
        scans[i].trials.push_back(trial("--max-photo-size", i == 0 ? "2000" : "500", i == 0 ? 4 : 2, 1e6,
                                        {-1.0 - 0.2 * i, -1.1 - 0.2 * i}));
    }
    scans[0].trials[1].default_seconds = {8.2};
    return scans;
}

TEST(CostStatistics, ConfidenceIntervalsAreThoseOfStudent) {
    const MeanWithError e = *estimate(std::vector<double>{1, 2, 3});
    EXPECT_DOUBLE_EQ(e.mean, 2);
    EXPECT_NEAR(e.error, 2.4841, 1e-3);  // t(0.975, 2) / sqrt(3), from a table of Student's t
    EXPECT_FALSE(certain(e));
    EXPECT_TRUE(certain(*estimate(std::vector<double>{2.9, 3, 3.1})));
    EXPECT_FALSE(certain(*estimate(std::vector<double>{5}))) << "a single photo proves nothing";
    EXPECT_FALSE(estimate({}));
}

TEST(CostStatistics, ScansArePooledByTheFractionOfThePhotosSize) {
    const std::vector<PooledTrial> pooled = pooled_trials(two_scans());
    ASSERT_EQ(pooled.size(), 2u);
    EXPECT_EQ(pooled[1].trial.value, "half");
    EXPECT_EQ(pooled[1].scans, (std::vector<std::string>{"large", "small"}));
    EXPECT_NEAR(*pooled[1].seconds, std::sqrt(4 / 8.2 * 2 / 8), 1e-9) << "the geometric mean of both";
    EXPECT_EQ(pooled[1].psnr->values, 4u);
    EXPECT_NEAR(pooled[1].psnr->mean, -1.15, 1e-9);
    EXPECT_FALSE(pooled[1].frame) << "not measured";
}

TEST(CostStatistics, NoiseIsTheSpreadOfTheDefaultsRepeatedTimes) {
    std::vector<ScanCosts> scans = two_scans();
    EXPECT_EQ(noise_of(scans).seconds, 0.05) << "the least, if no time was repeated";
    scans[0].trials.push_back(scans[0].trials[1]);
    scans[0].trials.back().default_seconds = {12.4, 9.02};
    EXPECT_NEAR(noise_of(scans).seconds, 0.1, 1e-9) << "between the least times of both runs";
    EXPECT_EQ(noise_of(scans).frame, 0.05);
}

TEST(CostTable, ReportsOnlyWhatExceedsTheNoise) {
    EXPECT_EQ(change_text(1.04, 0.05), "same");
    EXPECT_EQ(change_text(0.8, 0.05), "-20 %");
    EXPECT_EQ(change_text(2.5, 0.05), "2.5 times");
    EXPECT_EQ(change_text({}, 0.05), "");
    EXPECT_EQ(gain_text(MeanWithError{-1, 0.2, 9}, false), "-1.00 ± 0.20 dB");
    EXPECT_EQ(gain_text(MeanWithError{-1, 1.2, 9}, false), "cannot tell (-1.00 ± 1.20 dB)");
    EXPECT_EQ(gain_text(MeanWithError{-0.05, 0.1, 9}, false), "equal (-0.05 ± 0.10 dB)");
    EXPECT_EQ(gain_text(MeanWithError{0, 0, 9}, false), "identical");
}

TEST(CostTable, ListsTheValuesOfASettingByTheirCost) {
    std::vector<ScanCosts> scans = two_scans();
    scans[0].trials.push_back(trial("--effect", "compact=off", 8, 9e6, {0, 0}));
    scans[0].trials.push_back(trial("--max-photo-size", "1000", 2, 1e5, {-2, -2.1}));
    const TextTable table = setting_table(scans);
    ASSERT_EQ(table.rows.size(), 3u);
    using Row = std::vector<std::string>;
    EXPECT_EQ(table.rows[0], (Row{"`--max-photo-size`", "usual", "a quarter",
                                  "preparing -75 %, package -90 %", "-2.05 ± 0.64 dB", "large; 2 photos"}));
    EXPECT_EQ(table.rows[1],
              (Row{"", "", "half", "preparing -65 %", "-1.15 ± 0.21 dB", "all scans; 4 photos"}));
    EXPECT_EQ(table.rows[2], (Row{"`--effect compact`", "usual", "off", "package 9.0 times", "identical",
                                  "large; 2 photos"}));
}

TEST(CostAnswers, NameCostQualityAndCertainty) {
    const std::vector<std::string> answers = cost_answers(two_scans());
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[0],
              "Photos of half the width and height (`--max-photo-size`): preparing -65 %. Quality: "
              "-1.15 ± 0.21 dB");
    EXPECT_NE(answers[1].find("4 held-out photos of 2 scans"), std::string::npos) << answers[1];
}

TEST(Costs, AreReadAsTheyWereWritten) {
    Costs costs;
    costs.version = "1.2.3";
    costs.scans = two_scans();
    costs.scans[0].held_out = {{"a.jpg", "b.jpg"}, {"c.jpg"}};
    costs.scans[0].recipes.push_back({"a kiosk", "rule", {"vantage prepare"}, costs.scans[0].trials[1]});
    EXPECT_EQ(to_json(costs_of(to_json(costs))), to_json(costs));
    nlohmann::json damaged = to_json(costs);
    damaged["scans"][0].erase("trials");
    EXPECT_THROW(costs_of(damaged), nlohmann::json::exception);
}

}  // namespace
}  // namespace vantage

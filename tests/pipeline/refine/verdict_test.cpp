#include "pipeline/refine/verdict.h"

#include <gtest/gtest.h>

using namespace vantage;

namespace {

/// The validation of photos with these gains in dB; seams are 1 without the effect and `seams` with it.
Judgment validated(const std::vector<double>& gains, double seams = 1) {
    std::vector<ValidatedPhoto> photos;
    for (const double g : gains)
        photos.push_back(
            {"photo" + std::to_string(photos.size()), {10000, 30, 0.9, 1}, {10000, 30 + g, 0.9, seams}});
    return summarize(photos);
}

}  // namespace

TEST(Verdict, SummarizesGainErrorAndWorstPhoto) {
    const Judgment j = validated({0.1, 0.3, -0.1, 0.5});
    EXPECT_NEAR(j.gain, 0.2, 1e-9);
    EXPECT_NEAR(j.error, 0.1291, 1e-4) << "standard error of the mean";
    EXPECT_NEAR(j.noise, 0.0354, 1e-4) << "as if one of 4 photos lost 0.1 and another gained 0.1";
    EXPECT_EQ(j.worse, 1);
    EXPECT_EQ(j.worst_photo, "photo2");
    EXPECT_NEAR(j.worst, -0.1, 1e-9);
}

TEST(Verdict, ClearGainCallsForAnEffect) {
    EXPECT_TRUE(is_called_for(validated({0.2, 0.3, 0.25})));
    EXPECT_FALSE(is_called_for(validated({1, -0.4, 0.1}))) << "within the error";
    EXPECT_TRUE(is_called_for(validated({4, 1, 0, 0.01, -0.01, 0})))
        << "a few photos gain, and none loses much";
    EXPECT_FALSE(is_called_for(validated({2, 0.3, -0.4, -0.4, -0.4, -0.4})))
        << "one photo gains, and most lose";
    EXPECT_FALSE(is_called_for(validated({0, 0, 0})));
    EXPECT_FALSE(is_called_for(validated({-0.2, -0.3, -0.25})));
}

TEST(Verdict, FewerSeamsCallForAnEffectThatLosesNothing) {
    EXPECT_TRUE(is_called_for(validated({0.1, -0.1, 0.05}, 0.8)));
    EXPECT_FALSE(is_called_for(validated({0.1, -0.1, 0.05}, 0.95)));
    EXPECT_FALSE(is_called_for(validated({-0.2, -0.3, -0.25}, 0.5)));
}

TEST(Verdict, NoPhotoMayLoseMuch) {
    EXPECT_FALSE(is_called_for(validated({2, 2.1, 1.9, 2, 2, 2, 2, 2, -0.9}, 0.5)));
}

TEST(Verdict, TooFewPhotosDoNotJudge) {
    EXPECT_FALSE(is_called_for(validated({1, 1})));
    EXPECT_EQ(validated({}).photos, 0);
    EffectDecision decision{Effect::exposure, true, false, 0.1, "differ"};
    confirm(decision, validated({-1, -1}));
    EXPECT_TRUE(decision.on) << "decided by the threshold";
    confirm(decision, validated({-1, -1, -1}));
    EXPECT_FALSE(decision.on);
    EffectDecision forced{Effect::exposure, true, true, 0.1, "differ"};
    confirm(forced, validated({-1, -1, -1}));
    EXPECT_TRUE(forced.on);
}

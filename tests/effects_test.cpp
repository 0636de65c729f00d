#include "scene/effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/error.h"

using namespace vantage;

TEST(Effects, AreOnAboveTheirThresholdOnly) {
    for (const EffectRow& row : effect_table()) {
        EXPECT_FALSE(decide(row.effect, EffectChoice::automatic, row.threshold, "").on) << row.name;
        EXPECT_TRUE(decide(row.effect, EffectChoice::automatic, row.threshold * 1.01 + 1e-9, "").on)
            << row.name;
        EXPECT_FALSE(decide(row.effect, EffectChoice::automatic, std::nan(""), "").on) << row.name;
    }
}

TEST(Effects, CanBeForcedAgainstTheEvidence) {
    const EffectDecision off = decide(Effect::undistortion, EffectChoice::off, 100, "");
    EXPECT_FALSE(off.on);
    EXPECT_TRUE(off.forced);
    EXPECT_TRUE(decide(Effect::undistortion, EffectChoice::on, 0, "").on);
}

TEST(Effects, AreFoundByNameAndAStrangerIsNamed) {
    for (const EffectRow& row : effect_table())
        EXPECT_EQ(effect_row(std::string(row.name)).effect, row.effect);
    try {
        effect_row(std::string("sparkle"));
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::usage);
        EXPECT_NE(std::string(e.what()).find("undistortion"), std::string::npos);
    }
}

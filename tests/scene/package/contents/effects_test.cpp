#include "scene/package/contents/effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/text/error.h"

using namespace vantage;

TEST(Effects, AreOnOnlyAboveTheirThreshold) {
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

TEST(Effects, AreFoundByNameAndUnknownNamesAreRejected) {
    for (const EffectRow& row : effect_table())
        for (const char* name : {row.name, row.option}) EXPECT_EQ(effect_row(name).effect, row.effect);
    try {
        effect_row("sparkle");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::usage);
        EXPECT_NE(std::string(e.what()).find("undistortion"), std::string::npos);
    }
}

TEST(Effects, KeepTheSpellingThatPackagesStore) {
    EXPECT_STREQ(effect_row("fov-normalization").name, "fov-normalization");
}

TEST(Effects, DefineSymbolsOnlyInTheirShaderProgram) {
    const EffectSet on = effect_bit(Effect::vertex_colors) | effect_bit(Effect::per_fragment) |
                         effect_bit(Effect::vignetting) | effect_bit(Effect::pose_refinement);
    EXPECT_EQ(shader_defines("surface", on), std::vector<std::string>{"VERTEX_COLORS"});
    EXPECT_EQ(shader_defines("blend", on), (std::vector<std::string>{"PER_FRAGMENT", "PHOTO_VIGNETTING"}));
    EXPECT_TRUE(shader_defines("blend", on & effects_from(Basis::pixels)).empty());
}

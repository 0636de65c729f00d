#include "pipeline/costs/effect_costs.h"

#include <gtest/gtest.h>

#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

class EffectCosts : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(tiny_spec(), dir / "scene");
        copy_package(dir / "scene", {}, dir / "scene.vantage");
    }
    /// A scan on which per-fragment coordinates add 0.5 s to preparation and 20 ms to a frame, and gain 2 dB.
    static KnownCosts known() {
        KnownCosts k;
        k.own = true;
        ScanCosts& scan = k.costs.scans.emplace_back();
        scan.trials.resize(2);
        scan.trials[0].prepare_seconds = {3};
        scan.trials[0].frame_ms = {100};
        scan.trials[1].trial.setting = "--effect";
        scan.trials[1].trial.value = "per-fragment=off";
        scan.trials[1].prepare_seconds = {2.5};
        scan.trials[1].frame_ms = {80};
        scan.trials[1].psnr = {-1.9, -2.1};
        return k;
    }
    EffectCost cost_of(const char* name, const KnownCosts& from) const {
        const auto all = effect_costs(PackageReader(dir / "scene.vantage"), {}, from);
        return *std::ranges::find(all, name, &EffectCost::name);
    }
};

TEST_F(EffectCosts, AreTheDifferencesThatTurningAnEffectOffMakes) {
    const EffectCost cost = cost_of("per-fragment", known());
    ASSERT_EQ(cost.state, "on");
    EXPECT_NEAR(cost.gain->mean, 2, 1e-9);
    EXPECT_NEAR(cost.gain->error, 0.1, 1e-9) << "standard error of two values 0.2 apart";
    EXPECT_NEAR(*cost.seconds, 0.5, 1e-9);
    EXPECT_NEAR(*cost.frame_ms, 20, 1e-9);
}

TEST_F(EffectCosts, AnEffectThatIsOffCostsNothingInAFrame) {
    EXPECT_EQ(cost_of("points", known()).frame_ms, 0);
    EXPECT_EQ(cost_of("points", {}).frame_ms, 0);
}

TEST_F(EffectCosts, SayWhereTheyWereMeasured) {
    EXPECT_NE(origin_of(known()).find("on this scan"), std::string::npos);
    EXPECT_NE(origin_of(KnownCosts{}).find("'vantage costs SCAN' measures"), std::string::npos);
    EXPECT_FALSE(cost_of("per-fragment", {}).frame_ms);
}

}  // namespace
}  // namespace vantage

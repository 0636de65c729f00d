#include "pipeline/results/explain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/progress.h"
#include "pipeline/settings/settings.h"
#include "pipeline/synth/synthesize.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class Explain : public TemporaryFolder {
  protected:
    std::string explained(const PrepareSettings& settings) {
        synthesize(read_spec(VANTAGE_SOURCE_DIR "/data/tiny.toml"), dir / "scene", {});
        const SceneInput scene = read_scene(discover(dir / "scene"));
        prepare(scene, settings, dir / "p.vantage", [](const Progress&) {});
        std::string all;
        for (const std::string& line : explain(settings, scene, PackageReader(dir / "p.vantage")))
            all += line + "\n";
        return all;
    }
};

}  // namespace

TEST_F(Explain, ListsEverySettingWithItsMeasurement) {
    PrepareSettings settings;
    settings.distance = DistanceMethod::jfa;
    settings.photo_size = 165;
    const std::string text = explained(settings);
    for (const char* option : {"photo-size", "distance", "border-width", "border-threshold", "thumbnail",
                               "cluster-triangles", "per-fragment"})
        EXPECT_NE(text.find(option), std::string::npos) << option << " in\n" << text;
    EXPECT_EQ(text.find("not measured"), std::string::npos) << text;
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_NE(text.find("0.50 of 331 px"), std::string::npos) << text;
    EXPECT_NE(text.find("jfa "), std::string::npos) << text;
}

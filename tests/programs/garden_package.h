#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/programs/garden_spec.h"
#include "tests/temporary_folder.h"

namespace vantage {

/// A package that shows a small building in a garden.
class GardenPackage : public TemporaryFolder {
  protected:
    void make_package(const std::map<Effect, EffectChoice>& effects) const {
        copy_scene(garden_spec(3000, 400, 300), dir / "scene");
        PrepareSettings settings;
        settings.effects = effects;
        copy_package(dir / "scene", settings, file);
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    /// Renders the package to NAME.png with the player.
    std::filesystem::path offscreen(const std::string& name, const std::string& options) const {
        const std::filesystem::path png = dir / (name + ".png");
        const int status = std::system(
            (VANTAGE_PLAYER " render " + file.string() + " --quiet " + options + " -o " + png.string())
                .c_str());
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0) << options;
        return png;
    }
    std::filesystem::path file = dir / "scene.vantage";
};

}  // namespace vantage

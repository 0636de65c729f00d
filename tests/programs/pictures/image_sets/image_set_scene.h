#pragma once
// Two image sets of one synthetic building, which are shown one at a time. One is in visible light; the other
// is in infrared light and reveals an underdrawing.
#include <sys/wait.h>

#include <cstdlib>
#include <random>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/prepare/prepare.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

namespace fs = std::filesystem;

class ImageSets : public TemporaryFolder {
  protected:
    static constexpr std::uint32_t visible = 0, infrared = 1;
    static SynthSpec small_scene() {
        SynthSpec spec = spec_named("image_sets");
        spec.photos.samples = 1;
        spec.infrared.stops = 0;
        return spec;
    }
    void make(const SynthSpec& spec, const std::string& name = "scene") const {
        copy_scene(spec, dir / name);
    }
    PackageReader prepared(const std::string& scene = "scene", const PrepareSettings& settings = {},
                           const std::string& how = "auto") const {
        InputFiles given;
        given.image_sets = how;
        if (how == "auto")
            copy_package(dir / scene, settings, dir / (scene + ".vantage"));
        else
            prepare(read_scene(discover(dir / scene, given)), settings, dir / (scene + ".vantage"),
                    [](const Progress&) {});
        return PackageReader(dir / (scene + ".vantage"));
    }
    /// Adds random noise to every pixel of the photos in an image set.
    void add_noise(const std::string& scene, const std::string& image_set = "infrared") const {
        const int width = image_set == "infrared" ? 260 : 331, height = image_set == "infrared" ? 200 : 250;
        std::mt19937 random(7);
        for (const auto& entry : fs::directory_iterator(dir / scene / "images" / image_set)) {
            std::vector<std::byte> pixels(std::size_t(width * height * 3));
            for (std::byte& b : pixels) b = std::byte(random() & 255);
            image_files().write(entry.path(), width, height, 3, Sample::u8, pixels);
        }
    }
    struct Ran {
        int code;
        std::string says;
    };
    Ran run(const std::string& command) const {
        const int status = std::system((command + " >" + (dir / "says").string() + " 2>&1").c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(dir / "says")};
    }
};

}  // namespace vantage

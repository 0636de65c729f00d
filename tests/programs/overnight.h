#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files/part_file.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_writer.h"
#include "tests/made_scenes.h"
#include "tests/programs/run_program.h"
#include "tests/temporary_folder.h"

namespace vantage {

namespace fs = std::filesystem;

class Overnight : public TemporaryFolder {
  protected:
    const fs::path scene = dir / "scene", file = dir / "scene.vantage";

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 6;
        spec.photos.samples = 1;
        copy_scene(spec, scene);
        ::setenv("XDG_CACHE_HOME", (dir / "cache").c_str(), 1);
    }

    Outcome run(const std::string& words, const std::string& before = "",
                const std::string& program = VANTAGE_PROGRAM) const {
        return run_command(before + " " + program + " " + words, dir);
    }
    Outcome prepare_program(const std::string& options = "", const std::string& before = "") const {
        return run("prepare --progress none " + scene.string() + " -o " + file.string() + " " + options,
                   before);
    }
    Outcome with_fault(const std::string& fault, const std::string& options = "") const {
        return prepare_program(options, "FAULT=" + fault + " LD_PRELOAD=" FAULTY_DISK);
    }
    /// The bytes of the package that an uninterrupted run writes.
    std::string undisturbed(const PrepareSettings& settings = {}) const {
        const fs::path other = dir / "undisturbed.vantage";
        copy_package(scene, settings, other);
        return slurp(other);
    }
    PrepareResult prepare_here(const PrepareSettings& settings = {}) const {
        return prepare(read_scene(discover(scene)), settings, file, [](const Progress&) {});
    }
    std::vector<fs::path> photos() const {
        std::vector<fs::path> all;
        for (const auto& e : fs::directory_iterator(discover(scene).photos)) all.push_back(e.path());
        std::ranges::sort(all);
        return all;
    }
    void expect_whole(const std::string& bytes, const std::string& after) const {
        EXPECT_TRUE(slurp(file) == bytes) << after << ": differs from an uninterrupted run";
        EXPECT_FALSE(fs::exists(part_of(file))) << after;
        EXPECT_FALSE(fs::exists(displaced_part_of(file))) << after;
    }
};

}  // namespace vantage

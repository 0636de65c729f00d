// Settings from presets and configuration files, which the command line overrides.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/apply_config.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

struct Settings {
    Command command{"configured", ""};
    int size = 1;
    bool trim = false;
    std::vector<std::string> names;
    Settings() {
        command.integer("--size", size, 1, 10, "");
        command.flag("--trim", trim, "");
        command.list("--names", names, "");
    }
};

class Config : public TemporaryFolder {
  protected:
    const fs::path file = dir / "a.toml";
    std::string holding(const char* text) {
        std::ofstream(file) << text;
        return file.string();
    }
};

}  // namespace

TEST_F(Config, CommandLineOverridesTheFile) {
    Settings s;
    s.command.run({"--size", "7"});
    apply_config(s.command, holding("size = 3\nnames = ['a', 'b']\n"));
    EXPECT_EQ(s.size, 7);
    EXPECT_EQ(s.names, (std::vector<std::string>{"a", "b"}));
    Settings plain;
    apply_config(plain.command, file.string());
    EXPECT_EQ(plain.size, 3);
}

TEST_F(Config, RejectsUnknownOrInvalidSettings) {
    for (const char* text : {"color = 3\n", "size = 99\n", "size = {}\n", "size = \n", "size = [3, 4]\n",
                             "size = []\n", "trim = []\n"}) {
        const Settings s;
        EXPECT_THROW(apply_config(s.command, holding(text)), Error) << text;
    }
    const Settings s;
    EXPECT_THROW(apply_config(s.command, "no-such-preset"), Error);
}

TEST_F(Config, PrepareAcceptsEveryPreset) {
    for (const auto& preset : fs::directory_iterator(VANTAGE_SOURCE_DIR "/configs")) {
        if (preset.path().extension() != ".toml") continue;
        const Command program("vantage", "");
        add_prepare(program);
        try {
            program.run({"prepare", (dir / "none").string(), "-o", (dir / "out").string(), "--preset",
                         preset.path().string()});
            ADD_FAILURE() << "there is nothing to prepare";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input) << preset.path() << ": " << e.what();
        }
    }
}

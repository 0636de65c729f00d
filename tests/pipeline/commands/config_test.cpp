// Settings from presets and configuration files, which the command line overrides.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "pipeline/commands/apply_config.h"
#include "pipeline/commands/commands.h"
#include "player/commands/commands.h"
#include "scene/error.h"
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
            program.run({"prepare", (dir / "none").string(), "-o", (dir / "out").string(), "--config",
                         preset.path().string()});
            ADD_FAILURE() << "there is nothing to prepare";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input) << preset.path() << ": " << e.what();
        }
    }
}

/// NaN would pass every comparison with a bound.
void expect_nan_rejected(CLI::App& app) {
    for (CLI::Option* option : app.get_options())
        if (option->get_type_name().starts_with("FLOAT")) {
            option->add_result("nan");
            EXPECT_THROW(option->run_callback(), CLI::ParseError) << option->get_name();
        }
    for (CLI::App* sub : app.get_subcommands({})) expect_nan_rejected(*sub);
}

TEST(Options, RejectNan) {
    CLI::App player, bench, evaluate, verify;
    ShowOptions options;
    BenchOptions b;
    EvaluateOptions e;
    VerifyOptions v;
    UnusedOptions unused_by_bench, unused_by_evaluate;
    add_show_options(player, options);
    add_bench_options(bench, b, unused_by_bench);
    add_evaluate_options(evaluate, e, unused_by_evaluate);
    add_verify_options(verify, v);
    for (CLI::App* a : {&player, &bench, &evaluate, &verify}) expect_nan_rejected(*a);
}

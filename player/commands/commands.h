#pragma once
#include <CLI/CLI.hpp>

#include "player/commands/unused_options.h"
#include "player/evaluate/evaluate.h"
#include "player/measure/bench.h"
#include "player/measure/smoothness.h"
#include "player/options/show_options.h"
#include "player/orthophoto/orthophoto.h"
#include "player/verify/verify.h"

/// The verbs of vantage-player: each parses its command line and runs. They return the exit code and throw
/// Error. `argv[0]` is the name of the program or the verb.
namespace vantage {

int show_command(int argc, char** argv);
int bench_command(int argc, char** argv);
int evaluate_command(int argc, char** argv);
int orthophoto_command(int argc, char** argv);
int smoothness_command(int argc, char** argv);
int verify_command(int argc, char** argv);

/// A first argument that selects a command other than show_command.
struct Verb {
    const char* name;
    int (*command)(int argc, char** argv);
    const char* description;  ///< one line, for --help
};
inline constexpr Verb verbs[] = {
    {"bench", bench_command, "fly scripted paths and measure every frame"},
    {"evaluate", evaluate_command, "leave out each photo in turn and score the picture that the others give"},
    {"orthophoto", orthophoto_command, "project the model on a plane and write a picture true to scale"},
    {"smoothness", smoothness_command, "measure how far colors jump from frame to frame along a path"},
    {"verify", verify_command, "compare renderings of packages with stored pictures"},
};

void add_show_options(CLI::App& app, ShowOptions& options);
void add_bench_options(CLI::App& app, BenchOptions& options, UnusedOptions& unused);
void add_evaluate_options(CLI::App& app, EvaluateOptions& options, UnusedOptions& unused);
void add_orthophoto_options(CLI::App& app, OrthophotoOptions& options);
void add_smoothness_options(CLI::App& app, SmoothnessOptions& options);
void add_verify_options(CLI::App& app, VerifyOptions& options);

}  // namespace vantage

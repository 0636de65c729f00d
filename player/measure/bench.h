#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "player/options.h"
#include "scene/package_reader.h"

namespace vantage {

/// The command line of `vantage-player bench`.
struct BenchOptions {
    Options player;  ///< the package, budgets and blending
    std::vector<std::string> paths{"still", "orbit", "approach", "jump"};
    std::vector<std::string> modes{"stream", "resident", "whole"};
    int frames = 120, repeats = 3;
    double minutes = 0;  ///< instead of `frames`
    bool warm = false;
    std::string sweep;
    int pictures = 0;  ///< frames of a path kept as PNG
    std::filesystem::path folder = "bench";
};
void add_bench_options(CLI::App& app, BenchOptions& options);

/// Flies scripted paths without a display, and writes what every frame took: frames.csv, summary.json, and a
/// plot a path, and frames as PNG where asked for. Prints the summary. Throws Error.
int run_bench(const PackageReader& package, BenchOptions options);

}  // namespace vantage

#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>

#include "player/options.h"
#include "scene/package_reader.h"

namespace vantage {

/// The command line of `vantage-player evaluate`.
struct EvaluateOptions {
    Options player;  ///< the package, and how it is blended
    int level = 1;   ///< of the photos' pyramids: 0 is full size, 1 half
    int every = 1;   ///< photo that is left out
    int worst = 3;   ///< whose pictures the page shows first
    std::filesystem::path folder = "evaluation";
    std::filesystem::path against;  ///< folder of an earlier evaluation, or empty
};
void add_evaluate_options(CLI::App& app, EvaluateOptions& options);

/// Leaves each photo out in turn, renders from its camera with the others, and compares with the photo
/// itself: how good scan, calibration and coverage are, photo by photo and region by region. Writes
/// photos.csv, regions.csv, regions.ply (the model, coloured by error), pictures and index.html; prints the
/// table. With `against`, what has changed since, photo by photo, and where most. Throws Error.
int run_evaluate(const PackageReader& package, EvaluateOptions options);

}  // namespace vantage

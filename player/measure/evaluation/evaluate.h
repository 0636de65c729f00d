#pragma once
#include <filesystem>

#include "player/options/memory_options.h"
#include "player/options/output_options.h"
#include "player/options/shown/blending_options.h"
#include "player/options/shown/package_options.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The command line of `vantage-player evaluate`.
struct EvaluateOptions {
    PackageOptions package;
    BlendingOptions blending;
    MemoryOptions memory;
    OutputOptions output;
    int level = 1;  ///< level of the photos' pyramids: 0 is full size, 1 is half size
    int every = 1;  ///< every n-th photo is held out
    int worst = 3;  ///< number of photos shown first on the page
    std::filesystem::path folder = "evaluation";
    std::filesystem::path against;  ///< folder of an earlier evaluation, or empty
};

/// Holds out each photo in turn, renders its view from the others, and compares the picture with the photo: a
/// measure of scan, calibration and coverage, per photo and per region. Writes photos.csv, regions.csv,
/// regions.ply (the model, colored by error), pictures and index.html, and prints the table; with `against`,
/// also the changes since an earlier evaluation. Throws Error.
int run_evaluate(const PackageReader& package, const EvaluateOptions& options);

}  // namespace vantage

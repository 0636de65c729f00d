#pragma once
#include "player/measure/bench/flight.h"
#include "player/options/shown/object_options.h"

namespace vantage {

/// The command line of `vantage-player bench`.
struct BenchOptions : FlightOptions {
    ObjectOptions objects;
    std::vector<std::string> paths{"still", "orbit", "approach", "jump"};
    std::vector<std::string> modes{"stream", "resident", "whole"};
    int repeats = 3;
    OutputOptions output;
};

/// Flies scripted paths without a display, prints a summary, and writes the measurements of every frame:
/// frames.csv, summary.json, a plot per path and, if requested, frames as PNG. Throws Error.
int run_bench(const PackageReader& package, const BenchOptions& options);

}  // namespace vantage

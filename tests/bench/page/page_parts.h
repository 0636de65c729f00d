#pragma once
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/page/page.h"
#include "tests/bench/plots/gnuplot.h"
#include "tests/bench/results/moved.h"

namespace vantage::bench {

/// The rows of one sweep on one scene.
struct ScenePart {
    std::string scene;
    std::span<const Measurement> rows;
};
struct SweepPart {
    const Sweep* sweep;
    std::vector<ScenePart> scenes;  ///< none where it was not measured
};

/// What all parts of a page are written from.
struct PageContent {
    const PageInput& input;
    std::filesystem::path folder;
    std::vector<SweepPart> sweeps;
    std::optional<Comparison> comparison;
};

/// Where a value was in the earlier run; none where it has not moved.
const Moved* find_moved(const PageContent& page, const Measurement& row, const char* metric);

/// "worse", "better" or "" where the metric is neither.
const char* verdict_class(const Moved& moved);

/// In words, how far row `i` is from the front of a plot; empty where it is not on that plot.
std::string verdict(std::span<const Measurement> rows, std::size_t i, const Plot& plot);

PlotAxis axis_for(const char* metric, bool log);
/// Without `quiet` and what else depends on the plot's purpose.
PlotPoint point_for(const PageContent& page, const Measurement& row, const Plot& plot);
/// A plot, and below it what it could not show; besides, as folder/plots/SWEEP-TITLE.svg. Throws
/// Error(storage).
void write_plot(std::ostream& out, const PageContent& page, const Sweep& sweep, const PlotSpec& spec,
                std::span<const Measurement> rows, const Plot& plot);
/// All rows; marked those on the front of `plot`, if there is one.
void write_rows(std::ostream& out, const PageContent& page, std::span<const Measurement> rows,
                const Plot* plot);
/// Ends the grid of a scene's plots, the rows' pictures in it if they are few, below it if they are many.
void close_scene(std::ostream& out, const PageContent& page, std::span<const Measurement> rows);

void write_moved(std::ostream& out, const PageContent& page);
void write_sweep(std::ostream& out, const PageContent& page, const SweepPart& part);
void write_presets(std::ostream& out, const PageContent& page, const SweepPart& part);

}  // namespace vantage::bench

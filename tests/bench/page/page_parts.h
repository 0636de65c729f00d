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
    std::vector<ScenePart> scenes;  ///< empty if the sweep was not measured
};

/// The data of all parts of a page.
struct PageContent {
    const PageInput& input;
    std::filesystem::path folder;
    std::vector<SweepPart> sweeps;
    std::optional<Comparison> comparison;
};

/// The change in a value since the earlier run; null if the change does not exceed the noise.
const Moved* find_moved(const PageContent& page, const Measurement& row, const char* metric);

/// The CSS class of a change: "worse", "better", or "" if neither applies or the value is no longer measured.
const char* verdict_class(const Moved& moved);

/// Describes how far row `i` is from the front of a plot; empty if the row is not in the plot.
std::string verdict(std::span<const Measurement> rows, std::size_t i, const Plot& plot);

PlotAxis axis_for(const char* metric, bool log);
/// The row's point in the plot.
PlotPoint point_for(const PageContent& page, const Measurement& row, const Plot& plot);
/// Writes a plot and a list of the rows that the plot cannot show, and saves the plot as
/// folder/plots/SWEEP-TITLE.svg. Throws Error(storage).
void write_plot(std::ostream& out, const PageContent& page, const Sweep& sweep, const PlotSpec& spec,
                std::span<const Measurement> rows, const Plot& plot);
/// Writes a table of all rows. If `plot` is not null, rows on its front are marked.
void write_rows(std::ostream& out, const PageContent& page, std::span<const Measurement> rows,
                const Plot* plot);
/// Ends the grid of a scene's plots. If the rows have only a few pictures, these go into the grid; otherwise,
/// they go below it.
void close_scene(std::ostream& out, const PageContent& page, std::span<const Measurement> rows);

void write_moved(std::ostream& out, const PageContent& page);
void write_sweep(std::ostream& out, const PageContent& page, const SweepPart& part);

}  // namespace vantage::bench

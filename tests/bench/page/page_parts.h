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
    std::vector<ScenePart> scenes;  ///< empty if it was not measured
};

/// The data of all parts of a page.
struct PageContent {
    const PageInput& input;
    std::filesystem::path folder;
    std::vector<SweepPart> sweeps;
    std::optional<Comparison> comparison;
};

/// The change of a value since the earlier run; null if it has not moved.
const Moved* find_moved(const PageContent& page, const Measurement& row, const char* metric);

/// CSS class: "worse", "better", or "" if neither applies or the value is no longer measured.
const char* verdict_class(const Moved& moved);

/// Describes how far row `i` is from the front of a plot; empty if it is not on the plot.
std::string verdict(std::span<const Measurement> rows, std::size_t i, const Plot& plot);

PlotAxis axis_for(const char* metric, bool log);
/// The row's point in the plot, except `quiet`, which is not set here.
PlotPoint point_for(const PageContent& page, const Measurement& row, const Plot& plot);
/// Writes a plot with a list of the rows it cannot show, and saves it as folder/plots/SWEEP-TITLE.svg. Throws
/// Error(storage).
void write_plot(std::ostream& out, const PageContent& page, const Sweep& sweep, const PlotSpec& spec,
                std::span<const Measurement> rows, const Plot& plot);
/// Writes a table of all rows; those on the front of `plot`, if not null, are marked.
void write_rows(std::ostream& out, const PageContent& page, std::span<const Measurement> rows,
                const Plot* plot);
/// Ends the grid of a scene's plots. The rows' pictures go into the grid if there are few, otherwise below
/// it.
void close_scene(std::ostream& out, const PageContent& page, std::span<const Measurement> rows);

void write_moved(std::ostream& out, const PageContent& page);
void write_sweep(std::ostream& out, const PageContent& page, const SweepPart& part);
void write_presets(std::ostream& out, const PageContent& page, const SweepPart& part);

}  // namespace vantage::bench

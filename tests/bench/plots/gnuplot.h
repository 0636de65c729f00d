#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vantage::bench {

struct PlotPoint {
    double x = 0, y = 0;  ///< position in the axes' units; the point is drawn only if both are finite
    std::string label;
    bool chosen = false;                            ///< drawn with a ring
    bool exact = false;                             ///< drawn as a square
    std::optional<std::array<double, 2>> before{};  ///< position in an earlier run
};

struct PlotCurve {
    std::string name;  ///< shown in the key if there are several curves
    std::vector<PlotPoint> points;
    bool line = true;  ///< connect the points, in order along the longer dimension
};

struct PlotAxis {
    std::string title;
    std::string unit;  ///< unit of the points; bytes and times are rescaled for display
    bool log = false;  ///< values <= 0 are drawn at the edge, which is noted in the axis title
    bool less_is_better = true;
};

struct PlotSpec {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
};

/// The plot as an SVG element for HTML, as wide as its container. Its ids are unique to the plot, and points
/// show their labels as tooltips. Throws Error(input) if gnuplot is missing or fails, and Error(storage) if
/// its script cannot be written.
std::string svg_plot(const PlotSpec& plot);

}  // namespace vantage::bench

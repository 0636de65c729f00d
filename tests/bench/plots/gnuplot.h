#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vantage::bench {

struct PlotPoint {
    double x = 0, y = 0;  ///< in the axes' units; not drawn unless both are finite
    std::string label;
    bool chosen = false;                            ///< ringed
    bool exact = false;                             ///< a square
    bool quiet = false;                             ///< its label is seen only when it is pointed at
    std::optional<std::array<double, 2>> before{};  ///< where an earlier run had it
};

struct PlotCurve {
    std::string name;  ///< in the key, if there are several
    std::vector<PlotPoint> points;
    bool line = true;    ///< through its points, along its longer side
    bool muted = false;  ///< small and grey
};

struct PlotAxis {
    std::string title;
    std::string unit;  ///< of the points; bytes and times are drawn in one that suits them
    bool log = false;  ///< zeros are drawn at a floor, and the axis says so
    bool less_is_better = true;
};

struct PlotSpec {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
};

/// The plot as an SVG element as wide as what it stands in, to be put into HTML; its ids are its own. Points
/// show their names when pointed at. Throws Error(input) where gnuplot is missing or fails, Error(storage)
/// where its script cannot be written.
std::string svg_plot(const PlotSpec& plot);

}  // namespace vantage::bench

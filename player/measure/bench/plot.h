#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// A curve of a plot: values over 0, 1, 2, ...
struct Curve {
    std::string name;
    std::vector<double> values;
};

/// Writes curves over frames as an SVG picture with a legend and a vertical axis that starts at 0. Throws
/// Error(storage).
void write_plot(const std::filesystem::path& file, const std::string& title, const std::string& unit,
                const std::vector<Curve>& curves);

}  // namespace vantage

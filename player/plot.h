#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// A line of a plot: y over 0, 1, 2, ...
struct Curve {
    std::string name;
    std::vector<double> values;
};

/// Writes curves as an SVG picture with axes from 0 and a legend. Throws Error(storage).
void write_plot(const std::filesystem::path& file, const std::string& title, const std::string& unit,
                const std::vector<Curve>& curves);

}  // namespace vantage

#pragma once
#include <string>

namespace vantage::bench {

/// The SVG that gnuplot draws from a script. Throws Error(input) if gnuplot is missing or fails, and
/// Error(storage) if the script cannot be written.
std::string drawn_by_gnuplot(const std::string& script);

}  // namespace vantage::bench

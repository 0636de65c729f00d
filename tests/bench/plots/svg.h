#pragma once
#include <string>

namespace vantage::bench {

/// Converts an SVG document from gnuplot into an HTML element as wide as its container. Drops the prolog,
/// titles (which browsers show as tooltips) and empty groups, adds `prefix` to all ids and references to
/// them, and appends `last` to the content. Empty if the document is not a complete SVG.
std::string inline_svg(const std::string& document, const std::string& prefix, const std::string& title,
                       const std::string& last);

}  // namespace vantage::bench

#pragma once
#include <string>

namespace vantage::bench {

/// gnuplot's SVG document as an element for HTML: no prolog, no titles that show as tips, no empty groups,
/// ids and references to them begun with `prefix`, as wide as what it stands in; `last` comes before its end.
std::string inline_svg(const std::string& document, const std::string& prefix, const std::string& title,
                       const std::string& last);

}  // namespace vantage::bench

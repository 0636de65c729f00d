#pragma once
#include <string>
#include <vector>

namespace vantage {

/// What --help prints at its end, divided.
struct Notes {
    std::vector<std::string> paragraphs;  ///< each on one line
    std::vector<std::string> examples;    ///< lines, without indentation
    std::string exit_codes;  ///< a paragraph that starts with "Exit code"; empty if there is none
};

/// Paragraphs end with a line that ends with a period. Indented lines after "Example:" or "Examples:" are
/// examples; those after another line that ends with a colon (the list of verbs) are dropped with it.
Notes divided(const std::string& notes);

}  // namespace vantage

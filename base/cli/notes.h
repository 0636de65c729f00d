#pragma once
#include <string>
#include <vector>

namespace vantage {

/// The end of --help, split into its parts.
struct Notes {
    std::vector<std::string> paragraphs;  ///< each on one line
    std::vector<std::string> examples;    ///< lines, without indentation
    std::string exit_codes;               ///< the paragraph that starts with "Exit code", or empty
};

/// A paragraph ends at a line that ends with a period. Indented lines after "Example:" or "Examples:" are
/// examples. Any other line that ends with a colon (the list of verbs) is dropped with the indented lines
/// after it.
Notes divided(const std::string& notes);

}  // namespace vantage

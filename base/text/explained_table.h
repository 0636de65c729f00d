#pragma once
#include <span>
#include <string>

namespace vantage {

/// A column of a table on a page.
struct Column {
    std::string name;     ///< HTML, as in the heading; may be empty
    std::string meaning;  ///< plain text with units; empty only for a column that needs none
    bool number = false;  ///< aligned to the right
};

/// HTML: the beginning of a table, with its row of headings, each with its meaning as a tooltip; and before
/// it, closed until it is clicked, the meanings of all columns.
std::string explained_table(std::span<const Column> columns);

}  // namespace vantage

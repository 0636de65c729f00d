#pragma once
#include <span>
#include <string>

namespace vantage {

/// A column of an HTML table.
struct Column {
    std::string name;     ///< HTML, as in the heading; may be empty
    std::string meaning;  ///< plain text with units; empty only if self-explanatory
    bool number = false;  ///< aligned to the right
};

/// The beginning of an HTML table: a collapsed list of the columns' meanings, then the heading row, with the
/// meanings as tooltips.
std::string explained_table(std::span<const Column> columns);

}  // namespace vantage

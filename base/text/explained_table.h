#pragma once
#include <span>
#include <string>

namespace vantage {

/// A column of an HTML table.
struct Column {
    std::string name;     ///< the heading, in HTML; may be empty
    std::string meaning;  ///< plain text with units; empty only if the name is self-explanatory
    bool number = false;  ///< whether cells are aligned to the right
};

/// The beginning of an HTML table: a collapsed list of the columns' meanings, followed by the heading row,
/// which has the meanings as tooltips.
std::string explained_table(std::span<const Column> columns);

}  // namespace vantage

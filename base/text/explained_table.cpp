#include "base/text/explained_table.h"

#include <algorithm>

#include "base/text/markup.h"

namespace vantage {

std::string explained_table(std::span<const Column> columns) {
    std::string out;
    if (std::ranges::any_of(columns, [](const Column& c) { return !c.meaning.empty(); })) {
        out += "<details class=columns><summary>What the columns mean</summary><dl>\n";
        for (const Column& c : columns)
            if (!c.meaning.empty()) out += "<dt>" + c.name + "<dd>" + escaped(c.meaning) + "\n";
        out += "</dl></details>\n";
    }
    out += "<table><tr>";
    for (const Column& c : columns) {
        out += c.number ? "<th class=n" : "<th";
        if (!c.meaning.empty()) out += " title=\"" + escaped(c.meaning) + "\"";
        out += ">" + c.name;
    }
    return out + "</tr>\n";
}

}  // namespace vantage

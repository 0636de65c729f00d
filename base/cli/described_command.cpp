#include "base/cli/described_command.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "base/text/json_text.h"

namespace vantage {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DescribedOption, names, type, values, least, most, initial, description,
                                   group, required, several, commas)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DescribedCommand, name, description, notes, arguments, options, verbs)

std::vector<std::string> headings_of(const std::vector<DescribedOption>& options) {
    std::vector<std::string> out;
    for (const DescribedOption& o : options)
        if (std::ranges::count(out, o.group) == 0) out.push_back(o.group);
    return out;
}

std::string to_line(const DescribedCommand& command) { return json_text(command, -1); }

DescribedCommand from_line(const std::string& line) {
    try {
        return json_of(line).get<DescribedCommand>();
    } catch (const nlohmann::json::exception& e) {
        throw Error(Exit::input, std::string("a line that does not describe a command: ") + e.what());
    }
}

}  // namespace vantage

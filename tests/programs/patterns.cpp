#include "tests/programs/patterns.h"

#include <regex>

namespace vantage {

std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::vector<std::string>> out;
    for (std::sregex_iterator m(text.begin(), text.end(), regex), end; m != end; ++m)
        out.emplace_back(m->begin(), m->end());
    return out;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
    return std::regex_replace(text, std::regex(pattern), by);
}

}  // namespace vantage

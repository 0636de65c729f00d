#pragma once
#include <string>
#include <vector>

namespace vantage {

inline std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : between) + w;
    return out;
}

}  // namespace vantage

#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// Parses; a discarded value if the text is not JSON. The library's parser takes seconds to compile: once,
/// here.
nlohmann::json json_of(std::string_view text);

/// The strings of a list in an object, with an empty one for each item of another type; none if the object
/// lacks it.
std::vector<std::string> texts_in(std::string_view object, const char* list);

/// As it is written: indented, or in one line if `indent` is negative; bytes that are not UTF-8 are replaced.
std::string json_text(const nlohmann::json& json, int indent = 1);

}  // namespace vantage

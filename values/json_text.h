#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// Parses. A discarded value if the text is no JSON. The library's parser takes seconds to compile: once, here.
nlohmann::json json_of(std::string_view text);

/// The texts of a list in an object; an empty one for what is no text. Empty if there is no such list.
std::vector<std::string> texts_in(std::string_view object, const char* list);

/// As it is written: indented, or in one line if `indent` is negative; bytes that are not UTF-8 are replaced.
std::string json_text(const nlohmann::json& json, int indent = 1);

}  // namespace vantage

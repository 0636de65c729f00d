#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// Parses JSON; returns a discarded value if the text is invalid. The library's parser takes seconds to
/// compile, so it is compiled only here.
nlohmann::json json_of(std::string_view text);

/// The strings in a list that is a member of an object. Items that are not strings become empty strings. The
/// result is empty if the object has no such list.
std::vector<std::string> texts_in(std::string_view object, const char* list);

/// Formats JSON, indented, or as one line if `indent` is negative. Bytes that are not valid UTF-8 are
/// replaced.
std::string json_text(const nlohmann::json& json, int indent = 1);

}  // namespace vantage

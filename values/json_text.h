#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace vantage {

/// As it is printed: indented by one space, bytes of file names that are not UTF-8 replaced.
std::string json_text(const nlohmann::json& json);

}  // namespace vantage

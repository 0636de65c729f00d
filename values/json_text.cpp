#include "values/json_text.h"

#include <nlohmann/json.hpp>

namespace vantage {

nlohmann::json json_of(std::string_view text) { return nlohmann::json::parse(text, nullptr, false); }

std::string json_text(const nlohmann::json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace vantage

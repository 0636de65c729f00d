#include "base/text/json_text.h"

#include <nlohmann/json.hpp>

namespace vantage {

nlohmann::json json_of(std::string_view text) { return nlohmann::json::parse(text, nullptr, false); }

std::vector<std::string> texts_in(std::string_view object, const char* list) {
    const nlohmann::json all = json_of(object);
    std::vector<std::string> out;
    if (!all.is_object() || !all.contains(list) || !all[list].is_array()) return out;
    for (const nlohmann::json& item : all[list])
        out.push_back(item.is_string() ? item.get<std::string>() : "");
    return out;
}

std::string json_text(const nlohmann::json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace vantage

#include "base/text/located_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/text/error.h"

namespace vantage {
namespace {

using nlohmann::json;

constexpr double farthest = 1e12;  ///< input units; positions farther from the origin would be too imprecise

/// A value as shown in a message: one short line.
std::string shown(const json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    constexpr std::size_t most = 40;
    std::string text = value.is_string() ? value.get_ref<const std::string&>() : value.dump();
    const bool cut = text.size() > most;
    if (cut) text.resize(most);
    if (value.is_string()) text = json(text).dump(-1, ' ', false, json::error_handler_t::ignore);
    return cut ? text + "..." : text;
}

}  // namespace

std::string LocatedJson::place() const { return path_.empty() ? "" : path_ + ": "; }

void LocatedJson::fail(const std::string& expected) const {
    throw Error(Exit::input, *file_ + ": " + place() + "found " + shown(*value_) + ", expected " + expected);
}

void LocatedJson::expect_object(std::initializer_list<std::string_view> known) const {
    std::string names;
    for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    if (!value_->is_object()) fail("an object with " + names);
    for (const auto& [key, value] : value_->items())
        if (std::ranges::find(known, key) == known.end())
            unknown_->push_back(place() + "unknown key " + shown(json(key)) + ", expected " + names);
}

LocatedJson LocatedJson::at(const char* key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) {
        const std::string where = path_.empty() ? key : path_ + "." + key;
        throw Error(Exit::input, *file_ + ": " + where + ": is missing");
    }
    return {*this, *found, path_.empty() ? key : path_ + "." + key};
}

bool LocatedJson::has(const char* key) const { return value_->contains(key); }
bool LocatedJson::is_object() const { return value_->is_object(); }
bool LocatedJson::is_text() const { return value_->is_string(); }
bool LocatedJson::is_true() const { return value_->is_boolean() && value_->get<bool>(); }
bool LocatedJson::boolean() const {
    if (!value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
}
bool LocatedJson::is_null() const { return value_->is_null(); }

std::vector<LocatedJson> LocatedJson::items(std::size_t most) const {
    if (!value_->is_array() || value_->size() > most)
        fail("an array of at most " + std::to_string(most) + " items");
    std::vector<LocatedJson> out;
    for (const json& item : *value_)
        out.push_back({*this, item, path_ + "[" + std::to_string(out.size()) + "]"});
    return out;
}

std::vector<std::pair<std::string, LocatedJson>> LocatedJson::entries(std::size_t most) const {
    if (!value_->is_object() || value_->size() > most)
        fail("an object of at most " + std::to_string(most) + " keys");
    std::vector<std::pair<std::string, LocatedJson>> out;
    for (const auto& [key, value] : value_->items())
        out.emplace_back(key, LocatedJson(*this, value, path_ + "[" + shown(json(key)) + "]"));
    return out;
}

std::string LocatedJson::text(std::size_t most, bool lines) const {
    if (!value_->is_string()) fail("a string");
    const auto& text = value_->get_ref<const std::string&>();
    if (text.size() > most) fail("a string of at most " + std::to_string(most) + " bytes");
    const auto is_control = [&](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && !(lines && c == '\n')) || byte == 0x7f;
    };
    if (std::ranges::any_of(text, is_control)) fail("a string without control characters");
    return text;
}

double LocatedJson::number(double low, double high) const {
    const double number = value_->is_number() ? value_->get<double>() : std::nan("");
    if (number >= low && number <= high) return number;
    std::ostringstream range;
    range << "a number from " << low << " to " << high;
    fail(range.str());
}

Eigen::Vector3d LocatedJson::vector() const {
    if (!value_->is_array() || value_->size() != 3) fail("three numbers, such as [1, 0, 0.5]");
    Eigen::Vector3d out;
    const std::vector<LocatedJson> numbers = items(3);
    for (std::size_t i = 0; i < 3; ++i) out[Eigen::Index(i)] = numbers[i].number(-farthest, farthest);
    return out;
}

json parsed_json(const std::string& text, const std::string& file, int depth) {
    std::vector<std::set<std::string>> keys;  // of the open objects, by depth
    const auto watch = [&](int at, json::parse_event_t event, json& value) {
        if (at > depth)
            throw Error(Exit::input,
                        file + ": is nested more than " + std::to_string(depth) + " levels deep");
        const auto level = std::size_t(at);
        if (event == json::parse_event_t::object_start) {
            if (keys.size() <= level + 1) keys.resize(level + 2);
            keys[level + 1].clear();
        } else if (event == json::parse_event_t::key &&
                   !keys[level].insert(value.get<std::string>()).second) {
            throw Error(Exit::input, file + ": key " + shown(value) + " appears twice in an object");
        }
        return true;
    };
    try {
        return json::parse(text, watch);
    } catch (const json::exception& e) {
        const std::string_view what = e.what();
        const std::size_t at = what.find("] ");
        throw Error(Exit::input,
                    file + ": is not JSON: " + std::string(at == what.npos ? what : what.substr(at + 2)));
    }
}

}  // namespace vantage

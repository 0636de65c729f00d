#include "pipeline/commands/shared/apply_config.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>

#include "base/text/error.h"
#include "pipeline/run/config_files.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

std::string text(const fs::path& file, std::string_view key, const toml::node& value) {
    if (const auto* s = value.as_string()) return s->get();
    if (const auto* i = value.as_integer()) return std::to_string(i->get());
    if (const auto* d = value.as_floating_point()) return fmt::format("{}", d->get());
    if (const auto* b = value.as_boolean()) return b->get() ? "true" : "false";
    throw Error(Exit::usage, fmt::format("{}: {}: expected a string, a number, a boolean or a list of these",
                                         file.string(), key));
}

std::vector<std::string> texts(const fs::path& file, std::string_view key, const toml::node& value) {
    const auto* list = value.as_array();
    if (!list || list->empty()) return {text(file, key, value)};
    std::vector<std::string> out;
    for (const toml::node& item : *list) out.push_back(text(file, key, item));
    return out;
}

}  // namespace

void apply_config(const Command& command, const std::string& name) {
    const fs::path file = find_preset(name);
    toml::table table;
    try {
        table = toml::parse_file(file.string());
    } catch (const toml::parse_error& e) {
        throw Error(Exit::usage,
                    fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
    }
    for (const auto& [key, value] : table) {
        if (key == "config")
            throw Error(Exit::usage, file.string() + ": config: not allowed in a file of settings");
        command.give(std::string(key.str()), texts(file, key.str(), value), file.string());
    }
}

}  // namespace vantage

#include "pipeline/commands/apply_config.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>

#include "pipeline/settings/config_files.h"
#include "scene/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

std::string text(const fs::path& file, std::string_view key, const toml::node& value) {
    if (const auto* s = value.as_string()) return s->get();
    if (const auto* i = value.as_integer()) return std::to_string(i->get());
    if (const auto* d = value.as_floating_point()) return fmt::format("{}", d->get());
    if (const auto* b = value.as_boolean()) return b->get() ? "true" : "false";
    throw Error(Exit::usage, fmt::format("{}: {}: expected a string, a number, a boolean or a list of them",
                                         file.string(), key));
}

void apply(CLI::Option& option, const fs::path& file, std::string_view key, const toml::node& value) {
    if (const auto* list = value.as_array();
        list && !list->empty())  // with no result, CLI11 flags read out of bounds
        for (const toml::node& item : *list) option.add_result(text(file, key, item));
    else
        option.add_result(text(file, key, value));
    try {
        option.run_callback();
    } catch (const CLI::ParseError& e) {
        throw Error(Exit::usage, file.string() + ": " + e.what());
    }
}

}  // namespace

void apply_config(CLI::App& command, const std::string& name) {
    const fs::path file = find_preset(name);
    toml::table table;
    try {
        table = toml::parse_file(file.string());
    } catch (const toml::parse_error& e) {
        throw Error(Exit::usage,
                    fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
    }
    for (const auto& [key, value] : table) {
        CLI::Option* option = command.get_option_no_throw("--" + std::string(key.str()));
        if (option == nullptr || key == "config")
            throw Error(Exit::usage, fmt::format("{}: {}: unknown setting, see 'vantage {} --help'",
                                                 file.string(), key.str(), command.get_name()));
        if (option->count() == 0) apply(*option, file, key.str(), value);
    }
}

}  // namespace vantage

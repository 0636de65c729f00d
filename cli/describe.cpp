#include "cli/describe.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <string_view>

#include "manual/described_command.h"

namespace vantage {
namespace {

/// CLI11 gives the type of a value, its limits and the values to choose from as one text, such as
/// "INT:INT in [1 - 4096]", "TEXT:{raw,jpeg}" or "ENUM:value in {average->0,best->2} OR {0,2}".
void read_type(const std::string& text, DescribedOption& o) {
    o.type = text.substr(0, text.find(':'));
    if (o.type == "INT" || o.type == "UINT" || o.type == "FLOAT") o.type = "NUMBER";
    if (o.type == "ENUM" || o.type == "BOOLEAN") o.type = "TEXT";
    if (text.find(":SIZE ") != std::string::npos) o.type = "SIZE";
    std::smatch found;
    if (std::regex_search(text, found, std::regex(R"(in \[(\S+) - (\S+)\])")))
        o.least = found[1], o.most = found[2];
    if (!std::regex_search(text, found, std::regex(R"((?::| in )\{([^}]*)\})"))) return;
    const std::string list = found[1];
    const std::regex value(R"(([^,>-][^,>]*?)(->[^,]*)?(,|$))");
    for (std::sregex_iterator v(list.begin(), list.end(), value), end; v != end; ++v)
        o.values.push_back((*v)[1]);
}

/// Without the brackets around several values.
std::string initial_value(std::string text) {
    if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
    return text;
}

DescribedOption described(const CLI::Option& option) {
    DescribedOption o;
    if (option.get_positional()) o.names = {option.get_name(true)};
    for (const std::string& name : option.get_snames()) o.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) o.names.push_back("--" + name);
    o.description = option.get_description();
    o.group = option.get_group();
    if (option.get_items_expected_max() == 0) return o;
    read_type(option.get_type_name(), o);
    o.initial = initial_value(option.get_default_str());
    o.required = option.get_required();
    o.several = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    o.commas = option.get_delimiter() == ',';
    return o;
}

DescribedCommand described(const CLI::App& app, const std::string& name) {
    DescribedCommand out{name, app.get_description(), app.get_footer(), {}, {}, {}};
    for (const CLI::Option* option :
         app.get_options([](const CLI::Option* o) { return !o->get_group().empty(); }))
        (option->get_positional() ? out.arguments : out.options).push_back(described(*option));
    for (const CLI::App* verb : app.get_subcommands(std::function<bool(const CLI::App*)>{}))
        out.verbs.push_back(described(*verb, verb->get_name()));
    return out;
}

}  // namespace

bool describe_if_asked(const CLI::App& app, int argc, char** argv) {
    if (argc != 2 || std::string_view(argv[1]) != "--describe") return false;
    const std::string name = std::filesystem::path(argv[0]).filename().string();
    std::printf("%s\n", to_line(described(app, name)).c_str());
    return true;
}

}  // namespace vantage

#include "base/cli/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/cli/help_text.h"
#include "base/cli/joined.h"
#include "base/cli/standard_output.h"
#include "base/cli/suggestion.h"
#include "base/text/error.h"

namespace vantage {

struct Option::Entry {
    CLI::Option* option;
    DescribedOption described;
};

struct Command::Node {
    std::string program;  ///< for a verb, the name of its program
    std::string version;
    std::shared_ptr<CLI::App> app;
    std::deque<Option::Entry> options;  ///< options and arguments
    std::vector<Command> verbs;
    std::vector<std::string> common;
    std::function<int(const Command&)> action;
};

namespace {

[[noreturn]] void refuse(const std::string& expected, const std::string& text) {
    throw Error(Exit::usage, "expected " + expected + ", not '" + text + "'");
}

/// Parses the whole text as a number that must be within limits.
template <class T>
T number_in(const std::string& text, T least, T most, const std::string& expected) {
    T value{};
    const char* end = text.data() + text.size();
    const auto [parsed, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || parsed != end || !(value >= least && value <= most)) refuse(expected, text);
    return value;
}

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

std::uint64_t bytes_in(const std::string& text) {
    std::string number = text.starts_with('-') ? "" : text;
    try {
        CLI::AsSizeValue(false)(number);
        return number_in(number, std::uint64_t(1), std::uint64_t(1) << 60, "");
    } catch (const std::runtime_error&) {
        refuse("a size such as 800M", text);
    }
}

std::size_t index_of(const std::string& text, const std::vector<std::string>& words) {
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) throw Error(Exit::usage, "'" + text + "' is none of " + joined(words, ", "));
    return std::size_t(found - words.begin());
}

DescribedOption described_flag(const std::vector<std::string>& names, const std::string& help) {
    DescribedOption out;
    out.names = names;
    out.description = help;
    out.group = "Options";
    return out;
}

DescribedOption described_value(const std::string& type, const std::string& initial,
                                const std::string& help) {
    DescribedOption out = described_flag({}, help);
    out.type = type;
    out.initial = initial;
    return out;
}

}  // namespace

Option Option::group(const std::string& heading) const {
    entry_->described.group = heading;
    return *this;
}

Option Option::type(const std::string& kind) const {
    entry_->described.type = kind;
    entry_->option->type_name(label_of(entry_->described));
    return *this;
}

Option Option::required() const {
    entry_->described.required = true;
    entry_->option->required();
    return *this;
}

Option Option::commas() const {
    entry_->described.commas = true;
    entry_->option->delimiter(',');
    return *this;
}

Option Option::one_word() const {
    entry_->option->allow_extra_args(false);
    return *this;
}

Option Option::needs(const Option& other) const {
    entry_->option->needs(other.entry_->option);
    entry_->described.needs.push_back(other.entry_->described.names.back());
    return *this;
}

Option Option::excludes(const Option& other) const {
    entry_->option->excludes(other.entry_->option);
    return *this;
}

Option Option::suggests(std::vector<std::string> values) const {
    entry_->described.values = std::move(values);
    entry_->option->type_name(label_of(entry_->described));
    return *this;
}

Command::Command(const std::string& name, const std::string& description) : node_(std::make_shared<Node>()) {
    node_->app = std::make_shared<CLI::App>(description, name);
    node_->app->set_help_flag("-h,--help", "print this help and exit");
    node_->options.push_back(
        {node_->app->get_help_ptr(),
         described_flag({"-h", "--help"}, node_->app->get_help_ptr()->get_description())});
}

Option Command::add(const std::string& names, DescribedOption described,
                    std::function<void(const Words&)> take) const {
    const auto callback = [take = std::move(take), names](const CLI::results_t& words) {
        try {
            take(words);
        } catch (const Error& e) {
            throw CLI::ValidationError(names.substr(names.rfind(',') + 1), e.what());
        }
        return true;
    };
    CLI::Option* option = node_->app->add_option(names, callback, described.description);
    described.names = CLI::detail::split(names, ',');
    option->type_name(label_of(described));
    if (described.several) option->expected(CLI::detail::expected_max_vector_size);
    node_->options.push_back({option, std::move(described)});
    return Option(node_->options.back());
}

Option Command::add_flag(const std::string& names, const std::string& help, std::function<void()> set) const {
    CLI::Option* option = node_->app->add_flag_callback(names, std::move(set), help);
    node_->options.push_back({option, described_flag(CLI::detail::split(names, ','), help)});
    return Option(node_->options.back());
}

Option Command::text(const std::string& names, std::string& value, const std::string& help) const {
    return add(names, described_value("TEXT", value, help),
               [&value](const Words& words) { value = words.front(); });
}

Option Command::file(const std::string& names, std::string& value, const std::string& help) const {
    return text(names, value, help).type("FILE");
}

Option Command::file(const std::string& names, std::filesystem::path& value, const std::string& help) const {
    return add(names, described_value("FILE", value.string(), help),
               [&value](const Words& words) { value = words.front(); });
}

Option Command::add_integer(const std::string& names, std::int64_t initial, std::int64_t least,
                            std::int64_t most, const std::string& help,
                            std::function<void(std::int64_t)> set) const {
    const bool known = initial >= least && initial <= most;
    DescribedOption d = described_value("NUMBER", known ? std::to_string(initial) : "", help);
    d.least = std::to_string(least), d.most = std::to_string(most);
    const std::string expected = "an integer " + limits_text(d);
    return add(names, std::move(d), [=, set = std::move(set)](const Words& words) {
        set(number_in(words.front(), least, most, expected));
    });
}

Option Command::add_real(const std::string& names, double initial, double least, double most,
                         const std::string& help, std::function<void(double)> set) const {
    const bool known = initial >= least && initial <= most;
    DescribedOption d = described_value("NUMBER", known ? text_of(initial) : "", help);
    d.least = text_of(least), d.most = text_of(most);
    const std::string expected = "a number " + limits_text(d);
    return add(names, std::move(d), [=, set = std::move(set)](const Words& words) {
        set(number_in(words.front(), least, most, expected));
    });
}

Option Command::bytes(const std::string& names, std::uint64_t& value, const std::string& help) const {
    const std::string initial = value ? std::to_string(value) : "";
    return add(names, described_value("SIZE", initial, help),
               [&value](const Words& words) { value = bytes_in(words.front()); });
}

Option Command::add_choice(const std::string& names, const std::string& initial, const Words& words,
                           const std::string& help, std::function<void(std::size_t)> set) const {
    DescribedOption d = described_value("TEXT", initial, help);
    d.values = words;
    return add(names, std::move(d),
               [words, set = std::move(set)](const Words& given) { set(index_of(given.front(), words)); });
}

Option Command::choice(const std::string& names, std::string& value, const Words& words,
                       const std::string& help) const {
    return add_choice(names, value, words, help, [&value, words](std::size_t i) { value = words[i]; });
}

Option Command::choices(const std::string& names, std::vector<std::string>& values, const Words& words,
                        const std::string& help) const {
    DescribedOption d = described_value("TEXT", joined(values, ","), help);
    d.values = words;
    d.several = true;
    return add(names, std::move(d), [&values, words](const Words& given) {
        for (const std::string& word : given) index_of(word, words);
        values = given;
    });
}

Option Command::list(const std::string& names, std::vector<std::string>& values,
                     const std::string& help) const {
    DescribedOption d = described_value("TEXT", joined(values, ","), help);
    d.several = true;
    return add(names, std::move(d), [&values](const Words& words) { values = words; });
}

Option Command::pair(const std::string& names, std::vector<double>& values, const std::string& help) const {
    DescribedOption d = described_value("NUMBER", "", help);
    const Option out = add(names, std::move(d), [&values](const Words& words) {
        values.clear();
        for (const std::string& word : words)
            values.push_back(number_in(word, std::numeric_limits<double>::lowest(),
                                       std::numeric_limits<double>::max(), "two numbers"));
    });
    out.entry_->option->expected(2)->delimiter(',');
    return out;
}

void Command::force(bool& value) const {
    flag("--force", value,
         "also replace files that were not written by Vantage; never inputs, folders or devices");
}

void Command::version(const std::string& text) const {
    node_->version = text;
    CLI::Option* option = node_->app->set_version_flag("--version", text, "print the version and exit");
    node_->options.push_back({option, described_flag({"--version"}, option->get_description())});
}

Option Command::quiet() const {
    return add_flag("-q,--quiet", "print only errors", [] {});  // read by run()
}

void Command::notes(const std::string& text) const { node_->app->footer(text); }

void Command::common(std::vector<std::string> names) const {
    node_->common = std::move(names);
    CLI::Option* option = node_->app->set_help_all_flag("--help-all", "print help on all options, and exit");
    node_->options.push_back({option, described_flag({"--help-all"}, option->get_description())});
}

void Command::action(std::function<int(const Command&)> run) const { node_->action = std::move(run); }

void Command::action(std::function<int()> run) const {
    node_->action = [run = std::move(run)](const Command&) { return run(); };
}

Command Command::verb(const std::string& name, const std::string& description) const {
    const Command out(name, description);
    out.node_->program = node_->app->get_name();
    out.add_flag("--json", "print the results as JSON, for programs", [] {}).excludes(out.quiet());
    out.version(node_->version);
    return node_->verbs.emplace_back(out);
}

int Command::run(const std::vector<std::string>& arguments) const {
    if (arguments == Words{"--describe"}) return std::puts(to_line(described()).c_str()) < 0;
    const std::string first = arguments.empty() ? "" : arguments.front();
    Words names;
    for (const Command& verb : node_->verbs) {
        names.push_back(verb.node_->app->get_name());
        if (first == names.back()) return verb.run({arguments.begin() + 1, arguments.end()});
    }
    // If the program has an action of its own, an argument may be a file.
    const bool file =
        node_->action && (first.find_first_of("./") != first.npos || std::filesystem::exists(first));
    if (!names.empty() && !first.starts_with('-') && !file) {
        if (first == "help") return run({arguments.size() > 1 ? arguments[1] : "--help", "--help"});
        if (const std::string like = suggestion(first, names); !like.empty())
            throw Error(Exit::usage, "no verb '" + first + "'" + like);
        if (!node_->action)
            throw Error(Exit::usage, (first.empty() ? "no verb" : "no verb '" + first + "'") +
                                         ": expected one of " + joined(names, ", "));
    }
    const auto has = [&](const char* option) { return std::ranges::count(arguments, option) > 0; };
    choose_output(has("--json")                 ? OutputForm::json
                  : has("-q") || has("--quiet") ? OutputForm::none
                                                : OutputForm::lines);
    results()["command"] = command_name();
    results()["version"] = node_->version.substr(node_->version.rfind(' ') + 1);
    try {
        node_->app->parse(Words(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return print_help(false);
    } catch (const CLI::CallForAllHelp&) {
        return print_help(true);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return node_->app->exit(e);  // --version
        throw Error(Exit::usage, node_->app->remaining().empty() ? e.what() : unexpected());
    }
    return node_->action ? node_->action(*this) : int(Exit::ok);
}

std::string Command::command_name() const {
    return node_->program + (node_->program.empty() ? "" : " ") + node_->app->get_name();
}

int Command::print_help(bool all) const {
    std::fputs(help_text(described(), node_->program, all).c_str(), stdout);
    return int(Exit::ok);
}

/// The error message for unparsed arguments.
std::string Command::unexpected() const {
    const std::string word = node_->app->remaining().front();
    if (!word.starts_with('-')) return "'" + word + "' was not expected";
    Words names;
    for (const Option::Entry& o : node_->options) names.push_back(o.described.names.back());
    return "no option " + word + suggestion(word, names);
}

void Command::give(const std::string& name, const std::vector<std::string>& values,
                   const std::string& place) const {
    CLI::Option* option = node_->app->get_option_no_throw("--" + name);
    if (option == nullptr)
        throw Error(Exit::usage,
                    place + ": " + name + ": unknown setting, see '" + command_name() + " --help'");
    if (option->count() > 0) return;
    for (const std::string& value : values) option->add_result(value);
    try {
        option->run_callback();
    } catch (const CLI::ParseError& e) {
        throw Error(Exit::usage, place + ": " + e.what());
    }
}

bool Command::given(const std::string& group) const {
    return std::ranges::any_of(node_->options, [&](const Option::Entry& o) {
        return o.described.group == group && o.option->count() > 0;
    });
}

DescribedCommand Command::described() const {
    DescribedCommand out{
        node_->app->get_name(), node_->app->get_description(), node_->app->get_footer(), {}, {}, {}, {}};
    out.common = node_->common;
    for (const Option::Entry& o : node_->options)
        (o.described.names.front().starts_with('-') ? out.options : out.arguments).push_back(o.described);
    for (const Command& verb : node_->verbs) out.verbs.push_back(verb.described());
    return out;
}

std::string exit_codes_text() {
    return "Exit codes: 0 success, 2 usage, 3 input, 4 damaged package, 5 stale package, 6 storage,\n"
           "7 graphics, 8 interrupted, 9 incomplete, 10 different, 11 internal error, 12 out of memory,\n"
           "13 mesh not in view.";
}

}  // namespace vantage

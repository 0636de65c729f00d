#pragma once
#include <string>
#include <vector>

namespace vantage {

/// Maximum length of a limit's text; a longer text means "no limit".
inline constexpr std::size_t longest_limit = 7;

/// One option or argument of a command line.
struct DescribedOption {
    std::vector<std::string> names;  ///< "-o" and "--output"; for an argument, its only name, such as "INPUT"
    std::string type;  ///< kind of value: FILE, FOLDER, PACKAGE, NUMBER, TEXT, ...; empty for a flag
    std::vector<std::string> values;  ///< permitted values; empty if they are not listed
    std::string least, most;          ///< limits of a number, or empty
    std::string initial;              ///< the default; empty if it is not shown
    std::string description;
    std::string group;  ///< its heading in --help
    bool required = false;
    bool several = false;              ///< takes any number of values
    bool commas = false;               ///< accepts values separated by commas
    std::vector<std::string> needs{};  ///< options that must also be given; used only in --help
};

/// A program or one of its verbs, as described by its command line.
struct DescribedCommand {
    std::string name;  ///< for a verb, without the program's name
    std::string description;
    std::string notes;  ///< the end of --help: paragraphs, examples, exit codes
    std::vector<DescribedOption> arguments, options;
    std::vector<DescribedCommand> verbs;
    std::vector<std::string> common;  ///< options that the short form of --help lists; used only there
};

/// The group headings of the options, in order of first appearance.
std::vector<std::string> headings_of(const std::vector<DescribedOption>& options);

/// The command as one line of JSON.
std::string to_line(const DescribedCommand& command);
/// The command that the line describes. Throws Error(input) if the line was not written by to_line().
DescribedCommand from_line(const std::string& line);

}  // namespace vantage

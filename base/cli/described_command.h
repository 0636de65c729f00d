#pragma once
#include <string>
#include <vector>

namespace vantage {

/// Digits of a limit; larger ones only stand for "no limit".
inline constexpr std::size_t longest_limit = 7;

/// One option or argument of a command line.
struct DescribedOption {
    std::vector<std::string> names;  ///< "-o" and "--output"; of an argument its only name, such as "INPUT"
    std::string type;  ///< of its value: FILE, FOLDER, PACKAGE, NUMBER, TEXT, ...; empty: a flag
    std::vector<std::string> values;  ///< to choose from; empty if there is no such list
    std::string least, most;          ///< limits of a number; empty if there are none
    std::string initial;              ///< the value without the option; empty if nothing is to be said of it
    std::string description;
    std::string group;  ///< the heading of --help that it is listed under
    bool required = false;
    bool several = false;              ///< takes any number of values
    bool commas = false;               ///< values may be separated by commas
    std::vector<std::string> needs{};  ///< other options; of --help alone
};

/// A program or one of its verbs, as its command line describes it.
struct DescribedCommand {
    std::string name;  ///< of a verb without that of the program
    std::string description;
    std::string notes;  ///< what --help prints at the end: paragraphs, examples, exit codes
    std::vector<DescribedOption> arguments, options;
    std::vector<DescribedCommand> verbs;
    std::vector<std::string> common;  ///< options that --help lists if it does not list all; of --help alone
};

/// The headings that options are listed under, in the order of the first option of each.
std::vector<std::string> headings_of(const std::vector<DescribedOption>& options);

/// As one line of JSON.
std::string to_line(const DescribedCommand& command);
/// Throws Error(input) if the line is not of to_line().
DescribedCommand from_line(const std::string& line);

}  // namespace vantage

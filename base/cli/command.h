#pragma once
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/cli/described_command.h"

/// Command lines of the programs, parsed by CLI11, which only command.cpp includes.
namespace vantage {

/// An option, flag or argument, configured by chained calls. An Option refers to its Command, which must
/// outlive it.
class Option {
  public:
    Option group(const std::string& heading) const;  ///< heading in --help; default "Options"
    Option type(const std::string& kind) const;      ///< kind of value: FILE, FOLDER, PACKAGE, PHOTO, ...
    Option required() const;
    /// For a list: also accepts several values in one word, such as "a,b".
    Option commas() const;
    /// For a list: takes only one word per occurrence, so that arguments may follow.
    Option one_word() const;
    Option needs(const Option& other) const;
    Option excludes(const Option& other) const;
    /// Values to list in --help and to offer for completion. Other values are accepted as well: they may be
    /// file names, or are checked later.
    Option suggests(std::vector<std::string> values) const;

  private:
    friend class Command;
    struct Entry;
    explicit Option(Entry& entry) : entry_(&entry) {}
    Entry* entry_;
};

template <class T>
using NamedValues = std::initializer_list<std::pair<const char*, std::type_identity_t<T>>>;

/// A program or one of its verbs, with its options and its action. A handle: copies refer to the same
/// command.
///
/// `names`: the names of an option, such as "-o,--output", or the name of an argument, such as "FILE".
/// `value` must outlive run(); its initial value is the default that --help shows, unless it is empty or out
/// of range. An invalid value is a usage error that names the option and the expected values.
class Command {
  public:
    Command(const std::string& name, const std::string& description);

    /// A flag: if it is given, `value` is set to `sets`.
    template <class T>
    Option flag(const std::string& names, T& value, const std::string& help,
                std::type_identity_t<T> sets = true) const {
        return add_flag(names, help, [&value, sets] { value = sets; });
    }
    Option text(const std::string& names, std::string& value, const std::string& help) const;
    Option file(const std::string& names, std::string& value, const std::string& help) const;
    Option file(const std::string& names, std::filesystem::path& value, const std::string& help) const;
    /// The limits are inclusive.
    Option integer(const std::string& names, std::integral auto& value, std::int64_t least, std::int64_t most,
                   const std::string& help) const {
        return add_integer(names, std::int64_t(value), least, most, help, [&value](std::int64_t given) {
            value = static_cast<std::remove_cvref_t<decltype(value)>>(given);
        });
    }
    /// The limits are inclusive; neither NaN nor infinity is accepted.
    Option real(const std::string& names, std::floating_point auto& value, double least, double most,
                const std::string& help) const {
        return add_real(names, double(value), least, most, help, [&value](double given) {
            value = static_cast<std::remove_cvref_t<decltype(value)>>(given);
        });
    }
    /// A size such as 800M; K, M, G, T are powers of 1024. An initial value of 0 means no default.
    Option bytes(const std::string& names, std::uint64_t& value, const std::string& help) const;
    /// Accepts one of the names in the table and sets `value` to the value of that name.
    template <class T>
    Option choice(const std::string& names, T& value, NamedValues<T> table, const std::string& help) const {
        return choice(names, value, std::vector<std::pair<std::string, T>>(table.begin(), table.end()), help);
    }
    template <class T>
    Option choice(const std::string& names, T& value, std::vector<std::pair<std::string, T>> table,
                  const std::string& help) const {
        std::vector<std::string> words;
        std::string initial;
        for (const auto& [word, named] : table) {
            words.push_back(word);
            if (named == value) initial = word;
        }
        return add_choice(names, initial, words, help,
                          [&value, table = std::move(table)](std::size_t i) { value = table[i].second; });
    }
    Option choice(const std::string& names, std::string& value, const std::vector<std::string>& words,
                  const std::string& help) const;
    Option choices(const std::string& names, std::vector<std::string>& values,
                   const std::vector<std::string>& words, const std::string& help) const;
    Option list(const std::string& names, std::vector<std::string>& values, const std::string& help) const;
    /// Two finite numbers, given as one word, such as "1,2", or as two words.
    Option pair(const std::string& names, std::vector<double>& values, const std::string& help) const;
    /// --force, for commands that write files (see output_file).
    void force(bool& value) const;
    void version(const std::string& text) const;
    Option quiet() const;  ///< -q, for a program that also runs without a verb

    /// For a command with many options: sets the options that --help lists. Each option is given by the last
    /// of its names. --help-all lists all options.
    void common(std::vector<std::string> names) const;
    /// Sets the end of --help: paragraphs, examples and exit codes.
    void notes(const std::string& text) const;
    /// Sets the action, which returns the exit code. The action receives this command, so that it can query
    /// the options.
    void action(std::function<int(const Command&)> run) const;
    void action(std::function<int()> run) const;
    /// Adds a verb with the options that all verbs have: --help, -q, --json and --version (that of the
    /// program).
    Command verb(const std::string& name, const std::string& description) const;

    /// Parses the arguments (without the program's name) and prints the help (--help, or "help VERB"), or
    /// runs the action of the verb or program. The hidden option `--describe` prints described() as one line,
    /// from which the build makes the manual and the shell completions. Returns the exit code. Throws
    /// whatever the action throws. For an unknown option or verb, throws Error(usage), which suggests the
    /// most similar one.
    int run(const std::vector<std::string>& arguments) const;
    /// Sets the option --`name` to these values (at least one) unless the command line sets it. Throws
    /// Error(usage) for an unknown option or an invalid value; the message starts with `place`, such as a
    /// file name.
    void give(const std::string& name, const std::vector<std::string>& values,
              const std::string& place) const;
    bool given(const std::string& group) const;  ///< whether any option of the group was given
    DescribedCommand described() const;

  private:
    struct Node;
    using Words = std::vector<std::string>;
    Option add(const std::string& names, DescribedOption described,
               std::function<void(const Words&)> take) const;
    Option add_flag(const std::string& names, const std::string& help, std::function<void()> set) const;
    Option add_integer(const std::string& names, std::int64_t initial, std::int64_t least, std::int64_t most,
                       const std::string& help, std::function<void(std::int64_t)> set) const;
    Option add_real(const std::string& names, double initial, double least, double most,
                    const std::string& help, std::function<void(double)> set) const;
    Option add_choice(const std::string& names, const std::string& initial, const Words& words,
                      const std::string& help, std::function<void(std::size_t)> set) const;
    int print_help(bool all) const;
    std::string command_name() const;
    std::string unexpected() const;
    std::shared_ptr<Node> node_;
};

/// The exit codes of both programs (Exit), for the end of --help. Neither program returns all of them.
std::string exit_codes_text();

}  // namespace vantage

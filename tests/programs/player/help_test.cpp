// Tests that README.md and docs/ agree with the programs: every verb, option and choice that they mention
// must exist, and the exit codes must be those of Exit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/cli/described_command.h"
#include "base/text/error.h"
#include "scene/package/contents/effects.h"
#include "tests/generated_table.h"
#include "tests/programs/patterns.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// The options of a command, and the allowed values of the options that have choices.
using Options = std::map<std::string, std::set<std::string>>;

struct Program {
    std::string notes;
    std::map<std::string, Options> verbs;  ///< "": without a verb
    bool takes_arguments;
};

/// A command or part of a command, as quoted in a document.
struct Quote {
    std::string place, text;
};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

Options options_of(const DescribedCommand& command) {
    Options out;
    for (const DescribedOption& o : command.options)
        for (const std::string& name : o.names)
            out[name] = o.type == "FILE" ? std::set<std::string>()
                                         : std::set<std::string>(o.values.begin(), o.values.end());
    return out;
}

/// The code spans and the lines of code blocks in a Markdown file.
std::vector<Quote> quotes_in(const fs::path& file, const std::string& markdown) {
    std::vector<Quote> out;
    std::istringstream in(markdown);
    bool fenced = false;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string place = file.filename().string() + ":" + std::to_string(++number);
        if (line.starts_with("```")) {
            fenced = !fenced;
        } else if (fenced || line.starts_with("    ")) {
            out.push_back({place, replaced(line, R"(\s#.*|\s\(.*|^\s*- run:)", "")});
        } else {
            for (const auto& span : matches(line, "`([^`]+)`")) out.push_back({place, span[1]});
        }
    }
    return out;
}

class Help : public TemporaryFolder {
  protected:
    std::map<std::string, Program> programs;

    void SetUp() override {
        TemporaryFolder::SetUp();
        for (const fs::path path : {VANTAGE_PROGRAM, VANTAGE_PLAYER, VANTAGE_BENCH}) {
            if (!fs::exists(path)) continue;  // benchmarks are built for the full suite
            const DescribedCommand c = described(path);
            Program p{c.notes, {{"", options_of(c)}}, !c.arguments.empty()};
            for (const DescribedCommand& verb : c.verbs) p.verbs[verb.name] = options_of(verb);
            programs[c.name] = p;
        }
    }
    DescribedCommand described(const fs::path& program) const {
        const fs::path out = dir / "description";
        EXPECT_EQ(std::system((program.string() + " --describe >" + out.string()).c_str()), 0) << program;
        return from_line(slurp(out));
    }
    std::vector<Quote> quotes() const {
        const fs::path root = VANTAGE_SOURCE_DIR;
        std::vector<fs::path> files{root / "README.md"};
        for (const auto& entry : fs::directory_iterator(root / "docs"))
            if (entry.path().extension() == ".md") files.push_back(entry.path());
        std::vector<Quote> out;
        for (const fs::path& file : files)
            std::ranges::copy(quotes_in(file, slurp(file)), std::back_inserter(out));
        return out;
    }

    /// The first mistake in the options, starting with `words[first]`; empty if there is none.
    static std::string mistake(const Options& options, const std::vector<std::string>& words,
                               std::size_t first) {
        for (std::size_t i = first; i < words.size() && words[i] != "&&" && words[i] != "|"; ++i) {
            const auto name = matches(words[i], R"(^(-[A-Za-z]|--[A-Za-z][\w-]*)(=.*)?$)");
            if (name.empty()) continue;
            const auto option = options.find(name[0][1]);
            if (option == options.end()) return "has no option " + words[i];
            const std::set<std::string>& choices = option->second;
            if (choices.empty() || i + 1 == words.size()) continue;
            if (!choices.contains(words[i + 1])) return words[i] + " does not take " + words[i + 1];
        }
        return {};
    }

    /// The mistake in a quote; empty if there is none or if the quote is not about these programs.
    std::string mistake(const std::string& text) const {
        const std::vector<std::string> words = words_of(text);
        if (words.empty()) return {};
        if (const auto found = programs.find(fs::path(words[0]).filename().string());
            found != programs.end()) {
            const auto& verbs = found->second.verbs;
            const auto verb = words.size() > 1 ? verbs.find(words[1]) : verbs.end();
            if (verb != verbs.end()) return mistake(verb->second, words, 2);
            if (words.size() == 3 && words[1] == "help") return {};
            if (!found->second.takes_arguments && words.size() > 1 && !words[1].starts_with('-'))
                return "has no verb " + words[1];
            return mistake(verbs.at(""), words, 1);
        }
        // The quote is a verb with options, or options alone, which one of the programs must accept.
        std::string mistaken;
        for (const auto& [name, program] : programs)
            for (const auto& [verb, options] : program.verbs) {
                const bool of_verb = !verb.empty() && words[0] == verb && words.size() > 1;
                if (!of_verb && !words[0].starts_with("--")) continue;
                const std::string here = mistake(options, words, of_verb);
                if (here.empty()) return {};
                if (mistaken.empty() || here.find("does not take") != here.npos) mistaken = here;
            }
        return mistaken;
    }
};

/// A word that must occur in every description of the exit code.
std::optional<std::string> word_for(Exit code) {
    switch (code) {
        case Exit::ok:
            return "";
        case Exit::usage:
            return "usage";
        case Exit::input:
            return "input";
        case Exit::damaged:
            return "damaged";
        case Exit::stale:
            return "stale";
        case Exit::storage:
            return "storage";
        case Exit::graphics:
            return "OpenGL|graphics";
        case Exit::interrupted:
            return "interrupted";
        case Exit::incomplete:
            return "incomplete";
        case Exit::different:
            return "differ";
        case Exit::misplaced:
            return "mesh";
        case Exit::internal:
            return "internal error";
        case Exit::memory:
            return "memory";
    }
    return std::nullopt;
}

/// The exit codes and their descriptions, taken from the two groups of `pattern`.
std::map<int, std::string> codes_in(const std::string& text, const char* pattern) {
    std::map<int, std::string> out;
    for (const auto& m : matches(text, pattern))
        EXPECT_TRUE(out.emplace(std::stoi(m[1]), m[2]).second) << "listed twice: " << m[0];
    return out;
}

void expect_described(const std::map<int, std::string>& codes) {
    for (const auto& [code, text] : codes) {
        const auto word = word_for(Exit(code));
        ASSERT_TRUE(word) << "no exit code " << code;
        EXPECT_FALSE(matches(text, *word).empty()) << code << ": " << text;
    }
}

}  // namespace

TEST_F(Help, DocumentsMentionOnlyWhatProgramsAccept) {
    std::size_t commands = 0, options = 0;
    for (const Quote& q : quotes()) {
        if (q.text.find("gtest_filter") != std::string::npos) continue;
        if (!fs::exists(VANTAGE_BENCH) && q.place.starts_with("measurements.md"))
            continue;  // built for --full
        EXPECT_EQ(mistake(q.text), "") << q.place << ": " << q.text;
        const std::vector<std::string> words = words_of(q.text);
        commands += !words.empty() && programs.contains(fs::path(words[0]).filename().string());
        options += !words.empty() && words[0].starts_with("--");
    }
    EXPECT_GT(commands, 30u) << "commands were not recognized";
    EXPECT_GT(options, 15u) << "options were not recognized";
}

TEST_F(Help, MistakesAreFound) {
    for (const char* good :
         {"vantage prepare scan -o p.vantage --hold-out 0003",
          "build/pipeline/vantage check --deep p.vantage", "vantage-player p.vantage --blend best",
          "vantage-player evaluate p.vantage --level 3", "prepare --explain", "--blend average",
          "cmake --build build", "check", "vantage"})
        EXPECT_EQ(mistake(good), "") << good;
    for (const char* bad :
         {"vantage prepare scan --sparkle", "vantage sparkle p.vantage", "vantage check -o p.vantage",
          "vantage-player p.vantage --deep", "vantage-player p.vantage --blend worst",
          "vantage-player verify p.vantage --level 3", "prepare --deep", "--sparkle", "--blend worst"})
        EXPECT_NE(mistake(bad), "") << bad;
}

TEST_F(Help, ExitCodesAgree) {
    const auto table =
        codes_in(slurp(fs::path(VANTAGE_SOURCE_DIR) / "docs" / "contracts.md"), R"(\| (\d+) \| ([^|]+) )");
    expect_described(table);
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(table.contains(code), word_for(Exit(code)).has_value()) << code;
    for (const char* name : {"vantage", "vantage-player"}) {
        const std::string& notes = programs.at(name).notes;
        const std::size_t footer = notes.find("Exit codes:");
        ASSERT_NE(footer, std::string::npos) << name;
        const auto listed = codes_in(notes.substr(footer), R"((\d+) ([^,.]+)[,.])");
        expect_described(listed);
        for (const auto& [code, text] : listed) EXPECT_TRUE(table.contains(code)) << name << ": " << code;
        EXPECT_TRUE(name != std::string("vantage") || listed.size() == table.size()) << notes.substr(footer);
    }
}

TEST_F(Help, OfThePlayerFitsOnAScreen) {
    const fs::path out = dir / "help";
    ASSERT_EQ(std::system((std::string(VANTAGE_PLAYER) + " --help >" + out.string()).c_str()), 0);
    std::istringstream lines(slurp(out));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_LE(count, 50);
    EXPECT_GT(count, 30);
}

TEST_F(Help, ThePageOfCommandsListsAllVerbs) {
    std::string rows;
    for (const fs::path program : {VANTAGE_PROGRAM, VANTAGE_PLAYER}) {
        const DescribedCommand c = described(program);
        for (const DescribedCommand& verb : c.verbs)
            rows += "| `" + c.name + " " + verb.name + "` | " + verb.description + " |\n";
    }
    expect_table(fs::path(VANTAGE_SOURCE_DIR) / "docs/commands.md", "verbs", rows);
}

TEST_F(Help, ThePageOfEffectsListsAll) {
    std::vector<std::string> listed, expected;
    std::istringstream page(slurp(fs::path(VANTAGE_SOURCE_DIR) / "docs/effects.md"));
    for (std::string line; std::getline(page, line);)
        for (const auto& row : matches(line, R"(^\| `([^`]+)` \|)")) listed.push_back(row[1]);
    for (const EffectRow& row : effect_table()) expected.push_back(row.option);
    EXPECT_THAT(listed, testing::UnorderedElementsAreArray(expected));
}

TEST_F(Help, TheGuideListsAllPresets) {
    std::map<std::string, std::string> rows;
    for (const auto& file : fs::directory_iterator(fs::path(VANTAGE_SOURCE_DIR) / "configs")) {
        std::ifstream in(file.path());
        std::string first;
        if (file.path().extension() != ".toml" || !std::getline(in, first)) continue;
        ASSERT_TRUE(first.starts_with("# ") && first.ends_with(".")) << file.path();
        rows[file.path().stem()] = first.substr(2, first.size() - 3);
    }
    std::string all;
    for (const auto& [name, purpose] : rows) all += "| `" + name + "` | " + purpose + " |\n";
    expect_table(fs::path(VANTAGE_SOURCE_DIR) / "docs/overnight.md", "presets", all);
}

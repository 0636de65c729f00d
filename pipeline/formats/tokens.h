#pragma once
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/text/error.h"
#include "base/text/parse_number.h"
#include "pipeline/run/read_file.h"

namespace vantage {

/// Reads whitespace-separated words and numbers, independent of the locale. `what` names the expected item in
/// errors, which are Error(input) and give the file and line.
class Tokens {
  public:
    explicit Tokens(std::filesystem::path file)
        : file_(std::move(file)), text_(read_plain_text(file_)), rest_(text_) {}

    bool at_end() {
        skip_blanks(true);
        return rest_.empty();
    }
    bool at_line_end() {
        skip_blanks(false);
        return rest_.empty() || rest_.front() == '\n';
    }
    /// Whether the next word starts a comment.
    bool at_comment() {
        skip_blanks(false);
        return rest_.starts_with('#');
    }
    /// Whether the next word starts like a number.
    bool at_number() {
        skip_blanks(true);
        return !rest_.empty() &&
               (std::isdigit(static_cast<unsigned char>(rest_.front())) || rest_.front() == '+');
    }
    /// Whether the next word contains this character.
    bool at_word_with(char c) {
        skip_blanks(true);
        return rest_.substr(0, rest_.find_first_of(" \t\r\n")).find(c) != rest_.npos;
    }
    /// Skips the rest of the line, but not its end.
    void skip_to_line_end() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
    /// Consumes the end of a line if it is next.
    void next_line() {
        if (!rest_.starts_with('\n')) return;
        rest_.remove_prefix(1);
        ++line_;
    }
    /// Consumes the rest of the line and returns it without its end and trailing spaces.
    std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view out = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_;
        while (!out.empty() && (out.back() == '\r' || out.back() == ' ')) out.remove_suffix(1);
        return out;
    }
    std::string_view word(const char* what) {
        skip_blanks(true);
        const std::size_t end = std::min(rest_.find_first_of(" \t\r\n"), rest_.size());
        if (end == 0) fail(what, "the end of the file");
        const std::string_view out = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return out;
    }
    template <class T>
    T number(const char* what) {
        const std::string_view w = word(what);
        T value{};
        if (!parse_number(w, value)) fail(what, std::string("'").append(w.substr(0, 40)) + "'");
        return value;
    }
    /// Skips a line that starts with #; returns false if there is none.
    bool skip_comment() {
        skip_blanks(true);
        if (rest_.empty() || rest_.front() != '#') return false;
        line();
        return true;
    }
    [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
        throw Error(Exit::input, flaw(expected, found));
    }
    /// The message of fail().
    std::string flaw(const std::string& expected, const std::string& found) const {
        return file_.string() + ", line " + std::to_string(line_) + ": expected " + expected + ", found " +
               found;
    }

  private:
    void skip_blanks(bool lines) {
        while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t' || rest_.front() == '\r' ||
                                  (lines && rest_.front() == '\n'))) {
            line_ += rest_.front() == '\n';
            rest_.remove_prefix(1);
        }
    }
    std::filesystem::path file_;
    std::string text_;
    std::string_view rest_;
    std::size_t line_ = 1;
};

}  // namespace vantage

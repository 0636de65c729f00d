#include "base/cli/help_text.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/cli/joined.h"
#include "base/cli/notes.h"

namespace vantage {
namespace {

constexpr std::size_t width = 80, indent = 26, max_examples = 6;

/// Wraps words before column `width`. The first line starts at column `left`, and the following lines are
/// indented to it.
std::string wrapped(const std::string& text, std::size_t left) {
    std::istringstream words(text);
    std::string out, word;
    for (std::size_t column = left; words >> word;) {
        if (column > left && column + 1 + word.size() >= width) {
            out += "\n" + std::string(left, ' ');
            column = left;
        }
        const std::string_view space = column > left ? " " : "";
        out += space;
        out += word;
        column += space.size() + word.size();
    }
    return out + "\n";
}

std::string entry(const std::string& name, const std::string& text) {
    const std::string begin = "  " + name;
    if (text.empty()) return begin + "\n";
    const bool beside = begin.size() + 2 <= indent;
    return begin + (beside ? std::string(indent - begin.size(), ' ') : "\n" + std::string(indent, ' ')) +
           wrapped(text, indent);
}

std::string entry(const DescribedOption& o) {
    std::string name = joined(o.names, ","), text = o.description;
    if (const std::string label = label_of(o); name.starts_with('-') && !label.empty()) name += " " + label;
    if (o.several) name += " ...";
    if (name.starts_with('-') && o.required) text += " (required)";
    if (!o.needs.empty()) text += "; with " + joined(o.needs, ", ");
    return entry(name, text);
}

/// The entry without the details after the first semicolon outside parentheses.
std::string short_entry(const DescribedOption& o) {
    DescribedOption out = o;
    int depth = 0;
    const auto ends = [&](char c) { return (depth += (c == '(') - (c == ')')) == 0 && c == ';'; };
    const auto end = std::ranges::find_if(o.description, ends);
    out.description.resize(std::size_t(end - o.description.begin()));
    return entry(out);
}

std::string usage(const DescribedCommand& c, const std::string& command) {
    std::string out = "Usage: " + command + " [OPTIONS]";
    for (const DescribedOption& a : c.arguments) {
        const std::string name = a.names.front() + (a.several ? "..." : "");
        out += a.required ? " " + name : " [" + name + "]";
    }
    if (c.verbs.empty()) return out + "\n";
    return c.arguments.empty() ? out + " VERB\n" : out + "\n       " + command + " VERB ...\n";
}

std::string option_groups(const DescribedCommand& c) {
    std::string out;
    for (const std::string& group : headings_of(c.options)) {
        out += "\n" + group + ":\n";
        for (const DescribedOption& o : c.options)
            if (o.group == group) out += entry(o);
    }
    return out;
}

std::string common_options(const DescribedCommand& c, const std::string& command) {
    std::string out = "\nOptions that most people use; '" + command + " --help-all' lists all:\n";
    for (const DescribedOption& o : c.options)
        if (std::ranges::count(c.common, o.names.back())) out += short_entry(o);
    return out;
}

/// The notes, with at most `max_examples` examples unless `all` is set.
std::string notes_of(const DescribedCommand& c, bool all) {
    const Notes notes = divided(c.notes);
    std::string out;
    for (const std::string& p : notes.paragraphs) out += "\n" + wrapped(p, 0);
    if (!notes.examples.empty()) out += "\nExamples:\n";
    for (std::size_t i = 0; i < notes.examples.size() && (all || i < max_examples); ++i)
        out += "  " + notes.examples[i] + "\n";
    return notes.exit_codes.empty() ? out : out + "\n" + wrapped(notes.exit_codes, 0);
}

}  // namespace

std::string limits_text(const DescribedOption& o) {
    return "from " + o.least + (o.most.size() <= longest_limit ? " to " + o.most : " up");
}

std::string label_of(const DescribedOption& o) {
    std::vector<std::string> known;
    if (!o.least.empty()) known.push_back(limits_text(o));
    if (!o.initial.empty()) known.push_back("default " + o.initial);
    std::string kind = o.type;
    if (!o.values.empty()) kind = "{" + joined(o.values, ",") + "}" + (o.type == "FILE" ? " or FILE" : "");
    return known.empty() ? kind : kind + " (" + joined(known, ", ") + ")";
}

std::string help_text(const DescribedCommand& c, const std::string& program, bool all) {
    const std::string command = program.empty() ? c.name : program + " " + c.name;
    const bool whole = all || c.common.empty();
    std::string out = wrapped(c.description, 0) + "\n" + usage(c, command);
    if (!c.arguments.empty()) out += "\n";
    for (const DescribedOption& a : c.arguments) out += whole ? entry(a) : short_entry(a);
    if (!c.verbs.empty()) out += "\nVerbs:\n";
    for (const DescribedCommand& v : c.verbs) out += entry(v.name, v.description);
    out += whole ? option_groups(c) : common_options(c, command);
    return out + notes_of(c, whole);
}

}  // namespace vantage

#include "base/cli/man_page.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "base/cli/notes.h"

namespace vantage {
namespace {

/// Escapes text so that roff prints it literally and leaves hyphens as typed.
std::string roff_escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else
            out += c;
    }
    return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(const std::string& text) { return "\\fB" + roff_escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff_escaped(text) + "\\fR"; }

/// Capitalizes the text, unless it starts with a name or a value, and ends it with a period.
std::string sentence(std::string text) {
    const std::size_t word = text.find_first_of(" :=/");
    const bool prose = word != std::string::npos && text[word] == ' ' && text.find_first_of(",.") > word;
    if (prose && !text.empty()) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text.empty() || text.ends_with('.') ? text : text + ".";
}

/// Turns "Prepare a package." into "prepare a package".
std::string summary(std::string text) {
    if (text.ends_with('.')) text.pop_back();
    const auto lower = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
    if (text.size() > 1 && lower(text[1])) text[0] = char(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// The option's value as the manual shows it, such as "FILE", or the permitted values.
std::string value_of(const DescribedOption& o) {
    if (o.values.empty()) return italic(o.type);
    std::string out;
    const std::string next = "|\\:";  // permits a line break
    for (const std::string& v : o.values) out += (out.empty() ? "" : next) + bold(v);
    return o.type == "FILE" ? out + next + italic(o.type) : out;
}

/// The limits and the default of the value, such as "1 to 4096, default 256".
std::string limits_of(const DescribedOption& o) {
    std::string out;
    const auto add = [&](const std::string& text) { out += (out.empty() ? "" : ", ") + text; };
    if (o.required) add("required");
    if (o.type != "SIZE" && !o.least.empty())
        add(o.most.size() <= longest_limit ? o.least + " to " + o.most : "at least " + o.least);
    if (o.commas) add("several are separated by commas");
    if (!o.initial.empty()) add("default " + o.initial);
    return out;
}

std::string described(const DescribedOption& o) {
    const std::string limits = limits_of(o);
    return roff_escaped(sentence(o.description)) +
           (limits.empty() ? "" : "\n(" + roff_escaped(limits) + ")") + "\n";
}

std::string option_entry(const DescribedOption& o) {
    std::string out = ".TP\n";
    for (const std::string& name : o.names) out += (&name == &o.names.front() ? "" : ", ") + bold(name);
    if (!o.type.empty()) out += " " + value_of(o) + (o.several && !o.commas ? " ..." : "");
    return out + "\n" + described(o);
}

std::string argument_entry(const DescribedOption& o) {
    return ".TP\n" + italic(o.names.front()) + (o.several ? " ..." : "") + "\n" + described(o);
}

/// The options in their groups, as in --help. The first group, which includes --help itself, needs no
/// heading.
std::string option_sections(const DescribedCommand& c) {
    if (c.options.empty()) return {};
    const std::string plain = "Options";
    std::string out = ".SH OPTIONS\n";
    for (const std::string& group : headings_of(c.options)) {
        if (group != plain) out += ".SS " + roff_escaped(group) + "\n";
        for (const DescribedOption& o : c.options)
            if (o.group == group) out += option_entry(o);
    }
    return out;
}

std::string synopsis(const std::string& command, const DescribedCommand& c) {
    std::string out = ".SH SYNOPSIS\n" + bold(command);
    for (const DescribedOption& a : c.arguments) {
        const std::string name = italic(a.names.front()) + (a.several ? " ..." : "");
        out += a.required ? " " + name : " [" + name + "]";
    }
    for (const DescribedOption& o : c.options)
        if (o.required) out += " " + bold(o.names.front()) + " " + value_of(o);
    return out + " [" + italic("OPTIONS") + "]\n";
}

std::string commands_section(const DescribedCommand& program) {
    if (program.verbs.empty()) return {};
    std::string out = ".SH COMMANDS\n";
    for (const DescribedCommand& v : program.verbs)
        out += ".TP\n" + bold(program.name + " " + v.name) + "\n" +
               roff_escaped(sentence(summary(v.description))) + "\nSee " + bold(program.name + "-" + v.name) +
               "(1).\n";
    return out;
}

std::string examples_section(const std::vector<std::string>& examples) {
    if (examples.empty()) return {};
    std::string out = ".SH EXAMPLES\n.nf\n";
    for (const std::string& line : examples) out += roff_escaped(line) + "\n";
    return out + ".fi\n";
}

std::string see_also(const std::set<std::string>& pages) {
    std::string out;
    for (const std::string& page : pages) out += (out.empty() ? "" : ",\n") + bold(page) + "(1)";
    return ".SH \"SEE ALSO\"\n" + out + "\n";
}

/// `command`: as typed; `others`: related pages.
ManPage page(const DescribedCommand& c, const std::string& command, const std::set<std::string>& others,
             const std::string& version) {
    ManPage out{command, {}};
    std::ranges::replace(out.name, ' ', '-');
    const Notes notes = divided(c.notes);
    const std::string what = summary(c.description);
    out.text = ".TH \"" + roff_escaped(out.name) + "\" 1 \"\" \"Vantage " + version + "\" \"Vantage\"\n";
    out.text += ".nh\n.ad l\n";  // no hyphenation of option names
    out.text += ".SH NAME\n" + roff_escaped(out.name) + " \\- " + roff_escaped(what) + "\n";
    out.text += synopsis(command, c);
    if (!c.verbs.empty() && c.arguments.empty())
        out.text += ".br\n" + bold(command) + " " + italic("COMMAND") + " ...\n";
    out.text += ".SH DESCRIPTION\n" + roff_escaped(sentence(c.description)) + "\n";
    for (const std::string& p : notes.paragraphs) out.text += ".PP\n" + roff_escaped(p) + "\n";
    out.text += commands_section(c);
    if (!c.arguments.empty()) out.text += ".SH ARGUMENTS\n";
    for (const DescribedOption& a : c.arguments) out.text += argument_entry(a);
    out.text += option_sections(c) + examples_section(notes.examples);
    if (!notes.exit_codes.empty())
        out.text += ".SH \"EXIT STATUS\"\n" + roff_escaped(notes.exit_codes) + "\n";
    out.text += see_also(others);
    return out;
}

}  // namespace

std::vector<ManPage> man_pages(const std::vector<DescribedCommand>& programs, const std::string& version) {
    std::vector<ManPage> out;
    for (const DescribedCommand& program : programs) {
        std::set<std::string> related;
        for (const DescribedCommand& other : programs)
            if (other.name != program.name) related.insert(other.name);
        for (const DescribedCommand& verb : program.verbs) {
            const std::string command = program.name + " " + verb.name;
            out.push_back(page(verb, command, {program.name}, version));
            related.insert(out.back().name);
        }
        out.push_back(page(program, program.name, related, version));
    }
    return out;
}

}  // namespace vantage

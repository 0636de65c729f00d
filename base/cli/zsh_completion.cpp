#include "base/cli/zsh_completion.h"

#include <algorithm>

#include "base/cli/joined.h"

namespace vantage {
namespace {

/// Escapes single-quoted text for _arguments, in which brackets and colons are special.
std::string argument_escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        out += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return out;
}

/// The action that tells _arguments how to complete a value: from a list, with a kind of file, or not at all.
std::string action_of(const DescribedOption& o) {
    const std::string list = o.values.empty() ? "" : "(" + joined(o.values, " ") + ")";
    const std::string values =
        o.commas && !list.empty() ? "_sequence compadd - " + joined(o.values, " ") : list;
    if (o.type == "FOLDER") return "_files -/";
    if (o.type == "PACKAGE") return "_files -g \"*.(vantage|toml)\"";
    if (o.type == "FILE" && !list.empty())
        return "_alternative \"values:value:" + list + "\" \"files:file:_files\"";
    return o.type == "FILE" || (o.type == "TEXT" && list.empty()) ? "_files" : values;
}

/// The action with its colons escaped, because colons separate the fields of an _arguments specification.
std::string divided_action(const DescribedOption& o) {
    std::string out;
    for (const char c : action_of(o)) out += c == ':' ? "\\:" : std::string(1, c);
    return out;
}

/// '(-o --output)'{-o,--output}'[the package to write]:FILE:_files'
std::string specification_of(const DescribedOption& o) {
    const std::string value = o.type.empty() ? "" : ":" + argument_escaped(o.type) + ":" + divided_action(o);
    const std::string others = o.several ? "'*'" : "'(" + joined(o.names, " ") + ")'";
    const std::string names = joined(o.names, ",");
    return others + (o.names.size() == 1 ? names : "{" + names + "}") + "'[" +
           argument_escaped(o.description) + "]" + value + "'";
}

/// The case branch for the options and arguments of a verb, or of the program itself.
std::string zsh_verb_case(const DescribedCommand& c, const std::string& pattern) {
    std::string out = "    " + pattern + ")\n        _arguments";
    for (const DescribedOption& o : c.options) out += " \\\n            " + specification_of(o);
    for (const DescribedOption& a : c.arguments)
        out += std::string(" \\\n            '") + (a.several ? "*" : "") + ":" +
               argument_escaped(a.names.front()) + ":" + divided_action(a) + "'";
    return out + " ;;\n";
}

}  // namespace

std::string zsh_completion(const DescribedCommand& program) {
    std::string list, cases;
    std::vector<std::string> names;
    for (const DescribedCommand& v : program.verbs) {
        list += "    '" + v.name + ":" + argument_escaped(v.description) + "'\n";
        cases += zsh_verb_case(v, v.name);
        names.push_back(v.name);
    }
    const std::string files =
        program.arguments.empty() ? "" : "    " + action_of(program.arguments.front()) + "\n";
    return "#compdef " + program.name + "\n# Completion of " + program.name +
           " for zsh, made from its command line.\nlocal -a verbs=(\n" + list +
           ")\nif ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n    _describe verb verbs\n" + files +
           "    return\nfi\nif [[ $words[2] == (" + joined(names, "|") +
           ") ]]; then\n    shift words\n    ((CURRENT--))\nfi\ncase $words[1] in\n" + cases +
           zsh_verb_case(program, "*") + "esac\n";
}

}  // namespace vantage

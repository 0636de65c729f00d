#include "base/cli/bash_completion.h"

#include <algorithm>

#include "base/cli/joined.h"

namespace vantage {
namespace {

/// The kind of file or folder that a value names; empty if the value names neither.
std::string kind_of(const DescribedOption& o) {
    if (o.type == "TEXT") return o.values.empty() ? "FILE" : "";
    return o.type == "FILE" || o.type == "FOLDER" || o.type == "PACKAGE" ? o.type : "";
}

/// The case branch for the values of one option.
std::string value_case(const DescribedOption& o) {
    std::string out = "            " + joined(o.names, "|") + ") value=yes kind=" + kind_of(o);
    if (!o.values.empty()) out += " words='" + joined(o.values, " ") + "'";
    if (o.commas) out += " commas=yes";
    return out + " ;;\n";
}

/// The case branch for the options and arguments of a verb, or of the program itself.
std::string bash_verb_case(const DescribedCommand& c, const std::string& pattern) {
    std::vector<std::string> names;
    for (const DescribedOption& o : c.options) names.insert(names.end(), o.names.begin(), o.names.end());
    std::string out = "        " + pattern + ")\n            options='" + joined(names, " ") + "'";
    if (!c.arguments.empty()) out += " kind=" + kind_of(c.arguments.front());
    out += "\n            case $option in\n";
    for (const DescribedOption& o : c.options)
        if (!o.type.empty()) out += value_case(o);
    return out + "            esac ;;\n";
}

/// Start of the script: finds the option whose value is being completed. Bash splits words at "=".
constexpr const char* beginning = R"(# Completion of PROGRAM for bash, made from its command line.
FUNCTION() {
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} option= options= verbs= kind= words= value= commas=
    local before=${COMP_WORDS[COMP_CWORD-1]}
    if [[ $word == '=' ]]; then
        word= option=$before
    elif [[ $before == '=' ]]; then
        option=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $before == -* ]]; then
        option=$before
    fi
    if ((COMP_CWORD == 1)); then verb= verbs='VERBS'; fi
    case $verb in
)";

/// End of the script: completes one of `words` (in a list, the part after the last comma) or a file name.
/// Bash itself falls back to file names (default, dirnames).
constexpr const char* end = R"(    esac
    COMPREPLY=()
    if [[ -z $value && $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    [[ $value ]] || words=$verbs
    local first=
    [[ $commas && $word == *,* ]] && first=${word%,*},
    mapfile -t COMPREPLY < <(compgen -P "$first" -W "$words" -- "${word#"$first"}")
    [[ $first ]] && compopt -o nospace
    case $kind in
        PACKAGE)
            local cur=$word
            declare -F _filedir >/dev/null && _filedir '@(vantage|toml)'
            ((${#COMPREPLY[@]})) || compopt -o default ;;
        FOLDER) compopt -o dirnames ;;
        FILE) compopt -o default ;;
    esac
}
complete -F FUNCTION PROGRAM
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

}  // namespace

std::string bash_completion(const DescribedCommand& program) {
    std::string function = "_" + program.name;
    std::ranges::replace(function, '-', '_');
    std::vector<std::string> verbs;
    for (const DescribedCommand& v : program.verbs) verbs.push_back(v.name);
    std::string out = replaced(beginning, "VERBS", joined(verbs, " "));
    for (const DescribedCommand& v : program.verbs) out += bash_verb_case(v, v.name);
    out += bash_verb_case(program, "*") + end;
    return replaced(replaced(out, "FUNCTION", function), "PROGRAM", program.name);
}

}  // namespace vantage

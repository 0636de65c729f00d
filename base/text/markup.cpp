#include "base/text/markup.h"

namespace vantage {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c == '<' || c == '>' || c == '&' || c == '"' || c == '\'')
            out += "&#" + std::to_string(int(c)) + ";";
        else
            out += c;
    return out;
}

std::string sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
    return escaped(text) + ".";
}

}  // namespace vantage

#include "output/markup.h"

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

}  // namespace vantage

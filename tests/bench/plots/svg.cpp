#include "tests/bench/plots/svg.h"

#include <algorithm>
#include <string_view>

#include "base/text/markup.h"
#include "tests/bench/results/quantity.h"

namespace vantage::bench {
namespace {

std::string replaced(const std::string& text, std::string_view from, std::string_view to) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t next; (next = text.find(from, at)) != std::string::npos; at = next + from.size())
        out.append(text, at, next - at).append(to);
    return out.append(text, at);
}

std::string without(std::string text, std::string_view begin, std::string_view end) {
    for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
        const std::size_t stop = text.find(end, at);
        if (stop == std::string::npos) break;
        text.erase(at, stop + end.size() - at);
    }
    return text;
}

/// Removes empty groups; gnuplot writes many of them.
std::string without_empty_groups(const std::string& text) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t open; (open = text.find("<g ", at)) != std::string::npos;) {
        const std::size_t end = text.find('>', open) + 1;
        const std::size_t next = text.find_first_not_of(" \t\r\n", end);
        out.append(text, at, open - at);
        at = next;
        if (next == std::string::npos || text.compare(next, 4, "</g>") != 0)
            out.append(text, open, end - open);
        else
            at = next + 4;
    }
    return out.append(text, at);
}

/// Adds a prefix to all ids. Changes only tags, never visible text.
std::string with_own_ids(const std::string& text, const std::string& prefix) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const bool tag = text[at] == '<';
        const std::size_t end = std::min(text.size(), tag ? text.find('>', at) + 1 : text.find('<', at));
        std::string part = text.substr(at, end - at);
        for (const char* begin : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
            if (tag) part = replaced(part, begin, begin + prefix);
        out += part;
        at = end;
    }
    return out;
}

}  // namespace

std::string inline_svg(const std::string& document, const std::string& prefix, const std::string& title,
                       const std::string& last) {
    const std::size_t open = document.find("<svg"), view = document.find("viewBox=\"", open),
                      body = document.find('>', open), end = document.rfind("</svg>");
    if (end == std::string::npos || view == std::string::npos || view > body) return "";
    const std::string box = document.substr(view, document.find('"', view + 9) + 1 - view);
    std::string inside = document.substr(body + 1, end - body - 1);
    inside = without(without(inside, "<title>", "</title>"), "<desc>", "</desc>");
    inside = without(inside, "<filter ", "</filter>");
    inside = replaced(without_empty_groups(inside), "\n\n", "\n");
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
           "class=\"plot\" role=\"img\" aria-label=\"" +
           escaped(title) + "\" width=\"100%\" " + box + ">" + with_own_ids(inside, prefix) + last +
           "</svg>\n";
}

}  // namespace vantage::bench

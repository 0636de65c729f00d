#include "player/interface/language_menu.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "base/text/translation.h"

namespace vantage {
std::string own_name(const std::string& code) {
    struct Name {
        const char *code, *name;
    };
    constexpr Name names[] = {{"de", "Deutsch"},  {"en", "English"},  {"es", "Español"},
                              {"fr", "Français"}, {"it", "Italiano"}, {"nl", "Nederlands"},
                              {"pt", "Português"}};
    const auto at = std::ranges::find(names, code, &Name::code);
    return at == std::end(names) ? code : at->name;
}

void language_items(Controls& c, WindowState& window) {
    std::vector<std::string> codes = languages_of_window();
    for (const std::string& code : window.story_languages)
        if (!std::ranges::count(codes, code)) codes.push_back(code);
    std::string used = window.language;
    if (!std::ranges::count(codes, used)) used = used.substr(0, used.find('-'));
    for (const std::string& code : codes)
        if (c.menu_item(own_name(code).c_str(), nullptr, code == used)) window.language = code;
}

}  // namespace vantage

#include "player/interface/language_menu.h"

#include <algorithm>
#include <iterator>

#include "base/text/translation.h"

namespace vantage {
namespace {

/// The name of a language in that language, for users who do not know the current one.
std::string own_name(const std::string& code) {
    struct Name {
        const char *code, *name;
    };
    constexpr Name names[] = {{"de", "Deutsch"}, {"en", "English"}, {"fr", "Français"}};
    const auto at = std::ranges::find(names, code, &Name::code);
    return at == std::end(names) ? code : at->name;
}

}  // namespace

void language_items(Controls& c, WindowState& window) {
    for (const std::string& code : languages_of_window()) {
        const bool used = window.language.substr(0, window.language.find('-')) == code;
        if (c.menu_item(own_name(code).c_str(), nullptr, used)) window.language = code;
    }
}

}  // namespace vantage

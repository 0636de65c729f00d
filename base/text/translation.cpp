#include "base/text/translation.h"

#include <libintl.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

extern "C" int _nl_msg_cat_cntr;  // glibc: must be incremented after LANGUAGE changes

namespace vantage {
namespace {

constexpr const char* domain = "vantage";
constexpr char context_end = '\4';  ///< ends the context, as in gettext catalogs

thread_local int english_keepers = 0;

/// bin/../share/locale in an installation or a build folder.
std::filesystem::path catalogs() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return program.parent_path().parent_path() / "share/locale";
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// gettext follows LANGUAGE in every locale but C. Before glibc 2.39, gettext does so in C.UTF-8 as well,
/// which always exists.
void use_locale_with_languages() {
    for (const char* name : {"", "en_US.UTF-8", "en_GB.UTF-8", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
        const char* const taken = std::setlocale(LC_MESSAGES, name);
        const std::string_view locale = taken ? taken : "C";
        if (locale != "C" && locale != "POSIX" && !locale.starts_with("C.")) return;
    }
    std::setlocale(LC_MESSAGES, "C.UTF-8");
}

}  // namespace

const char* without_context(const char* text) {
    const char* const end = std::strchr(text, context_end);
    return end ? end + 1 : text;
}

const char* tr(const char* text) {
    if (!*text || english_keepers > 0) return without_context(text);
    const char* const translated = ::dgettext(domain, text);
    return translated == text ? without_context(text) : translated;
}

const char* tr_in(const char* context, const char* text) {
    if (english_keepers > 0) return text;
    const std::string key = std::string(context) + context_end + text;
    const char* const translated = ::dgettext(domain, key.c_str());
    return translated == key.c_str() ? text : translated;
}

const char* tr_count(const char* one, const char* several, std::size_t count) {
    if (english_keepers > 0) return count == 1 ? one : several;
    return ::dngettext(domain, one, several, count);
}

KeepEnglish::KeepEnglish() { ++english_keepers; }
KeepEnglish::~KeepEnglish() { --english_keepers; }

void use_language(const std::string& language) {
    std::string code = language.empty() ? "en" : language;
    std::ranges::replace(code, '-', '_');
    use_locale_with_languages();
    ::setenv("LANGUAGE", code.c_str(), 1);
    ::bindtextdomain(domain, catalogs().c_str());
    ::bind_textdomain_codeset(domain, "UTF-8");
    ++_nl_msg_cat_cntr;
}

std::vector<std::string> languages_of_window() {
    std::vector<std::string> out{"en"};
    std::error_code error;
    for (std::filesystem::directory_iterator at(catalogs(), error), end; !error && at != end;
         at.increment(error))
        if (std::error_code unknown;
            std::filesystem::exists(at->path() / "LC_MESSAGES" / (std::string(domain) + ".mo"), unknown))
            out.push_back(at->path().filename().string());
    std::ranges::sort(out);
    return out;
}

std::string system_language() {
    std::string locale;
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (locale.empty()) locale = variable(name);
    locale.erase(std::min(locale.find_first_of(".@"), locale.size()));
    if (locale == "C" || locale == "POSIX") return "";
    const std::string preferred = locale.empty() ? "" : variable("LANGUAGE");
    std::string language = preferred.empty() ? locale : preferred.substr(0, preferred.find(':'));
    std::ranges::replace(language, '_', '-');
    return language;
}

}  // namespace vantage

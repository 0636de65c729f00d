#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// What the window says in the user's language, by gettext. The English texts are the keys of the catalogs in
/// languages/, which lie in share/locale beside the programs' folder. Belongs to one thread.
namespace vantage {

/// A text that is translated where it is shown; so that it gets into the catalogs.
constexpr const char* marked(const char* text) { return text; }

/// The text in the language in use, or itself; valid until another language is used.
[[gnu::format_arg(1)]] const char* tr(const char* text);
/// That for one, or for another number, by the language's rules.
[[gnu::format_arg(1), gnu::format_arg(2)]] const char* tr_count(const char* one, const char* several,
                                                                std::size_t count);

/// Uses a language: "de", or "de-AT", for which "de" does as well. English where there is no catalog.
void use_language(const std::string& language);
/// The languages that have a catalog, by their codes, and English.
std::vector<std::string> languages_of_window();
/// That of the environment (LC_ALL, LC_MESSAGES, LANG; then LANGUAGE), such as "de-AT"; empty if it names
/// none.
std::string system_language();

}  // namespace vantage

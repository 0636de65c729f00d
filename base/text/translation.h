#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// Translates the window's texts with gettext. English texts are the keys of the catalogs in languages/,
/// which are installed in share/locale, next to the programs' folder. All calls must be made on one thread,
/// except while a KeepEnglish exists.
namespace vantage {

/// Marks a text for the catalogs; it is translated where it is shown.
constexpr const char* marked(const char* text) { return text; }
/// Marks a text that has several meanings. The context distinguishes the meanings in the catalogs; it is not
/// shown.
#define MARKED_IN(context, text) context "\004" text
/// The text without its context, if it has one.
const char* without_context(const char* text);

/// Translates a text. Without a translation, returns the text minus its context. The result is valid until
/// the language changes.
[[gnu::format_arg(1)]] const char* tr(const char* text);
/// Translates a text in a context.
[[gnu::format_arg(2)]] const char* tr_in(const char* context, const char* text);
/// The translated singular or plural, according to the rules of the language.
[[gnu::format_arg(1), gnu::format_arg(2)]] const char* tr_count(const char* one, const char* several,
                                                                std::size_t count);

/// While an object of this class exists, texts on its thread are not translated, as in files.
class KeepEnglish {
  public:
    KeepEnglish();
    ~KeepEnglish();
    KeepEnglish(const KeepEnglish&) = delete;
};

/// Selects a language, such as "de"; "de-AT" uses the catalog of "de". A language without a catalog selects
/// English.
void use_language(const std::string& language);
/// The codes of English and of the languages that have a catalog.
std::vector<std::string> languages_of_window();
/// The language that the environment sets (LC_ALL, LC_MESSAGES, LANG; then LANGUAGE), such as "de-AT"; empty
/// if it sets none.
std::string system_language();

}  // namespace vantage

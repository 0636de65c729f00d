#include "base/text/translation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "base/text/formatted.h"
#include "base/text/localized.h"

using namespace vantage;

namespace {

/// The system language if the environment has no other language variables.
std::string language_in(const std::map<std::string, std::string>& variables) {
    for (const char* name : {"LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"}) ::unsetenv(name);
    for (const auto& [name, value] : variables) ::setenv(name.c_str(), value.c_str(), 1);
    return system_language();
}

}  // namespace

TEST(SystemLanguage, IsThatOfTheEnvironment) {
    EXPECT_EQ(language_in({}), "");
    EXPECT_EQ(language_in({{"LANG", "de_AT.UTF-8"}}), "de-AT");
    EXPECT_EQ(language_in({{"LANG", "de_AT.UTF-8"}, {"LC_MESSAGES", "fr_FR@euro"}}), "fr-FR");
    EXPECT_EQ(language_in({{"LC_MESSAGES", "fr_FR"}, {"LC_ALL", "en_GB.UTF-8"}}), "en-GB");
    EXPECT_EQ(language_in({{"LANG", "en_US.UTF-8"}, {"LANGUAGE", "de:en"}}), "de");
    EXPECT_EQ(language_in({{"LANG", "C.UTF-8"}}), "");
    EXPECT_EQ(language_in({{"LANG", "C"}, {"LANGUAGE", "de"}}), "") << "as gettext does";
    EXPECT_EQ(language_in({{"LC_ALL", ""}, {"LANG", "POSIX"}}), "");
}

TEST(Translation, OfWhatNoCatalogHasIsTheTextItself) {
    use_language("tlh");
    EXPECT_STREQ(tr("no catalog has this"), "no catalog has this");
    EXPECT_STREQ(tr(""), "");
    EXPECT_STREQ(tr(MARKED_IN("of no catalog", "in")), "in");
    EXPECT_STREQ(tr_in("of no catalog", "in"), "in");
    EXPECT_STREQ(without_context(MARKED_IN("unit", "in")), "in");
    EXPECT_STREQ(without_context("in"), "in");
    EXPECT_STREQ(tr_count("one %zu", "several %zu", 1), "one %zu");
    EXPECT_STREQ(tr_count("one %zu", "several %zu", 0), "several %zu");
}

TEST(Formatted, IsWhatPrintfPrints) {
    EXPECT_EQ(formatted("%s of %zu %%", "part", std::size_t(3)), "part of 3 %");
    EXPECT_EQ(formatted("%s", std::string(5000, 'x').c_str()), std::string(5000, 'x'));
    EXPECT_EQ(formatted("%s", ""), "");
}

TEST(Formatted, HasNoNegativeZero) {
    EXPECT_EQ(formatted("%.1f, %+.1f, %5.1f, %g, %.0e", -0.04, -0.04, -0.04, -0.0, -0.0),
              "0.0, +0.0,   0.0, 0, 0e+00");
    EXPECT_EQ(formatted("%s, %d, %.1f, %g, %g", "-0.0", -10, -10.0, -1e-10, -HUGE_VAL),
              "-0.0, -10, -10.0, -1e-10, -inf");
}

TEST(Localized, IsWhatPrintfPrintsInEnglish) {
    use_language("");
    EXPECT_EQ(localized("%s of %5.2f %%, %zu, %+.1e", "1.5", 2.25, std::size_t(3), 0.5),
              "1.5 of  2.25 %, 3, +5.0e-01");
    EXPECT_EQ(localized("100 %%"), "100 %");
    EXPECT_EQ(localized("%.*f%c", 3, 1.5, 'm'), "1.500m");
    EXPECT_EQ(localized_numbers("x 1.5, IMG.2.jpg"), "x 1.5, IMG.2.jpg");
}

TEST(TypedNumber, HasAPointOrAComma) {
    EXPECT_EQ(typed_number(" 1.25 "), 1.25);
    EXPECT_EQ(typed_number("-1,25"), -1.25);
    EXPECT_EQ(typed_number("+3"), 3);
    EXPECT_EQ(typed_number("1e-3"), 1e-3);
    for (const char* none : {"", " ", "1.234,5", "1,2,3", "m", "1 m", "inf", "nan"})
        EXPECT_FALSE(typed_number(none)) << none;
}

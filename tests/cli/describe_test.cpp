// What a program tells of its command line is what was added to it, in words that manual and completion need.
#include "cli/describe.h"

#include <gtest/gtest.h>

#include <map>

#include "cli/known_values.h"
#include "cli/real_range.h"
#include "manual/described_command.h"

using namespace vantage;

namespace {

enum class Blend { average, best };

using Words = std::vector<std::string>;

/// What `app` describes when it is called as build/bin/`name`.
DescribedCommand described(const CLI::App& app, std::string name) {
    std::string path = "build/bin/" + name, option = "--describe";
    char* words[] = {path.data(), option.data()};
    testing::internal::CaptureStdout();
    EXPECT_TRUE(describe_if_asked(app, 2, words));
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_EQ(std::ranges::count(text, '\n'), 1);
    return from_line(text);
}

/// The only option beside --help.
template <class Add>
DescribedOption option(const Add& add) {
    CLI::App app;
    add(app);
    const DescribedCommand c = described(app, "program");
    EXPECT_EQ(c.options.size() + c.arguments.size(), 2u);
    return c.arguments.empty() ? c.options.back() : c.arguments.front();
}

}  // namespace

TEST(Describe, FlagsTakeNoValue) {
    bool on = false;
    const auto o = option([&](CLI::App& app) { app.add_flag("-q,--quiet", on, "print only errors"); });
    EXPECT_EQ(o.names, (Words{"-q", "--quiet"}));
    EXPECT_EQ(o.type, "");
    EXPECT_EQ(o.description, "print only errors");
    EXPECT_EQ(option([&](CLI::App& app) { app.add_flag("!--bilinear", on); }).names, Words{"--bilinear"});
}

TEST(Describe, NumbersHaveLimits) {
    int count = 256;
    const auto o = option([&](CLI::App& app) {
        app.add_option("--size", count)->check(CLI::Range(1, 4096))->capture_default_str()->group("Pictures");
    });
    EXPECT_EQ(o.type, "NUMBER");
    EXPECT_EQ(o.least + " " + o.most + " " + o.initial, "1 4096 256");
    EXPECT_EQ(o.group, "Pictures");
    double share = 0;
    const auto real =
        option([&](CLI::App& app) { app.add_option("--share", share)->check(real_range(0.5, 1.5)); });
    EXPECT_EQ(real.type + " " + real.least + " " + real.most, "NUMBER 0.5 1.5");
}

TEST(Describe, ValuesToChooseFromAreListed) {
    std::string text = "raw";
    EXPECT_EQ(option([&](CLI::App& app) {
                  app.add_option("--tiles", text)->check(CLI::IsMember(Words{"raw", "jpeg"}));
              }).values,
              (Words{"raw", "jpeg"}));
    Blend blend{};
    const auto o = option([&](CLI::App& app) {
        app.add_option("--blend", blend)
            ->transform(CLI::CheckedTransformer(
                std::map<std::string, Blend>{{"average", Blend::average}, {"best-photo", Blend::best}}))
            ->default_str("average");
    });
    EXPECT_EQ(o.values, (Words{"average", "best-photo"}));
    EXPECT_EQ(o.type + " " + o.initial, "TEXT average");
    const auto open = option([&](CLI::App& app) {
        app.add_option("--distance", text)
            ->type_name("FILE")
            ->check(known_values({"jfa+1", "1+jfa", "jfa^2"}));
    });
    EXPECT_EQ(open.values, (Words{"jfa+1", "1+jfa", "jfa^2"}));
    EXPECT_EQ(open.type, "FILE");
}

TEST(Describe, ListsAndArguments) {
    Words words{"still", "orbit"};
    const auto o = option(
        [&](CLI::App& app) { app.add_option("--paths", words)->delimiter(',')->capture_default_str(); });
    EXPECT_TRUE(o.several && o.commas);
    EXPECT_EQ(o.initial, "still,orbit");
    const auto a = option(
        [&](CLI::App& app) { app.add_option("FILES", words, "packages")->type_name("PACKAGE")->required(); });
    EXPECT_EQ(a.names, Words{"FILES"});
    EXPECT_EQ(a.type, "PACKAGE");
    EXPECT_TRUE(a.several && a.required && !a.commas);
}

TEST(Describe, VerbsAreDescribedWithTheirOptionsAndHiddenOnesAreNot) {
    CLI::App app{"a program"};
    bool hidden = false;
    app.add_flag("--secret", hidden)->group("");
    app.add_subcommand("check", "Check it")->footer("Example:\n  program check");
    const DescribedCommand c = described(app, "program");
    EXPECT_EQ(c.name + ": " + c.description, "program: a program");
    ASSERT_EQ(c.options.size(), 1u);
    EXPECT_EQ(c.options[0].names, (Words{"-h", "--help"}));
    ASSERT_EQ(c.verbs.size(), 1u);
    EXPECT_EQ(c.verbs[0].name + ": " + c.verbs[0].description, "check: Check it");
    EXPECT_EQ(c.verbs[0].notes, "Example:\n  program check");
}

TEST(Describe, OtherCommandLinesAreLeftAlone) {
    const CLI::App app;
    std::string words[] = {"program", "--describe", "more"};
    char* all[] = {words[0].data(), words[1].data(), words[2].data()};
    EXPECT_FALSE(describe_if_asked(app, 3, all));
    EXPECT_FALSE(describe_if_asked(app, 1, all));
}

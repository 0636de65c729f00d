// Command lines: accepted and rejected arguments, error messages, manual pages and shell completion.
#include "base/cli/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "base/text/error.h"

using namespace vantage;

namespace {

enum class Blend { average, best };

using Words = std::vector<std::string>;

struct Answer {
    int code;
    std::string out, error;
};

Answer run(const Command& command, const Words& arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    int code = 0;
    try {
        code = command.run(arguments);
    } catch (const Error& e) {
        code = int(e.code());
        std::fputs(e.what(), stderr);
    }
    const std::string out = testing::internal::GetCapturedStdout();
    return {code, out, testing::internal::GetCapturedStderr()};
}

/// The first line of the error message for rejected arguments.
std::string refusal(const Command& command, const Words& arguments) {
    const Answer a = run(command, arguments);
    EXPECT_EQ(a.code, int(Exit::usage));
    return a.error.substr(0, a.error.find('\n'));
}

/// The only option or argument besides --help.
template <class Add>
DescribedOption option(const Add& add) {
    const Command c("program", "");
    add(c);
    const DescribedCommand d = c.described();
    EXPECT_EQ(d.options.size() + d.arguments.size(), 2u);
    return d.arguments.empty() ? d.options.back() : d.arguments.front();
}

struct Picture {
    Command command{"program", "Makes a picture"};
    int samples = 2;
    unsigned threads = 0;
    std::uint64_t memory = 0;
    double scale = 1;
    bool quiet = false, trilinear = true;
    Blend blend = Blend::average;
    std::optional<Blend> other;
    std::string tiles = "raw", file;
    Words photos, modes{"stream"};
    std::vector<double> range;

    Picture() {
        command.file("FILE", file, "package").type("PACKAGE").required();
        command.flag("-q,--quiet", quiet, "print only errors");
        command.flag("--bilinear", trilinear, "sample one level", false);
        command.integer("--samples", samples, 1, 8, "samples per side").group("Quality");
        command.integer("--threads", threads, 0, 1 << 30, "threads");
        command.real("--scale", scale, 0.5, 8, "relative size");
        command.bytes("--memory", memory, "limit");
        const NamedValues<Blend> blends{{"average", Blend::average}, {"best-photo", Blend::best}};
        command.choice("--blend", blend, blends, "how");
        command.choice("--other", other, {{"average", Blend::average}, {"best-photo", Blend::best}}, "how");
        command.choice("--tiles", tiles, {"raw", "jpeg"}, "form of tiles");
        command.choices("--modes", modes, {"stream", "whole"}, "what to measure").commas();
        command.list("--photo", photos, "photos to use").type("PHOTO").commas();
        command.pair("--range", range, "LOW,HIGH");
    }
};

}  // namespace

TEST(CommandLine, SetsWhatIsGiven) {
    Picture p;
    EXPECT_EQ(
        run(p.command, {"a.vantage",       "-q",      "--bilinear", "--samples",   "3",       "--threads=4",
                        "--scale",         "0.5",     "--memory",   "2k",          "--blend", "best-photo",
                        "--other=average", "--tiles", "jpeg",       "--photo",     "1,2",     "3",
                        "--range",         "-1,2.5",  "--modes",    "whole,stream"})
            .error,
        "");
    EXPECT_EQ(p.file, "a.vantage");
    EXPECT_TRUE(p.quiet && !p.trilinear);
    EXPECT_EQ(p.samples, 3);
    EXPECT_EQ(p.threads, 4u);
    EXPECT_EQ(p.scale, 0.5);
    EXPECT_EQ(p.memory, 2048u);
    EXPECT_TRUE(p.blend == Blend::best && p.other == Blend::average);
    EXPECT_EQ(p.tiles, "jpeg");
    EXPECT_EQ(p.photos, (Words{"1", "2", "3"}));
    EXPECT_EQ(p.modes, (Words{"whole", "stream"}));
    EXPECT_EQ(p.range, (std::vector{-1, 2.5}));
    EXPECT_TRUE(p.command.given("Quality"));
}

TEST(CommandLine, SaysInWordsWhatWasExpected) {
    const auto refused = [](const std::string& name, const std::string& value) {
        return refusal(Picture().command, {"a.vantage", name, value});
    };
    EXPECT_EQ(refused("--blend", "beste"), "--blend: 'beste' is none of average, best-photo");
    EXPECT_EQ(refused("--tiles", ""), "--tiles: '' is none of raw, jpeg");
    EXPECT_EQ(refused("--modes", "stream,all"), "--modes: 'all' is none of stream, whole");
    for (const char* samples : {"0", "9", "many", "2.5", "3 ", "nan"})
        EXPECT_EQ(refused("--samples", samples),
                  std::string("--samples: expected an integer from 1 to 8, not '") + samples + "'");
    EXPECT_EQ(refused("--threads", "-1"), "--threads: expected an integer from 0 up, not '-1'");
    for (const char* scale : {"0.49", "nan", "inf", "1x", ""})
        EXPECT_EQ(refused("--scale", scale),
                  std::string("--scale: expected a number from 0.5 to 8, not '") + scale + "'");
    for (const char* size : {"-5", "0", "9999999T", "much"})
        EXPECT_EQ(refused("--memory", size),
                  std::string("--memory: expected a size such as 800M, not '") + size + "'");
    EXPECT_EQ(refused("--range", "1,nan"), "--range: expected two numbers, not 'nan'");
    EXPECT_NE(refused("--range", "1"), "");
}

TEST(CommandLine, RefusesWhatIsMissingUnknownOrExcluded) {
    EXPECT_EQ(refusal(Picture().command, {}), "FILE is required");
    EXPECT_NE(refusal(Picture().command, {"a.vantage", "--blend"}), "");
    EXPECT_NE(refusal(Picture().command, {"a.vantage", "b.vantage"}), "");
    EXPECT_NE(refusal(Picture().command, {"a.vantage", "--verbose"}), "");
    const Command c("program", "");
    bool a = false, b = false;
    std::string text;
    const Option first = c.flag("--first", a, "");
    c.flag("--second", b, "").excludes(first);
    c.text("--third", text, "").needs(first);
    EXPECT_NE(refusal(c, {"--first", "--second"}), "");
    EXPECT_NE(refusal(c, {"--third", "x"}), "");
    EXPECT_EQ(run(c, {"--first", "--third", "x"}).code, 0);
    EXPECT_EQ(text, "x");
}

TEST(CommandLine, ArgumentsMayFollowAListOfOneWord) {
    const Command c("program", "");
    Words names;
    std::string input;
    c.text("INPUT", input, "");
    c.list("--names", names, "").commas().one_word();
    EXPECT_EQ(run(c, {"--names", "a,b", "input", "--names", "c"}).code, 0);
    EXPECT_EQ(names, (Words{"a", "b", "c"}));
    EXPECT_EQ(input, "input");
}

TEST(CommandLine, VerbsAreSelectedByTheFirstArgument) {
    const Command c("program", "Does things");
    std::string text;
    const Command check = c.verb("check", "Check it");
    check.text("WHAT", text, "");
    check.notes("Example:\n  program check");
    check.action([] { return 7; });
    EXPECT_EQ(run(c, {"check", "it"}).code, 7);
    EXPECT_EQ(text, "it");
    EXPECT_NE(run(c, {"--help"}).out.find("Check it"), std::string::npos);
    EXPECT_NE(run(c, {"check", "--help"}).out.find("Usage: program check [OPTIONS] [WHAT]"),
              std::string::npos);
    for (const Words& wrong : {Words{"chekc"}, Words{}}) EXPECT_NE(refusal(c, wrong), "");
    EXPECT_NE(run(c, {"--help"}).out.find("Usage: program [OPTIONS] VERB"), std::string::npos);
    EXPECT_NE(refusal(c, {"--verbose"}), "");
    std::string file;
    c.text("FILE", file, "");
    c.action([] { return 8; });
    EXPECT_EQ(run(c, {"chapel"}).code, 8);
    EXPECT_EQ(file, "chapel");
    EXPECT_THROW(c.run({"chekc"}), Error) << "not treated as a file";
    EXPECT_EQ(run(c, {"help", "check"}).out, run(c, {"check", "--help"}).out);
}

TEST(CommandLine, ActionsMayAskWhatWasGiven) {
    const Command c("program", "");
    bool on = false, quiet = false;
    c.flag("--on", on, "").group("Blending");
    c.flag("--quiet", quiet, "");
    c.action([](const Command& command) { return command.given("Blending") ? 1 : 2; });
    EXPECT_EQ(run(c, {"--quiet", "--on"}).code, 1);
    EXPECT_EQ(run(c, {"--quiet"}).code, 2);
}

TEST(CommandLine, SettingsOfFilesYieldToTheCommandLine) {
    Picture p;
    EXPECT_EQ(run(p.command, {"a", "--samples", "3"}).code, 0);
    p.command.give("samples", {"4"}, "a.toml");
    p.command.give("scale", {"2"}, "a.toml");
    p.command.give("photo", {"b", "c"}, "a.toml");
    p.command.give("quiet", {"true"}, "a.toml");
    EXPECT_EQ(p.samples, 3);
    EXPECT_EQ(p.scale, 2);
    EXPECT_EQ(p.photos, (Words{"b", "c"}));
    EXPECT_TRUE(p.quiet);
    for (const char* name : {"blend", "bilinear", "nothing"})
        EXPECT_THROW(p.command.give(name, {"perhaps"}, "a.toml"), Error) << name;
}

TEST(CommandLine, DescribesFlagsAndNumbers) {
    bool on = false;
    const auto flag = option([&](const Command& c) { c.flag("-q,--quiet", on, "print only errors"); });
    EXPECT_EQ(flag.names, (Words{"-q", "--quiet"}));
    EXPECT_EQ(flag.type + flag.description, "print only errors");
    int count = 256;
    const auto integer =
        option([&](const Command& c) { c.integer("--size", count, 1, 4096, "").group("Pictures"); });
    EXPECT_EQ(integer.type, "NUMBER");
    EXPECT_EQ(integer.least + " " + integer.most + " " + integer.initial, "1 4096 256");
    EXPECT_EQ(integer.group, "Pictures");
    double share = 0;
    const auto real = option([&](const Command& c) { c.real("--max-diff-fraction", share, 0.5, 1.5, ""); });
    EXPECT_EQ(real.type + " " + real.least + " " + real.most, "NUMBER 0.5 1.5");
    EXPECT_EQ(real.initial, "");  // out of range: no default
}

TEST(CommandLine, DescribesValuesToChooseFrom) {
    Blend blend{};
    const auto o = option([&](const Command& c) {
        c.choice("--blend", blend, {{"average", Blend::average}, {"best-photo", Blend::best}}, "");
    });
    EXPECT_EQ(o.values, (Words{"average", "best-photo"}));
    EXPECT_EQ(o.type + " " + o.initial, "TEXT average");
    std::string text;
    const auto open = option([&](const Command& c) {
        c.file("--image-sets", text, "").suggests({"auto", "off"});
    });
    EXPECT_EQ(open.values, (Words{"auto", "off"}));
    EXPECT_EQ(open.type, "FILE");
}

TEST(CommandLine, DescribesListsArgumentsAndVerbs) {
    Words words{"still", "orbit"};
    const auto o = option([&](const Command& c) { c.list("--paths", words, "").commas(); });
    EXPECT_TRUE(o.several && o.commas);
    EXPECT_EQ(o.initial, "still,orbit");
    words.clear();
    const auto a = option([&](const Command& c) { c.list("FILES", words, "").type("PACKAGE").required(); });
    EXPECT_EQ(a.names, Words{"FILES"});
    EXPECT_EQ(a.type, "PACKAGE");
    EXPECT_TRUE(a.several && a.required && !a.commas);

    const Command c("program", "a program");
    c.verb("check", "Check it").notes("Example:\n  program check");
    c.version("program 1.0");
    const std::string line = run(c, {"--describe"}).out;
    EXPECT_EQ(std::ranges::count(line, '\n'), 1);
    const DescribedCommand d = from_line(line);
    EXPECT_EQ(d.name + ": " + d.description, "program: a program");
    ASSERT_EQ(d.options.size(), 2u);
    EXPECT_EQ(d.options[0].names, (Words{"-h", "--help"}));
    ASSERT_EQ(d.verbs.size(), 1u);
    EXPECT_EQ(d.verbs[0].name + ": " + d.verbs[0].description, "check: Check it");
    EXPECT_EQ(d.verbs[0].notes, "Example:\n  program check");
    EXPECT_EQ(run(c, {"--version"}).out, "program 1.0\n");
}

TEST(CommandLine, AMistypedOptionOrVerbGetsASuggestion) {
    const Command c("program", "");
    bool quiet = false;
    c.flag("-q,--quiet", quiet, "");
    c.verb("check", "");
    EXPECT_EQ(refusal(c, {"--quite"}), "no option --quite; did you mean --quiet?");
    EXPECT_EQ(refusal(c, {"--sparkle"}), "no option --sparkle");
    EXPECT_EQ(refusal(c, {"chekc"}), "no verb 'chekc'; did you mean check?");
    for (const char* no_verb : {"sparkle", "scans/chapel", "chapel.vantage", "chapel-1", "/"})
        EXPECT_EQ(refusal(c, {no_verb}), "no verb '" + std::string(no_verb) + "': expected one of check");
}

TEST(CommandLine, HelpOfManyOptionsListsTheCommonOnes) {
    const Command c("program", "Shows " + std::string(100, 'x'));
    bool quiet = false, rare = false;
    c.flag("-q,--quiet", quiet, "print errors only; not even results " + std::string(60, 'y'));
    c.flag("--rare", rare, "for " + std::string(30, 'z') + " and " + std::string(30, 'z'));
    c.common({"--quiet"});
    c.notes(
        "Examples:\n  program 1\n  program 2\n  program 3\n  program 4\n  program 5\n  program 6\n  program "
        "7");
    const std::string few = run(c, {"--help"}).out, all = run(c, {"--help-all"}).out;
    for (const char* both : {"-q,--quiet", "print errors only", "program 6"}) {
        EXPECT_NE(few.find(both), std::string::npos) << both;
        EXPECT_NE(all.find(both), std::string::npos) << both;
    }
    for (const char* of_all : {"--rare", "not even results", "program 7"}) {
        EXPECT_EQ(few.find(of_all), std::string::npos) << of_all;
        EXPECT_NE(all.find(of_all), std::string::npos) << of_all;
    }
}

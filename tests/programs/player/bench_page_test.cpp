#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

#include "base/text/error.h"
#include "pipeline/reports/page/base64.h"
#include "tests/bench/page/page.h"
#include "tests/bench/plots/gnuplot.h"
#include "tests/bench/results/front.h"
#include "tests/bench/results/moved.h"
#include "tests/bench/results/quantity.h"
#include "tests/bench/results/tables.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using namespace vantage::bench;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Measurement row(std::string setting, std::map<std::string, double> values) {
    return {"border", "hall", "weight maps at 1/2", std::move(setting), false, false, std::move(values), {}};
}

/// Rows with coarsely rounded values, many of which are equal; some values are missing or not finite.
std::vector<Measurement> random_rows(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> value(0, 12), odd(0, 9);
    std::vector<Measurement> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(row(std::to_string(i), {{"photo_ms", value(random)}, {"psnr", value(random)}}));
        const int kind = odd(random);
        if (kind == 0) out.back().values.erase("psnr");
        if (kind == 1) out.back().values.erase("photo_ms");
        if (kind == 2) out.back().values["psnr"] = nan_value;
        if (kind == 3) out.back().values["photo_ms"] = std::numeric_limits<double>::infinity();
    }
    return out;
}

bool complete(const Measurement& m) {
    return m.values.contains("photo_ms") && m.values.contains("psnr") &&
           std::isfinite(m.values.at("photo_ms")) && std::isfinite(m.values.at("psnr"));
}

bool beats(const Measurement& a, const Measurement& b) {
    const double ta = a.values.at("photo_ms"), tb = b.values.at("photo_ms");
    const double qa = a.values.at("psnr"), qb = b.values.at("psnr");
    return ta <= tb && qa >= qb && (ta < tb || qa > qb);
}

TEST(Front, MatchesComparingAllPairs) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::vector<Measurement> rows = random_rows(seed, int(seed % 60));
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            bool beaten = !complete(rows[i]);
            for (const Measurement& other : rows)
                beaten = beaten || (complete(other) && beats(other, rows[i]));
            if (!beaten) expected.push_back(i);
        }
        std::vector<std::size_t> found = front(rows, "photo_ms", "psnr");
        EXPECT_TRUE(
            std::ranges::is_sorted(found, {}, [&](std::size_t i) { return rows[i].values.at("photo_ms"); }));
        std::ranges::sort(found);
        EXPECT_EQ(found, expected) << "seed " << seed;
    }
}

TEST(Front, BeatenByIsTheGapToTheBestAtNoHigherCost) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const std::vector<Measurement> rows = random_rows(seed, 40);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double by = beaten_by(rows, i, "photo_ms", "psnr");
            EXPECT_EQ(std::isnan(by), !complete(rows[i]));
            if (!complete(rows[i])) continue;
            double best = rows[i].values.at("psnr");
            for (const Measurement& other : rows)
                if (complete(other) && other.values.at("photo_ms") <= rows[i].values.at("photo_ms"))
                    best = std::max(best, other.values.at("psnr"));
            EXPECT_EQ(by, best - rows[i].values.at("psnr"));
        }
        for (const std::size_t i : front(rows, "photo_ms", "psnr"))
            EXPECT_EQ(beaten_by(rows, i, "photo_ms", "psnr"), 0);
    }
}

TEST(Front, UnknownMetricThrows) { EXPECT_THROW(front({}, "photo_ms", "beauty"), std::out_of_range); }

TEST(Base64, EncodesAsTheStandardSays) {
    const char* vectors[][2] = {{"", ""},
                                {"f", "Zg=="},
                                {"fo", "Zm8="},
                                {"foo", "Zm9v"},
                                {"foob", "Zm9vYg=="},
                                {"fooba", "Zm9vYmE="},
                                {"foobar", "Zm9vYmFy"},
                                {"\xff\xfe\xfd", "//79"}};
    for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64(std::string(3, '\0')), "AAAA");
}

class BenchTables : public TemporaryFolder {};

TEST_F(BenchTables, JsonRoundTrips) {
    bench::Run run{"0.1.0", "short", {"one line", "\"another\""}, {row("jfa^2", {{"psnr", 1.0 / 3}})}};
    run.measurements[0].chosen = true;
    run.measurements[0].values["photo_ms"] = nan_value;
    run.measurements[0].exhibits = {{"a caption", "exhibits/a.jpg"}};
    write_json(dir / "run.json", run);
    const bench::Run back = read_json(dir / "run.json");
    EXPECT_EQ(back.version, run.version);
    EXPECT_EQ(back.effort, run.effort);
    EXPECT_EQ(back.machine, run.machine);
    ASSERT_EQ(back.measurements.size(), 1U);
    EXPECT_EQ(back.measurements[0].setting, "jfa^2");
    EXPECT_TRUE(back.measurements[0].chosen);
    EXPECT_EQ(back.measurements[0].values, (std::map<std::string, double>{{"psnr", 1.0 / 3}}));
    EXPECT_EQ(back.measurements[0].exhibits[0].file, "exhibits/a.jpg");
}

TEST_F(BenchTables, InvalidJsonIsReportedWithItsFile) {
    const auto complaint = [&](const char* text) -> std::string {
        std::ofstream(dir / "odd.json") << text;
        try {
            read_json(dir / "odd.json");
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            return e.what();
        }
        return "";
    };
    for (const char* text :
         {"", "[]", "{\"format\": \"another\"}", "{\"format\": \"vantage-bench 1\"}", "\xff"})
        EXPECT_NE(complaint(text).find("odd.json"), std::string::npos) << text;
    EXPECT_THROW(read_json(dir / "none.json"), Error);
}

TEST_F(BenchTables, CsvHasOneLinePerValue) {
    write_csv(dir / "run.csv", std::vector{row("a, \"b\"", {{"psnr", 34.5}, {"photo_ms", nan_value}})});
    EXPECT_EQ(slurp(dir / "run.csv"),
              "sweep,scene,curve,setting,exact,chosen,metric,unit,value\r\n"
              "border,hall,weight maps at 1/2,\"a, \"\"b\"\"\",0,0,photo_ms,ms,\r\n"
              "border,hall,weight maps at 1/2,\"a, \"\"b\"\"\",0,0,psnr,dB,34.5\r\n");
}

TEST(Quantity, IsPrintedWithASuitableUnit) {
    EXPECT_EQ(quantity(12'340'000, "B"), "12.34 MB");
    EXPECT_EQ(quantity(0.0005, "s"), "500.0 µs");
    EXPECT_EQ(quantity(34.5, "dB"), "34.50 dB");
    EXPECT_EQ(quantity(-0.25, ""), "−0.2500");
    EXPECT_EQ(quantity(0, "ms"), "0 ms");
    EXPECT_EQ(number(9.99996), "10.00");
    EXPECT_EQ(number(2.5e-7, 2), "2.5·10⁻⁷");
    EXPECT_EQ(quantity(nan_value, "dB"), "–");
    EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "–");
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
    return n;
}

PlotSpec plot_of(std::vector<PlotPoint> points) {
    return {"a plot",
            {"preparing", "ms", true, true},
            {"error", "of 255", true, true},
            {PlotCurve{"weight maps", std::move(points)}}};
}

/// Expects a complete and valid SVG.
void expect_valid(const std::string& svg) {
    EXPECT_EQ(svg.find("<svg "), 0U);
    EXPECT_EQ(count(svg, "<svg"), 1U);
    EXPECT_EQ(count(svg, "</svg>"), 1U);
    EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
    EXPECT_EQ(svg.find("<?xml"), std::string::npos);
    for (const char* odd : {"nan", "NaN", "inf,", "-inf"}) EXPECT_EQ(svg.find(odd), std::string::npos) << odd;
}

TEST(Plot, ZerosOnALogAxisAreDrawnAtALabeledFloor) {
    const std::string svg = svg_plot(plot_of({{1, 0, "none"}, {10, 0.5, "some"}, {100, 5, "much"}}));
    expect_valid(svg);
    EXPECT_NE(svg.find("0 at the edge"), std::string::npos);
    for (const char* label : {"none", "some", "much"}) EXPECT_NE(svg.find(label), std::string::npos);
    EXPECT_EQ(svg_plot(plot_of({{1, 1, "a"}, {2, 3, "b"}})).find("0 at the edge"), std::string::npos);
    expect_valid(svg_plot(plot_of({{0, 0, "all"}, {0, 0, "zero"}})));
    expect_valid(svg_plot(plot_of({{1, -3, "negative"}, {2, 3, "b"}})));
}

TEST(Plot, OnePointOrNoneMakesAPlot) {
    expect_valid(svg_plot(plot_of({{5, 5, "alone", true, true}})));
    expect_valid(svg_plot(plot_of({{1e-300, 1e300, "far"}, {1e300, 1e-300, "apart"}})));
    expect_valid(svg_plot(plot_of({{5, nan_value, "not drawn"}})));
    const std::string none = svg_plot(plot_of({}));
    expect_valid(none);
    EXPECT_NE(none.find("no data"), std::string::npos);
    expect_valid(svg_plot({}));
}

TEST(Plot, NamesAreEscaped) {
    const auto trap = std::filesystem::temp_directory_path() / ("bench-trap-" + std::to_string(::getpid()));
    const std::string name = "it's `touch " + trap.string() + "` $(touch " + trap.string() + ")";
    PlotSpec plot = plot_of({{1, 1, "jfa^2_x"}, {9, 4, "<b>&\\n\"q\""}});
    plot.title = name;
    const std::string svg = svg_plot(plot);
    expect_valid(svg);
    EXPECT_NE(svg.find("jfa^2_x"), std::string::npos);
    EXPECT_NE(svg.find("<text>" + name), std::string::npos);
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(trap));
}

TEST(Plot, TwoPlotsShareNoIds) {
    const auto ids = [](const std::string& svg) {
        std::set<std::string> out;
        for (std::size_t at = 0; (at = svg.find(" id=", at)) != std::string::npos; at += 5)
            out.insert(svg.substr(at + 5, svg.find(svg[at + 4], at + 5) - at - 5));
        return out;
    };
    const std::set<std::string> a = ids(svg_plot(plot_of({{1, 1, "a"}}))),
                                b = ids(svg_plot(plot_of({{1, 2, "a"}})));
    EXPECT_FALSE(a.empty());
    for (const std::string& id : a) EXPECT_FALSE(b.contains(id)) << id;
}

/// The error message of svg_plot() if PATH is set to `folder`.
std::string complaint_with_path(const std::filesystem::path& folder) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", folder.c_str(), 1);
    std::string message;
    try {
        svg_plot({});
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::input);
        message = e.what();
    }
    ::setenv("PATH", path.c_str(), 1);
    return message;
}

TEST_F(BenchTables, MissingOrFailingGnuplotIsReportedInOneLine) {
    EXPECT_NE(complaint_with_path(dir).find("gnuplot-nox"), std::string::npos);
    std::ofstream(dir / "gnuplot")
        << "#!/bin/sh\nprintf '\\nplot x\\n     ^\\n\"plot.gp\", line 3: no x\\n' >&2\nexit 1\n";
    std::filesystem::permissions(dir / "gnuplot", std::filesystem::perms::owner_all);
    EXPECT_EQ(complaint_with_path(dir), "gnuplot failed: \"plot.gp\", line 3: no x");
}

/// Ten settings, all of whose times are multiplied by `drift`.
std::vector<Measurement> drifting_rows(double drift) {
    std::vector<Measurement> out;
    for (int i = 1; i <= 10; ++i)
        out.push_back(row("setting " + std::to_string(i), {{"photo_ms", i * drift}, {"psnr", 30.0 + i}}));
    return out;
}

TEST(Moved, UniformDriftIsNotAMove) {
    const Comparison same = compare(drifting_rows(2), drifting_rows(1));
    EXPECT_DOUBLE_EQ(same.drift, 2);
    EXPECT_EQ(same.compared, 20U);
    EXPECT_TRUE(same.moved.empty());
}

TEST(Moved, AreSortedFromWorstToBest) {
    std::vector<Measurement> now = drifting_rows(2);
    now[3].values["photo_ms"] *= 1.5;
    now[4].values["psnr"] -= 3;
    now[5].values["photo_ms"] *= 0.5;
    now[6].values["psnr"] = nan_value;
    now[7].setting = "another";
    const std::vector<Measurement> before = drifting_rows(1);
    const Comparison c = compare(now, before);
    ASSERT_EQ(c.moved.size(), 4U);
    EXPECT_EQ(c.moved[0].row, &now[6]);
    EXPECT_FALSE(c.moved[0].now);
    EXPECT_EQ(c.moved[1].row, &now[4]);
    EXPECT_EQ(c.moved[2].row, &now[3]);
    EXPECT_DOUBLE_EQ(c.moved[2].before, 8);
    EXPECT_EQ(c.moved[3].row, &now[5]);
    EXPECT_LT(c.moved[3].by, 0);
    EXPECT_EQ(c.appeared, std::vector{full_name(now[7])});
    EXPECT_EQ(c.vanished, std::vector{full_name(before[7])});
}

std::vector<Job> no_jobs(const BenchScene&, const Effort&, const std::filesystem::path&) { return {}; }
const Sweep two_sweeps[] = {
    {"border", "Borders <near>", "Which?", "the truth", "0", {{"photo_ms", "psnr"}}, no_jobs},
    {"tiles", "Tiles", "Which?", "the truth", "0", {}, no_jobs}};

class BenchPage : public TemporaryFolder {
  protected:
    PageInput input{"A <page>", two_sweeps, {"0.1.0", "short", {"a & b"}, drifting_rows(1)}, std::nullopt};

    std::string page() {
        write_page(dir, input);
        return slurp(dir / "index.html");
    }
};

TEST_F(BenchPage, IsSelfContained) {
    std::ofstream(dir / "shot.jpg") << "not really a JPEG";
    input.now.measurements[0].exhibits = {{"a <shot>", "shot.jpg"}, {"another", "gone.jpg"}};
    const std::string html = page();
    for (const char* attribute : {"src=", "href=", "url("})
        for (std::size_t at = 0; (at = html.find(attribute, at)) != std::string::npos;) {
            at += std::string_view(attribute).size();
            const std::size_t value = html[at] == '"' || html[at] == '\'' ? at + 1 : at;
            EXPECT_TRUE(html[value] == '#' || html.compare(value, 5, "data:") == 0) << html.substr(at, 60);
        }
    EXPECT_NE(html.find("data:image/jpeg;base64," + base64("not really a JPEG")), std::string::npos);
    EXPECT_NE(html.find("missing picture"), std::string::npos);
    EXPECT_EQ(html.find("@import"), std::string::npos);
    EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST_F(BenchPage, EscapesWhatItPrints) {
    input.now.measurements[0].setting = "<script>alert('1')</script>";
    const std::string html = page();
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<near>"), std::string::npos);
    EXPECT_NE(html.find("&#60;near&#62;"), std::string::npos);
    EXPECT_NE(html.find("a &#38; b"), std::string::npos);
}

TEST_F(BenchPage, ListsOnlyWhatMoved) {
    input.before = bench::Run{"0.0.9", "short", {}, drifting_rows(1.3)};
    EXPECT_NE(page().find("Nothing moved"), std::string::npos);
    input.before->measurements[2].values["psnr"] += 2;
    const std::string html = page();
    const std::string section =
        html.substr(html.find("<section id=moved>"),
                    html.find("<section id=defaults>") - html.find("<section id=moved>"));
    EXPECT_EQ(section.find("Nothing moved"), std::string::npos);
    EXPECT_NE(section.find("<tr class=\"worse\"><td>border<td>hall<td>weight maps at 1/2<td>setting "
                           "3<td>PSNR<td>35.00 dB<td>33.00 dB"),
              std::string::npos)
        << section;
    EXPECT_EQ(section.find("setting 4"), std::string::npos);
}

TEST_F(BenchPage, NonFiniteValuesAreDashes) {
    input.now.measurements[1].values["psnr"] = nan_value;
    input.now.measurements[2].values["photo_ms"] = std::numeric_limits<double>::infinity();
    const std::string html = page();
    for (const char* odd : {">nan", ">inf", "NaN", "-nan"})
        EXPECT_EQ(html.find(odd), std::string::npos) << odd;
    EXPECT_NE(html.find("<td>–"), std::string::npos);
    EXPECT_NE(
        html.find(
            "Not drawn (no finite value): weight maps at 1/2, setting 2; weight maps at 1/2, setting 3"),
        std::string::npos);
}

TEST_F(BenchPage, EmptyRunMakesAPage) {
    input.now.measurements.clear();
    EXPECT_NE(page().find("Not measured in this run: border, tiles"), std::string::npos);
    EXPECT_THROW(write_page(dir / "none", input), Error);
}

}  // namespace

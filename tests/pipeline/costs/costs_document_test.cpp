// The shipped measurements, and the documents made from them. VANTAGE_WRITE_DOCS=1 writes the documents.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "pipeline/costs/cost_chart.h"
#include "pipeline/costs/cost_table.h"
#include "pipeline/costs/cost_trials.h"
#include "pipeline/costs/costs_page.h"
#include "pipeline/costs/known_costs.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

const fs::path source = VANTAGE_SOURCE_DIR;

std::string text_of(const fs::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

void expect_file(const fs::path& file, const std::string& text) {
    if (std::getenv("VANTAGE_WRITE_DOCS"))
        std::ofstream(file) << text;
    else
        EXPECT_TRUE(text_of(file) == text)
            << file << ": run the same test with VANTAGE_WRITE_DOCS=1 to write it";
}

Costs shipped() { return read_costs(source / "configs/costs.json"); }

constexpr const char* heading = R"(# Accuracy and cost

This page shows how each setting of both programs affects quality, time and space. `vantage costs SCAN` measures the same on your
own scan and machine, in three minutes or, with `--full`, as long as it takes; `prepare --explain` and `info` then show the results.
Half resolution of masks (weight maps), which is not a setting, is not visible on photos ([figures](#approximations-that-are-not-settings)).
The page is made from `configs/costs.json`, which these commands wrote:

    for scan in sceaux fountain-P11 head demo-scene; do vantage costs $scan --minutes 60 -o costs-$scan; done
    vantage costs costs-*/costs.json
)";

std::string bullets(const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& line : lines) out += "- " + line + ".\n";
    return out;
}

std::string joined_lines(const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& line : lines) out += line + "\n";
    return out;
}

std::string file_of(CostAxis axis) {
    std::string out = title_of(axis);
    out[0] = char(out[0] + 'a' - 'A');
    return out + ".svg";
}

std::string markdown_of(const PagePart& part) {
    switch (part.kind) {
        case PagePart::heading:
            return "## " + part.lines[0] + "\n";
        case PagePart::paragraph:
            return part.lines[0] + "\n";
        case PagePart::list:
            return bullets(part.lines);
        case PagePart::table:
            return as_markdown(part.rows);
        case PagePart::chart:
            return fmt::format("![Quality against cost](../data/cost/{})\n", file_of(part.axis));
        case PagePart::code:
            return "```\n" + joined_lines(part.lines) + "```\n";
    }
    return {};
}

std::string costs_document(const Costs& costs) {
    std::string out = heading;
    for (const PagePart& part : page_parts(costs)) out += "\n" + markdown_of(part);
    return out;
}

/// The decimal numbers in a text: "23.6", ".88".
std::vector<std::string> numbers_in(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t end = i;
        bool point = false;
        while (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) ||
                                     (text[end] == '.' && end + 1 < text.size() &&
                                      std::isdigit(static_cast<unsigned char>(text[end + 1])))))
            point |= text[end++] == '.';
        if (end > i && point) out.push_back(text.substr(i, end - i));
        i = std::max(i, end);
    }
    return out;
}

constexpr const char* of_weight_maps = R"(
## Approximations that are not settings

Weight maps (masks) have half the width and height of the photo. On photos, this is not visible. On the synthetic scene, some
pixels differ at the edges of small openings. Full size instead, on three held-out photos of each scan (`data/cost/weight_maps.json`):

)";

constexpr const char* of_border_weights = R"(
Errors of the border weight, whose range is 0 to 255, on Sceaux, by resolution and method for distances to depth borders
(`build/tests/bench/vantage-bench sceaux --set full --only border`):

)";

/// The effect of weight maps of full instead of half size on held-out photos, and on packages.
std::string effect_of_half_weight_maps() {
    const nlohmann::json measured = nlohmann::json::parse(text_of(source / "data/cost/weight_maps.json"));
    std::string out;
    for (const nlohmann::json& s : measured["scans"]) {
        const MeanWithError gain = *estimate(s["psnr_gain"].get<std::vector<double>>());
        out += fmt::format("- {}: quality {:+.2f} ± {:.2f} dB, package {:+.0f} %\n",
                           s["name"].get<std::string>(), gain.mean, gain.error,
                           100 * (s["full_bytes"].get<double>() / s["half_bytes"].get<double>() - 1));
    }
    return out;
}

/// The resolution of weight maps, and the method for border distances as measured by
/// 'vantage-bench sceaux --set full --only border'.
std::string approximations() {
    const nlohmann::json run = nlohmann::json::parse(text_of(source / "data/cost/approximations.json"));
    TextTable table{{"border weights", "mean error", "worst 0.1 %", "size per photo", "time per photo"}, {}};
    for (const nlohmann::json& m : run["measurements"]) {
        if (m["setting"] == "chamfer") continue;
        const nlohmann::json& v = m["values"];
        table.rows.push_back({m["curve"].get<std::string>() + ", " + m["setting"].get<std::string>() +
                                  (m["chosen"].get<bool>() ? " (**the default**)" : ""),
                              fmt::format("{:.2f} of 255", v["weight_mean"].get<double>()),
                              fmt::format("{:.0f} of 255", v["weight_worst"].get<double>()),
                              fmt::format("{:.1f} MB", v["photo_bytes"].get<double>() / 1e6),
                              fmt::format("{:.0f} ms", v["photo_ms"].get<double>())});
    }
    return std::string(of_weight_maps) + effect_of_half_weight_maps() + of_border_weights +
           as_markdown(table);
}

TEST(CostsDocument, IsMadeFromTheShippedMeasurements) {
    const Costs costs = shipped();
    const std::string page = costs_document(costs) + approximations();
    expect_file(source / "docs/accuracy-and-cost.md", page);
    EXPECT_LE(std::ranges::count(page, '\n'), 150);
    for (const CostAxis axis : {CostAxis::preparing, CostAxis::storing, CostAxis::drawing})
        expect_file(source / "data/cost" / file_of(axis), cost_chart(costs.scans, axis));
}

TEST(CostsDocument, MeasurementsAreOfThisVersion) {
    EXPECT_EQ(shipped().version, VANTAGE_VERSION)
        << "to update configs/costs.json, run 'vantage costs' on the scans of docs/accuracy-and-cost.md";
}

class ShippedCosts : public TemporaryFolder {};

TEST_F(ShippedCosts, HaveEverySettingThatIsTriedToday) {
    std::set<std::string> measured;
    for (const ScanCosts& s : shipped().scans)
        for (const TrialCosts& c : s.trials) measured.insert(c.trial.setting);
    copy_scene(tiny_spec(), dir / "scene");
    copy_package(dir / "scene", {}, dir / "scene.vantage");
    for (const CostTrial& t : cost_trials(PackageReader(dir / "scene.vantage"), true))
        EXPECT_TRUE(measured.contains(t.setting)) << t.setting;
}

TEST(CostsDocument, FiguresOfTheReadmeAreMeasured) {
    const std::string readme = text_of(source / "README.md"),
                      measurements = text_of(source / "docs/measurements.md");
    const std::size_t begin = readme.find("## Quality and speed"), end = readme.find("## How it works");
    ASSERT_LT(begin, end);
    const Costs costs = shipped();
    std::vector<double> known;
    for (const ScanCosts& s : costs.scans)
        known.insert(known.end(),
                     {s.whole_seconds.value_or(0), s.whole_bytes.value_or(0) / 1e6,
                      s.whole_bytes.value_or(0) / s.photo_bytes, estimate(s.trials.front().psnr)->mean});
    for (const std::string& number : numbers_in(measurements)) known.push_back(std::stod(number));
    for (const std::string& number : numbers_in(readme.substr(begin, end - begin))) {
        const double rounding = 0.5 * std::pow(10, -double(number.size() - number.find('.') - 1)) + 1e-9;
        EXPECT_TRUE(std::ranges::any_of(known, [&](double k) {
            return std::abs(k - std::stod(number)) <= rounding;
        })) << number;
    }
    EXPECT_NE(
        readme.find(fmt::format("chapel.vantage ({:.1f} MB, {:.1f} s)",
                                *costs.scans.front().whole_bytes / 1e6, *costs.scans.front().whole_seconds)),
        std::string::npos)
        << "the example's output";
}

}  // namespace
}  // namespace vantage

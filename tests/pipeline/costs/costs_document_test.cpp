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
The page is made from `configs/costs.json`, which these commands wrote:

    vantage costs sceaux --minutes 15 -o a            # likewise fountain-P11 and garden, three minutes each
    vantage costs a/costs.json b/costs.json c/costs.json
)";

constexpr const char* reading = R"(
**How to read it.** Every row changes one setting of the defaults. Photos were held out of preparing, rendered from their cameras, and
compared with the originals (PSNR after the best gain per channel; 3 dB: half the squared error). Differences from the defaults count
only pixels that both color. "±" is the 95 % confidence interval over the photos of all scans; "no difference seen" means that it
includes zero, so that the setting matters less than the scan. Costs are geometric means over the scans, relative to the defaults.
)";

std::string bullets(const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& line : lines) out += "- " + line + ".\n";
    return out;
}

/// One row per purpose and scan.
TextTable recipe_table(const Costs& costs) {
    TextTable out{{"for", "scan", "settings", "package", "frame", "held-out photos"}, {}};
    if (costs.scans.empty()) return out;
    for (std::size_t r = 0; r < costs.scans.front().recipes.size(); ++r)
        for (const ScanCosts& s : costs.scans) {
            if (r >= s.recipes.size()) continue;
            const Recipe& recipe = s.recipes[r];
            const CostNoise noise = noise_of({&s, 1});
            std::string settings;
            for (const auto* options : {&recipe.costs.trial.prepare, &recipe.costs.trial.show})
                for (const std::string& o : *options) settings += (settings.empty() ? "`" : " ") + o;
            const TrialCosts& defaults = s.trials.front();
            out.rows.push_back({&s == &costs.scans.front() ? recipe.purpose + ": " + recipe.reason : "",
                                s.name, settings.empty() ? "the defaults" : settings + "`",
                                change_text(bytes_ratio(recipe.costs, defaults), 0),
                                change_text(frame_ratio(recipe.costs, defaults), noise.frame),
                                settings.empty() ? "" : gain_text(estimate(recipe.costs.psnr), false)});
        }
    return out;
}

/// The setting's name as code.
TextTable with_code(TextTable table) {
    for (auto& row : table.rows) row[0] = "`" + row[0] + "`";
    return table;
}

/// The page as Markdown, with the charts in the folder `charts`.
std::string costs_document(const Costs& costs, const std::string& charts, const std::string& approximations) {
    const CostNoise noise = noise_of(costs.scans);
    std::string out = heading;
    out += fmt::format("\n**Machine.** {}.\n\n{}", origin_of(costs), bullets(scans_in_words(costs)));
    out += reading;
    out += fmt::format(
        "\nThe defaults' times repeated to within {:.0f} % (preparing) and {:.0f} % (frames); smaller "
        "changes "
        "count as the same.\n",
        100 * noise.seconds, 100 * noise.frame);
    for (const CostAxis axis : {CostAxis::preparing, CostAxis::storing, CostAxis::drawing}) {
        std::string file = title_of(axis);
        file[0] = char(file[0] + 'a' - 'A');
        out += fmt::format("\n## {0}\n\n![Quality against the cost of {1}]({2}/{1}.svg)\n", title_of(axis),
                           file, charts);
    }
    out +=
        "\nBlue: nothing measured is both cheaper and better. Red rings: the defaults and the presets. "
        "Settings that "
        "change neither\ncost nor quality are not drawn.\n";
    out += "\n## Settings\n\n" + as_markdown(with_code(setting_table(costs.scans)));
    out +=
        "\n## Approximations that are not settings\n\nWeight maps have half the width and height of the "
        "photo, "
        "and distances to depth borders are exact without a GPU. Errors of\nthe border weight, whose range "
        "is "
        "0 to 255, on Sceaux (`build/tests/bench/vantage-bench sceaux --set full --only border`):\n\n" +
        approximations;
    out +=
        "\n## Recommendations\n\nThe settings are chosen by the rule in the first column, and the "
        "combination is measured "
        "again.\n\n" +
        as_markdown(recipe_table(costs));
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

/// The resolution of weight maps and the method for border distances, as measured by
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
    return as_markdown(table);
}

TEST(CostsDocument, IsMadeFromTheShippedMeasurements) {
    const Costs costs = shipped();
    const std::string page = costs_document(costs, "../data/cost", approximations());
    expect_file(source / "docs/accuracy-and-cost.md", page);
    EXPECT_LE(std::ranges::count(page, '\n'), 150);
    expect_file(source / "data/cost/preparing.svg", cost_chart(costs.scans, CostAxis::preparing));
    expect_file(source / "data/cost/storing.svg", cost_chart(costs.scans, CostAxis::storing));
    expect_file(source / "data/cost/drawing.svg", cost_chart(costs.scans, CostAxis::drawing));
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

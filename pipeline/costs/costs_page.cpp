#include "pipeline/costs/costs_page.h"

#include <fmt/format.h>

#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "pipeline/costs/cost_chart.h"
#include "pipeline/costs/cost_table.h"

namespace vantage {
namespace {

/// Appended to page_style.
constexpr const char* costs_style = R"(
td { vertical-align: top; } svg { max-width: 100%; height: auto; } pre { margin: .3rem 0 .3rem 1rem; }
)";

/// How to read the table and the charts.
constexpr const char* reading =
    "Each row changes one setting of the defaults. Quality is the PSNR of photos that were held out of "
    "preparing, rendered from their cameras and compared with the photo, after the best gain per channel; "
    "the "
    "difference from the defaults is measured on the pixels that both color. ± is the 95 % confidence "
    "interval "
    "over the photos; \"no difference seen\" means that it includes zero.";

std::string costs_in_words(const TrialCosts& c, const TrialCosts& defaults, const CostNoise& noise) {
    std::string out;
    const auto add = [&](const char* name, const std::string& change) {
        if (!change.empty()) out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", name, change);
    };
    if (c.trial.prepare.empty() && c.trial.show.empty()) return "these are the defaults";
    add("preparing", change_text(seconds_ratio(c, defaults), noise.seconds));
    add("package", change_text(bytes_ratio(c, defaults), 0));
    add("frame", change_text(frame_ratio(c, defaults), noise.frame));
    add("held-out photos", gain_text(estimate(c.psnr), false));
    return out;
}

std::string chart_part(const std::vector<ScanCosts>& scans) {
    std::string out;
    for (const CostAxis axis : {CostAxis::preparing, CostAxis::storing, CostAxis::drawing})
        out += fmt::format("<h2>{}</h2>\n{}", title_of(axis), cost_chart(scans, axis));
    return out;
}

}  // namespace

std::string origin_of(const Costs& costs) {
    return fmt::format("Vantage {}, {}; {}, {} cores; OpenGL: {}", costs.version, costs.date, costs.processor,
                       costs.cores, costs.renderer);
}

std::vector<std::string> scans_in_words(const Costs& costs) {
    std::vector<std::string> out;
    for (const ScanCosts& s : costs.scans) {
        const TrialCosts& d = s.trials.front();
        std::string line = fmt::format("{}: {} photos of up to {}x{}, {} triangles", s.name, s.photos,
                                       s.width, s.height, s.triangles);
        if (s.whole_seconds)
            line += fmt::format(
                "; with the defaults, prepared in {:.1f} s into {:.1f} MB ({:.2f} times the photos)",
                *s.whole_seconds, s.whole_bytes.value_or(0) / 1e6,
                s.photo_bytes > 0 ? s.whole_bytes.value_or(0) / s.photo_bytes : 0);
        line += fmt::format("; {:.0f} ms per frame", median_of(d.frame_ms));
        if (const auto psnr = estimate(d.psnr))
            line += fmt::format("; {} photos {}: {:.1f} ± {:.1f} dB in pictures {} px wide", psnr->values,
                                s.excluded ? "excluded from blending" : "held out", psnr->mean, psnr->error,
                                s.picture);
        out.push_back(line + (s.complete ? "" : "; not all settings measured (--full measures them)"));
    }
    return out;
}

std::vector<std::string> recipes_in_words(const ScanCosts& scan) {
    std::vector<std::string> out;
    const CostNoise noise = noise_of({&scan, 1});
    for (const Recipe& r : scan.recipes) {
        out.push_back(fmt::format("for {} ({}):", r.purpose, r.reason));
        for (const std::string& command : r.commands) out.push_back("    " + command);
        out.push_back("  " + costs_in_words(r.costs, scan.trials.front(), noise));
    }
    return out;
}

std::string costs_page(const Costs& costs) {
    std::string out =
        "<!doctype html><html lang=en><meta charset=utf-8><title>Accuracy and cost</title>\n<style>" +
        std::string(page_style) + costs_style + "</style>\n<h1>Accuracy and cost</h1>\n<p>" +
        escaped(origin_of(costs)) + "</p>\n<ul>";
    for (const std::string& line : scans_in_words(costs)) out += "<li>" + escaped(line) + "\n";
    out += "</ul>\n<p>" + escaped(reading) + "</p>\n" + chart_part(costs.scans) + "<h2>Settings</h2>\n" +
           as_html(setting_table(costs.scans));
    const CostNoise noise = noise_of(costs.scans);
    out += fmt::format(
        "<p>The defaults' times repeated to within {:.0f} % (preparing) and {:.0f} % (frames); smaller "
        "changes are not reported.</p>\n<h2>Recommendations</h2>\n",
        100 * noise.seconds, 100 * noise.frame);
    for (const ScanCosts& s : costs.scans) {
        out += "<h3>" + escaped(s.name) + "</h3>\n<pre>";
        for (const std::string& line : recipes_in_words(s)) out += escaped(line) + "\n";
        out += "</pre>\n";
    }
    return out + "</html>\n";
}

}  // namespace vantage

#include "pipeline/costs/costs_page.h"

#include <fmt/format.h>

#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "pipeline/costs/cost_answers.h"

namespace vantage {
namespace {

/// Appended to page_style.
constexpr const char* costs_style = R"(
td { vertical-align: top; } svg { max-width: 100%; height: auto; } pre { margin: .3rem 0 .3rem 1rem; }
)";

constexpr const char* reading =
    "Photos were held out of preparing, rendered from their cameras, and compared with the same photos as "
    "the "
    "player shows them if they are not held out (PSNR after the best gain per channel; 3 dB: half the "
    "squared "
    "error). Each row of the table changes one setting of the defaults; its quality is the mean difference "
    "from the defaults on the pixels that both color. \"Equal\": the difference is certainly below 0.25 dB. "
    "\"Cannot tell\": the interval includes zero, so the mean is not proven; it depends on the scan and its "
    "photos. Costs are geometric means over the scans, relative to the defaults. Frames are those of a still "
    "view at 1280x720; in motion, the window draws smaller frames to reach its frame rate.";

constexpr const char* legend =
    "Blue: nothing measured on all scans is both cheaper and better. Red rings: the defaults and the "
    "presets. "
    "Hollow: measured on some scans only. Settings that change neither cost nor quality are not drawn.";

std::string costs_in_words(const TrialCosts& c, const TrialCosts& defaults, const CostNoise& noise) {
    std::string out;
    const auto add = [&](const char* name, const std::string& change) {
        if (!change.empty()) out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", name, change);
    };
    if (changes_nothing(c.trial)) return "these are the defaults";
    add("preparing", change_text(seconds_ratio(c, defaults), noise.seconds));
    add("package", change_text(bytes_ratio(c, defaults), 0));
    add("frame", change_text(frame_ratio(c, defaults), noise.frame));
    add("held-out photos", gain_text(estimate(c.psnr), false));
    return out;
}

/// A row per purpose and scan.
TextTable recipe_table(const Costs& costs) {
    TextTable out{{"for", "scan", "settings", "package", "a frame", "quality"}, {}};
    for (std::size_t r = 0; r < costs.scans.front().recipes.size(); ++r)
        for (const ScanCosts& s : costs.scans) {
            if (r >= s.recipes.size()) continue;
            const Recipe& recipe = s.recipes[r];
            const TrialCosts& defaults = s.trials.front();
            out.rows.push_back(
                {&s == &costs.scans.front() ? recipe.purpose + ": " + recipe.reason : "", s.name,
                 settings_in_words(recipe), change_text(bytes_ratio(recipe.costs, defaults), 0),
                 frame_in_words(recipe.costs.frame_ms),
                 changes_nothing(recipe.costs.trial) ? "" : gain_text(estimate(recipe.costs.psnr), false)});
        }
    return out;
}

std::string html_of(const PagePart& part, const std::vector<ScanCosts>& scans) {
    std::string out;
    switch (part.kind) {
        case PagePart::heading:
            return "<h2>" + escaped(part.lines[0]) + "</h2>\n";
        case PagePart::paragraph:
            return "<p>" + with_code(part.lines[0]) + "</p>\n";
        case PagePart::list:
            for (const std::string& line : part.lines) out += "<li>" + with_code(line) + ".\n";
            return "<ul>" + out + "</ul>\n";
        case PagePart::table:
            return as_html(part.rows);
        case PagePart::chart:
            return cost_chart(scans, part.axis);
        case PagePart::code:
            for (const std::string& line : part.lines) out += escaped(line) + "\n";
            return "<pre>" + out + "</pre>\n";
    }
    return out;
}

}  // namespace

std::string origin_of(const Costs& costs) {
    return fmt::format("Vantage {}, {}; {}, {} cores; OpenGL: {}", costs.version, costs.date, costs.processor,
                       costs.cores, costs.renderer);
}

TextTable scan_table(const Costs& costs) {
    TextTable out{{"scan", "photos", "triangles", "preparing", "package", "a frame", "held-out photos"}, {}};
    for (const ScanCosts& s : costs.scans) {
        const TrialCosts& d = s.trials.front();
        const auto psnr = estimate(d.psnr);
        std::string package;
        if (s.whole_bytes && s.photo_bytes > 0)
            package = fmt::format("{:.1f} MB, {:.2f} times the photos", *s.whole_bytes / 1e6,
                                  *s.whole_bytes / s.photo_bytes);
        out.rows.push_back(
            {s.name, fmt::format("{} of up to {}x{}", s.photos, s.width, s.height),
             std::to_string(s.triangles), s.whole_seconds ? fmt::format("{:.1f} s", *s.whole_seconds) : "",
             package, frame_in_words(d.frame_ms),
             psnr ? fmt::format("{}: {:.1f} ± {:.1f} dB, {} px wide{}{}", psnr->values, psnr->mean,
                                psnr->error, s.picture, s.excluded ? ", only excluded from blending" : "",
                                s.complete ? "" : "; some settings not measured")
                  : ""});
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

std::vector<PagePart> page_parts(const Costs& costs) {
    std::vector<PagePart> out{{PagePart::heading, {"In short"}},
                              {PagePart::list, cost_answers(costs.scans)},
                              {PagePart::heading, {"Machine and scans"}},
                              {PagePart::paragraph, {origin_of(costs) + ". With the defaults:"}},
                              {PagePart::table, {}, scan_table(costs)},
                              {PagePart::paragraph, {reading}}};
    for (const CostAxis axis : {CostAxis::preparing, CostAxis::storing, CostAxis::drawing}) {
        out.push_back({PagePart::heading, {title_of(axis)}});
        out.push_back({PagePart::chart, {}, {}, axis});
    }
    out.push_back({PagePart::paragraph, {legend}});
    out.push_back({PagePart::heading, {"Settings"}});
    out.push_back({PagePart::table, {}, setting_table(costs.scans)});
    out.push_back({PagePart::heading, {"Recommendations"}});
    out.push_back({PagePart::table, {}, recipe_table(costs)});
    if (costs.scans.size() == 1) out.push_back({PagePart::code, recipes_in_words(costs.scans.front())});
    return out;
}

std::string costs_page(const Costs& costs) {
    std::string out =
        "<!doctype html><html lang=en><meta charset=utf-8><title>Accuracy and cost</title>\n<style>" +
        std::string(page_style) + costs_style + "</style>\n<h1>Accuracy and cost</h1>\n";
    for (const PagePart& part : page_parts(costs)) out += html_of(part, costs.scans);
    return out + "</html>\n";
}

}  // namespace vantage

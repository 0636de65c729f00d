#include "pipeline/costs/cost_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "pipeline/costs/cost_table.h"

namespace vantage {
namespace {

/// A trial, and its description in a sentence.
struct Question {
    const char *setting, *value, *words;
};
constexpr Question questions[] = {
    {"--max-photo-size", "half", "Photos of half the width and height (`--max-photo-size`)"},
    {"--max-photos", "2", "Two blended photos instead of four (`--max-photos 2`)"},
    {"--border-distance", "jfa^2",
     "Exact border distances are the default without a GPU; with one, they were not measured. Jump flooding "
     "instead (`--border-distance "
     "jfa^2`)"},
    {"--preset", "preview", "The preset `preview`"},
    {"--effect", "background=off", "No background (`--effect background=off`)"},
};

std::string answer(const Question& q, const PooledTrial& p, const CostNoise& noise) {
    const std::string quality = gain_text(p);
    return fmt::format("{}: {}. Quality: {}", q.words, costs_text(p, noise),
                       quality.empty() ? "not measured" : quality);
}

/// "287 to 353 ms per frame": the range over the scans; empty if not measured.
std::string frames_in_words(std::span<const ScanCosts> scans, std::size_t purpose) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const ScanCosts& s : scans)
        if (purpose < s.recipes.size() && !s.recipes[purpose].costs.frame_ms.empty()) {
            const double ms = median_of(s.recipes[purpose].costs.frame_ms);
            least = std::min(least, ms);
            most = std::max(most, ms);
        }
    if (most <= 0) return "";
    const std::string range =
        least < most ? fmt::format("{:.0f} to {:.0f}", least, most) : fmt::format("{:.0f}", most);
    return "; " + range + " ms per frame on this machine";
}

/// The recommendation of each scan for one purpose.
std::string recommendation(std::span<const ScanCosts> scans, std::size_t purpose) {
    std::vector<std::pair<std::string, std::string>>
        settings;  // and the scans for which they are recommended
    for (const ScanCosts& s : scans) {
        if (purpose >= s.recipes.size()) continue;
        const std::string words = settings_in_words(s.recipes[purpose]);
        const auto same = std::ranges::find(settings, words, &std::pair<std::string, std::string>::first);
        if (same == settings.end())
            settings.emplace_back(words, s.name);
        else
            same->second += ", " + s.name;
    }
    std::string out = fmt::format("For {}: ", scans.front().recipes[purpose].purpose);
    for (const auto& [words, names] : settings)
        out += (&words == &settings.front().first ? "" : "; ") + words +
               (settings.size() > 1 ? " (" + names + ")" : "");
    return out + frames_in_words(scans, purpose);
}

}  // namespace

bool changes_nothing(const CostTrial& trial) { return trial.prepare.empty() && trial.show.empty(); }

std::string settings_in_words(const Recipe& recipe) {
    if (changes_nothing(recipe.costs.trial)) return "the defaults";
    std::string out;
    for (const auto* options : {&recipe.costs.trial.prepare, &recipe.costs.trial.show})
        for (const std::string& o : *options) out += (out.empty() ? "`" : " ") + o;
    return out + "`";
}

std::string frame_in_words(const std::vector<double>& ms) {
    const double median = median_of(ms);
    return median > 0 ? fmt::format("{:.0f} ms ({:.1f} per second)", median, 1000 / median) : "";
}

std::vector<std::string> cost_answers(std::span<const ScanCosts> scans) {
    if (scans.empty()) return {};
    const CostNoise noise = noise_of(scans);
    const std::vector<PooledTrial> pooled = pooled_trials(scans);
    std::vector<std::string> out;
    for (const Question& q : questions) {
        const auto found = std::ranges::find_if(pooled, [&](const PooledTrial& p) {
            return p.trial.setting == q.setting && p.trial.value == q.value;
        });
        if (found != pooled.end()) out.push_back(answer(q, *found, noise));
    }
    for (std::size_t r = 0; r < scans.front().recipes.size(); ++r) out.push_back(recommendation(scans, r));
    std::size_t photos = 0;
    for (const ScanCosts& s : scans) photos += s.trials.front().psnr.size();
    out.push_back(fmt::format(
        "How certain: ± is the 95 % confidence interval over up to {} held-out photos of {} {}; repeated "
        "times of the defaults differ by at most {:.0f} % (preparing) and {:.0f} % (frames) in nine of ten "
        "cases, and smaller changes are shown as \"same\"",
        photos, scans.size(), scans.size() == 1 ? "scan" : "scans", 100 * noise.seconds, 100 * noise.frame));
    return out;
}

}  // namespace vantage

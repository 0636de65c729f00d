#include "pipeline/costs/recipes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/files/shell_word.h"
#include "pipeline/costs/cost_table.h"

namespace vantage {
namespace {

/// Whether a recipe may include the setting. Effects are not included, because they depend on the scan.
bool offered(const CostTrial& t) {
    return t.setting == "--max-photo-size" || t.setting == "--max-photos" || t.setting == "--blend";
}

/// Largest permitted mean loss of a recommended setting, in dB.
constexpr double acceptable_loss = 0.5;

/// Minimum relative saving of a recommended setting, beyond the noise of the frame times.
constexpr double certain_saving = 0.03;

/// Largest permitted frame time for a certain gain, relative to the frame time of the defaults.
constexpr double acceptable_frame = 1.25;

double cost(const TrialCosts& c, const TrialCosts& defaults) {
    return frame_ratio(c, defaults).value_or(1) * bytes_ratio(c, defaults).value_or(1);
}

/// For each setting, the best of the trials that pass, according to `better`.
template <class Passes, class Better>
std::vector<const TrialCosts*> chosen(const ScanCosts& costs, const Passes& passes, const Better& better) {
    std::vector<const TrialCosts*> out;
    for (const TrialCosts& c : costs.trials) {
        if (!offered(c.trial) || !passes(c)) continue;
        const auto same = std::ranges::find_if(
            out, [&](const TrialCosts* o) { return o->trial.setting == c.trial.setting; });
        if (same == out.end())
            out.push_back(&c);
        else if (better(c, **same))
            *same = &c;
    }
    return out;
}

CostTrial combined(const std::string& purpose, const std::vector<const TrialCosts*>& of) {
    CostTrial out{"recommended", purpose, "", "", {}, {}, true, false};
    for (const TrialCosts* c : of) {
        out.prepare.insert(out.prepare.end(), c->trial.prepare.begin(), c->trial.prepare.end());
        out.show.insert(out.show.end(), c->trial.show.begin(), c->trial.show.end());
    }
    return out;
}

Recipe recipe(const ScanCosts& costs, const std::string& input, const std::string& purpose,
              const std::string& reason, const std::string& verb, const std::vector<const TrialCosts*>& of) {
    Recipe out{purpose, reason, {}, {}};
    out.costs.trial = combined(purpose, of);
    const std::string package = shell_word(costs.excluded ? input : costs.name + ".vantage");
    const auto words = [](const std::vector<std::string>& options) {
        std::string text;
        for (const std::string& o : options) text += " " + shell_word(o);
        return text;
    };
    if (!costs.excluded)
        out.commands.push_back(fmt::format("vantage prepare {} -o {}{}", shell_word(input), package,
                                           words(out.costs.trial.prepare)));
    if (!verb.empty())
        out.commands.push_back(fmt::format("{} {}{}", verb, package, words(out.costs.trial.show)));
    return out;
}

}  // namespace

std::vector<Recipe> recipes(const ScanCosts& costs, const std::string& input) {
    const TrialCosts& defaults = costs.trials.front();
    const double noise = noise_of({&costs, 1}).frame;
    const auto cheaper = [&](const TrialCosts& c) {
        const auto loss = estimate(c.psnr);
        return loss && loss->mean > -acceptable_loss && cost(c, defaults) < 1 - certain_saving - noise;
    };
    const auto by_cost = [&](const TrialCosts& a, const TrialCosts& b) {
        return cost(a, defaults) < cost(b, defaults);
    };
    const auto finer = [&](const TrialCosts& c) {
        const auto gain = estimate(c.psnr);
        return gain && certain(*gain) && gain->mean > 0 &&
               frame_ratio(c, defaults).value_or(1) <= acceptable_frame;
    };
    const auto by_gain = [&](const TrialCosts& a, const TrialCosts& b) {
        return estimate(a.psnr)->mean > estimate(b.psnr)->mean;
    };
    const auto for_ever = [&](const TrialCosts& c) { return finer(c) && !c.trial.prepare.empty(); };
    return {
        recipe(costs, input, "a laptop without a graphics card",
               fmt::format("the cheapest values that lose at most {} dB each, on average", acceptable_loss),
               "vantage-player", chosen(costs, cheaper, by_cost)),
        recipe(costs, input, "a kiosk or a mini PC",
               fmt::format("the most accurate values that lengthen frames by at most {:.0f} %",
                           100 * (acceptable_frame - 1)),
               "vantage-player kiosk", chosen(costs, finer, by_gain)),
        recipe(costs, input, "an archive", "only preparation settings that certainly improve quality",
               "vantage check --deep", chosen(costs, for_ever, by_gain))};
}

}  // namespace vantage

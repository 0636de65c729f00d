#include "pipeline/costs/effect_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

#include "pipeline/costs/cost_table.h"
#include "pipeline/output/meta.h"

namespace vantage {
namespace {

using package::Type;

/// The trace spans and package chunks of an effect.
struct Parts {
    std::vector<std::string> spans;  ///< see Traced
    std::vector<Type> chunks;
};

/// The parts of an effect; empty for effects from later versions.
Parts parts_of(const std::string& name) {
    const auto row = std::ranges::find(effect_table(), std::string_view(name), &EffectRow::name);
    if (row == effect_table().end()) return {};
    switch (row->effect) {
        case Effect::undistortion:
            return {{"lens"}, {Type::lenses}};
        case Effect::vertex_colors:
            return {{}, {Type::colors}};
        case Effect::exposure:
            return {{"colors"}, {Type::samples}};
        case Effect::pose_refinement:
            return {{"register"}, {Type::pose_refinement, Type::pose_refinement_without, Type::pairs}};
        case Effect::transients:
            return {{"transients"}, {}};
        case Effect::background:
            return {{"background"}, {Type::background}};
        case Effect::scalar_fields:
            return {{"deviation"}, {Type::scalars}};
        case Effect::points:
            return {{"points"}, {Type::point_nodes, Type::points}};
        default:
            return {};
    }
}

/// The effect's documented name or, for effects from later versions, its name in the package.
std::string option_of(const std::string& name) {
    const auto row = std::ranges::find(effect_table(), std::string_view(name), &EffectRow::name);
    return row == effect_table().end() ? name : row->option;
}

void add_judgment(const nlohmann::json& validated, EffectCost& out) {
    const double before = validated.at("seams_before"), after = validated.at("seams_after");
    out.gain = MeanWithError{validated.at("gain"), validated.at("error"), 0};
    if (before > 0) out.seams = after / before - 1;
}

/// A trial that turned an effect off or on.
struct EffectTrial {
    const TrialCosts& trial;
    const TrialCosts& defaults;
    double sign;  ///< 1 if the effect was turned off, -1 if it was turned on
};

std::vector<EffectTrial> trials_of(const KnownCosts& known, const std::string& option) {
    std::vector<EffectTrial> out;
    for (const ScanCosts& scan : known.costs.scans)
        for (const TrialCosts& c : scan.trials)
            if (c.trial.setting == "--effect" &&
                (c.trial.value == option + "=off" || c.trial.value == option + "=on"))
                out.push_back({c, scan.trials.front(), c.trial.value.ends_with("=off") ? 1.0 : -1.0});
    return out;
}

/// The measured time with the effect minus the time without it, averaged over the trials. `before`: the
/// defaults' times, each measured directly before.
std::optional<double> measured_time(std::span<const EffectTrial> trials,
                                    std::vector<double> TrialCosts::*times,
                                    std::vector<double> TrialCosts::*before) {
    std::vector<double> differences;
    for (const EffectTrial& t : trials) {
        const std::vector<double>& paired = t.trial.*before;
        const std::vector<double>& defaults = paired.empty() ? t.defaults.*times : paired;
        if ((t.trial.*times).empty() || defaults.empty()) continue;
        differences.push_back((least_of(defaults) - least_of(t.trial.*times)) * t.sign);
    }
    if (differences.empty()) return {};
    return std::accumulate(differences.begin(), differences.end(), 0.0) / double(differences.size());
}

/// The gain in PSNR of held-out photos due to the effect.
std::optional<MeanWithError> measured_gain(std::span<const EffectTrial> trials) {
    std::vector<double> gains;
    for (const EffectTrial& t : trials)
        for (const double change : t.trial.psnr) gains.push_back(-t.sign * change);
    std::optional<MeanWithError> out = estimate(gains);
    if (out && gains.size() > 1) out->error = standard_error(gains);
    return out;
}

void add_measured(const KnownCosts& known, bool on, EffectCost& out) {
    if (!on) {
        out.frame_ms = 0;
        return;
    }
    const std::vector<EffectTrial> trials = trials_of(known, option_of(out.name));
    if (!out.gain) out.gain = measured_gain(trials);
    if (!out.seconds)
        out.seconds = measured_time(trials, &TrialCosts::prepare_seconds, &TrialCosts::default_seconds);
    out.frame_ms = measured_time(trials, &TrialCosts::frame_ms, &TrialCosts::default_ms);
}

}  // namespace

std::vector<EffectCost> effect_costs(const PackageReader& package, std::span<const Trace::Span> spans,
                                     const KnownCosts& known) {
    std::map<std::uint32_t, std::uint64_t> bytes;
    for (const package::DirectoryEntry& e : package.directory()) bytes[e.type] += e.length;
    std::map<std::string, double> seconds;
    for (const Trace::Span& s : spans) seconds[s.what] += s.end - s.begin;
    std::vector<EffectCost> out;
    const nlohmann::json meta = parse_meta(package);
    for (const auto& e : meta.value("effects", nlohmann::json::array())) {
        EffectCost& cost = out.emplace_back();
        const bool on = e.value("on", false);
        cost.name = e.value("name", "");
        cost.state = std::string(on ? "on" : "off") + (e.value("forced", false) ? ", forced" : "");
        if (e.contains("judged")) add_judgment(e["judged"], cost);
        const Parts parts = parts_of(cost.name);
        for (const std::string& span : parts.spans)
            if (!spans.empty()) cost.seconds = cost.seconds.value_or(0) + seconds[span];
        for (const Type chunk : parts.chunks) cost.bytes += bytes[std::uint32_t(chunk)];
        add_measured(known, on, cost);
    }
    return out;
}

std::array<std::string, 5> effect_cells(const EffectCost& c) {
    std::array<std::string, 5> out;
    if (c.gain) out[0] = fmt::format("{:+.2f} ± {:.2f} dB", c.gain->mean, c.gain->error);
    if (c.seams) out[1] = fmt::format("{:+.0f} %", 100 * *c.seams);
    if (c.seconds) out[2] = fmt::format("{:.2f} s", *c.seconds);
    out[3] = fmt::format("{:.1f} kB", double(c.bytes) / 1000);
    if (c.frame_ms) out[4] = fmt::format("{:.0f} ms", *c.frame_ms);
    return out;
}

std::string origin_of(const KnownCosts& known) {
    if (known.costs.scans.empty()) return "'vantage costs SCAN' measures the costs of each effect";
    std::string names;
    for (const ScanCosts& s : known.costs.scans) names += (names.empty() ? "" : ", ") + s.name;
    if (known.own) return fmt::format("times measured on this scan by 'vantage costs', {}", known.costs.date);
    return fmt::format(
        "times of effects that are on were measured on {} ({}, {}); 'vantage costs SCAN' measures this "
        "scan",
        names, known.costs.processor, known.costs.date);
}

std::vector<std::string> effect_lines(std::span<const EffectCost> costs, const KnownCosts& known) {
    TextTable table{{"effect", "", "gain", "seams", "preparing", "package", "frame"}, {}};
    for (const EffectCost& c : costs) {
        std::vector<std::string> row{option_of(c.name), c.state};
        for (const std::string& cell : effect_cells(c)) row.push_back(cell);
        table.rows.push_back(row);
    }
    std::vector<std::string> out = as_lines(table);
    out.push_back(origin_of(known));
    return out;
}

}  // namespace vantage

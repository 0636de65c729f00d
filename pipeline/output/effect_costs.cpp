#include "pipeline/output/effect_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "pipeline/output/meta.h"

namespace vantage {
namespace {

using package::Type;

/// The trace spans and package chunks of an effect.
struct Parts {
    std::vector<std::string> spans;  ///< see Traced
    std::vector<Type> chunks;
};

/// Empty for effects of later versions.
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

void add_judgment(const nlohmann::json& validated, EffectCost& out) {
    const double before = validated.at("seams_before"), after = validated.at("seams_after");
    out.gain = fmt::format("{:+.2f} ± {:.2f} dB", validated.at("gain").get<double>(),
                           validated.at("error").get<double>());
    if (before > 0) out.seams = fmt::format("{:+.0f} %", 100 * (after / before - 1));
}

}  // namespace

std::vector<EffectCost> effect_costs(const PackageReader& package, std::span<const Trace::Span> spans) {
    std::map<std::uint32_t, std::uint64_t> bytes;
    for (const package::DirectoryEntry& e : package.directory()) bytes[e.type] += e.length;
    std::map<std::string, double> seconds;
    for (const Trace::Span& s : spans) seconds[s.what] += s.end - s.begin;
    std::vector<EffectCost> out;
    const nlohmann::json meta = parse_meta(package);
    for (const auto& e : meta.value("effects", nlohmann::json::array())) {
        EffectCost& cost = out.emplace_back();
        cost.name = e.value("name", "");
        cost.state =
            std::string(e.value("on", false) ? "on" : "off") + (e.value("forced", false) ? ", forced" : "");
        if (e.contains("judged")) add_judgment(e["judged"], cost);
        const Parts parts = parts_of(cost.name);
        for (const std::string& span : parts.spans)
            if (!spans.empty()) cost.seconds = cost.seconds.value_or(0) + seconds[span];
        for (const Type chunk : parts.chunks) cost.bytes += bytes[std::uint32_t(chunk)];
    }
    return out;
}

std::vector<std::string> table_of(std::span<const EffectCost> costs) {
    constexpr const char* row = "{:<18} {:<11} {:>17} {:>7} {:>8} {:>10}";
    const auto or_dash = [](const std::string& text) { return text.empty() ? "-" : text; };
    std::vector<std::string> out{fmt::format(row, "effect", "", "gain", "seams", "seconds", "bytes")};
    for (const EffectCost& c : costs)
        out.push_back(fmt::format(row, c.name, c.state, or_dash(c.gain), or_dash(c.seams),
                                  c.seconds ? fmt::format("{:.2f}", *c.seconds) : "-", c.bytes));
    return out;
}

}  // namespace vantage

#include "pipeline/costs/cost_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/markup.h"

namespace vantage {
namespace {

/// Differences in PSNR that are certainly smaller than this, in dB, are reported as equal: a difference of
/// 6 % in the squared error is not visible.
constexpr double equal_within = 0.25;

std::string joined(const std::vector<std::string>& parts, const char* separator) {
    std::string out;
    for (const std::string& p : parts)
        if (!p.empty()) out += (out.empty() ? "" : separator) + p;
    return out;
}

std::string with_name(const char* name, const std::string& change) {
    return change.empty() || change == "same" ? "" : name + (" " + change);
}

/// The order of values within a setting: by their combined cost.
double cost_of(const PooledTrial& p) {
    return p.seconds.value_or(1) * p.bytes.value_or(1) * p.frame.value_or(1);
}

std::string where_measured(const PooledTrial& p, std::size_t scans) {
    const std::string names =
        p.scans.size() > 1 && p.scans.size() == scans ? "all scans" : joined(p.scans, ", ");
    return fmt::format("{}; {} photos", names, p.psnr ? p.psnr->values : 0);
}

/// The option and its value; each effect counts as a separate setting.
std::pair<std::string, std::string> setting_and_value(const CostTrial& t) {
    if (t.setting != "--effect") return {t.setting, t.value};
    const std::size_t equals = t.value.find('=');
    return {"--effect " + t.value.substr(0, equals), t.value.substr(equals + 1)};
}

}  // namespace

CostNoise noise_of(std::span<const ScanCosts> scans) {
    return {noise_of_seconds(scans), noise_of_frames(scans)};
}

std::string change_text(const CostRatio& ratio, double noise) {
    if (!ratio) return "";
    if (std::abs(*ratio - 1) <= std::max(noise, size_noise)) return "same";
    return *ratio >= 2 ? fmt::format("{:.1f} times", *ratio) : fmt::format("{:+.0f} %", 100 * (*ratio - 1));
}

std::string costs_text(const PooledTrial& p, const CostNoise& noise) {
    const std::string all = joined({with_name("preparing", change_text(p.seconds, noise.seconds)),
                                    with_name("package", change_text(p.bytes, size_noise)),
                                    with_name("frame", change_text(p.frame, noise.frame))},
                                   ", ");
    return all.empty() ? "same cost" : all;
}

std::string gain_text(const std::optional<MeanWithError>& gain, bool whole_frame) {
    if (!gain) return "";
    const std::string where = whole_frame ? " of the whole frame" : "";
    if (gain->mean == 0 && gain->error == 0) return "identical";
    if (!std::isfinite(gain->error)) return fmt::format("{:+.2f} dB{} (one photo)", gain->mean, where);
    const double most = std::abs(gain->mean) + gain->error;
    if (most < 0.01) return "equal (within 0.01 dB)";
    const std::string estimated = fmt::format("{:+.2f} ± {:.2f} dB{}", gain->mean, gain->error, where);
    if (certain(*gain)) return estimated;
    return fmt::format("{} ({})", most <= equal_within ? "equal" : "cannot tell", estimated);
}

std::string gain_text(const PooledTrial& p) {
    constexpr double wide = 0.5;  // dB
    const std::string all = gain_text(p.psnr, p.trial.whole_frame);
    if (p.psnr_of_scans.size() < 2) return all;
    const auto [least, most] = std::ranges::minmax(p.psnr_of_scans);
    return most - least < wide ? all : fmt::format("{} (by scan: {:+.2f} to {:+.2f})", all, least, most);
}

TextTable trial_table(std::span<const ScanCosts> scans) {
    const CostNoise noise = noise_of(scans);
    TextTable out{{"setting", "default", "preparing", "memory", "package", "frame", "held-out photos"}, {}};
    for (const PooledTrial& p : pooled_trials(scans))
        if (!p.trial.setting.empty())
            out.rows.push_back({p.trial.setting + " " + p.trial.value, p.trial.usual,
                                change_text(p.seconds, noise.seconds), change_text(p.memory, size_noise),
                                change_text(p.bytes, size_noise), change_text(p.frame, noise.frame),
                                gain_text(p)});
    return out;
}

TextTable setting_table(std::span<const ScanCosts> scans) {
    const CostNoise noise = noise_of(scans);
    std::vector<PooledTrial> pooled = pooled_trials(scans);
    std::erase_if(pooled, [](const PooledTrial& p) { return p.trial.setting.empty(); });
    std::vector<std::string> settings;  // in the order of their importance
    for (const PooledTrial& p : pooled)
        if (const std::string s = setting_and_value(p.trial).first; !std::ranges::count(settings, s))
            settings.push_back(s);
    std::ranges::stable_sort(pooled, {}, [&](const PooledTrial& p) {
        return std::pair(std::ranges::find(settings, setting_and_value(p.trial).first) - settings.begin(),
                         cost_of(p));
    });
    TextTable out{{"setting", "default", "other value", "saves or costs", "quality", "measured on"}, {}};
    std::string last, usual;
    for (const PooledTrial& p : pooled) {
        const auto [setting, value] = setting_and_value(p.trial);
        const bool first = std::exchange(last, setting) != setting;
        const bool other =
            std::exchange(usual, p.trial.usual) != usual;  // an effect that some scans call for
        out.rows.push_back({first ? "`" + setting + "`" : "", first || other ? p.trial.usual : "",
                            p.trial.note.empty() ? value : fmt::format("{} ({})", value, p.trial.note),
                            costs_text(p, noise), gain_text(p), where_measured(p, scans.size())});
    }
    return out;
}

std::vector<std::string> as_lines(const TextTable& table) {
    std::vector<std::size_t> widths;
    const auto length = [](const std::string& s) {  // characters of UTF-8
        return std::size_t(std::ranges::count_if(s, [](char c) { return (c & 0xC0) != 0x80; }));
    };
    for (std::size_t c = 0; c < table.heading.size(); ++c) {
        widths.push_back(length(table.heading[c]));
        for (const auto& row : table.rows) widths[c] = std::max(widths[c], length(row[c]));
    }
    const auto line = [&](const std::vector<std::string>& row) {
        std::string out;
        for (std::size_t c = 0; c < row.size(); ++c)
            out += row[c] + std::string(c + 1 < row.size() ? widths[c] - length(row[c]) + 2 : 0, ' ');
        return out.substr(0, out.find_last_not_of(' ') + 1);
    };
    std::vector<std::string> out{line(table.heading)};
    for (const auto& row : table.rows) out.push_back(line(row));
    return out;
}

std::string as_markdown(const TextTable& table) {
    const auto line = [](const std::vector<std::string>& row) {
        std::string out = "|";
        for (const std::string& cell : row) out += " " + cell + " |";
        return out + "\n";
    };
    std::string out = line(table.heading) + "|";
    for (std::size_t c = 0; c < table.heading.size(); ++c) out += "---|";
    out += "\n";
    for (const auto& row : table.rows) out += line(row);
    return out;
}

std::string with_code(const std::string& text) {
    std::string out = escaped(text);
    for (std::size_t at = 0, ticks = 0; (at = out.find('`', at)) != out.npos; ++ticks)
        out.replace(at, 1, ticks % 2 == 0 ? "<code>" : "</code>");
    return out;
}

std::string as_html(const TextTable& table) {
    std::string out = "<table><tr>";
    for (const std::string& h : table.heading) out += "<th>" + escaped(h);
    for (const auto& row : table.rows) {
        out += "\n<tr>";
        for (const std::string& cell : row) out += "<td>" + with_code(cell);
    }
    return out + "\n</table>\n";
}

}  // namespace vantage

#include "pipeline/costs/cost_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text/markup.h"

namespace vantage {
namespace {

/// Relative changes of preparation times up to this value are treated as noise if each was measured only
/// once, not directly after the defaults: the speed of machines drifts.
constexpr double noise_of_single_runs = 0.3;

std::string joined(const std::vector<std::string>& parts, const char* separator) {
    std::string out;
    for (const std::string& p : parts)
        if (!p.empty()) out += (out.empty() ? "" : separator) + p;
    return out;
}

std::string with_name(const char* name, const std::string& change) {
    return change.empty() || change == "same" ? "" : name + (" " + change);
}

/// Whether the value costs more than the default overall.
bool dearer(const PooledTrial& p) {
    return p.seconds.value_or(1) * p.bytes.value_or(1) * p.frame.value_or(1) > 1;
}

std::string costs_text(const PooledTrial& p, const CostNoise& noise) {
    const std::string all = joined({with_name("preparing", change_text(p.seconds, noise.seconds)),
                                    with_name("package", change_text(p.bytes, size_noise)),
                                    with_name("frame", change_text(p.frame, noise.frame))},
                                   ", ");
    return all.empty() ? "same cost" : all;
}

std::string error_text(const PooledTrial& p) {
    return p.psnr && std::isfinite(p.psnr->error) ? fmt::format("± {:.2f} dB", p.psnr->error) : "";
}

std::string mean_text(const PooledTrial& p) {
    if (!p.psnr) return "";
    const std::string where = p.trial.whole_frame ? " of the frame" : "";
    if (p.psnr->mean == 0 && p.psnr->error == 0) return "identical";
    return certain(*p.psnr) ? fmt::format("{:+.2f} dB{}", p.psnr->mean, where) : "no difference seen";
}

/// The option and its value; each effect counts as a separate setting.
std::pair<std::string, std::string> setting_and_value(const CostTrial& t) {
    if (t.setting != "--effect") return {t.setting, t.value};
    const std::size_t equals = t.value.find('=');
    return {"--effect " + t.value.substr(0, equals), t.value.substr(equals + 1)};
}

}  // namespace

CostNoise noise_of(std::span<const ScanCosts> scans) {
    const bool paired = std::ranges::any_of(scans, [](const ScanCosts& s) {
        return std::ranges::any_of(s.trials, [](const TrialCosts& c) { return !c.default_seconds.empty(); });
    });
    const double seconds = noise_of_times(scans, &TrialCosts::prepare_seconds, &TrialCosts::default_seconds);
    return {paired ? seconds : std::max(seconds, noise_of_single_runs),
            noise_of_times(scans, &TrialCosts::frame_ms, &TrialCosts::default_ms)};
}

std::string change_text(const CostRatio& ratio, double noise) {
    if (!ratio) return "";
    if (std::abs(*ratio - 1) <= std::max(noise, size_noise)) return "same";
    return *ratio >= 2 ? fmt::format("{:.1f} times", *ratio) : fmt::format("{:+.0f} %", 100 * (*ratio - 1));
}

std::string gain_text(const std::optional<MeanWithError>& gain, bool whole_frame) {
    if (!gain) return "";
    const std::string where = whole_frame ? " of the whole frame" : "";
    if (gain->mean == 0 && gain->error == 0) return "identical";
    if (!std::isfinite(gain->error)) return fmt::format("{:+.2f} dB{} (one photo)", gain->mean, where);
    if (!certain(*gain)) return fmt::format("no difference seen (± {:.2f} dB)", gain->error);
    return fmt::format("{:+.2f} ± {:.2f} dB{}", gain->mean, gain->error, where);
}

TextTable trial_table(std::span<const ScanCosts> scans) {
    const CostNoise noise = noise_of(scans);
    TextTable out{{"setting", "default", "preparing", "memory", "package", "frame", "held-out photos"}, {}};
    for (const PooledTrial& p : pooled_trials(scans))
        if (!p.trial.setting.empty())
            out.rows.push_back({p.trial.setting + " " + p.trial.value, p.trial.usual,
                                change_text(p.seconds, noise.seconds), change_text(p.memory, size_noise),
                                change_text(p.bytes, size_noise), change_text(p.frame, noise.frame),
                                gain_text(p.psnr, p.trial.whole_frame)});
    return out;
}

TextTable setting_table(std::span<const ScanCosts> scans) {
    const CostNoise noise = noise_of(scans);
    TextTable out{
        {"setting", "default", "cheaper: saves, loses", "dearer: costs, gains", "error", "measured on"}, {}};
    for (const PooledTrial& p : pooled_trials(scans)) {
        if (p.trial.setting.empty()) continue;
        const auto [setting, value] = setting_and_value(p.trial);
        auto row = std::ranges::find_if(out.rows, [&](const auto& r) { return r[0] == setting; });
        if (row == out.rows.end())
            row = out.rows.insert(out.rows.end(), {setting, p.trial.usual, "", "", "", ""});
        const std::string line = joined({value + ": " + costs_text(p, noise), mean_text(p)}, "; ");
        const std::string where =
            fmt::format("{}; {} photos", joined(p.scans, ", "), p.psnr ? p.psnr->values : 0);
        for (const auto& [cell, text] :
             {std::pair(dearer(p) ? 3 : 2, line), std::pair(4, error_text(p)), std::pair(5, where)})
            if (!text.empty()) (*row)[cell] += ((*row)[cell].empty() ? "" : "\n") + text;
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
        for (std::string cell : row) {
            for (std::size_t at = 0; (at = cell.find('\n', at)) != cell.npos;) cell.replace(at, 1, "<br>");
            out += " " + cell + " |";
        }
        return out + "\n";
    };
    std::string out = line(table.heading) + "|";
    for (std::size_t c = 0; c < table.heading.size(); ++c) out += "---|";
    out += "\n";
    for (const auto& row : table.rows) out += line(row);
    return out;
}

std::string as_html(const TextTable& table) {
    std::string out = "<table><tr>";
    for (const std::string& h : table.heading) out += "<th>" + escaped(h);
    for (const auto& row : table.rows) {
        out += "\n<tr>";
        for (const std::string& cell : row) {
            std::string text = escaped(cell);
            for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos;) text.replace(at, 1, "<br>");
            out += "<td>" + text;
        }
    }
    return out + "\n</table>\n";
}

}  // namespace vantage

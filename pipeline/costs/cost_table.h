#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/costs/cost_statistics.h"

namespace vantage {

/// Relative changes in package size or memory up to this value are treated as noise.
inline constexpr double size_noise = 0.005;

/// Relative differences in time up to these are reported as "same".
struct CostNoise {
    double seconds = 0, frame = 0;
};
CostNoise noise_of(std::span<const ScanCosts> scans);

/// "-31 %", "2.4 times", or "same" within the noise; empty if not measured.
std::string change_text(const CostRatio& ratio, double noise);
/// "preparing -57 %, package -59 %", or "same cost".
std::string costs_text(const PooledTrial& trial, const CostNoise& noise);
/// "-0.31 ± 0.08 dB", "equal (+0.01 ± 0.03 dB)", "cannot tell (-0.20 ± 0.42 dB)", or "identical"; empty if
/// not measured.
std::string gain_text(const std::optional<MeanWithError>& gain, bool whole_frame);

/// The gain of a pooled trial; with its range over the scans if that exceeds 0.5 dB: "-0.77 ± 0.89 dB (by
/// scan: -3.31 to +0.06)".
std::string gain_text(const PooledTrial& trial);

/// A table of text.
struct TextTable {
    std::vector<std::string> heading;
    std::vector<std::vector<std::string>> rows;
};
/// A row per trial, for a terminal.
TextTable trial_table(std::span<const ScanCosts> scans);
/// A row per value of a setting, with its costs, quality and scans. The values of a setting are in order of
/// their cost.
TextTable setting_table(std::span<const ScanCosts> scans);

std::vector<std::string> as_lines(const TextTable& table);  ///< in aligned columns
std::string as_markdown(const TextTable& table);
std::string as_html(const TextTable& table);
/// The text as HTML, with text between backticks as code.
std::string with_code(const std::string& text);

}  // namespace vantage

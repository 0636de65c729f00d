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
/// "-0.31 ± 0.08 dB", "no difference seen (± 0.12 dB)", or "identical"; empty if not measured.
std::string gain_text(const std::optional<MeanWithError>& gain, bool whole_frame);

/// A table of text.
struct TextTable {
    std::vector<std::string> heading;
    std::vector<std::vector<std::string>> rows;
};
/// A row per trial, for a terminal.
TextTable trial_table(std::span<const ScanCosts> scans);
/// A row per setting: default, cheaper values, more expensive values, errors, and the scans. The lines within
/// a cell are separated by line feeds.
TextTable setting_table(std::span<const ScanCosts> scans);

std::vector<std::string> as_lines(const TextTable& table);  ///< in aligned columns
std::string as_markdown(const TextTable& table);
std::string as_html(const TextTable& table);

}  // namespace vantage

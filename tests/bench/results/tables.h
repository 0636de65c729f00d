#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// All that was measured in one go, and on what.
struct Run {
    std::string version;               ///< of Vantage
    std::string effort;                ///< Effort::name
    std::vector<std::string> machine;  ///< a line each: processor, renderer, date
    std::vector<Measurement> measurements;
};

/// A line a value: sweep,scene,curve,setting,exact,chosen,metric,unit,value (RFC 4180); an empty value is not
/// finite. Throws Error(storage).
void write_csv(const std::filesystem::path& file, std::span<const Measurement> measurements);

/// Values that are not finite are left out, JSON having none. Throws Error(storage).
void write_json(const std::filesystem::path& file, const Run& run);
/// Throws Error(input), naming the file, where it is not one that write_json() wrote.
Run read_json(const std::filesystem::path& file);

}  // namespace vantage::bench

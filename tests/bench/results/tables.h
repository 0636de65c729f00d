#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// The measurements of one run, and the machine and program that made them.
struct Run {
    std::string version;               ///< version of Vantage
    std::string effort;                ///< Effort::name
    std::vector<std::string> machine;  ///< one entry each: processor, renderer, date
    std::vector<Measurement> measurements;
};

/// One line per value: sweep,scene,curve,setting,exact,chosen,metric,unit,value (RFC 4180). Values that are
/// not finite are left empty. Throws Error(storage).
void write_csv(const std::filesystem::path& file, std::span<const Measurement> measurements);

/// Writes a run. Non-finite values, which JSON cannot represent, are skipped. Throws Error(storage).
void write_json(const std::filesystem::path& file, const Run& run);
/// Reads a run. Throws Error(input) with the file's name if the file was not written by write_json().
Run read_json(const std::filesystem::path& file);

}  // namespace vantage::bench

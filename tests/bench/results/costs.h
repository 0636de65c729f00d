#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// Writes the file that `vantage prepare --explain` reads (pipeline/results/explain.h): for each setting of
/// prepare, its cost and error on each scene. `about` describes the machine, as in Run. Throws
/// Error(storage).
void write_costs(const std::filesystem::path& file, const std::vector<std::string>& about,
                 std::span<const Measurement> measurements);

}  // namespace vantage::bench

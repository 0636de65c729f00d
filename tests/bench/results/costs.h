#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// Writes what `vantage prepare --explain` reads (pipeline/explain.h): of the settings of prepare, what each
/// cost and gave up on each scene. `about`: the machine, a line each. Throws Error(storage).
void write_costs(const std::filesystem::path& file, const std::vector<std::string>& about,
                 std::span<const Measurement> measurements);

}  // namespace vantage::bench

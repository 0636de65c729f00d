#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/measure/pictures.h"

namespace vantage::bench {

/// Resources that `vantage prepare` used.
struct PrepareCost {
    double seconds = 0;  ///< wall
    /// The peak as reported by the program. The system's value for a child process includes its parent's.
    double memory_bytes = 0;
};

/// Runs `vantage prepare FOLDER -o PACKAGE OPTIONS...` in a separate process. If it fails, throws
/// Error(input) with the last line of its output.
PrepareCost run_prepare(const std::filesystem::path& folder, const std::filesystem::path& package,
                        const std::vector<std::string>& options);

/// Prepares a package with these options and measures one setting on it. The result has the values of
/// measure_pictures() plus package_bytes, prepare_s and memory_bytes. It lacks psnr_exact and an exhibit of
/// the truth, because there is no other setting to compare with.
Measurement measure_prepared(const BenchScene& scene, const Effort& effort,
                             const std::vector<std::string>& options, const PictureSetting& setting,
                             const std::filesystem::path& folder, const std::string& tag);

}  // namespace vantage::bench

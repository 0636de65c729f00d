#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/measure/pictures.h"

namespace vantage::bench {

/// What `vantage prepare` took.
struct PrepareCost {
    double seconds = 0;  ///< wall
    double memory_bytes =
        0;  ///< peak, as it says itself: what the system keeps of a child counts its parent's, too
};

/// Runs the program as a user does, `vantage prepare FOLDER -o PACKAGE OPTIONS...`. Throws Error(input) with
/// its last line where it fails.
PrepareCost run_prepare(const std::filesystem::path& folder, const std::filesystem::path& package,
                        const std::vector<std::string>& options);

/// What measure_pictures() finds of one setting on a package prepared for it, package_bytes, prepare_s and
/// memory_bytes; beside nothing else, so without psnr_exact and the truth's exhibit.
Measurement measure_prepared(const BenchScene& scene, const Effort& effort,
                             const std::vector<std::string>& options, const PictureSetting& setting,
                             const std::filesystem::path& folder, const std::string& tag);

}  // namespace vantage::bench

#pragma once
#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace vantage::bench

#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// The command line of `vantage-player verify`.
struct VerifyOptions {
    std::vector<std::string> packages;
    std::filesystem::path golden, differences = "differences";
    std::string size = "640x360", junit;
    int tolerance = 8;     ///< allowed difference of a pixel, in gray levels
    double share = 0.001;  ///< allowed fraction of pixels with larger differences
    bool update = false;
};

/// Renders each package's recorded views without a display, and compares them with the stored pictures or,
/// with `update`, stores them. Prints differences and non-finite values, and writes difference pictures.
/// Returns the exit code: the first of input, damaged and different that applies to any package. Throws
/// Error(storage) and Error(graphics).
int run_verify(const VerifyOptions& options);

}  // namespace vantage

#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// The command line of `vantage-player verify`.
struct VerifyOptions {
    std::vector<std::string> packages;
    std::filesystem::path golden, differences = "differences";
    std::string size = "640x360", junit;
    int tolerance = 8;     ///< grey levels that a pixel may be off
    double share = 0.001;  ///< of the pixels that may be off by more
    bool update = false, json = false;
};
void add_verify_options(CLI::App& app, VerifyOptions& options);

/// Renders each package's recorded views without a display and compares them with the stored pictures, or
/// with `update` stores them. Says what differs, writes pictures of it, and says where arithmetic gave no
/// number; returns the worst of all packages' exit codes. Throws Error(storage) and Error(graphics).
int run_verify(const VerifyOptions& options);

}  // namespace vantage

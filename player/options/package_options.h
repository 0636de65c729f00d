#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "scene/package_reader.h"

namespace vantage {

/// The package, and a selection of its photos.
struct PackageOptions {
    std::string file;
    std::vector<std::string> exclude;  ///< photos that are not blended
    std::vector<std::string> photos;   ///< to look from, or to leave out
};
void add_package_options(CLI::App& app, PackageOptions& options);

/// All photos but the excluded ones. Throws Error(usage) for an unknown name.
std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& options);

/// Those of them that are of one band.
std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& options,
                                         std::uint32_t band);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A difference between two packages: in a setting, the model, a photo, or one of a photo's artifacts.
struct Difference {
    std::string of;    ///< "settings", "inputs", "model", or a photo's name
    std::string what;  ///< the setting, part or artifact; empty if `of` is in one package only
    std::string text;  ///< the difference, as a message
};

/// All differences; photos are paired by name, in the order of `a`. Chunks with equal checksums are treated
/// as equal, because both packages are checked first. Throws Error(damaged) if one of them is invalid.
std::vector<Difference> diff(const PackageReader& a, const PackageReader& b);

/// Whether write_difference_page may write into the folder. Throws Error(usage).
void expect_replaceable(const PackageReader& a, const PackageReader& b, const std::filesystem::path& folder,
                        bool force);

/// Writes index.html: the packages compared, a table of `all` differences (if any), and pictures of the
/// photos that differ (tiles and each weight map), PNG files with A, B and the difference side by side.
/// Returns the page's path. Throws Error(storage).
std::filesystem::path write_difference_page(const PackageReader& a, const PackageReader& b,
                                            const std::vector<Difference>& all,
                                            const std::filesystem::path& folder);

}  // namespace vantage

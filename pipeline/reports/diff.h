#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A difference between two packages: in a setting, the model, a photo, or data made from a photo.
struct Difference {
    std::string of;    ///< "settings", "inputs", "model", or a photo's name
    std::string what;  ///< the setting or part; empty if `of` exists in only one package
    std::string text;  ///< the difference, as a message
};

/// All differences. Photos are paired by name, in the order of `a`. Chunks with equal checksums are treated
/// as equal, because both packages are checked first. Throws Error(damaged) if either package is invalid.
std::vector<Difference> diff(const PackageReader& a, const PackageReader& b);

/// Throws Error(usage) if write_difference_page may not write into the folder.
void expect_replaceable(const PackageReader& a, const PackageReader& b, const std::filesystem::path& folder,
                        bool force);

/// Writes index.html with the packages compared, a table of `all` differences (if any), and pictures of the
/// tiles and weight maps that differ. The pictures are PNG files that show A, B and the difference side by
/// side. Returns the page's path. Throws Error(storage).
std::filesystem::path write_difference_page(const PackageReader& a, const PackageReader& b,
                                            const std::vector<Difference>& all,
                                            const std::filesystem::path& folder);

}  // namespace vantage

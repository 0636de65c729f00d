#pragma once
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

class Command;
class Option;

/// The package, and a selection of its photos.
struct PackageOptions {
    std::string file;
    std::vector<std::string> exclude;  ///< photos that are not blended
    std::vector<std::string> photos;   ///< photos to view from, or to hold out
};
/// Adds the argument FILE; `more` is appended to its help text.
Option add_package_argument(const Command& command, PackageOptions& options, const std::string& more = {});
void add_exclude_option(const Command& command, PackageOptions& options);
void add_photo_option(const Command& command, PackageOptions& options, const std::string& help);

/// All photos except the excluded ones. Throws Error(usage) for an unknown name.
std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& options);

/// The photos of one image set, except the excluded ones.
std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& options,
                                         std::uint32_t image_set);

}  // namespace vantage

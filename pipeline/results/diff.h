#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package_reader.h"

namespace vantage {

/// What differs between two packages in one thing: a setting, the model, a photo, a photo's artefact.
struct Difference {
    std::string of;    ///< "settings", "inputs", "model", "photos", or a photo's name
    std::string what;  ///< the artefact; empty where `of` says it all
    std::string text;  ///< how much, for people
};

/// All differences, photos paired by name, in the order of their names. Chunks of equal checksums are not
/// read.
std::vector<Difference> diff(const PackageReader& a, const PackageReader& b);

/// Pictures of what differs between photos (tiles, and each mask): A, B and the difference side by side, as
/// PNG files and an index.html. Throws Error(storage).
void write_difference_pictures(const PackageReader& a, const PackageReader& b,
                               const std::filesystem::path& folder);

}  // namespace vantage

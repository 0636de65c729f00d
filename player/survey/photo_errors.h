#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// How far each photo's camera is off, as far as the pairs tell in which prepare compared it with photos that
/// overlap it: the median over its pairs of the pairs' median distance between corners that match, each pair
/// counted by its matches; pixels. Nothing for a photo in no pair with matches.
std::vector<std::optional<double>> photo_errors(std::span<const package::PairRecord> pairs,
                                                std::size_t photos);

/// Those of a package; nothing for all if it has no pairs, or damaged ones.
std::vector<std::optional<double>> photo_errors(const PackageReader& package);

}  // namespace vantage

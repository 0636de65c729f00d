#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// The camera error of each photo in pixels, estimated from the pairs of overlapping photos that prepare
/// compared. Each pair has a median distance between matching corners; the error is the median of these
/// distances over the photo's pairs, weighted by the number of matches. The error is nullopt if a photo has
/// no matches.
std::vector<std::optional<double>> photo_errors(std::span<const package::PairRecord> pairs,
                                                std::size_t photos);

/// The errors of a package's photos; all are nullopt if the package has no pairs, or if its pairs are
/// damaged.
std::vector<std::optional<double>> photo_errors(const PackageReader& package);

}  // namespace vantage

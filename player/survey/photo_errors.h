#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// The camera error of each photo, estimated from the pairs of overlapping photos that prepare compared: the
/// median over its pairs of their median distance between matching corners, weighted by the number of
/// matches; in pixels. Nullopt for a photo without matches.
std::vector<std::optional<double>> photo_errors(std::span<const package::PairRecord> pairs,
                                                std::size_t photos);

/// The errors of a package's photos; all are nullopt if the package has no pairs, or if its pairs are
/// damaged.
std::vector<std::optional<double>> photo_errors(const PackageReader& package);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/agree/photo_pairs.h"
#include "pipeline/agree/surface_matches.h"
#include "pipeline/run/progress.h"
#include "scene/package_reader.h"

namespace vantage {

/// How photos are matched.
struct MatchSettings {
    int long_side;  ///< px that photos are reduced to
    int corners;    ///< a photo, at most
    unsigned threads;
    OnProgress progress{};  ///< by photos; may be empty
};

/// What matching found: pairs in order, and the tracks of all photos.
struct Matching {
    std::vector<package::PairRecord> pairs;
    std::vector<Track> tracks;
};

/// Matches pairs through the model under these poses. Photos are read as they are needed, and no more than a
/// few are in memory. Throws Error(damaged).
Matching match_pairs(const PackageReader& package, std::span<const package::PhotoRecord> photos,
                     std::span<const Pose> poses, std::span<const PhotoPair> pairs, const MatchSettings& how);

/// There are enough matches to tell anything.
bool trusted(const package::PairRecord& pair);
/// Corners could be compared, and were not found again: these photos do not show one surface.
bool contradicts(const package::PairRecord& pair);

/// Median displacement of trusted pairs, of those with one photo, or of those without it; 0 without any.
double median_displacement(std::span<const package::PairRecord> pairs);
double median_displacement(std::span<const package::PairRecord> pairs, std::uint32_t photo);
double median_displacement_beside(std::span<const package::PairRecord> pairs, std::uint32_t photo);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/poses/surface_matches.h"
#include "pipeline/run/until_stopped.h"
#include "scene/agreement/photo_pairs.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Settings for match_pairs.
struct MatchSettings {
    int long_side;  ///< longer side of the reduced photos, px
    int corners;    ///< maximum per photo
    unsigned threads;
    OnProgress progress{};  ///< called after each photo; may be empty
};

/// Result of match_pairs: the pairs in the given order, and the tracks of all photos.
struct Matching {
    std::vector<package::PairRecord> pairs;
    std::vector<Track> tracks;
};

/// Matches pairs of photos through the model, using `poses`. `pairs` must be sorted by their first photo.
/// Throws Error(damaged).
Matching match_pairs(const MatchViews& views, std::span<const package::PhotoRecord> photos,
                     std::span<const Pose> poses, std::span<const PhotoPair> pairs, const MatchSettings& how);

/// Whether the pair has at least 20 matches and contradicts() is false for it.
bool trusted(const package::PairRecord& pair);
/// Whether at least 20 corners were compared and fewer than a quarter of them matched, which means that the
/// photos do not show the same surface.
bool contradicts(const package::PairRecord& pair);

/// Median of the trusted pairs' median displacements, in px: over all pairs, over the pairs that contain a
/// photo, or over those that do not. 0 if there are no such pairs.
double median_displacement(std::span<const package::PairRecord> pairs);
double median_displacement(std::span<const package::PairRecord> pairs, std::uint32_t photo);
double median_displacement_without(std::span<const package::PairRecord> pairs, std::uint32_t photo);

}  // namespace vantage

#pragma once
#include <future>

#include "pipeline/decoded_ahead.h"
#include "pipeline/former.h"
#include "pipeline/geometry_stages.h"
#include "pipeline/identity_cache.h"
#include "pipeline/stage_keys.h"

namespace vantage {

/// What every photo's stages read.
struct PhotoStages {
    const SceneInput& scene;
    const SceneKey& key;
    const GeometryStages& geometry;
    std::span<const Pose> poses;  ///< relative to the origin: as given, or registered
    IdentityCache& identities;
    DecodedAhead& ahead;
    const std::vector<std::unique_ptr<Former>>& formers;
    bool strict;  ///< a photo that cannot be read ends it all
};

/// Brings photo `i` through all stages into the package and completes its record and state: what earlier runs
/// left is kept where it was made from the same, the rest is made; on a spare core what comes from the model,
/// while the photo is decoded and cut. A photo that cannot be decoded is left out, and its state says why.
/// Returns the stages that were made. Thread-safe for different photos. Throws Error.
std::vector<package::Stage> run_photo(const PhotoStages& stages, std::uint32_t i, bool spare_core,
                                      package::PhotoRecord& record, package::PhotoState& state);

/// The stages that a photo goes through: all, or for a held-out one its geometry only.
std::vector<package::Stage> stages_of(const package::PhotoRecord& record);

}  // namespace vantage

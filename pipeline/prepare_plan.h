#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/identity_cache.h"
#include "pipeline/package_layout.h"
#include "pipeline/prepare.h"
#include "scene/package_writer.h"

namespace vantage {

/// What is known of the photos while they are prepared, each by its own thread.
struct PhotoTables {
    std::vector<package::PhotoRecord> records;
    std::vector<package::PhotoState> states;
};

/// All that is settled before the first photo is begun.
struct PreparePlan {
    PackedModel model;
    PhotoTables photos;
    std::string meta;
    std::vector<ChunkPlan> chunks;
    std::uint64_t names;  ///< a checksum of the photos', in order
};

/// Gives cameras for photos of at most `longest` pixels on the long side.
void reduce_photos(SceneInput& scene, int longest);

/// The model as it is packed; the scene's mesh is divided and ordered alike.
PackedModel make_model(SceneInput& scene, const PrepareSettings& settings, Trace* trace);

/// Fills in the rest of a plan that holds the model.
void complete_plan(PreparePlan& plan, const SceneInput& scene, const PrepareSettings& settings,
                   const PrepareRun& run, IdentityCache& identities);

}  // namespace vantage

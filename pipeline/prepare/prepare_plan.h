#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/input/identity_cache.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/mesh/point_tree.h"
#include "pipeline/prepare/photo/photo_tables.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/trace.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// The decisions made before the first photo is processed.
struct PreparePlan {
    package::SceneRecord scene{};
    std::vector<EffectDecision> effects;
    PointTree points;  ///< empty if the effect `points` is off
    PhotoTables photos;
    std::vector<std::string> image_sets{""};  ///< names, see ImageSet
    std::string meta;
    std::vector<ChunkPlan> chunks;
    std::uint64_t names = 0;  ///< checksum of the photos' names, in order
};

/// Throws if the scene cannot be prepared: Error(usage) if it consists only of points and the effect `points`
/// is off, or Error(input) if the mesh has no triangles.
void expect_usable(const SceneInput& scene, const PrepareSettings& settings);

/// Scales the cameras to photos that are reduced to at most `longest` pixels on the longer side.
void reduce_photos(SceneInput& scene, int longest);

/// Subdivides the model, compares it with the reference meshes, and clusters and packs it. The scene's mesh
/// is subdivided and reordered in the same way.
PackedModel make_model(SceneInput& scene, const PrepareSettings& settings, Trace* trace);

/// Inspects the scene and plans the chunks of the package or shard. Throws Error(input), or Error(usage) if a
/// photo to be held out is not in the scene.
PreparePlan make_plan(const PackedModel& model, const SceneInput& scene, const PrepareSettings& settings,
                      Share share, IdentityCache& identities, Trace* trace);

}  // namespace vantage

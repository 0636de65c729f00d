#pragma once
#include <future>

#include "pipeline/gl_thread.h"
#include "pipeline/package_layout.h"
#include "pipeline/ray_scene.h"
#include "pipeline/stages/photo_geometry.h"

namespace vantage {

/// What every photo's stages read.
struct PhotoStages {
    const SceneInput& scene;
    const PrepareSettings& settings;
    const PackedModel& model;
    const ModelBuffers& buffers;
    GlThread& gl;
    PackageWriter& writer;
    DistanceMethod distance;  ///< settled, not automatic
    std::shared_future<RayScene> rays;
};

/// Takes photo `i` through all stages into the package and completes its record. The OpenGL work runs while
/// the photo is decoded and cut. Thread-safe for different photos. Throws Error.
void run_photo(const PhotoStages& stages, std::uint32_t i, package::PhotoRecord& record);

}  // namespace vantage

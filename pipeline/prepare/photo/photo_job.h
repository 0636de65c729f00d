#pragma once
#include <span>

#include "pipeline/input/identity_cache.h"
#include "pipeline/input/photo_prefetch.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/run/trace.h"
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// Inputs and outputs that the stages of all photos share.
struct PhotoContext {
    const SceneInput& scene;
    const SceneKey& key;
    const GeometryContext& geometry;
    std::span<const Pose> poses;  ///< relative to the origin; given or refined
    IdentityCache& identities;
    PhotoPrefetch& prefetch;
    const EarlierPackages& earlier;
    PackageWriter& writer;
    Trace* trace;  ///< may be null
    bool strict;   ///< an unusable photo ends the run
};

/// A photo in flight.
struct PhotoJob {
    const PhotoContext& context;
    const PhotoInput& photo;
    PosedPhoto at;
    bool spare_core;  ///< a core is idle and no other photo needs that core
};

}  // namespace vantage

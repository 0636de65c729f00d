#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Reads mesh and cameras, finds each camera's photo (by path, file name or name without extension),
/// completes cameras of unknown size from the photos' headers, checks all. Photos or cameras without the
/// other, unreadable photos, those of another shape than their camera, and cameras that are none are left
/// out; none left, two cameras of a photo or two photos of one name are an Error(input).
SceneInput read_scene(const InputFiles& files);

}  // namespace vantage

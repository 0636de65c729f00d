#pragma once
#include "pipeline/scene_input.h"

namespace vantage {

/// Reads mesh and cameras, finds each camera's photo (by path, file name or name without extension),
/// completes cameras of unknown size from the photos' headers, checks all. Photos or cameras without the
/// other are warnings; none left, two photos of one name, or a photo of another shape than its camera is an
/// Error(input).
SceneInput read_scene(const InputFiles& files);

}  // namespace vantage

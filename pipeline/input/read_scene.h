#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Reads the mesh, the meshes to compare it with and the cameras, finds each camera's photo by
/// match_photos(), takes image sizes that a camera lacks from the photos' headers, and validates everything.
/// Left out are photos without a camera, cameras without a photo, unreadable photos, photos whose aspect
/// ratio differs from their camera's, and invalid cameras. Throws Error(input) if no photo is left or a photo
/// has two cameras, Error(usage) if two meshes to compare with have the same name.
SceneInput read_scene(const InputFiles& files);

}  // namespace vantage

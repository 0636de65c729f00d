#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Reads the mesh, the meshes to compare it with and the cameras, finds each camera's photo by
/// match_photos(), takes image sizes that a camera lacks from the photos' headers, and validates everything.
/// Skipped are photos without a camera, cameras without a photo, unreadable photos, photos whose aspect
/// ratio differs from their camera's, and invalid cameras. Moves the cameras into the mesh's frame by
/// `align`. Without a mesh, a cloud is enough: cameras and photos may then be missing. Throws Error(input) if
/// there is a mesh and no photo is left, or if a photo has two cameras, Error(usage) if two meshes to compare
/// with have the same name.
SceneInput read_scene(const InputFiles& files);

}  // namespace vantage

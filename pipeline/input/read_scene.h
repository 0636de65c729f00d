#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Reads the mesh, its reference meshes and the cameras, finds each camera's photo by match_photos(), takes
/// missing image sizes from the photos' headers, and validates everything. Skips photos without a camera,
/// cameras without a photo, unreadable photos, photos whose aspect ratio differs from their camera's, and
/// invalid cameras. Transforms the cameras to the mesh's frame with `align`. Without a mesh, a cloud is
/// enough: cameras and photos may then be missing. Throws Error(input) if there is a mesh but no usable
/// photo, or if a photo has two cameras. Throws Error(usage) if two reference meshes have the same name.
SceneInput read_scene(const InputFiles& files);

}  // namespace vantage

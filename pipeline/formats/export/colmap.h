#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "scene/camera.h"

namespace vantage {

/// A photo's file name and its camera.
struct NamedCamera {
    std::string photo;
    Camera camera;
};

/// Writes cameras.txt and images.txt (COLMAP text: PINHOLE, or OPENCV for a lens of that model with four
/// terms), a camera a photo, to full double precision. Throws Error(storage), and Error(input) for a lens
/// that has no such model.
void write_colmap_text(const std::filesystem::path& folder, std::span<const NamedCamera> photos);

}  // namespace vantage

#pragma once
#include <filesystem>

namespace vantage {

/// Packages for tests of the window. Each is created once per process, on first use. Tests that write beside
/// a package use a copy.
enum class WindowScene {
    tiny,        ///< a building in five photos
    garden,      ///< with a background, glass, a scalar field and a point cloud
    image_sets,  ///< in visible light and infrared
    many         ///< sixty photos around the building, whose names have a different order
};
std::filesystem::path package_of(WindowScene scene);
/// The images.txt (COLMAP) of the scene's photos.
std::filesystem::path images_of(WindowScene scene);

}  // namespace vantage

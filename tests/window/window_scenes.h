#pragma once
#include <filesystem>

namespace vantage {

/// Packages for tests of the window, each made once per process, when it is first asked for. Tests that write
/// beside a package take a copy.
enum class WindowScene {
    tiny,        ///< a building in five photos
    garden,      ///< with a background, glass, a scalar field and a point cloud
    image_sets,  ///< in visible light and infrared
    many         ///< sixty photos around the building, whose names are in another order
};
std::filesystem::path package_of(WindowScene scene);
/// COLMAP's images.txt of its photos.
std::filesystem::path images_of(WindowScene scene);

}  // namespace vantage

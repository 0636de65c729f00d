#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/formats/images/image_files.h"
#include "scene/camera.h"
#include "scene/mesh.h"

namespace vantage {

/// A photo and its camera.
struct PhotoInput {
    std::string name;  ///< file name without folders
    std::filesystem::path file;
    Camera camera;
    PhotoSize decoded{};  ///< in the camera's orientation; larger than the camera's if photos are reduced
    std::filesystem::path stencil{};  ///< image, black where the photo must not be shown; empty: none
};

/// Where the parts of an input are.
struct InputFiles {
    std::filesystem::path mesh;
    std::filesystem::path cameras;  ///< a file, or a COLMAP folder
    std::filesystem::path photos;   ///< a folder
};

/// A photo that cannot be used, and the reason.
struct UnusablePhoto {
    std::string photo, why;
};

/// Everything `prepare` starts from.
struct SceneInput {
    InputFiles files;
    std::string camera_format;  ///< display name: "COLMAP text", "Bundler", ...
    Mesh mesh;
    std::vector<PhotoInput> photos;       ///< sorted by name
    std::vector<UnusablePhoto> left_out;  ///< sorted by name; found unusable before decoding
    std::vector<std::string> warnings;
};

}  // namespace vantage

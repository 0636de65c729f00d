#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/formats/images/image_files.h"
#include "scene/camera.h"
#include "scene/mesh.h"

namespace vantage {

/// A photo's file, its name (without folders) and its camera.
struct PhotoInput {
    std::string name;
    std::filesystem::path file;
    Camera camera;
    PhotoSize decoded{};  ///< of the file as the camera sees it; larger than the camera's where reduced
    std::filesystem::path stencil{};  ///< black where the photo is not to be shown; empty where it has none
};

/// The files an input was found to consist of.
struct InputFiles {
    std::filesystem::path mesh, cameras, photos;
};

/// A photo that cannot be used, and why.
struct UnusablePhoto {
    std::string photo, why;
};

/// Everything `prepare` starts from. Photos are sorted by name.
struct SceneInput {
    InputFiles files;
    std::string camera_format;  ///< for people: "COLMAP text", "Bundler", ...
    Mesh mesh;
    std::vector<PhotoInput> photos;
    std::vector<UnusablePhoto> left_out;  ///< sorted by name; of those that show before a photo is decoded
    std::vector<std::string> warnings;
};

}  // namespace vantage

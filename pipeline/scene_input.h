#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace vantage {

/// A photo's file, its name (without folders) and its camera.
struct PhotoInput {
    std::string name;
    std::filesystem::path file;
    Camera camera;
};

/// The files an input was found to consist of.
struct InputFiles {
    std::filesystem::path mesh, cameras, photos;
};

/// Everything `prepare` starts from. Photos are sorted by name.
struct SceneInput {
    InputFiles files;
    std::string camera_format;  ///< for people: "COLMAP text", "Bundler", ...
    Mesh mesh;
    std::vector<PhotoInput> photos;
    std::vector<std::string> warnings;
};

}  // namespace vantage

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
    std::string name;  ///< file name without folders, or with them joined by _ if photos share a name; UTF-8
    std::filesystem::path file;
    Camera camera;
    PhotoSize decoded{};  ///< in the camera's orientation; larger than the camera's if photos are reduced
    std::filesystem::path stencil{};  ///< image, black where the photo must not be shown; empty: none
    bool linear = false;              ///< its file holds linear light
};

/// Where the parts of an input are.
struct InputFiles {
    std::filesystem::path mesh;
    std::filesystem::path cameras;     ///< a file, or a COLMAP folder
    std::filesystem::path photos;      ///< a folder
    std::vector<std::string> notes{};  ///< what else was found and not taken
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

#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/camera.h"

namespace vantage {

/// Cameras as a file gives them.
struct CameraSet {
    struct Entry {
        std::string photo;  ///< as the file names it, folders included
        Camera camera;      ///< where `size_known` is false, focal lengths and lens only
        bool size_known;    ///< false for Bundler: the principal point is the photo's centre
    };
    std::string format;
    std::vector<Entry> entries;
    std::vector<std::string> warnings;
};

/// A COLMAP folder (text or binary), a Bundler .out file or a MeshLab .mlp project. Throws Error(input)
/// naming file and item.
CameraSet read_cameras(const std::filesystem::path& path);

CameraSet read_colmap_text(const std::filesystem::path& folder);
CameraSet read_colmap_binary(const std::filesystem::path& folder);
/// The photos' names come from list.txt, or NAME.list.txt, beside the file.
CameraSet read_bundler(const std::filesystem::path& file);
/// Rasters of a MeshLab project. CenterPx is taken from the photo's upper left corner, as the programs that
/// write such projects with an off-centre principal point do (MeshLab itself uses it for the size alone). A
/// mesh that the project moves is an error, because the mesh is read apart from it.
CameraSet read_meshlab(const std::filesystem::path& file);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scene/camera.h"

namespace vantage {

/// The cameras of a file.
struct CameraSet {
    struct Entry {
        std::string photo;  ///< name in the file, folders included
        Camera camera;      ///< size and principal point are set only if `size_known`
        bool size_known;    ///< false for Bundler, whose principal point is the photo's center
    };
    std::string format;  ///< display name: "COLMAP text", "Bundler", ...
    std::vector<Entry> entries;
    std::vector<std::string> warnings;
};

/// A camera format: a file, or a folder of files with fixed names.
struct CameraFormat {
    const char* name;                ///< in messages: "Bundler"
    const char* form;                ///< what the user passes, in messages: ".out"
    std::vector<const char*> files;  ///< names of the files in the folder; empty if the format is one file
    bool (*matches)(const std::filesystem::path& path);
    CameraSet (*read)(const std::filesystem::path& path);  ///< of a path that matches
    /// Other files that read() reads; null if there are none.
    std::vector<std::filesystem::path> (*companions)(const std::filesystem::path& path) = nullptr;
};

/// All formats; if several match, the first is read.
std::span<const CameraFormat> camera_formats();

/// The formats for messages: "COLMAP folder (...), Bundler .out, ...".
std::string camera_format_names();

/// The files that read_cameras reads: those of the first format that matches, or `path` if none does.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& path);

/// Reads cameras in the first format that matches. This and the readers below throw Error(input) naming the
/// file and the item.
CameraSet read_cameras(const std::filesystem::path& path);

CameraSet read_colmap_text(const std::filesystem::path& folder);
CameraSet read_colmap_binary(const std::filesystem::path& folder);
/// Photo names come from list.txt or NAME.list.txt next to the file, or from list.txt in the folder above.
CameraSet read_bundler(const std::filesystem::path& file);
/// The list of photo names that read_bundler reads; empty if there is none.
std::filesystem::path bundler_list(const std::filesystem::path& file);
/// Reads the rasters of a MeshLab project. CenterPx is measured from the photo's upper left corner, as in
/// programs that write projects with an off-center principal point (MeshLab itself uses it for the size
/// only). A mesh with a transformation is an error, because the mesh is not read through the project.
CameraSet read_meshlab(const std::filesystem::path& file);

}  // namespace vantage

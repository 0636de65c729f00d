#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "scene/camera/camera.h"
#include "scene/camera/similarity.h"

namespace vantage {

/// The Error(input) that is thrown for a valid file in which no camera has a pose.
class NoCamera : public Error {
  public:
    explicit NoCamera(const std::string& message) : Error(Exit::input, message) {}
};

/// The cameras of a file.
struct CameraSet {
    /// The unit of the intrinsics. If the file does not state the size of the photo, it is read from the
    /// photo.
    enum class Unit {
        pixels,              ///< the size is known
        pixels_from_corner,  ///< the size is unknown
        pixels_from_center,  ///< measured from the photo's center, as in the following units
        photo_width,
        longer_side
    };
    struct Entry {
        std::string photo;  ///< name in the file, folders included
        Camera camera;
        Unit unit = Unit::pixels;
        std::string group = {};  ///< a group of photos in the file, possibly their folder; may be empty
    };
    std::string format;  ///< display name: "COLMAP text", "Bundler", ...
    std::vector<Entry> entries;
    std::vector<std::string> warnings;
    /// The file's own transform from its frame to the mesh's, already applied to `entries`; if the transforms
    /// of the entries differ, this is that of the first.
    Similarity transform{};
};

/// A camera format: a file, or a folder of files with fixed names.
struct CameraFormat {
    const char* name;                ///< in messages: "Bundler"
    const char* form;                ///< the argument that the user passes, in messages: ".out"
    std::vector<const char*> files;  ///< names of the files in the folder; empty if the format is one file
    bool (*matches)(const std::filesystem::path& path);    ///< whether the file or folder has this format
    CameraSet (*read)(const std::filesystem::path& path);  ///< reads a path that matches
    /// Further files that read() reads; null if there are none.
    std::vector<std::filesystem::path> (*companions)(const std::filesystem::path& path) = nullptr;
    bool one_per_photo = false;  ///< whether there is one file per photo; read() then takes the folder
};

/// All formats; a file is read by the first that matches it.
std::span<const CameraFormat> camera_formats();

/// The names of the formats for messages, as in "COLMAP folder (...), Bundler .out, ...".
std::string camera_format_names();

/// The files that read_cameras reads: those of the first format that matches, or `path` if none does.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& path);

/// Reads cameras in the first format that matches. This function and the readers below throw Error(input),
/// which names the file and the item.
CameraSet read_cameras(const std::filesystem::path& path);

CameraSet read_colmap_text(const std::filesystem::path& folder);
CameraSet read_colmap_binary(const std::filesystem::path& folder);
/// Photo names come from list.txt or NAME.list.txt next to the file, or from list.txt in the folder above.
CameraSet read_bundler(const std::filesystem::path& file);
/// The list of photo names that read_bundler reads; empty if there is none.
std::filesystem::path bundler_list(const std::filesystem::path& file);
/// Reads the rasters of a MeshLab project. CenterPx is measured from the photo's upper left corner, as in
/// programs that write projects with an off-center principal point (MeshLab itself uses it only for the
/// size). A mesh with a transformation is an error, because the mesh is not read through the project.
CameraSet read_meshlab(const std::filesystem::path& file);
/// Agisoft Metashape's cameras.xml, including that of PhotoScan before 1.0. Reads the chunk with the most
/// poses. Skips cameras that are disabled, belong to a rig, lack a pose, or have a lens other than `frame`.
CameraSet read_metashape(const std::filesystem::path& file);
/// The XMP sidecars of RealityCapture and RealityScan in a folder.
CameraSet read_realitycapture_xmp(const std::filesystem::path& folder);
/// A list of cameras with user-selected columns; the angles omega, phi and kappa are rejected, because their
/// meaning differs between versions.
CameraSet read_realitycapture_csv(const std::filesystem::path& file);
/// The JSON .sfm files of Meshroom and AliceVision.
CameraSet read_meshroom(const std::filesystem::path& file);
/// sfm_data.json.
CameraSet read_openmvg(const std::filesystem::path& file);
/// reconstruction.json of OpenSfM and OpenDroneMap; if it contains several reconstructions, the largest is
/// read.
CameraSet read_opensfm(const std::filesystem::path& file);
/// transforms.json of nerfstudio and instant-ngp.
CameraSet read_transforms(const std::filesystem::path& file);
/// Blocks Exchange XML of ContextCapture and iTwin Capture.
CameraSet read_blocks_exchange(const std::filesystem::path& file);
/// .rzml of MatchMover and ImageModeler (REALVIZ, Autodesk): the frames of a sequence.
CameraSet read_matchmover(const std::filesystem::path& file);

}  // namespace vantage

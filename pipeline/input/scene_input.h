#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/input/file_identity.h"
#include "pipeline/photos/image_files.h"
#include "scene/camera/camera.h"
#include "scene/camera/similarity.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// A photo and its camera.
struct PhotoInput {
    std::string name;  ///< file name; includes folders, joined by _, if names collide; UTF-8
    std::filesystem::path file;
    Camera camera;
    PhotoSize decoded{};              ///< size in the camera's orientation, before any reduction
    std::filesystem::path mask{};     ///< image, black where the photo must not be shown; may be empty
    bool linear = false;              ///< whether the file stores linear light
    ProfileUse profile{};             ///< use of the file's ICC profile
    std::vector<StampedFile> read{};  ///< photo and mask, stamped before the photo's header was read
    std::uint32_t image_set = 0;      ///< index into SceneInput::image_sets
    int orientation = 1;              ///< EXIF
    int open_turn = 0;  ///< EXIF orientation that the pixels may still need to fit their camera; 0 if none
};

/// The paths of an input's parts.
struct InputFiles {
    std::filesystem::path mesh;     ///< empty in a point-only scene
    std::filesystem::path cameras;  ///< a file, or a COLMAP folder; empty without photos
    std::filesystem::path photos;   ///< a folder; empty in a point-only scene without photos
    std::vector<std::filesystem::path>
        compared{};  ///< meshes or clouds from which the mesh's deviation is measured
    std::vector<std::filesystem::path> points{};  ///< point clouds to show, with the mesh or alone
    std::vector<std::string> notes{};             ///< other files found but not used
    std::vector<std::filesystem::path>
        more_cameras{};  ///< like `cameras`, each for the photos in its own folder below `photos`
    std::string image_sets = "auto";    ///< grouping into image sets; see group_image_sets()
    std::optional<Similarity> align{};  ///< transform from the cameras' frame to the mesh's, if they differ
    /// Further files that read_mesh() read for `mesh` and `compared`.
    std::map<std::filesystem::path, std::vector<std::filesystem::path>> companions{};
};

/// The companions of one of the meshes.
inline std::vector<std::filesystem::path> companions_of(const std::filesystem::path& mesh,
                                                        const InputFiles& files) {
    const auto found = files.companions.find(mesh);
    return found == files.companions.end() ? std::vector<std::filesystem::path>() : found->second;
}

/// The reason to skip a photo without a camera.
inline constexpr const char* without_camera = "has no camera";

/// An unusable photo, and the reason.
struct UnusablePhoto {
    std::string photo, why;
    std::filesystem::path file{};  ///< empty if there is no file, or if its content does not matter
};

/// The complete input of `prepare`.
struct SceneInput {
    InputFiles files;
    std::string camera_format;           ///< display name: "COLMAP text", "Bundler", ...
    std::string convention = "as-read";  ///< conventions applied to all cameras; see apply_conventions()
    Similarity transform{};              ///< the camera file's own transform from its frame to the mesh's
    Mesh mesh;
    std::vector<Mesh> compared;          ///< the meshes of files.compared
    Mesh points;                         ///< all files.points joined; without triangles
    std::vector<PhotoInput> photos;      ///< sorted by name
    std::vector<UnusablePhoto> skipped;  ///< photos found unusable before decoding, sorted by name
    std::vector<std::string> warnings;
    std::vector<StampedFile> read{};  ///< meshes, cameras and skipped photos, stamped before they were read
    std::vector<std::string> image_sets{
        ""};  ///< names, the default image set first; a single image set may have no name
};

/// Whether there is a cloud and no mesh.
inline bool has_points_only(const SceneInput& scene) {
    return scene.files.mesh.empty() && !scene.files.points.empty();
}

}  // namespace vantage

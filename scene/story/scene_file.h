#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/similarity.h"
#include "scene/story/placement.h"

namespace vantage {

/// One object of a scene file. In the file, paths are relative to its folder.
struct SceneObject {
    std::string name;
    std::filesystem::path package;  ///< or URL; empty if the object is not yet prepared
    Placement placement;
    bool shown = true;
    double opacity = 1;  ///< 0 to 1; below 1, objects behind it are visible through its surface
    /// Inputs for preparation: a folder, or mesh, cameras and photos separately; and point clouds to show
    /// with the object.
    struct Input {
        std::filesystem::path folder, mesh, cameras, photos;
        std::vector<std::filesystem::path> points;
        std::optional<Similarity> align{};  ///< transforms the cameras' frame into the mesh's, if they differ
    } input{};
    /// The transform from the object's own coordinates to the scene's, in place of `placement`.
    std::optional<Similarity> matrix{};
};

/// Why a scene file is read: `show` needs packages, `prepare` needs inputs.
enum class SceneUse { show, prepare };

/// Whether the path names a scene file, *.toml.
bool is_scene_file(const std::filesystem::path& file);

/// Reads a list of objects, each with `package` or its inputs (`input`, or `mesh`, `cameras` and `photos`;
/// `points`; `align`, 3 rows of 4 numbers), and optionally `name`, `move`, `turn` and `scale`, or `matrix`, 4
/// rows of 4 numbers, `shown` and `opacity`:
///
///     [[object]]
///     package = "altar.vantage"
///     move = [2.5, 0, 0]
///
/// The first object is not moved, turned or scaled. Paths are converted to be relative to the current folder;
/// a missing name defaults to that of the package or input. Throws Error(input) naming the file and the key
/// that is missing, unknown, of the wrong type, not finite or out of range, or a name that is not unique or
/// not usable as a file name.
std::vector<SceneObject> read_scene_file(const std::filesystem::path& file, SceneUse use);

/// The text of a scene file in `folder`, with the paths of packages, or of inputs for objects without a
/// package, relative to that folder.
std::string scene_file_text(const std::vector<SceneObject>& objects, const std::filesystem::path& folder);
/// Writes a scene file, with the packages' paths relative to its folder. Replaces any existing file. Throws
/// Error(storage).
void write_scene_file(const std::filesystem::path& file, const std::vector<SceneObject>& objects);

}  // namespace vantage

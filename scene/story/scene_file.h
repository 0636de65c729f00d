#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/similarity.h"
#include "scene/story/placement.h"

namespace vantage {

/// One object of a scene file. In the file, paths are relative to the file's folder.
struct SceneObject {
    std::string name;
    std::filesystem::path package;  ///< path or URL; empty if the object is not yet prepared
    Placement placement;
    bool shown = true;
    double opacity = 1;  ///< 0 to 1; below 1, objects behind it are visible through its surface
    /// Inputs for preparation: a folder, or a mesh, cameras and photos separately, and point clouds to show
    /// with the object.
    struct Input {
        std::filesystem::path folder, mesh, cameras, photos;
        std::vector<std::filesystem::path> points;
        std::optional<Similarity> align{};  ///< transforms the cameras' frame into the mesh's, if they differ
    } input{};
    /// If set, replaces `placement`: the transform from the object's own coordinates to the scene's.
    std::optional<Similarity> matrix{};
};

/// The purpose of reading a scene file: `show` needs packages, `prepare` needs inputs.
enum class SceneUse { show, prepare };

/// Whether the path names a scene file (*.toml).
bool is_scene_file(const std::filesystem::path& file);

/// Reads a list of objects. Each object has a `package` or inputs: `input`, or `mesh`, `cameras` and
/// `photos`; `points`; and `align`, 3 rows of 4 numbers. Optional keys are `name`; `move`, `turn` and
/// `scale`, or instead `matrix`, 4 rows of 4 numbers; `shown`; and `opacity`. For example:
///
///     [[object]]
///     package = "altar.vantage"
///     move = [2.5, 0, 0]
///
/// The first object is not moved, turned or scaled. The paths in the result are relative to the current
/// folder. A missing name defaults to that of the package or input. Throws Error(input), which names the file
/// and the key, if a key is missing or unknown, if a value has the wrong type, is not finite or is out of
/// range, or if a name is not unique or cannot be a file name.
std::vector<SceneObject> read_scene_file(const std::filesystem::path& file, SceneUse use);

/// The text of a scene file in `folder`. The paths of packages, or of the inputs of objects without a
/// package, are relative to that folder.
std::string scene_file_text(const std::vector<SceneObject>& objects, const std::filesystem::path& folder);
/// Writes a scene file, with the packages' paths relative to its folder. Replaces any existing file. Throws
/// Error(storage).
void write_scene_file(const std::filesystem::path& file, const std::vector<SceneObject>& objects);

}  // namespace vantage

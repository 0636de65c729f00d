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
    std::filesystem::path package;  ///< or URL; empty if the object is still to be prepared
    Placement placement;
    bool shown = true;
    double opacity = 1;  ///< 0 to 1; below 1, what is behind shows through its surface
    /// What to prepare it from: a folder, or the three parts by themselves; and point clouds to show with it.
    struct Input {
        std::filesystem::path folder, mesh, cameras, photos;
        std::vector<std::filesystem::path> points;
        std::optional<Similarity> align{};  ///< from the cameras' frame to the mesh's, if they differ
    } input{};
    /// In place of `placement`, from the object's own coordinates to the scene's.
    std::optional<Similarity> matrix{};
};

/// What a scene file is read for: `show` needs packages, `prepare` needs inputs.
enum class SceneUse { show, prepare };

/// Whether a name is that of a scene file, *.toml.
bool is_scene_file(const std::filesystem::path& file);

/// Reads a list of objects, each with `package` or what it is prepared from (`input`, or `mesh`, `cameras`
/// and `photos`; `points`; `align`, 3 rows of 4 numbers), and if wanted `name`, `move`, `turn` and `scale`,
/// or `matrix`, 4 rows of 4 numbers, and `shown` and `opacity`:
///
///     [[object]]
///     package = "altar.vantage"
///     move = [2.5, 0, 0]
///
/// The first one is not moved, turned or scaled. Paths become paths from the current folder; a name that is
/// not given is that of the package or input. Throws Error(input) naming the file and the key that is
/// missing, unknown, of the wrong type, not finite or out of range, or a name that two objects have or that
/// cannot be a file's.
std::vector<SceneObject> read_scene_file(const std::filesystem::path& file, SceneUse use);

/// The text of such a file, with packages, or the inputs of objects without one, relative to its folder
/// `folder`.
std::string scene_file_text(const std::vector<SceneObject>& objects, const std::filesystem::path& folder);
/// Writes it, with packages relative to its own folder. Replaces any file of that name. Throws
/// Error(storage).
void write_scene_file(const std::filesystem::path& file, const std::vector<SceneObject>& objects);

}  // namespace vantage

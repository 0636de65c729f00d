#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "base/text/error.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Searches a folder, three levels deep, for a mesh (a PLY with faces, OBJ, STL or OFF, or if there is none,
/// glTF, GLB or FBX; preferably mesh.*, else the largest file), cameras (in the order of camera_formats(), of
/// several the file with the most) and the photos' folder: the one where most cameras find their photo,
/// preferably one named images or photos. If several folders, each with the photos of an image set (see
/// image_set_folder), have a camera file each, all are taken. Follows symbolic links, ignores hidden files.
/// Alternatives that were not taken are listed in `notes`. Parts in `given` are not searched for, and no file
/// of `given.compared` or `given.points` is taken for the mesh. Without a mesh, the largest point cloud (a
/// PLY without faces, or a file of cloud.h) is taken in its place, and cameras and photos may be missing.
/// Throws Error(input) stating what is missing, or if there are several camera files and one is unreadable,
/// because it might be the right one.
InputFiles discover(const std::filesystem::path& folder, const InputFiles& given = {});

/// The parts found in a folder and, if any is missing, the error that discover() throws.
struct FoundInput {
    InputFiles files;
    std::optional<Error> lacks;
};
/// As discover(), but continues if a part is missing. Throws Error(input) only if the folder cannot be read.
FoundInput search(const std::filesystem::path& folder, const InputFiles& given = {});

}  // namespace vantage

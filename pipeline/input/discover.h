#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "base/text/error.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Searches a folder, three levels deep, for a mesh, cameras and the photos' folder. The mesh is a PLY with
/// faces, an OBJ, an STL or an OFF; if there is none, a glTF, GLB or FBX. mesh.* is preferred, then the
/// largest file. The camera file is the one that fits the most photos; if several fit equally many, it is the
/// one whose format comes first in camera_formats(). The photos' folder is the one where the most cameras
/// find their photos, preferably one named images or photos. If several folders each contain the photos of an
/// image set (see image_set_folder()) and a camera file, all these camera files are used. Follows symbolic
/// links and ignores hidden files. Alternatives that were not chosen are listed in `notes`. Parts in `given`
/// are not searched for, and no file of `given.compared` or `given.points` is used as the mesh. Without a
/// mesh, the largest point cloud (a PLY without faces, or a file of cloud.h) takes its place, and cameras and
/// photos may be missing. Throws Error(input) if a part is missing, or if there are several camera files and
/// one is unreadable, because it might be the right one.
InputFiles discover(const std::filesystem::path& folder, const InputFiles& given = {});

/// The parts found in a folder and, if any is missing, the error that discover() throws.
struct FoundInput {
    InputFiles files;
    std::optional<Error> lacks;
};
/// Like discover(), but continues if a part is missing. Throws Error(input) only if the folder cannot be
/// read.
FoundInput search(const std::filesystem::path& folder, const InputFiles& given = {});

}  // namespace vantage

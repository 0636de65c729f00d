#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// The numbers of extracted elements; 0 for elements that the package does not have.
struct Extracted {
    std::size_t photos = 0, vertices = 0, triangles = 0, points = 0;
};

/// Writes a package's contents to `folder` as ordinary files, which prepare() can read again.
/// `photos/NAME.png` or `.jpg` holds level 0 as taken or, with `undistorted`, as captured by a pinhole
/// camera. `weights/NAME.png` holds angle, depth, border and transient masking at half size, for the pinhole
/// camera. `depth/NAME.exr` holds linear z at half size, for the pinhole camera (+inf: unseen). `mesh.ply`
/// and `points.ply` hold doubles in input coordinates. `sparse/` holds the cameras of these photos as COLMAP
/// text, with refined poses, as doubles in input coordinates. Photos whose lens COLMAP cannot express are
/// undistorted. NAME has no extension, unless other photos have the same name, and includes a folder for the
/// image set if there are several. Extracts the photos in `names`, or all photos if `names` is empty; photos
/// without pixels are omitted. Replaces only pictures, meshes and cameras that an earlier call may have
/// written; with `force`, replaces any file except inputs of the package. The mesh is that of the package, in
/// which large triangles are divided (see subdivide_large_triangles()). Throws Error.
Extracted extract(const std::filesystem::path& package, const std::filesystem::path& folder,
                  const std::vector<std::string>& names, bool undistorted = false, bool force = false);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads a Wavefront OBJ file in double precision: vertices with their colors ("v x y z r g b", see
/// color_bytes(); white if only other vertices have one), normals and polygons, which become triangle fans. A
/// line that ends in a backslash continues on the next, unless the backslash ends a comment or a name. A
/// vertex with several normals gets their sum. Corners that refer to no vertex become `no_vertex`; lines of
/// other kinds are skipped. If faces use a material that is not opaque (according to read_mtl() for the files
/// that `mtllib` names, in the OBJ's folder or below it), all faces get their materials' colors; see
/// color_by_material(). The files read are added to `materials`, even if all are opaque, and so are the paths
/// at which missing files may appear. Missing files and materials and the warnings of read_mtl() are added to
/// `warnings`. Throws Error(input) naming the line.
Mesh read_obj(const std::filesystem::path& file, std::vector<std::string>& warnings,
              std::vector<std::filesystem::path>& materials);

}  // namespace vantage

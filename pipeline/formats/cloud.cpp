#include "pipeline/formats/cloud.h"

#include <algorithm>
#include <cstdint>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/values/main_box.h"
#include "pipeline/formats/las.h"
#include "pipeline/formats/meshes/read_mesh.h"

namespace vantage {

namespace {

bool is_las(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".las" || extension == ".laz";
}

bool is_e57(const std::filesystem::path& file) { return lower_extension(file) == ".e57"; }

}  // namespace

bool is_cloud_file(const std::filesystem::path& file) {
    return lower_extension(file) == ".ply" || is_las(file) || is_e57(file);
}

Mesh read_cloud(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    if (is_e57(file))
        throw Error(
            Exit::input,
            file.string() + ": E57 is not supported; expected LAS or PLY (CloudCompare can convert it)");
    if (has_nodes(file))
        throw Error(Exit::input,
                    file.string() + ": is not a supported point cloud; expected PLY, LAS, OBJ, STL or OFF");
    Mesh cloud = is_las(file) ? read_las(file, warnings) : read_mesh_file(file);
    cloud.triangles = {}, cloud.normals = {}, cloud.scalars = {};
    const std::string name = file.filename().string();
    if (const std::size_t n = drop_points(cloud, [&](std::size_t i) { return !usable(cloud.positions[i]); }))
        warnings.push_back(name + ": " + std::to_string(n) +
                           (n == 1 ? " invalid point dropped" : " invalid points dropped"));
    if (cloud.positions.empty())
        throw Error(Exit::input, file.string() + ": has no point with finite coordinates");
    const MainBox box = main_box(cloud.positions, {});
    const auto stray = [&](std::size_t i) {
        return std::ranges::binary_search(box.strays, std::uint32_t(i));
    };
    if (const std::size_t n = drop_points(cloud, stray))
        warnings.push_back(name + ": " + std::to_string(n) + (n == 1 ? " point" : " points") +
                           " far from all others dropped");
    return cloud;
}

}  // namespace vantage

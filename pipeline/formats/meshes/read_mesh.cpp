#include "pipeline/formats/meshes/read_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "pipeline/formats/coordinate_warnings.h"
#include "pipeline/formats/meshes/assimp_reader.h"
#include "pipeline/formats/meshes/obj.h"
#include "pipeline/formats/meshes/off.h"
#include "pipeline/formats/meshes/openmesh_reader.h"
#include "pipeline/formats/meshes/ply.h"
#include "pipeline/formats/meshes/stl.h"
#include "pipeline/formats/meshes/weld.h"

namespace vantage {
namespace {

bool is_one_of(const std::string& extension, std::initializer_list<const char*> list) {
    return std::ranges::find(list, extension) != list.end();
}

/// Drops triangles with a missing, repeated or unusable vertex and returns their number. Unreferenced
/// vertices are moved onto a referenced one, so that they do not enlarge the model's extent. In a mesh
/// without triangles, unusable vertices are moved onto the first usable one.
std::size_t drop_invalid_triangles(Mesh& mesh) {
    const auto bad = [&](std::uint32_t v) { return v == no_vertex || !usable(mesh.positions[v]); };
    const std::size_t dropped = std::erase_if(mesh.triangles, [&](const auto& t) {
        return bad(t[0]) || bad(t[1]) || bad(t[2]) || t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
    std::vector<bool> used(mesh.positions.size(), false);
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) used[v] = true;
    for (std::size_t v = 0; mesh.triangles.empty() && v < used.size(); ++v)
        used[v] = usable(mesh.positions[v]);
    const auto first = std::ranges::find(used, true) - used.begin();
    const Eigen::Vector3d replacement =
        first == std::ssize(used) ? Eigen::Vector3d::Zero().eval() : mesh.positions[std::size_t(first)];
    for (std::size_t v = 0; v < used.size(); ++v)
        if (!used[v]) mesh.positions[v] = replacement;
    return dropped;
}

/// Gives every vertex a unit normal: its own if it is valid, otherwise the area-weighted mean of its faces'
/// normals.
void complete_normals(Mesh& mesh) {
    mesh.normals.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
    const auto has_direction = [](const Eigen::Vector3f& n) {
        return n.allFinite() && n.squaredNorm() > 1e-12f;
    };
    if (!std::all_of(mesh.normals.begin(), mesh.normals.end(), has_direction)) {
        std::vector<Eigen::Vector3d> sum(mesh.positions.size(), Eigen::Vector3d::Zero());
        for (const auto& t : mesh.triangles) {
            const Eigen::Vector3d n = (mesh.positions[t[1]] - mesh.positions[t[0]])
                                          .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
            for (const std::uint32_t v : t) sum[v] += n;
        }
        for (std::size_t v = 0; v < sum.size(); ++v) {
            if (has_direction(mesh.normals[v])) continue;
            const double length = sum[v].norm();  // 0 for an unreferenced vertex: any normal will do
            mesh.normals[v] =
                length > 0 ? (sum[v] / length).cast<float>().eval() : Eigen::Vector3f::UnitZ().eval();
        }
    }
    for (Eigen::Vector3f& n : mesh.normals) n.stableNormalize();
}

/// Further results of reading a mesh.
struct Found {
    std::vector<std::string>& warnings;
    std::vector<std::filesystem::path> companions{};  ///< further files
    double rounding = 0;  ///< largest error of a coordinate, known from the reader
};

Mesh read_nodes(const std::filesystem::path& file, Found& found) {
    constexpr double meter = 100;  // cm
    AssimpMesh read = read_with_assimp(file);
    found.companions = std::move(read.buffers);
    found.rounding = read.rounding;
    if (read.unit != 0 && read.unit != meter)
        found.warnings.push_back(fmt::format(
            "{}: says that its unit is {:.6g} cm; its coordinates are used as written, in the cameras' unit",
            file.filename().string(), read.unit));
    return std::move(read.mesh);
}

Mesh parse(const std::filesystem::path& file, const std::string& extension, Found& found) {
    if (extension == ".ply") return read_ply(file, found.warnings);
    if (extension == ".obj") return read_obj(file, found.warnings, found.companions);
    if (extension == ".stl") return read_stl(file);
    if (extension == ".off" && !is_binary_off(file)) return read_off(file);
    if (has_nodes(file)) return read_nodes(file, found);
    if (is_usd_file(file))
        throw Error(
            Exit::input,
            file.string() + ": USD is not supported; expected PLY, OBJ or GLB (Blender can convert it)");
    return read_with_openmesh(file);
}

/// Throws Error(input), also if the file has no vertices.
Mesh read_any(const std::filesystem::path& file, const std::string& extension, Found& found) {
    if (!std::filesystem::exists(file)) throw Error(Exit::input, file.string() + ": does not exist");
    if (std::filesystem::is_directory(file))
        throw Error(Exit::input, file.string() + ": expected a file, found a folder");
    Mesh mesh = parse(file, extension, found);
    if (mesh.positions.empty()) throw Error(Exit::input, file.string() + ": has no vertices");
    return mesh;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
    return has_nodes(file) || is_one_of(lower_extension(file), {".ply", ".obj", ".stl", ".off"});
}

bool has_nodes(const std::filesystem::path& file) {
    return is_one_of(lower_extension(file), {".gltf", ".glb", ".fbx"});
}

bool is_usd_file(const std::filesystem::path& file) {
    return is_one_of(lower_extension(file), {".usd", ".usda", ".usdc", ".usdz"});
}

bool usable(const Eigen::Vector3d& p) { return p.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < 1e18; }

std::size_t drop_points(Mesh& cloud, const std::function<bool(std::size_t)>& bad) {
    std::size_t kept = 0;
    const std::size_t all = cloud.positions.size();
    for (std::size_t i = 0; i < all; ++i) {
        if (bad(i)) continue;
        cloud.positions[kept] = cloud.positions[i];
        if (!cloud.colors.empty()) cloud.colors[kept] = cloud.colors[i];
        if (!cloud.normals.empty()) cloud.normals[kept] = cloud.normals[i];
        ++kept;
    }
    cloud.positions.resize(kept);
    if (!cloud.colors.empty()) cloud.colors.resize(kept);
    if (!cloud.normals.empty()) cloud.normals.resize(kept);
    return all - kept;
}

Mesh read_mesh_file(const std::filesystem::path& file) {
    std::vector<std::string> of_materials;  // points have none
    Found found{of_materials};
    return read_any(file, lower_extension(file), found);
}

Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string>& warnings,
               std::vector<std::filesystem::path>* companions) {
    const std::string extension = lower_extension(file);
    Found found{warnings};
    Mesh mesh = read_any(file, extension, found);
    if (companions) *companions = std::move(found.companions);
    if (mesh.points_only()) {
        mesh.scalars = {};
        if (const std::size_t n =
                drop_points(mesh, [&](std::size_t i) { return !usable(mesh.positions[i]); }))
            warnings.push_back(file.filename().string() + ": " + std::to_string(n) +
                               (n == 1 ? " invalid point dropped" : " invalid points dropped"));
        if (mesh.positions.empty())
            throw Error(Exit::input, file.string() + ": has no point with finite coordinates");
    } else if (const std::size_t n = drop_invalid_triangles(mesh))
        warnings.push_back(file.filename().string() + ": " + std::to_string(n) +
                           (n == 1 ? " invalid triangle dropped" : " invalid triangles dropped"));
    if (extension == ".stl" || has_nodes(file)) weld(mesh);
    if (!mesh.points_only() || !mesh.normals.empty()) complete_normals(mesh);
    for (const std::string& w : coordinate_warnings(mesh, found.rounding))
        warnings.push_back(file.filename().string() + ": " + w);
    return mesh;
}

}  // namespace vantage

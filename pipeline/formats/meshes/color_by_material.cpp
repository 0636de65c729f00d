#include "pipeline/formats/meshes/color_by_material.h"

#include <Eigen/Geometry>
#include <bit>
#include <unordered_map>
#include <vector>

namespace vantage {
namespace {

constexpr MaterialColor white{255, 255, 255, 255};

/// Gives vertices without a usable normal the area-weighted mean of their triangles' normals.
void complete_normals(Mesh& mesh, const std::vector<bool>& wanted) {
    mesh.normals.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
    const auto exists = [&](std::uint32_t v) { return v < mesh.positions.size(); };
    std::vector<Eigen::Vector3d> sum(mesh.positions.size(), Eigen::Vector3d::Zero());
    for (const auto& t : mesh.triangles) {
        if (!exists(t[0]) || !exists(t[1]) || !exists(t[2])) continue;
        const Eigen::Vector3d a = mesh.positions[t[0]];
        const Eigen::Vector3d n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
        if (!n.allFinite()) continue;
        for (const std::uint32_t v : t) sum[v] += n;
    }
    for (std::size_t v = 0; v < sum.size(); ++v) {
        const Eigen::Vector3f& n = mesh.normals[v];
        const bool usable = n.allFinite() && n.squaredNorm() > 1e-12f;
        if (wanted[v] && !usable && sum[v].norm() > 0 && sum[v].allFinite())
            mesh.normals[v] = sum[v].stableNormalized().cast<float>();
    }
}

/// Assigns colors to vertices; a vertex that already has a different color is copied.
class Splitter {
  public:
    Splitter(Mesh& mesh, bool keeps_colors)
        : mesh_(mesh), keeps_colors_(keeps_colors), given_(mesh.positions.size(), false) {}

    std::uint32_t colored(std::uint32_t v, const MaterialColor& material) {
        if (v >= given_.size()) return v;  // no vertex
        MaterialColor color = material;
        if (keeps_colors_) std::copy_n(own_[v].begin(), 3, color.begin());
        if (!given_[v]) {
            given_[v] = true;
            mesh_.colors[v] = color;
            return v;
        }
        if (mesh_.colors[v] == color) return v;
        const std::uint64_t key = std::uint64_t(v) << 32 | std::bit_cast<std::uint32_t>(color);
        const auto [copy, is_new] = copies_.try_emplace(key, std::uint32_t(mesh_.positions.size()));
        if (is_new) add_copy(v, color);
        return copy->second;
    }

  private:
    void add_copy(std::uint32_t v, const MaterialColor& color) {
        mesh_.positions.push_back(Eigen::Vector3d(mesh_.positions[v]));
        mesh_.colors.push_back(color);
        if (!mesh_.normals.empty()) mesh_.normals.push_back(Eigen::Vector3f(mesh_.normals[v]));
    }

    Mesh& mesh_;
    bool keeps_colors_;
    std::vector<bool> given_;
    std::vector<MaterialColor> own_ = mesh_.colors;
    std::unordered_map<std::uint64_t, std::uint32_t> copies_;
};

/// Whether triangles of different colors meet at each vertex.
std::vector<bool> borders(const Mesh& mesh, std::span<const std::uint32_t> of_triangle,
                          std::span<const MaterialColor> materials) {
    std::vector<bool> out(mesh.positions.size(), false);
    constexpr std::uint32_t none = ~0u - 1;
    std::vector<std::uint32_t> first(mesh.positions.size(), none);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t]) {
            if (v >= out.size()) continue;
            if (first[v] == none) first[v] = of_triangle[t];
            const auto color = [&](std::uint32_t m) { return m < materials.size() ? materials[m] : white; };
            if (color(first[v]) != color(of_triangle[t])) out[v] = true;
        }
    return out;
}

}  // namespace

void color_by_material(Mesh& mesh, std::span<const std::uint32_t> of_triangle,
                       std::span<const MaterialColor> materials) {
    complete_normals(mesh, borders(mesh, of_triangle, materials));
    const bool keeps_colors = !mesh.colors.empty();
    mesh.colors.resize(mesh.positions.size(), white);
    Splitter splitter(mesh, keeps_colors);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t& v : mesh.triangles[t])
            v = splitter.colored(v, of_triangle[t] < materials.size() ? materials[of_triangle[t]] : white);
}

}  // namespace vantage

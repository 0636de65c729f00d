#include "player/plan/coarse_mesh.h"

#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>

namespace vantage {
namespace {

constexpr std::size_t least_mesh = 50'000;   // triangles; smaller meshes are fast enough
constexpr std::size_t max_coarse = 100'000;  // triangles
constexpr std::size_t part_triangles = 1 << 17;

/// The number of opaque triangles, which come first.
std::size_t opaque_triangles(const PlanScene& scene) {
    const std::size_t behind = std::min<std::size_t>(scene.first_transparent, scene.first_surrounding);
    const std::size_t end =
        behind < scene.clusters.size() ? scene.clusters[behind].first_triangle : scene.triangles;
    return std::min(end, scene.indices.size() / 3);
}

/// Some triangles, with their own vertex numbering.
struct Part {
    std::vector<std::uint32_t> indices, vertices;  ///< `vertices`: scene vertices by part vertex
    std::vector<Eigen::Vector3f> positions;
};

/// `number`: scratch memory that maps the scene's vertices to the part's vertices; ~0u for all vertices
/// before and after the call. The file may change while it is in use, so triangles with vertices out of range
/// are skipped.
Part part_of(const PlanScene& scene, std::size_t first, std::size_t count,
             std::vector<std::uint32_t>& number) {
    Part part;
    for (std::size_t t = first; t < first + count; ++t) {
        std::array<std::uint32_t, 3> corners{};
        std::copy_n(&scene.indices[3 * t], 3, corners.begin());
        if (*std::ranges::max_element(corners) >= number.size()) continue;
        for (const std::uint32_t v : corners) {
            if (number[v] == ~0u) {
                number[v] = std::uint32_t(part.vertices.size());
                part.vertices.push_back(v);
                part.positions.push_back(scene.positions[v]);
            }
            part.indices.push_back(number[v]);
        }
    }
    for (const std::uint32_t v : part.vertices) number[v] = ~0u;
    return part;
}

Eigen::Vector3f normal_of(const Part& part, std::span<const std::uint32_t, 3> t) {
    const Eigen::Vector3f& a = part.positions[t[0]];
    return (part.positions[t[1]] - a).cross(part.positions[t[2]] - a).stableNormalized();
}

/// For each coarse triangle: of the part's triangles at its corners, the one that is most nearly parallel to
/// it.
std::vector<std::uint32_t> replaced(const Part& part, std::span<const std::uint32_t> coarse) {
    std::vector<std::uint32_t> at_vertex(part.vertices.size(), 0), out;
    for (std::size_t i = 0; i < part.indices.size(); ++i) at_vertex[part.indices[i]] = std::uint32_t(i / 3);
    for (std::size_t t = 0; t < coarse.size(); t += 3) {
        const Eigen::Vector3f normal = normal_of(part, coarse.subspan(t).first<3>());
        const auto facing = [&](std::uint32_t vertex) {
            return normal_of(part, std::span(part.indices).subspan(3 * at_vertex[vertex]).first<3>())
                .dot(normal);
        };
        const std::uint32_t best =
            *std::max_element(&coarse[t], &coarse[t] + 3,
                              [&](std::uint32_t a, std::uint32_t b) { return facing(a) < facing(b); });
        out.push_back(at_vertex[best]);
    }
    return out;
}

void add_simplified(const Part& part, std::size_t first, std::size_t triangles, CoarseMesh& mesh) {
    std::vector<std::uint32_t> coarse(part.indices.size());
    float error = 0;
    const float* positions = part.positions.front().data();
    coarse.resize(meshopt_simplify(coarse.data(), part.indices.data(), part.indices.size(), positions,
                                   part.positions.size(), sizeof(Eigen::Vector3f), 3 * triangles, 1.0f,
                                   meshopt_SimplifyLockBorder, &error));
    const float scale = meshopt_simplifyScale(positions, part.positions.size(), sizeof(Eigen::Vector3f));
    mesh.error = std::max(mesh.error, double(error) * double(scale));
    for (const std::uint32_t t : replaced(part, coarse)) mesh.stands_for.push_back(std::uint32_t(first) + t);
    for (const std::uint32_t v : coarse) mesh.indices.push_back(part.vertices[v]);
}

}  // namespace

std::size_t coarse_triangles(const PlanScene& scene) {
    const std::size_t all = opaque_triangles(scene);
    return all < least_mesh ? 0 : std::min(all / 8, max_coarse);
}

CoarseMesh make_coarse_mesh(const PlanScene& scene, const std::stop_token& stop) {
    const std::size_t all = opaque_triangles(scene), wanted = coarse_triangles(scene);
    CoarseMesh mesh;
    if (wanted == 0) return mesh;
    std::vector<std::uint32_t> number(scene.positions.size(), ~0u);
    for (std::size_t first = 0; first < all; first += part_triangles) {
        if (stop.stop_requested()) return {};
        const std::size_t count = std::min(part_triangles, all - first);
        const Part part = part_of(scene, first, count, number);
        if (part.indices.empty()) continue;
        add_simplified(part, first, wanted * count / all, mesh);
    }
    return mesh;
}

}  // namespace vantage

#include "pipeline/stages/vertex_coordinates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "pipeline/stages/visibility.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

constexpr std::uint32_t nothing = ~0u;
constexpr float plain = 0.15f;  ///< cosine above which a surface does not hide itself

enum class Seen { no, yes, unsettled };

/// Corners from the camera's centre.
struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    Eigen::Vector3f a, b, c;

    bool holds(std::uint32_t vertex) const { return std::ranges::count(vertices, vertex) > 0; }
};

class Vertices {
  public:
    Vertices(const ModelSpans& model, std::span<const std::uint32_t> indices, const Intrinsics& k,
             const Pose& pose, const PhotoGeometry& map)
        : model_(model),
          indices_(indices),
          k_(k),
          pose_(pose),
          map_(map),
          eye_(pose.center().cast<float>()),
          longest_(float(std::max(k.fx, k.fy))),
          shortest_(float(std::min(k.fx, k.fy))) {}

    Eigen::Vector2f coordinate(std::uint32_t vertex) const {
        const Eigen::Vector2f hidden(-1, -1);
        const Eigen::Vector3d p = pose_.R * model_.positions[vertex].cast<double>() + pose_.t;
        if (!(p.z() > 0)) return hidden;
        const double x = k_.fx * p.x() / p.z() + k_.cx, y = k_.fy * p.y() / p.z() + k_.cy;
        if (!(x >= 0 && y >= 0 && x < k_.width && y < k_.height)) return hidden;
        constexpr int texel = 1 << mask_level;
        const Seen seen = visibility(vertex, int(x) / texel, int(y) / texel);
        if (seen == Seen::no) return hidden;
        if (seen == Seen::unsettled) return {unsettled_coordinate, unsettled_coordinate};
        return {float(x / k_.width), float(y / k_.height)};
    }

  private:
    Triangle triangle(std::uint32_t number) const {
        Triangle t;
        std::copy_n(indices_.begin() + std::ptrdiff_t(number) * 3, 3, t.vertices.begin());
        t.a = model_.positions[t.vertices[0]] - eye_;
        t.b = model_.positions[t.vertices[1]] - eye_;
        t.c = model_.positions[t.vertices[2]] - eye_;
        return t;
    }
    std::uint32_t seen_at(int x, int y) const {
        x = std::clamp(x, 0, map_.width - 1);
        y = std::clamp(y, 0, map_.height - 1);
        return map_.triangles[std::size_t(y) * std::size_t(map_.width) + std::size_t(x)];
    }
    /// The ray crosses the triangle before the vertex, by more than a third of a pixel's footprint (Moeller
    /// and Trumbore 1997).
    bool crosses(const Triangle& t, const Eigen::Vector3f& ray) const {
        const float u = ray.dot(t.c.cross(t.b)), v = ray.dot(t.a.cross(t.c)), w = ray.dot(t.b.cross(t.a)),
                    sum = u + v + w;
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || sum == 0) return false;
        const float share = ((u * t.a + v * t.b + w * t.c) / sum).dot(ray) / ray.squaredNorm();
        return share > 0 && share < 1 - 0.3f / longest_;
    }
    /// The triangle's plane meets the ray within a third of a pixel's footprint of the vertex: one surface
    /// with it.
    bool continues(const Triangle& t, const Eigen::Vector3f& ray) const {
        const Eigen::Vector3f n = (t.b - t.a).cross(t.c - t.a);
        const float along = n.dot(ray), off = n.dot(t.a) - along;
        return std::abs(off) * longest_ < 0.3f * std::abs(along);
    }
    /// Wholly before the vertex, by more than a texel's footprint along the vertex's slope.
    bool before(const Triangle& t, float distance, float facing) const {
        const float footprint = float(1 << mask_level) * distance / shortest_;
        const float slack = footprint * (1 + 1 / std::max(std::abs(facing), 0.1f));
        return std::max({t.a.norm(), t.b.norm(), t.c.norm()}) < distance - slack;
    }
    /// Hidden behind the triangle at its own texel, or behind those of the texels at its corners, too; seen
    /// on a surface that goes on through all of them.
    Seen visibility(std::uint32_t vertex, int x, int y) const {
        const Eigen::Vector3f ray = model_.positions[vertex] - eye_;
        const float distance = ray.norm(), facing = -model_.normals[vertex].dot(ray) / distance;
        bool behind = true, goes_on = facing > plain;
        std::uint32_t last = nothing;
        constexpr std::array<std::array<int, 2>, 5> around{{{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
        for (std::size_t i = 0; i < around.size(); ++i) {
            const std::uint32_t number = seen_at(x + around[i][0], y + around[i][1]);
            behind = behind && number != nothing;
            if (number == nothing || number == last) continue;
            last = number;
            const Triangle t = triangle(number);
            const bool own = t.holds(vertex);
            if (i == 0 && !own && crosses(t, ray)) return Seen::no;
            behind = behind && !own && before(t, distance, facing);
            goes_on = goes_on && (own || continues(t, ray));
            if (!behind && !goes_on) return Seen::unsettled;
        }
        return behind ? Seen::no : goes_on ? Seen::yes : Seen::unsettled;
    }

    const ModelSpans& model_;
    std::span<const std::uint32_t> indices_;
    const Intrinsics& k_;
    const Pose& pose_;
    const PhotoGeometry& map_;
    Eigen::Vector3f eye_;
    float longest_, shortest_;
};

}  // namespace

std::vector<Eigen::Vector2f> vertex_coordinates(const ModelSpans& model,
                                                std::span<const std::uint32_t> indices, const Intrinsics& k,
                                                const Pose& pose, const PhotoGeometry& geometry) {
    const Vertices vertices(model, indices, k, pose, geometry);
    std::vector<Eigen::Vector2f> out(model.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = vertices.coordinate(std::uint32_t(v));
    return out;
}

}  // namespace vantage

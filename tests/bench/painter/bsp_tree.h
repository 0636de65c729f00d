#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace vantage {

/// A convex piece of a triangle.
struct PaintedPolygon {
    std::vector<Eigen::Vector3d> corners;
    std::uint32_t triangle;
};

/// The painter's algorithm over a binary space partition (Fuchs, Kedem and Naylor 1980), as in the reference
/// [V]. The planes of triangles divide space. Triangles that cross a plane are split by a Sutherland-Hodgman
/// clipper that keeps both sides. Planes are thick, so that corners near a plane are not cut off.
class BspTree {
  public:
    using Triangle = std::array<Eigen::Vector3d, 3>;
    /// The planes are processed in random order. Degenerate triangles are skipped. Splitting stops at `most`
    /// polygons; complete() is then false, and the order is wrong.
    explicit BspTree(std::span<const Triangle> triangles, std::uint32_t seed = 1,
                     std::size_t most = std::numeric_limits<std::size_t>::max());

    std::size_t polygons() const { return polygons_; }
    bool complete() const { return complete_; }
    /// Calls `paint` for each polygon, farthest from `eye` first. Among polygons in one plane, the triangle
    /// with the lowest number is painted last.
    void back_to_front(const Eigen::Vector3d& eye,
                       const std::function<void(const PaintedPolygon&)>& paint) const;

  private:
    static constexpr std::uint32_t none = ~0u;
    struct Node {
        Eigen::Vector3d normal;
        double offset;  ///< the points p on the plane satisfy normal . p = offset
        std::vector<PaintedPolygon> in_plane;
        std::uint32_t front = none, behind = none;
    };
    std::vector<Node> nodes_;
    std::size_t polygons_ = 0;
    bool complete_ = true;
};

}  // namespace vantage

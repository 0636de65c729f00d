#include "tests/bench/painter/bsp_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <random>
#include <utility>

namespace vantage {
namespace {

using Eigen::Vector3d;

/// Splits a polygon by a plane. Corners within `thick` of the plane belong to both parts.
std::pair<PaintedPolygon, PaintedPolygon> split(const PaintedPolygon& p, const std::vector<double>& side,
                                                double thick) {
    std::pair<PaintedPolygon, PaintedPolygon> out{{{}, p.triangle}, {{}, p.triangle}};
    for (std::size_t i = 0; i < p.corners.size(); ++i) {
        const std::size_t j = (i + 1) % p.corners.size();
        const double a = side[i], b = side[j];
        if (a >= -thick) out.first.corners.push_back(p.corners[i]);
        if (a <= thick) out.second.corners.push_back(p.corners[i]);
        if ((a > thick && b < -thick) || (a < -thick && b > thick)) {
            const Vector3d at = p.corners[i] + a / (a - b) * (p.corners[j] - p.corners[i]);
            out.first.corners.push_back(at);
            out.second.corners.push_back(at);
        }
    }
    return out;
}

/// The non-degenerate triangles, in random order.
std::vector<PaintedPolygon> shuffled(std::span<const BspTree::Triangle> triangles, std::uint32_t seed) {
    std::vector<PaintedPolygon> out;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        if ((b - a).cross(c - a).norm() > 0) out.push_back({{a, b, c}, t});
    }
    std::mt19937 random(seed);
    std::ranges::shuffle(out, random);
    return out;
}

double extent_of(std::span<const BspTree::Triangle> triangles) {
    double extent = 0;
    for (const BspTree::Triangle& t : triangles)
        for (const Vector3d& corner : t) extent = std::max(extent, corner.cwiseAbs().maxCoeff());
    return extent;
}

/// The polygons on each side of a plane.
struct Sides {
    std::vector<PaintedPolygon> in_plane, front, behind;
    std::size_t cut = 0;
    bool complete = true;  ///< false if splitting stopped at the maximum number of polygons
};

Sides divided(std::vector<PaintedPolygon> polygons, const Vector3d& normal, double offset, double thick,
              std::size_t room) {
    Sides out;
    for (PaintedPolygon& p : polygons) {
        std::vector<double> side;
        for (const Vector3d& corner : p.corners) side.push_back(normal.dot(corner) - offset);
        const double low = std::ranges::min(side), high = std::ranges::max(side);
        if (low >= -thick && high <= thick) {
            out.in_plane.push_back(std::move(p));
        } else if (low >= -thick) {
            out.front.push_back(std::move(p));
        } else if (high <= thick) {
            out.behind.push_back(std::move(p));
        } else if (out.cut >= room) {
            out.complete = false;
            (high > -low ? out.front : out.behind).push_back(std::move(p));
        } else {
            auto [one, other] = split(p, side, thick);
            out.front.push_back(std::move(one));
            out.behind.push_back(std::move(other));
            ++out.cut;
        }
    }
    std::ranges::sort(out.in_plane, std::greater(), &PaintedPolygon::triangle);
    return out;
}

}  // namespace

BspTree::BspTree(std::span<const Triangle> triangles, std::uint32_t seed, std::size_t most) {
    struct Work {
        std::vector<PaintedPolygon> polygons;
        std::uint32_t parent;
        bool front;
    };
    const double thick = 1e-9 * extent_of(triangles);
    std::vector<Work> todo;
    if (auto all = shuffled(triangles, seed); !all.empty()) todo.push_back({std::move(all), none, false});
    polygons_ = todo.empty() ? 0 : todo.front().polygons.size();
    while (!todo.empty()) {
        Work work = std::move(todo.back());
        todo.pop_back();
        const auto& [a, b, c] = triangles[work.polygons.front().triangle];
        const Vector3d normal = (b - a).cross(c - a).normalized();
        const double offset = normal.dot(a);
        Sides sides =
            divided(std::move(work.polygons), normal, offset, thick, most - std::min(most, polygons_));
        polygons_ += sides.cut;
        complete_ &= sides.complete;
        const auto number = std::uint32_t(nodes_.size());
        if (work.parent != none)
            (work.front ? nodes_[work.parent].front : nodes_[work.parent].behind) = number;
        nodes_.push_back({normal, offset, std::move(sides.in_plane)});
        if (!sides.front.empty()) todo.push_back({std::move(sides.front), number, true});
        if (!sides.behind.empty()) todo.push_back({std::move(sides.behind), number, false});
    }
}

void BspTree::back_to_front(const Vector3d& eye,
                            const std::function<void(const PaintedPolygon&)>& paint) const {
    struct Visit {
        std::uint32_t node;
        bool plane;  ///< paint the polygons in the node's plane; otherwise, visit its far side first
    };
    std::vector<Visit> todo;
    if (!nodes_.empty()) todo.push_back({0, false});
    while (!todo.empty()) {
        const Visit at = todo.back();
        todo.pop_back();
        const Node& node = nodes_[at.node];
        if (at.plane) {
            for (const PaintedPolygon& p : node.in_plane) paint(p);
            continue;
        }
        const bool in_front = node.normal.dot(eye) >= node.offset;
        const std::uint32_t near = in_front ? node.front : node.behind,
                            far = in_front ? node.behind : node.front;
        if (near != none) todo.push_back({near, false});
        todo.push_back({at.node, true});
        if (far != none) todo.push_back({far, false});
    }
}

}  // namespace vantage

#include "tests/bench/painter/bsp_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <utility>

namespace vantage {
namespace {

using Eigen::Vector3d;

/// Both parts of a polygon that a plane cuts. Corners within `thick` of the plane belong to both.
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

}  // namespace

BspTree::BspTree(std::span<const Triangle> triangles, std::uint32_t seed, std::size_t most) {
    std::vector<PaintedPolygon> all;
    double extent = 0;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        extent =
            std::max({extent, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
        if ((b - a).cross(c - a).norm() > 0) all.push_back({{a, b, c}, t});
    }
    const double thick = 1e-9 * extent;
    std::mt19937 random(seed);
    std::ranges::shuffle(all, random);
    polygons_ = all.size();
    struct Work {
        std::vector<PaintedPolygon> polygons;
        std::uint32_t parent;
        bool front;
    };
    std::vector<Work> todo;
    if (!all.empty()) todo.push_back({std::move(all), none, false});
    while (!todo.empty()) {
        Work work = std::move(todo.back());
        todo.pop_back();
        const PaintedPolygon& first = work.polygons.front();
        const auto& [a, b, c] = triangles[first.triangle];
        Node node{(b - a).cross(c - a).normalized(), 0, {}};
        node.offset = node.normal.dot(a);
        Work front{{}, std::uint32_t(nodes_.size()), true}, behind{{}, std::uint32_t(nodes_.size()), false};
        for (PaintedPolygon& p : work.polygons) {
            std::vector<double> side;
            for (const Vector3d& corner : p.corners) side.push_back(node.normal.dot(corner) - node.offset);
            const double low = std::ranges::min(side), high = std::ranges::max(side);
            if (low >= -thick && high <= thick) {
                node.in_plane.push_back(std::move(p));
            } else if (low >= -thick) {
                front.polygons.push_back(std::move(p));
            } else if (high <= thick) {
                behind.polygons.push_back(std::move(p));
            } else if (polygons_ >= most) {
                complete_ = false;
                (high > -low ? front : behind).polygons.push_back(std::move(p));
            } else {
                auto [one, other] = split(p, side, thick);
                front.polygons.push_back(std::move(one));
                behind.polygons.push_back(std::move(other));
                ++polygons_;
            }
        }
        std::ranges::sort(node.in_plane, std::greater(), &PaintedPolygon::triangle);
        if (work.parent != none)
            (work.front ? nodes_[work.parent].front : nodes_[work.parent].behind) =
                std::uint32_t(nodes_.size());
        nodes_.push_back(std::move(node));
        if (!front.polygons.empty()) todo.push_back(std::move(front));
        if (!behind.polygons.empty()) todo.push_back(std::move(behind));
    }
}

void BspTree::back_to_front(const Vector3d& eye,
                            const std::function<void(const PaintedPolygon&)>& paint) const {
    struct Visit {
        std::uint32_t node;
        bool plane;  ///< paint what is in its plane; else visit its far side first
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

#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "pipeline/synth/building.h"

namespace vantage {

/// A model under construction.
struct ModelBuilder {
    SynthModel model;
    double max_edge;

    std::uint32_t vertex(const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
        model.mesh.positions.push_back(p);
        model.mesh.normals.push_back(n.cast<float>());
        return std::uint32_t(model.mesh.positions.size() - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, Material material) {
        model.mesh.triangles.push_back({a, b, c});
        model.materials.push_back(material);
    }

    /// A parallelogram with edges u and v at `corner`; its normal is along u x v. It is divided into quads
    /// with sides of at most `max_edge`, unless that is 0.
    void quad(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              Material material) {
        const auto pieces = [&](double length) {
            return max_edge > 0 ? std::max(1, int(std::ceil(length / max_edge))) : 1;
        };
        const int nu = pieces(u.norm()), nv = pieces(v.norm());
        const Eigen::Vector3d n = u.cross(v).normalized();
        const auto first = std::uint32_t(model.mesh.positions.size());
        for (int j = 0; j <= nv; ++j)
            for (int i = 0; i <= nu; ++i) vertex(corner + u * (double(i) / nu) + v * (double(j) / nv), n);
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) {
                const std::uint32_t row = std::uint32_t(nu) + 1;
                const std::uint32_t a = first + std::uint32_t(j) * row + std::uint32_t(i);
                triangle(a, a + 1, a + row + 1, material);
                triangle(a, a + row + 1, a + row, material);
            }
    }
    /// The surface f(u, v) for u and v from 0 to 1, divided into at least nu x nv quads; its normal is along
    /// the cross product of its derivatives. Quads are divided further until their sides are about
    /// `max_edge`, unless that is 0.
    void surface(int nu, int nv, const std::function<Eigen::Vector3d(double u, double v)>& f,
                 Material material);
    /// The surface swept by a profile: its point p moves along `at(t, p)`, with t going from 0 to 1 in
    /// `steps` steps.
    void sweep(std::span<const Eigen::Vector2d> profile, int steps,
               const std::function<Eigen::Vector3d(double t, const Eigen::Vector2d& p)>& at,
               Material material);
    /// A box without its bottom face.
    void box(const Eigen::Vector3d& center, const Eigen::Vector3d& half, Material material) {
        const Eigen::Vector3d x(2 * half.x(), 0, 0), y(0, 2 * half.y(), 0), z(0, 0, 2 * half.z());
        const Eigen::Vector3d low = center - half, high = center + half;
        quad(low, x, z, material);
        quad(high - z, -x, z, material);
        quad(low + x, y, z, material);
        quad(low + y, -y, z, material);
        quad(low + z, x, y, material);
    }
};

}  // namespace vantage

#include "tests/bench/painter/transparent_layers.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/srgb.h"
#include "scene/package/contents/opaque_part.h"

namespace vantage {

using Eigen::Vector2d;
using Eigen::Vector3d;
using package::Type;

TransparentLayers::TransparentLayers(const PackageReader& package) : first_(opaque_part(package).triangles) {
    for (const Eigen::Vector3f& p : package.records<Eigen::Vector3f>(Type::positions))
        positions_.push_back(p.cast<double>());
    for (const Eigen::Vector3f& n : package.records<Eigen::Vector3f>(Type::normals))
        normals_.push_back(n.cast<double>());
    for (const auto& c : package.records<std::array<std::uint8_t, 4>>(Type::colors))
        colors_.push_back({c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, c[3] / 255.0});
    const auto indices = package.records<std::uint32_t>(Type::indices);
    indices_.assign(indices.begin(), indices.end());
}

std::vector<std::array<Vector3d, 3>> TransparentLayers::triangles() const {
    std::vector<std::array<Vector3d, 3>> out;
    for (std::size_t t = first_; t < indices_.size() / 3; ++t)
        out.push_back(
            {positions_[indices_[3 * t]], positions_[indices_[3 * t + 1]], positions_[indices_[3 * t + 2]]});
    return out;
}

std::optional<TransparentLayers::Fragment> TransparentLayers::at(const View& view, std::uint32_t triangle,
                                                                 const Vector2d& pixel, double* edge) const {
    const Intrinsics& k = view.intrinsics;
    const Vector3d ray((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy, 1);
    const std::uint32_t* v = &indices_[3 * std::size_t(triangle)];
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i)
        corners.col(i) = view.cam_from_origin.R * positions_[v[i]] + view.cam_from_origin.t;
    // Solve corners * shares = z * ray, where the shares sum to 1.
    const Vector3d scaled = corners.fullPivLu().solve(ray);
    const double z = 1 / scaled.sum();
    const Vector3d shares = scaled * z;
    if (edge) {
        // Converts a barycentric weight to the distance in the picture from the corresponding edge, for a
        // triangle in front of the viewer.
        Vector2d at[3];
        for (int i = 0; i < 3; ++i) at[i] = corners.col(i).head<2>() / corners(2, i);
        const double area =
            (at[1] - at[0]).x() * (at[2] - at[0]).y() - (at[1] - at[0]).y() * (at[2] - at[0]).x();
        *edge = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const Vector2d a = at[(i + 1) % 3], b = at[(i + 2) % 3], p = ray.head<2>();
            const double cross = (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
            *edge = std::min(*edge, std::abs(cross) / std::max((b - a).norm(), 1e-12) * k.fx);
        }
        const bool inside = shares.minCoeff() >= 0;
        if (!inside && shares.minCoeff() < -0.2) *edge = std::numeric_limits<double>::infinity();
        if (!(std::abs(area) > 1e-12)) *edge = 0;
    }
    if (!(z > 0) || !(shares.minCoeff() >= 0)) return {};
    Vector3d normal = Vector3d::Zero(), color = Vector3d::Zero(), position = Vector3d::Zero();
    double alpha = 0;
    for (int i = 0; i < 3; ++i) {
        const auto& c = colors_[v[i]];
        normal += shares[i] * normals_[v[i]];
        position += shares[i] * positions_[v[i]];
        color += shares[i] * Vector3d(c[0], c[1], c[2]);
        alpha += shares[i] * c[3];
    }
    const Vector3d toward = (view.cam_from_origin.center() - position).normalized();
    // The factor is 1 where the surface faces the viewer.
    const double light = (0.12 + 0.35 * std::abs(normal.normalized().dot(toward))) / 0.47;
    return Fragment{z, triangle, color.cwiseMax(0).unaryExpr(&linear_from_srgb) * light, alpha};
}

std::vector<TransparentLayers::Pixel> TransparentLayers::fragments(const View& view) const {
    const Intrinsics& k = view.intrinsics;
    std::vector<Pixel> out(std::size_t(k.width) * std::size_t(k.height));
    for (std::uint32_t t = first_; t < indices_.size() / 3; ++t) {
        Vector2d low(1e9, 1e9), high(-1e9, -1e9);
        for (int i = 0; i < 3; ++i) {
            const auto p =
                project(k, view.cam_from_origin, positions_[indices_[3 * std::size_t(t) + std::size_t(i)]]);
            low = p ? low.cwiseMin(p->pixel).eval() : Vector2d(0, 0);
            high = p ? high.cwiseMax(p->pixel).eval() : Vector2d(k.width, k.height);
        }
        const int x0 = std::max(0, int(low.x()) - 1), x1 = std::min(k.width - 1, int(high.x()) + 1),
                  y0 = std::max(0, int(low.y()) - 1), y1 = std::min(k.height - 1, int(high.y()) + 1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                Pixel& pixel = out[std::size_t(y) * std::size_t(k.width) + std::size_t(x)];
                double edge = 1e9;
                const auto f = at(view, t, {x + 0.5, y + 0.5}, &edge);
                pixel.edge |= edge < 0.02;
                if (f) pixel.fragments.push_back(*f);
            }
    }
    return out;
}

Eigen::Vector4d blended(std::vector<TransparentLayers::Fragment> fragments, Eigen::Vector4d behind) {
    std::ranges::sort(fragments, [](const auto& a, const auto& b) {
        return a.z != b.z ? a.z > b.z : a.triangle > b.triangle;  // the farthest first
    });
    for (const auto& f : fragments) {
        behind.head<3>() = f.alpha * f.color + (1 - f.alpha) * behind.head<3>();
        behind[3] = f.alpha + (1 - f.alpha) * behind[3];
    }
    return behind;
}

}  // namespace vantage

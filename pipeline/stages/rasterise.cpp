#include "pipeline/stages/rasterise.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "pipeline/stages/vertex_coordinates.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

constexpr std::uint32_t no_triangle = ~0u;
/// To a pixel: corners are snapped, so that edges that are shared are the same.
constexpr int subpixel_bits = 8;
constexpr std::int64_t subpixels = 1 << subpixel_bits;

/// A corner on the picture: subpixels, and 1/z.
struct Projected {
    std::int64_t x, y;
    double inverse;
};

/// Depths as 1/z, greater is nearer, and the triangle that is nearest.
struct Target {
    int width, height;
    std::vector<float> inverse;
    std::vector<std::uint32_t>& triangles;
};

class Rasteriser {
  public:
    Rasteriser(const ModelSpans& model, const Intrinsics& k, const Pose& pose, double near, Target& target)
        : k_(k), near_(float(near)), target_(target) {
        cam_.reserve(model.positions.size());
        projected_.reserve(model.positions.size());
        for (const Eigen::Vector3f& p : model.positions) {
            cam_.push_back((pose.R * p.cast<double>() + pose.t).cast<float>());
            projected_.push_back(cam_.back().z() >= near_ ? project(cam_.back()) : Projected{});
        }
    }

    /// The part behind the near plane is cut off.
    void draw(const std::uint32_t* corners, std::uint32_t number) {
        int before = 0;
        for (std::size_t i = 0; i < 3; ++i) before += cam_[corners[i]].z() >= near_;
        if (before == 3)
            fill({projected_[corners[0]], projected_[corners[1]], projected_[corners[2]]}, number);
        else if (before > 0)
            clipped({cam_[corners[0]], cam_[corners[1]], cam_[corners[2]]}, number);
    }

  private:
    static std::int64_t nearest(double v) { return std::int64_t(v < 0 ? v - 0.5 : v + 0.5); }

    Projected project(const Eigen::Vector3f& p) const {
        const double inverse = 1 / double(p.z());
        return {nearest((k_.fx * p.x() * inverse + k_.cx) * double(subpixels)),
                nearest((k_.fy * p.y() * inverse + k_.cy) * double(subpixels)), inverse};
    }

    void clipped(const std::array<Eigen::Vector3f, 3>& cam, std::uint32_t number) {
        std::array<Eigen::Vector3f, 4> kept;
        std::size_t n = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3f &a = cam[i], &b = cam[(i + 1) % 3];
            if (a.z() >= near_) kept[n++] = a;
            if ((a.z() >= near_) == (b.z() >= near_)) continue;
            kept[n] = a + (near_ - a.z()) / (b.z() - a.z()) * (b - a);
            kept[n++].z() = near_;
        }
        for (std::size_t i = 2; i < n; ++i)
            fill({project(kept[0]), project(kept[i - 1]), project(kept[i])}, number);
    }

    /// The first and the last pixel whose centre lies between, inside the picture.
    static std::pair<int, int> centres(std::int64_t low, std::int64_t high, int size) {
        constexpr std::int64_t half = subpixels / 2;
        return {int(std::clamp<std::int64_t>((low + half - 1) >> subpixel_bits, 0, size)),
                int(std::clamp<std::int64_t>((high - half) >> subpixel_bits, -1, size - 1))};
    }

    void fill(const std::array<Projected, 3>& p, std::uint32_t number) {
        const auto [x0, x1] =
            centres(std::min({p[0].x, p[1].x, p[2].x}), std::max({p[0].x, p[1].x, p[2].x}), target_.width);
        const auto [y0, y1] =
            centres(std::min({p[0].y, p[1].y, p[2].y}), std::max({p[0].y, p[1].y, p[2].y}), target_.height);
        if (x0 > x1 || y0 > y1) return;
        const double area = double(p[1].x - p[0].x) * double(p[2].y - p[0].y) -
                            double(p[1].y - p[0].y) * double(p[2].x - p[0].x);
        if (area == 0) return;
        // Edge i is across from corner i; within the triangle all three functions are 0 or more, and sum up
        // to the area.
        const double sign = area > 0 ? 1 : -1;
        double step_x[3], step_y[3], row[3], inverse_row = 0, inverse_x = 0, inverse_y = 0;
        const std::int64_t cx = x0 * subpixels + subpixels / 2, cy = y0 * subpixels + subpixels / 2;
        for (std::size_t i = 0; i < 3; ++i) {
            const Projected &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
            const double dx = sign * double(b.x - a.x), dy = sign * double(b.y - a.y);
            const double share = p[i].inverse / (sign * area);
            row[i] = dx * double(cy - a.y) - dy * double(cx - a.x);
            step_x[i] = -dy * double(subpixels);
            step_y[i] = dx * double(subpixels);
            inverse_row += row[i] * share;
            inverse_x += step_x[i] * share;
            inverse_y += step_y[i] * share;
        }
        const std::size_t width = std::size_t(target_.width);
        for (int y = y0; y <= y1; ++y) {
            double a = row[0], b = row[1], c = row[2], inverse = inverse_row;
            float* depth = &target_.inverse[std::size_t(y) * width];
            std::uint32_t* shown = &target_.triangles[std::size_t(y) * width];
            for (int x = x0; x <= x1; ++x) {
                if (std::min(std::min(a, b), c) >= 0 && float(inverse) > depth[x]) {
                    depth[x] = float(inverse);
                    shown[x] = number;
                }
                a += step_x[0], b += step_x[1], c += step_x[2];
                inverse += inverse_x;
            }
            for (std::size_t i = 0; i < 3; ++i) row[i] += step_y[i];
            inverse_row += inverse_y;
        }
    }

    const Intrinsics& k_;
    float near_;
    Target& target_;
    std::vector<Eigen::Vector3f> cam_;
    std::vector<Projected> projected_;
};

/// The cosine between a triangle's interpolated normal and the direction to the camera (Callieri et al.
/// 2008).
class Shader {
  public:
    Shader(const ModelSpans& model, std::span<const std::uint32_t> indices, const Eigen::Vector3f& eye)
        : model_(model), indices_(indices), eye_(eye) {}

    /// At the point of the triangle that lies on this ray from the camera.
    float cosine(std::uint32_t triangle, const Eigen::Vector3f& ray) {
        if (triangle != current_) set(triangle);
        // The weights of the corners are the volumes that the ray spans with the edges across.
        const float u = ray.dot(across_[0]), v = ray.dot(across_[1]), w = ray.dot(across_[2]);
        const Eigen::Vector3f n = u * normals_[0] + v * normals_[1] + w * normals_[2];
        const float lengths = std::sqrt(n.squaredNorm() * ray.squaredNorm());
        if (!(lengths > 0)) return 0;
        return std::max(0.0f, (u + v + w < 0 ? 1.0f : -1.0f) * n.dot(ray) / lengths);
    }

  private:
    void set(std::uint32_t triangle) {
        current_ = triangle;
        Eigen::Vector3f c[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t v = indices_[3 * std::size_t(triangle) + i];
            c[i] = model_.positions[v] - eye_;
            normals_[i] = model_.normals[v];
        }
        for (std::size_t i = 0; i < 3; ++i) across_[i] = c[(i + 1) % 3].cross(c[(i + 2) % 3]);
    }

    const ModelSpans& model_;
    std::span<const std::uint32_t> indices_;
    Eigen::Vector3f eye_;
    std::uint32_t current_ = no_triangle;
    Eigen::Vector3f normals_[3], across_[3];
};

/// Depth and angle of every pixel from the triangle that it shows.
void shade(const Target& target, Shader shader, const Intrinsics& k, const Pose& pose, PhotoGeometry& out) {
    // Rays in the world's axes, in which the normals are.
    const Eigen::Matrix3d world = pose.R.transpose();
    const Eigen::Vector3f right = (world.col(0) / k.fx).cast<float>();
    std::size_t at = 0;
    for (int y = 0; y < out.height; ++y) {
        const Eigen::Vector3f first =
            (world * Eigen::Vector3d((0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1)).cast<float>();
        for (int x = 0; x < out.width; ++x, ++at) {
            if (target.triangles[at] == no_triangle) continue;
            out.z[at] = 1 / target.inverse[at];
            const float cosine = shader.cosine(target.triangles[at], first + float(x) * right);
            out.angle[at] = std::uint8_t(std::min(1.0f, cosine) * 255 + 0.5f);
        }
    }
}

}  // namespace

PhotoGeometry rasterise_geometry(const ModelSpans& model, std::span<const std::uint32_t> indices,
                                 const Intrinsics& k, const Pose& pose, Eigen::Vector2d near_far) {
    PhotoGeometry out = empty_geometry(k, model.positions.size());
    if (!(near_far.y() > 0) || indices.empty()) return out;
    const Intrinsics coarse = map_intrinsics(k);
    Target target{out.width, out.height, std::vector<float>(out.z.size(), 0.0f), out.triangles};
    Rasteriser rasteriser(model, coarse, pose, near_far.x(), target);
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) rasteriser.draw(&indices[3 * t], std::uint32_t(t));
    shade(target, Shader(model, indices, pose.center().cast<float>()), coarse, pose, out);
    out.coordinates = vertex_coordinates(model, indices, k, pose, out);
    return out;
}

}  // namespace vantage

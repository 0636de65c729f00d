#include "player/measure/bench/color_step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/values/srgb.h"
#include "player/plan/visible_surface.h"

namespace vantage {
namespace {

constexpr double depth_step = 0.01;  ///< fraction of the depth: points this far behind a surface are occluded
constexpr double least_compared = 0.25;

/// The plane of a triangle numbered from 1.
struct FacePlane {
    Eigen::Vector3d point, normal;
};
std::optional<FacePlane> plane_of(const PlanScene& scene, std::uint32_t triangle) {
    if (triangle == 0 || triangle > scene.triangles) return {};
    Eigen::Vector3d corner[3];
    for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t vertex = scene.indices[3 * (std::size_t(triangle) - 1) + v];
        corner[v] = scene.positions[std::min(vertex, scene.positions.size() - 1)].cast<double>();
    }
    return FacePlane{corner[0], (corner[1] - corner[0]).cross(corner[2] - corner[0])};
}

/// Intersection of a ray with a plane, in multiples of `ahead`; empty if there is none.
std::optional<double> distance_along(const Eigen::Vector3d& eye, const Eigen::Vector3d& ahead,
                                     const FacePlane& plane) {
    const double t = plane.normal.dot(plane.point - eye) / plane.normal.dot(ahead);
    return std::isfinite(t) && t > 0 ? std::optional(t) : std::nullopt;
}

/// The surface at a pixel's center.
std::optional<Eigen::Vector3d> surface_at(const PlanScene& scene, const SeenFrame& frame, std::size_t pixel) {
    const std::optional<FacePlane> plane = plane_of(scene, frame.triangles[pixel]);
    if (!plane) return {};
    const Intrinsics& k = frame.view.intrinsics;
    const double x = double(pixel % std::size_t(k.width)) + 0.5,
                 y = double(pixel / std::size_t(k.width)) + 0.5;
    const Eigen::Vector3d eye = frame.view.cam_from_origin.center();
    const Eigen::Vector3d ahead =
        frame.view.cam_from_origin.R.transpose() * Eigen::Vector3d((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1);
    const auto t = distance_along(eye, ahead, *plane);
    return t ? std::optional<Eigen::Vector3d>(eye + *t * ahead) : std::nullopt;
}

bool visible(const PlanScene& scene, const SeenFrame& frame, const Eigen::Vector3d& point) {
    const Intrinsics& k = frame.view.intrinsics;
    const auto at = project(k, frame.view.cam_from_origin, point);
    if (!at || !in_frame(k, at->pixel)) return false;
    const std::size_t pixel = std::size_t(at->pixel.y()) * std::size_t(k.width) + std::size_t(at->pixel.x());
    const std::optional<FacePlane> plane = plane_of(scene, frame.triangles[pixel]);
    if (!plane) return false;
    const Eigen::Vector3d eye = frame.view.cam_from_origin.center();
    const auto t = distance_along(eye, point - eye, *plane);
    return t && *t > 1 - depth_step;
}

/// Sums over the compared pixels of a cell.
struct Cell {
    std::size_t pixels = 0, compared = 0;
    Eigen::Vector3d change = Eigen::Vector3d::Zero();

    bool counts() const { return compared > 0 && double(compared) >= least_compared * double(pixels); }
    /// Root mean square over the channels of the mean change.
    double step() const { return change.norm() / double(compared) / std::sqrt(3.0); }
};

void summarize(ColorStep& out, std::vector<Cell> cells) {
    std::erase_if(cells, [](const Cell& c) { return !c.counts(); });
    std::ranges::sort(cells, {}, &Cell::step);
    double all = 0, sum = 0;
    for (const Cell& c : cells) all += double(c.compared), sum += double(c.compared) * c.step();
    if (cells.empty()) return;
    out.mean = sum / all;
    out.max = cells.back().step();
    double below = 0;
    for (const Cell& c : cells) {
        below += double(c.compared);
        out.p99 = c.step();
        if (below >= 0.99 * all) break;
    }
}

}  // namespace

SeenFrame seen_frame(const Renderer& renderer, const View& view) {
    const std::size_t pixels = std::size_t(view.intrinsics.width) * std::size_t(view.intrinsics.height);
    std::vector<std::array<float, 4>> light(pixels);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(renderer.resources().targets.samples.front().sum.id(), 0, GL_RGBA, GL_FLOAT,
                      GLsizei(16 * pixels), light.data());
    SeenFrame out{view, std::vector<std::array<float, 3>>(pixels),
                  read_triangles(renderer.resources().targets)};
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            out.codes[i][c] = 255 * float(srgb_from_linear(std::clamp(double(light[i][c]), 0.0, 1.0)));
    return out;
}

Picture picture_of(const SeenFrame& frame) {
    Picture p{frame.view.intrinsics.width, frame.view.intrinsics.height, {}, {}};
    p.rgba.reserve(4 * frame.codes.size());
    for (const std::array<float, 3>& code : frame.codes) {
        for (const float c : code) p.rgba.push_back(std::uint8_t(std::lround(c)));
        p.rgba.push_back(255);
    }
    return p;
}

int step_cell(int width, int height) { return std::max(1, std::max(width, height) / 40); }

ColorStep color_step(const PlanScene& scene, const SeenFrame& now, const SeenFrame& then,
                     const SeenFrame& next) {
    const Intrinsics& k = now.view.intrinsics;
    const auto side = std::size_t(step_cell(k.width, k.height)), width = std::size_t(k.width);
    const std::size_t columns = (width + side - 1) / side;
    std::vector<Cell> cells(columns * ((std::size_t(k.height) + side - 1) / side));
    const Eigen::Vector3d eye = now.view.cam_from_origin.center(),
                          next_eye = next.view.cam_from_origin.center();
    double angles = 0;
    std::size_t compared = 0, surface = 0;
    for (std::size_t i = 0; i < now.triangles.size(); ++i) {
        Cell& cell = cells[i / width / side * columns + i % width / side];
        ++cell.pixels;
        surface += now.triangles[i] > 0;
        if (now.triangles[i] != then.triangles[i]) continue;
        const auto point = surface_at(scene, now, i);
        if (!point || !visible(scene, next, *point)) continue;
        for (std::size_t c = 0; c < 3; ++c)
            cell.change[Eigen::Index(c)] += double(then.codes[i][c]) - double(now.codes[i][c]);
        ++cell.compared;
        ++compared;
        angles += ray_angle(*point, eye, next_eye);
    }
    ColorStep out;
    summarize(out, std::move(cells));
    if (compared > 0) out.degrees = angles / double(compared) * 180 / std::numbers::pi;
    if (surface > 0) out.compared = double(compared) / double(surface);
    return out;
}

}  // namespace vantage

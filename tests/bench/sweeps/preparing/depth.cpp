// Measures the size, bit depth and tolerance that depth maps need to classify points as visible or hidden.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/gl/context.h"
#include "base/values/grid.h"
#include "base/values/tiling.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/model.h"
#include "tests/bench/scenes/surface_points.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

enum class Bits { float32, unorm24, unorm16, half16 };

/// How far a point may lie behind the surrounding depths: a fraction of its depth, the footprint of a map
/// pixel along the slope, or the larger of the two, as in shaders/blend.frag.
struct Tolerance {
    float share;
    bool footprint;
};
constexpr Tolerance players{0.004f, true};

struct Setting {
    const char *curve, *name;
    int level;  ///< pyramid level of the photo that has the same size as the map
    Bits bits;
    Tolerance tolerance;
    bool chosen = false;
    bool ray = false;  ///< no map, exact
    bool shown = false;
};
constexpr const char *sizes = "size (float, player's tolerance)",
                     *bits = "bits (half size, player's tolerance)",
                     *tolerances = "tolerance (half size, float)";
constexpr Setting settings[] = {
    {sizes, "1/1", 0, Bits::float32, players},
    {sizes, "1/2", 1, Bits::float32, players, true},
    {sizes, "1/4", 2, Bits::float32, players},
    {sizes, "1/8", 3, Bits::float32, players, false, false, true},
    {bits, "32 bit float", 1, Bits::float32, players, true},
    {bits, "24 bit unorm", 1, Bits::unorm24, players},
    {bits, "16 bit unorm", 1, Bits::unorm16, players},
    {bits, "16 bit float", 1, Bits::half16, players},
    {tolerances, "0.0005", 1, Bits::float32, {0.0005f, false}, false, false, true},
    {tolerances, "0.004", 1, Bits::float32, {0.004f, false}},
    {tolerances, "0.02", 1, Bits::float32, {0.02f, false}, false, false, true},
    {tolerances, "footprint", 1, Bits::float32, {0, true}},
    {tolerances, "player's", 1, Bits::float32, players, true, false, true},
    {"rays", "one ray per point", 0, Bits::float32, {}, false, true},
};

/// A linear depth map as the player reads it, and its camera.
struct Map {
    int width = 0, height = 0;
    std::vector<float> z;
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    float fx = 0, fy = 0, cx = 0, cy = 0;
};

Map render_map(const BenchModel& model, const Camera& camera, int level) {
    // Maps are rendered at half the size given by the intrinsics, with angles and texture coordinates.
    const Level size = level_size(camera.intrinsics.width, camera.intrinsics.height, level);
    const Intrinsics k =
        camera.intrinsics.scaled(size.width << weight_map_level, size.height << weight_map_level);
    PhotoGeometry g = model.geometry(k, camera.cam_from_world);
    const double s = 1.0 / (1 << weight_map_level);
    return {g.width,
            g.height,
            std::move(g.z),
            camera.cam_from_world.R.cast<float>(),
            camera.cam_from_world.t.cast<float>(),
            float(k.fx * s),
            float(k.fy * s),
            float(k.cx * s),
            float(k.cy * s)};
}

/// The depths after quantization. Pixels that do not show the model keep +inf.
std::vector<float> stored(const std::vector<float>& z, Bits how) {
    if (how == Bits::float32) return z;
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const float d : z)
        if (std::isfinite(d)) nearest = std::min(nearest, d), farthest = std::max(farthest, d);
    // The last code represents +inf.
    const double codes = how == Bits::unorm24 ? 0xfffffe : 0xfffe;
    const double step = (double(farthest) - double(nearest)) / codes;
    std::vector<float> out = z;
    for (float& d : out) {
        if (!std::isfinite(d)) continue;
        if (how == Bits::half16)  // relative to the farthest depth, independent of the scene's unit
            d = farthest * float(Eigen::half(d / farthest));
        else if (step > 0)
            d = float(double(nearest) + step * std::round((double(d) - double(nearest)) / step));
    }
    return out;
}

/// A surface point that faces the photo and lies in its frame.
struct TestPoint {
    Eigen::Vector3d position;
    Eigen::Vector3f normal;  ///< normal, interpolated as in shaders
    bool seen;               ///< whether the photo sees the point, according to a ray
};

/// Makes the same decision as `seen` in shaders/blend.frag.
bool seen(const Map& map, const Tolerance& tolerance, const TestPoint& point) {
    const Eigen::Vector3f p = map.R * point.position.cast<float>() + map.t;
    const int x = int(std::floor(map.fx * p.x() / p.z() + map.cx - 0.5f)),
              y = int(std::floor(map.fy * p.y() / p.z() + map.cy - 0.5f));
    const Grid<const float> z{map.z.data(), map.width, map.height};
    const auto at = [&](int i, int j) {
        return z(std::clamp(i, 0, map.width - 1), std::clamp(j, 0, map.height - 1));
    };
    const float farthest = std::max({at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)});
    float slack = tolerance.share * p.z();
    if (tolerance.footprint) {
        const Eigen::Vector3f n = map.R * point.normal;
        const float cosine = std::max(std::abs(n.normalized().dot(p.normalized())), 0.1f);
        slack = std::max(slack, p.z() / std::min(map.fx, map.fy) / cosine);
    }
    return p.z() <= farthest + slack;
}

/// A third of a pixel's footprint, expressed as a fraction of the distance, as in vertex_coordinates(). Hits
/// closer to the point than this lie on its own surface.
double near_enough(const Intrinsics& k) { return 0.3 / std::max(k.fx, k.fy); }

bool seen_from_photo(const RayScene& rays, const Camera& camera, const Eigen::Vector3d& point) {
    const Eigen::Vector3d eye = camera.cam_from_world.center();
    return !rays.occluded(eye, point - eye, 0, 1 - near_enough(camera.intrinsics));
}

/// The exact method: traces the same line of sight from the other end.
bool sees_photo(const RayScene& rays, const Camera& camera, const Eigen::Vector3d& point) {
    return !rays.occluded(point, camera.cam_from_world.center() - point, near_enough(camera.intrinsics), 1);
}

/// The test point at `place`; empty if the surface faces away from the photo or `place` is outside the
/// photo's frame.
std::optional<TestPoint> test_point(const BenchModel& model, const RayScene& rays, const Camera& camera,
                                    const SurfacePoint& place) {
    const Eigen::Matrix3d c = corners(model.positions(), model.indices(), place.triangle);
    const Eigen::Vector3d p = c * place.weights;
    const auto drawn = project(camera.intrinsics, camera.cam_from_world, p);
    if (!drawn || !in_frame(camera.intrinsics, drawn->pixel) ||
        !(area_vector(c).dot(camera.cam_from_world.center() - p) > 0))
        return {};
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        normal += float(place.weights[Eigen::Index(i)]) *
                  model.scene().mesh.normals[model.indices()[3 * place.triangle + i]];
    return TestPoint{p, normal, seen_from_photo(rays, camera, p)};
}

/// Classifies all points and writes the results to `out`; returns the time in milliseconds.
double classify(const Setting& setting, const Map& map, const RayScene& rays, const Camera& camera,
                const std::vector<TestPoint>& points, std::vector<char>& out) {
    return milliseconds([&] {
        for (std::size_t i = 0; i < points.size(); ++i)
            out[i] = setting.ray ? sees_photo(rays, camera, points[i].position)
                                 : seen(map, setting.tolerance, points[i]);
    });
}

struct Result {
    double hidden = 0, visible = 0;  ///< numbers of points wrongly classified as hidden or visible
    std::vector<double> photo_ms, bytes, point_ns;
};

/// Adds the results of all settings for one photo.
void add(const BenchModel& model, const RayScene& rays, const Camera& camera, int repeats,
         const std::vector<TestPoint>& points, std::array<Result, std::size(settings)>& results) {
    std::array<Map, 4> rendered;
    const auto render_ms = medians_in_turn(rendered.size(), repeats, [&](std::size_t level) {
        return milliseconds([&] { rendered[level] = render_map(model, camera, int(level)); });
    });
    std::vector<Map> maps;
    std::vector<std::vector<char>> answers(std::size(settings), std::vector<char>(points.size()));
    for (std::size_t s = 0; s < std::size(settings); ++s) {
        const std::size_t level = std::size_t(settings[s].level);
        maps.push_back(settings[s].ray ? Map{} : rendered[level]);
        if (settings[s].ray) continue;
        const double store_ms =
            milliseconds([&] { maps[s].z = stored(rendered[level].z, settings[s].bits); });
        const double bytes = settings[s].bits == Bits::float32   ? 4
                             : settings[s].bits == Bits::unorm24 ? 3
                                                                 : 2;
        results[s].bytes.push_back(bytes * maps[s].width * maps[s].height * 4 / 3);
        results[s].photo_ms.push_back(render_ms[level] + store_ms);
    }
    const auto ms = medians_in_turn(std::size(settings), repeats, [&](std::size_t s) {
        return classify(settings[s], maps[s], rays, camera, points, answers[s]);
    });
    for (std::size_t s = 0; s < std::size(settings); ++s) {
        results[s].point_ns.push_back(ms[s] * 1e6 / double(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            results[s].hidden += points[i].seen && !answers[s][i];
            results[s].visible += !points[i].seen && answers[s][i];
        }
    }
}

/// The model as seen from another camera. It is light where it is visible in the photo, dark where it is
/// hidden, red where it is wrongly classified as visible, blue where it is wrongly classified as hidden, and
/// white where the surface does not face the photo.
Picture error_picture(const BenchModel& model, const RayScene& rays, const Camera& photo, const Camera& from,
                      const Setting& setting) {
    const Intrinsics& full = from.intrinsics;
    const int width = std::min(480, full.width);
    const Intrinsics k = full.scaled(width, std::max(1, width * full.height / full.width));
    const Map map = render_map(model, photo, setting.level);
    const Eigen::Matrix3d world_from_cam = from.cam_from_world.R.transpose();
    Picture out{k.width, k.height, {}, {}};
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x) {
            const Eigen::Vector3d ray((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            const auto hit = rays.first_hit(from.cam_from_world.center(), world_from_cam * ray);
            std::array<std::uint8_t, 4> color{255, 255, 255, 255};
            const auto point =
                hit ? test_point(model, rays, photo,
                                 {hit->triangle, {1 - hit->uv.sum(), hit->uv.x(), hit->uv.y()}})
                    : std::nullopt;
            if (point) {
                const bool visible = seen(map, setting.tolerance, *point);
                const float facing = std::abs(
                    point->normal.normalized().dot((world_from_cam * ray).normalized().cast<float>()));
                const auto shade = std::uint8_t((point->seen ? 120 : 40) + 100 * facing);
                color = {shade, shade, shade, 255};
                if (visible && !point->seen) color = {220, 30, 30, 255};
                if (!visible && point->seen) color = {30, 70, 230, 255};
            }
            out.rgba.insert(out.rgba.end(), color.begin(), color.end());
        }
    return out;
}

std::vector<Measurement> listed(const std::array<Result, std::size(settings)>& results, std::size_t points) {
    std::vector<Measurement> out;
    for (std::size_t s = 0; s < std::size(settings); ++s) {
        Measurement m;
        m.curve = settings[s].curve;
        m.setting = settings[s].name;
        m.exact = settings[s].ray;
        m.chosen = settings[s].chosen;
        m.values = {{"false_hidden", 100 * results[s].hidden / double(points)},
                    {"false_visible", 100 * results[s].visible / double(points)},
                    {"photo_ms", mean(results[s].photo_ms)},
                    {"point_ns", mean(results[s].point_ns)}};
        if (!settings[s].ray) m.values["photo_bytes"] = mean(results[s].bytes);
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort,
                                 const std::filesystem::path& folder) {
    const gl::HeadlessContext context;
    const BenchModel model(read_scene(discover(scene.folder)));
    if (model.indices().empty()) return {};  // a point cloud hides nothing
    std::optional<RayScene> rays;
    const double tree_ms = milliseconds([&] { rays.emplace(model.positions(), model.indices()); });
    const auto places = surface_points(model.positions(), model.indices(), effort.points, 1);
    const std::vector<Camera> cameras = model.some_cameras(effort.photos);
    std::array<Result, std::size(settings)> results;
    std::size_t points = 0;
    for (const Camera& camera : cameras) {
        std::vector<TestPoint> here;
        for (const SurfacePoint& place : places)
            if (const auto point = test_point(model, *rays, camera, place)) here.push_back(*point);
        points += here.size();
        if (!here.empty()) add(model, *rays, camera, effort.repeats, here, results);
    }
    if (points == 0) return {};
    // Instead of a map, rays need a tree over the model. All photos share the cost of the tree.
    results.back().photo_ms = {tree_ms / double(model.scene().photos.size())};
    std::vector<Measurement> out = listed(results, points);
    for (std::size_t s = 0; s < out.size(); ++s) {
        if (!settings[s].shown) continue;
        const Picture p = error_picture(model, *rays, cameras.front(), cameras.back(), settings[s]);
        out[s].exhibits.push_back(keep_exhibit(folder, scene.name + "-depth-" + std::to_string(s),
                                               std::string(settings[s].curve) + ": " + settings[s].name +
                                                   " (red: wrongly visible, blue: wrongly hidden)",
                                               p, {0, 0, p.width, p.height}));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"all", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep depth_sweep;
const Sweep depth_sweep{
    "depth",
    "Visible or hidden",
    "Which size, bit depth and tolerance must a photo's depth map have to determine which surface points the "
    "photo sees?",
    "rays from the photo to random points on the surface",
    "wrong at 0.001 % of the points, where rays from the two ends of a line are rounded differently",
    {{"photo_bytes", "false_visible", true, false},
     {"photo_bytes", "false_hidden", true, false},
     {"point_ns", "false_visible", true, false}},
    jobs};

}  // namespace vantage::bench

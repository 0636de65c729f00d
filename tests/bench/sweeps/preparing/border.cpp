// Compares methods and resolutions for computing the distances on which the border weight depends.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/gl/context.h"
#include "base/values/grid.h"
#include "base/values/quantile.h"
#include "base/values/tiling.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/stages/borders.h"
#include "pipeline/visibility/border_distance.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/model.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

// Chamfer distances (Borgefors 1986, with OpenCV's 5x5 mask) are not an option of prepare, because they are
// only approximate and, in this implementation, slower than exact distances.
constexpr const char* methods[] = {"exact", "chamfer", "jfa^2"};

/// A photo's depth map at a fraction of the photo's size, and the full border width in pixels of the map.
struct Map {
    DepthMap depth;
    float full_width;
};

Map depth_map(const BenchModel& model, const Camera& camera, double scale) {
    // Maps are rendered at half the size given by the intrinsics.
    const Intrinsics& k = camera.intrinsics;
    const auto times = [&](int n) {
        return std::max(2, int(std::lround(n * scale * (1 << weight_map_level))));
    };
    PhotoGeometry g = model.geometry(k.scaled(times(k.width), times(k.height)), camera.cam_from_world);
    return {{g.width, g.height, std::move(g.z), {}}, float(border_width * k.width / 3072 * scale)};
}

std::vector<float> chamfer_distance(const std::vector<std::uint8_t>& borders, int width, int height) {
    cv::Mat away(height, width, CV_8UC1), out;
    for (std::size_t i = 0; i < borders.size(); ++i) away.data[i] = borders[i] ? 0 : 255;
    cv::distanceTransform(away, out, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
    return {out.begin<float>(), out.end<float>()};
}

std::vector<float> distances(const std::string& method, const std::vector<std::uint8_t>& borders,
                             const Map& map, const gl::Program& jump_flood) {
    const int w = map.depth.width, h = map.depth.height;
    if (method == "exact") return exact_distance(borders, w, h);
    if (method == "chamfer") return chamfer_distance(borders, w, h);
    return flood_distance(jump_flood, borders, w, h);
}

/// The weight map, sampled bilinearly as it is in the player.
float bilinear(const std::vector<std::uint8_t>& weights, int w, int h, double x, double y) {
    const double u = std::clamp(x - 0.5, 0.0, w - 1.0), v = std::clamp(y - 0.5, 0.0, h - 1.0);
    const int i = std::min(int(u), std::max(0, w - 2)), j = std::min(int(v), std::max(0, h - 2));
    const Grid<const std::uint8_t> texels{weights.data(), w, h};
    const auto at = [&](int a, int b) { return double(texels(std::min(a, w - 1), std::min(b, h - 1))); };
    const double s = u - i, t = v - j;
    return float((1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
                 t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1)));
}

struct Errors {
    std::vector<float> weights;  ///< absolute error of the weight at each pixel of the full photo
    double distance = 0;         ///< largest error, in pixels of the full photo
    double bytes = 0;
};

void add_errors(const std::vector<std::uint8_t>& weights, const Map& map,
                const std::vector<std::uint8_t>& truth, const Map& full, Errors& e) {
    const int w = map.depth.width, h = map.depth.height;
    const double sx = double(w) / full.depth.width, sy = double(h) / full.depth.height;
    const Grid<const std::uint8_t> expected{truth.data(), full.depth.width, full.depth.height};
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x)
            e.weights.push_back(
                std::abs(bilinear(weights, w, h, (x + 0.5) * sx, (y + 0.5) * sy) - float(expected(x, y))));
}

/// Measures all methods at one scale, on the same photos.
std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, int level,
                                 const std::filesystem::path& folder) {
    const gl::HeadlessContext context;
    const BenchModel model(read_scene(discover(scene.folder)));
    const gl::Program jump_flood = jump_flood_program();
    const double scale = 1.0 / (1 << level);
    const float threshold = float(border_threshold);
    std::vector<Errors> errors(std::size(methods));
    std::vector<std::vector<double>> ms(std::size(methods));
    std::vector<Measurement> out(std::size(methods));
    for (const Camera& camera : model.some_cameras(effort.photos)) {
        const Map full = depth_map(model, camera, 1), map = level ? depth_map(model, camera, scale) : full;
        const int fw = full.depth.width, fh = full.depth.height, w = map.depth.width, h = map.depth.height;
        const auto truth = border_weights(exact_distance(find_borders(full.depth, threshold), fw, fh), fw, fh,
                                          full.full_width);
        const auto exact = exact_distance(find_borders(map.depth, threshold), w, h);
        std::vector<std::vector<std::uint8_t>> weight_maps(std::size(methods));
        std::vector<std::vector<float>> found(std::size(methods));
        const auto time = [&](std::size_t m) {
            return milliseconds([&] {
                found[m] = distances(methods[m], find_borders(map.depth, threshold), map, jump_flood);
                weight_maps[m] = border_weights(found[m], w, h, map.full_width);
            });
        };
        const std::vector<double> medians =
            medians_in_turn(std::size(methods), level > 1 ? effort.repeats : 1, time);
        for (std::size_t m = 0; m < std::size(methods); ++m) {
            add_errors(weight_maps[m], map, truth, full, errors[m]);
            for (std::size_t i = 0; i < exact.size(); ++i)
                if (std::isfinite(exact[i]))
                    errors[m].distance =
                        std::max(errors[m].distance, double(std::abs(found[m][i] - exact[i])) / scale);
            errors[m].bytes = 4.0 * w * h;
            ms[m].push_back(medians[m]);
            if (!out[m].exhibits.empty()) continue;
            const Picture right = gray_picture(truth, fw, fh), wrong = gray_picture(weight_maps[m], w, h);
            const Picture scaled = enlarged(wrong, fw, fh);
            out[m].exhibits.push_back(keep_exhibit(
                folder, scene.name + "-border-" + std::to_string(level) + "-" + std::to_string(m),
                std::string(methods[m]) + ", weight maps at 1/" + std::to_string(1 << level), scaled,
                worst_window(right, scaled)));
        }
    }
    for (std::size_t m = 0; m < std::size(methods); ++m) {
        out[m].curve = "weight maps at 1/" + std::to_string(1 << level);
        out[m].setting = methods[m];
        out[m].exact = level == 0 && m == 0;
        out[m].chosen = level == weight_map_level && m == 0;
        out[m].values = {{"weight_mean", mean(errors[m].weights)},
                         {"weight_worst", quantile(errors[m].weights, 0.999)},
                         {"distance_worst", errors[m].distance},
                         {"photo_ms", mean(ms[m])},
                         {"photo_bytes", errors[m].bytes}};
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    std::vector<Job> out;
    for (int level = 0; level <= 3; ++level)
        out.push_back({"1/" + std::to_string(1 << level),
                       [=, &scene] { return measure(scene, effort, level, folder); }});
    return out;
}

}  // namespace

extern const Sweep border_sweep;
const Sweep border_sweep{"border",
                         "Distance to the nearest border",
                         "Jump flooding is fast on a graphics card but slightly inexact, and weight maps at "
                         "half the size cost only a quarter as much. "
                         "How large are the errors in the border weight?",
                         "the exact distance transform at full size",
                         "0 of 255",
                         {{"photo_ms", "weight_mean"}, {"photo_bytes", "weight_worst"}},
                         jobs};

}  // namespace vantage::bench

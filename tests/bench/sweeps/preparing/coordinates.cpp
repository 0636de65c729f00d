// Compares texture coordinates that are stored per vertex and interpolated with those computed per fragment.
#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/gl/context.h"
#include "base/values/quantile.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "scene/package/package_reader.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/model.h"
#include "tests/bench/scenes/surface_points.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

enum class Kept { unorm16, floats, homogeneous, nothing, count };
constexpr std::size_t kinds = std::size_t(Kept::count);

struct Kind {
    const char* name;
    double vertex_bytes;
};
constexpr std::array<Kind, kinds> kind_table{{{"16-bit unorm per vertex", 4},
                                              {"float per vertex", 8},
                                              {"homogeneous float per vertex", 12},
                                              {"per fragment", 0}}};

using Triangles = std::vector<std::uint32_t>;

/// The model simplified to 1/`divisor` of its triangles, or as far as meshoptimizer can simplify it.
Triangles simplified(const BenchModel& model, unsigned divisor) {
    const Triangles& all = model.indices();
    if (divisor == 1 || all.empty()) return all;
    Triangles out(all.size());
    const auto& p = model.positions();
    // Any error is allowed: only the size of the triangles matters, not the model's appearance.
    out.resize(meshopt_simplify(out.data(), all.data(), all.size(), p.front().data(), p.size(),
                                sizeof(Eigen::Vector3f), all.size() / 3 / divisor * 3, 1e9f));
    return out;
}

/// The triangles that have all corners in the photo's frame.
Triangles in_photo(const BenchModel& model, const Triangles& triangles, const Camera& camera) {
    const auto inside = [&](std::uint32_t v) {
        const auto p = project(camera.intrinsics, camera.cam_from_world, model.positions()[v].cast<double>());
        return p && in_frame(camera.intrinsics, p->pixel);
    };
    Triangles out;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        if (inside(triangles[i]) && inside(triangles[i + 1]) && inside(triangles[i + 2]))
            out.insert(out.end(), &triangles[i], &triangles[i] + 3);
    return out;
}

/// The coordinates of the vertices in a photo, in all representations.
struct Vertices {
    std::vector<std::array<std::uint16_t, 2>> unorm16;
    std::vector<Eigen::Vector2f> floats;
    std::vector<Eigen::Vector3f> homogeneous;  ///< u z, v z, z
};

Vertices vertices(const BenchModel& model, const Camera& camera) {
    const Intrinsics& k = camera.intrinsics;
    Vertices out;
    for (const Eigen::Vector3f& position : model.positions()) {
        const auto p = project(k, camera.cam_from_world, position.cast<double>());
        Eigen::Vector2d uv(-1, -1);
        if (p && in_frame(k, p->pixel)) uv = p->pixel.cwiseQuotient(Eigen::Vector2d(k.width, k.height));
        const double z = p ? p->z : 0;
        const auto code = [](double u) {
            return std::uint16_t(std::lround(65535 * std::clamp(u, 0.0, 1.0)));
        };
        out.unorm16.push_back({code(uv.x()), code(uv.y())});
        out.floats.push_back(uv.cast<float>());
        out.homogeneous.push_back(Eigen::Vector3d(uv.x() * z, uv.y() * z, z).cast<float>());
    }
    return out;
}

/// A point on a triangle: the triangle's corners and their weights in single precision.
struct Place {
    std::array<std::uint32_t, 3> corner;
    Eigen::Vector3f weights;
};

/// A value interpolated linearly in space from the values at the corners, as is done between vertex and
/// fragment shaders.
template <class T>
T interpolated(const std::vector<T>& values, const Place& at) {
    return values[at.corner[0]] * at.weights[0] + values[at.corner[1]] * at.weights[1] +
           values[at.corner[2]] * at.weights[2];
}

/// The camera in single precision, as shaders use it.
struct Single {
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    Eigen::Array2f focal, center, size;
};

Single single(const Camera& camera) {
    const Intrinsics& k = camera.intrinsics;
    return {camera.cam_from_world.R.cast<float>(),
            camera.cam_from_world.t.cast<float>(),
            {float(k.fx), float(k.fy)},
            {float(k.cx), float(k.cy)},
            {float(k.width), float(k.height)}};
}

/// The position in the photo in pixels, computed in single precision.
Eigen::Array2f pixel(Kept kept, const BenchModel& model, const Vertices& v, const Single& photo,
                     const Place& at) {
    switch (kept) {
        case Kept::unorm16: {
            Eigen::Array2f uv = Eigen::Array2f::Zero();
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& code = v.unorm16[at.corner[i]];
                uv += Eigen::Array2f(code[0], code[1]) * (at.weights[Eigen::Index(i)] / 65535.0f);
            }
            return uv * photo.size;
        }
        case Kept::floats:
            return interpolated(v.floats, at).array() * photo.size;
        case Kept::homogeneous: {
            const Eigen::Vector3f h = interpolated(v.homogeneous, at);
            return h.head<2>().array() / h.z() * photo.size;
        }
        case Kept::nothing:
        case Kept::count:
            break;
    }
    // Projects a position relative to the model's origin, as in shaders/blend.frag.
    const Eigen::Vector3f p = photo.R * interpolated(model.positions(), at) + photo.t;
    return photo.focal * p.head<2>().array() / p.z() + photo.center;
}

struct Result {
    std::vector<float> px;
    std::vector<double> point_ns;
};

/// Adds the results of all representations for one photo.
void add(const BenchModel& model, const Triangles& triangles, const Camera& camera, const Effort& effort,
         std::array<Result, kinds>& results, std::vector<float>& triangle_px) {
    const Triangles shown = in_photo(model, triangles, camera);
    std::vector<Place> places;
    std::vector<Eigen::Vector2d> truth;
    for (const SurfacePoint& s : surface_points(model.positions(), shown, effort.points, 2)) {
        const Eigen::Matrix3d c = corners(model.positions(), shown, s.triangle);
        const auto at = [&](const Eigen::Vector3d& p) {
            return project(camera.intrinsics, camera.cam_from_world, p);
        };
        const auto here = at(c * s.weights), p = at(c.col(0)), q = at(c.col(1)), r = at(c.col(2));
        if (!here || !p || !q || !r) continue;  // its corners are in front, so only rounding can cause this
        const Eigen::Vector2d e = q->pixel - p->pixel, f = r->pixel - p->pixel;
        triangle_px.push_back(float(std::sqrt(std::abs(e.x() * f.y() - e.y() * f.x()) / 2)));
        const auto* i = &shown[3 * s.triangle];
        places.push_back({{i[0], i[1], i[2]}, s.weights.cast<float>()});
        truth.push_back(here->pixel);
    }
    if (places.empty()) return;
    const Vertices v = vertices(model, camera);
    const Single photo = single(camera);
    std::array<std::vector<Eigen::Array2f>, kinds> found;
    found.fill(std::vector<Eigen::Array2f>(places.size()));
    const auto ms = medians_in_turn(kinds, effort.repeats, [&](std::size_t k) {
        return milliseconds([&] {
            for (std::size_t i = 0; i < places.size(); ++i)
                found[k][i] = pixel(Kept(k), model, v, photo, places[i]);
        });
    });
    for (std::size_t k = 0; k < kinds; ++k) {
        results[k].point_ns.push_back(ms[k] * 1e6 / double(places.size()));
        for (std::size_t i = 0; i < places.size(); ++i)
            results[k].px.push_back(float((found[k][i].matrix().cast<double>() - truth[i]).norm()));
    }
}

/// Measures all representations on the model simplified by `divisor`.
std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, unsigned divisor) {
    const gl::HeadlessContext context;
    const BenchModel model(read_scene(discover(scene.folder)));
    const Triangles triangles = simplified(model, divisor);
    std::array<Result, kinds> results;
    std::vector<float> triangle_px;
    for (const Camera& camera : model.some_cameras(effort.photos))
        add(model, triangles, camera, effort, results, triangle_px);
    if (triangle_px.empty()) return {};
    const PackageReader package(scene.package);
    const Kept chosen = effect_on(package.scene(), Effect::per_fragment) ? Kept::nothing : Kept::floats;
    std::vector<Measurement> out;
    for (std::size_t k = 0; k < kinds; ++k) {
        Measurement m;
        m.curve = kind_table[k].name;
        m.setting = divisor == 1 ? "full mesh" : "mesh 1/" + std::to_string(divisor);
        m.exact = Kept(k) == Kept::nothing;
        m.chosen = divisor == 1 && Kept(k) == chosen;
        m.values = {{"px_median", quantile(results[k].px, 0.5)},
                    {"px_worst", quantile(results[k].px, 0.999)},
                    {"triangle_px", quantile(triangle_px, 0.5)},
                    {"vertex_bytes", kind_table[k].vertex_bytes},
                    {"point_ns", mean(results[k].point_ns)}};
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    std::vector<Job> out;
    for (const unsigned divisor : {1u, 4u, 16u, 64u})
        out.push_back(
            {"1/" + std::to_string(divisor), [=, &scene] { return measure(scene, effort, divisor); }});
    return out;
}

}  // namespace

extern const Sweep coordinates_sweep;
const Sweep coordinates_sweep{
    "coordinates",
    "Texture coordinates",
    "Coordinates that are stored per vertex are fast to look up, but perspective is not linear over a "
    "triangle. Above which triangle size must every fragment be projected instead?",
    "the projection of random points on the triangles in double precision",
    "0.001 px",
    {{"triangle_px", "px_median", true, true},
     {"triangle_px", "px_worst", true, true},
     {"point_ns", "px_worst", true, true}},
    jobs};

}  // namespace vantage::bench

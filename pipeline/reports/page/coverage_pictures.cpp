#include "pipeline/reports/page/coverage_pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "base/values/main_box.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/package/contents/opaque_part.h"

namespace vantage {

using package::Type;

const std::array<CoverageClass, 5> coverage_classes{{{"no photo", {196, 48, 40}},
                                                     {"one photo", {232, 140, 44}},
                                                     {"two photos", {226, 205, 70}},
                                                     {"three or four", {122, 182, 92}},
                                                     {"five or more", {46, 125, 110}}}};

namespace {

/// The world axis nearest to the up direction, and its sign.
struct UpAxis {
    int axis = 2;   ///< 0, 1, 2: x, y, z
    int sign = +1;  ///< -1 if the axis points down
};

UpAxis up_axis(const Eigen::Vector3d& up) {
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    return {int(axis), up[axis] < 0 ? -1 : 1};
}

std::size_t class_of(unsigned photos) { return photos < 3 ? photos : photos < 5 ? 3 : 4; }

struct Geometry {
    std::span<const Eigen::Vector3f> positions;
    std::span<const std::uint32_t> indices;
    Eigen::AlignedBox3d bounds;

    explicit Geometry(const PackageReader& package)
        : positions(package.records<Eigen::Vector3f>(Type::positions)),
          indices(package.records<std::uint32_t>(Type::indices)
                      .first(3 * std::size_t(opaque_part(package).triangles))),
          bounds(bounds_from_origin(package.scene())) {}
    std::array<Eigen::Vector3f, 3> corners(std::size_t triangle) const {
        return {positions[indices[3 * triangle]], positions[indices[3 * triangle + 1]],
                positions[indices[3 * triangle + 2]]};
    }
};

/// A parallel projection of the model along an axis, seen from the positive side.
struct ParallelView {
    Eigen::Matrix3f axes;  ///< rows: the world axes that point right, down and forward in the picture
    Eigen::Vector3f center;
    float scale;
    int width, height;

    Eigen::Vector3f at(const Eigen::Vector3f& p) const {
        const Eigen::Vector3f d = axes * (p - center);
        return {float(width) / 2 + d.x() * scale, float(height) / 2 + d.y() * scale, d.z()};
    }
};

ParallelView look_along(int axis, const UpAxis& up, const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                        int size) {
    const Eigen::Vector3f forward = -Eigen::Vector3f::Unit(axis);
    // In views from above or below, the preceding axis points to the top of the picture: y if z is up.
    const Eigen::Vector3f down = axis == up.axis ? (-Eigen::Vector3f::Unit((axis + 2) % 3)).eval()
                                                 : (-float(up.sign) * Eigen::Vector3f::Unit(up.axis)).eval();
    ParallelView p{{}, (low + high) / 2, 1, 0, 0};
    p.axes << down.cross(forward).transpose(), down.transpose(), forward.transpose();
    const Eigen::Vector3f extent = p.axes.cwiseAbs() * (high - low).cwiseMax((high - low).maxCoeff() * 1e-3f);
    p.scale = float(size - 8) / std::max(extent.x(), extent.y());
    p.width = std::max(16, int(extent.x() * p.scale) + 8);
    p.height = std::max(16, int(extent.y() * p.scale) + 8);
    return p;
}

/// A side of the model. The top and the bottom come last.
struct Side {
    int axis;
    bool opposite;
    std::string name;
};
std::vector<Side> sides(const UpAxis& up) {
    std::vector<Side> out;
    for (const bool upright : {true, false})
        for (int axis = 0; axis < 3; ++axis)
            for (const bool opposite : {false, true})
                if ((axis != up.axis) == upright)
                    out.push_back({axis, opposite, std::string(opposite ? "-" : "+") + "xyz"[axis]});
    if (up.sign < 0) std::swap(out[4], out[5]);
    out[4].name = "above (" + out[4].name + ")";
    out[5].name = "below (" + out[5].name + ")";
    return out;
}

/// The nearest triangle at each pixel, and the farthest one, which is visible in the opposite view.
struct Canvas {
    static constexpr std::uint32_t nothing = ~0u;
    struct Pixel {
        float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
        std::uint32_t first = nothing, last = nothing;
    };
    int width, height;
    std::vector<Pixel> pixels;

    explicit Canvas(const ParallelView& view)
        : width(view.width), height(view.height), pixels(std::size_t(width) * std::size_t(height)) {}

    void put(int x, int y, float z, std::uint32_t number) {
        Pixel& p = pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        if (z < p.nearest) p.nearest = z, p.first = number;
        if (z > p.farthest) p.farthest = z, p.last = number;
    }
    /// Merges another canvas of the same view into this one. Its triangles must have higher numbers.
    void add(const Canvas& others) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            Pixel& p = pixels[i];
            const Pixel& o = others.pixels[i];
            if (o.nearest < p.nearest) p.nearest = o.nearest, p.first = o.first;
            if (o.farthest > p.farthest) p.farthest = o.farthest, p.last = o.last;
        }
    }
};

/// Fills the pixels whose centers lie in the triangle, and always the pixel of its first corner.
void fill(Canvas& canvas, const std::array<Eigen::Vector3f, 3>& p, std::uint32_t number) {
    const auto pixel = [](float v, int end) { return std::clamp(int(v), 0, end - 1); };
    const int w = canvas.width, h = canvas.height;
    canvas.put(pixel(p[0].x(), w), pixel(p[0].y(), h), p[0].z(), number);
    const int x0 = pixel(std::min({p[0].x(), p[1].x(), p[2].x()}), w),
              x1 = pixel(std::max({p[0].x(), p[1].x(), p[2].x()}), w);
    const int y0 = pixel(std::min({p[0].y(), p[1].y(), p[2].y()}), h),
              y1 = pixel(std::max({p[0].y(), p[1].y(), p[2].y()}), h);
    if (x0 == x1 && y0 == y1) return;
    const float area =
        (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x());
    if (!(std::abs(area) > 1e-12f)) return;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const Eigen::Vector2f c(float(x) + 0.5f, float(y) + 0.5f);
            const auto part = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                return ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / area;
            };
            const float u = part(p[1], p[2]), v = part(p[2], p[0]), t = part(p[0], p[1]);
            if (u >= 0 && v >= 0 && t >= 0)
                canvas.put(x, y, u * p[0].z() + v * p[1].z() + t * p[2].z(), number);
        }
}

std::array<std::uint8_t, 3> shaded(unsigned photos, const std::array<Eigen::Vector3f, 3>& corners, int axis) {
    const Eigen::Vector3f n = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const float length = n.norm(), facing = length > 0 ? std::abs(n[axis]) / length : 1;
    std::array<std::uint8_t, 3> color = coverage_classes[class_of(photos)].color;
    for (std::uint8_t& c : color) c = std::uint8_t(float(c) * (0.55f + 0.45f * facing));
    return color;
}

/// In the opposite view, left and right are exchanged.
RgbaImage picture(const Canvas& canvas, bool opposite, const Geometry& g, const std::vector<unsigned>& photos,
                  int axis) {
    RgbaImage image{canvas.width, canvas.height, std::vector<std::uint8_t>(canvas.pixels.size() * 4, 255),
                    true};
    std::uint8_t* to = image.rgba.data();
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x, to += 4) {
            const int column = opposite ? canvas.width - 1 - x : x;
            const Canvas::Pixel& p =
                canvas.pixels[std::size_t(y) * std::size_t(canvas.width) + std::size_t(column)];
            const std::uint32_t t = opposite ? p.last : p.first;
            if (t == Canvas::nothing) continue;
            const auto color = shaded(photos[t], g.corners(t), axis);
            std::copy_n(color.begin(), 3, to);
        }
    return image;
}

}  // namespace

std::vector<unsigned> photos_per_triangle(const PackageReader& package) {
    const std::uint64_t triangles = package.scene().triangles;
    std::vector<unsigned> count(triangles, 0);
    for (std::uint32_t i = 0; i < package.photos().size(); ++i) {
        const auto bits = package.records<std::uint64_t>(Type::visible, i, false);
        const std::uint64_t words = package::visible_words(triangles);
        if (bits.size() != 2 * words) continue;
        for (std::uint64_t t = 0; t < triangles; t += 64) {
            std::uint64_t seen = bits[words + t / 64];
            for (; seen; seen &= seen - 1) ++count[t + std::uint64_t(std::countr_zero(seen))];
        }
        package.forget(std::as_bytes(bits));
    }
    count.resize(opaque_part(package).triangles);
    return count;
}

std::array<double, 5> covered_area(const PackageReader& package, const std::vector<unsigned>& photos) {
    const Geometry g(package);
    std::array<double, 5> area{};
    double total = 0;
    for (std::size_t t = 0; t < photos.size(); ++t) {
        const auto p = g.corners(t);
        if (has_stray(p, g.bounds)) continue;
        const double a = double((p[1] - p[0]).cross(p[2] - p[0]).norm());
        area[class_of(photos[t])] += a;
        total += a;
    }
    for (double& a : area) a = total > 0 ? a / total : 0;
    return area;
}

namespace {

std::array<ParallelView, 3> views(const Geometry& g, const UpAxis& up, int size) {
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
    for (std::size_t t = 0; t < g.indices.size() / 3; ++t)
        if (const auto corners = g.corners(t); !has_stray(corners, g.bounds))
            for (const Eigen::Vector3f& p : corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    return {look_along(0, up, low, high, size), look_along(1, up, low, high, size),
            look_along(2, up, low, high, size)};
}

/// Draws all triangles in all views, divided among the cores of the CPU.
std::vector<Canvas> draw(const Geometry& g, const std::array<ParallelView, 3>& views) {
    const std::size_t triangles = g.indices.size() / 3;
    const std::size_t shares = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    std::vector<std::vector<Canvas>> canvases(shares, std::vector<Canvas>(views.begin(), views.end()));
    for_each_photo(shares, 0, [&](std::size_t s) {
        for (std::size_t t = triangles * s / shares; t < triangles * (s + 1) / shares; ++t) {
            const auto p = g.corners(t);
            if (has_stray(p, g.bounds)) continue;
            for (std::size_t axis = 0; axis < views.size(); ++axis)
                fill(canvases[s][axis], {views[axis].at(p[0]), views[axis].at(p[1]), views[axis].at(p[2])},
                     std::uint32_t(t));
        }
    });
    for (std::size_t s = 1; s < shares; ++s)
        for (std::size_t axis = 0; axis < views.size(); ++axis) canvases[0][axis].add(canvases[s][axis]);
    return std::move(canvases[0]);
}

}  // namespace

std::vector<CoveragePicture> coverage_pictures(const PackageReader& package,
                                               const std::vector<unsigned>& photos, int size) {
    if (photos.empty()) return {};
    const Geometry g(package);
    const UpAxis up = up_axis(up_of(package.scene()));
    const std::vector<Canvas> canvases = draw(g, views(g, up, size));
    const std::vector<Side> all = sides(up);
    std::vector<CoveragePicture> pictures(all.size());
    for_each_photo(pictures.size(), 0, [&](std::size_t i) {
        const Side& side = all[i];
        pictures[i] = {side.name,
                       picture(canvases[std::size_t(side.axis)], side.opposite, g, photos, side.axis)};
    });
    return pictures;
}

}  // namespace vantage

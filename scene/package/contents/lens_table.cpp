#include "scene/package/contents/lens_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/tiling.h"

namespace vantage {
namespace {

using Eigen::Vector2d;

/// Like distort(), but continued smoothly beyond the range.
Vector2d continued(const Lens& lens, double range, const Vector2d& ray) {
    const double r = ray.norm();
    if (r <= range) return distort(lens, ray);
    const Vector2d at = ray * (range / r), inner = at * (1 - 1e-4);
    const Vector2d slope = (distort(lens, at) - distort(lens, inner)) / (1e-4 * range);
    return distort(lens, at) + slope * (r - range);
}

/// The displacement at a node, in pixels. Node 0 lies on the frame's edge; nodes are one cell apart.
Vector2d displacement(const Intrinsics& k, const Lens& lens, double range, int column, int row) {
    constexpr double most = 1e6;
    const Vector2d pixel(double(column) * k.width / LensTable::cells,
                         double(row) * k.height / LensTable::cells);
    const Vector2d ray((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy);
    const Vector2d d = continued(lens, range, ray) - ray;
    const Vector2d px(k.fx * d.x(), k.fy * d.y());
    return px.allFinite() ? Vector2d(px.cwiseMax(-most).cwiseMin(most)) : Vector2d(most, most);
}

/// Coefficients from values at nodes, using the quasi-interpolant (-1, 8, -1) / 6, which is exact for cubics.
/// `at`: returns the value of node i, from -2 to cells + 2.
template <class Value>
auto coefficient(int i, const Value& at) {
    return ((8 * at(i) - at(i - 1) - at(i + 1)) / 6).eval();
}

bool is_inside(const Intrinsics& k, const Vector2d& pixel, double margin) {
    return pixel.x() >= margin && pixel.y() >= margin && pixel.x() <= k.width - margin &&
           pixel.y() <= k.height - margin;
}

/// Whether the image of a whole cell lies inside the photo.
bool is_inside(const LensTable& t, int column, int row, double margin) {
    const Intrinsics& k = t.camera;
    const Vector2d size(double(k.width) / LensTable::cells, double(k.height) / LensTable::cells);
    const Eigen::AlignedBox2d cell(Vector2d(column * size.x(), row * size.y()),
                                   Vector2d((column + 1) * size.x(), (row + 1) * size.y()));
    const Vector2d far = (cell.min() - Vector2d(k.cx, k.cy))
                             .cwiseAbs()
                             .cwiseMax((cell.max() - Vector2d(k.cx, k.cy)).cwiseAbs());
    if (!(std::hypot(far.x() / k.fx, far.y() / k.fy) <= t.range)) return false;
    const Vector2d inset = size * 1e-6;  // strictly within this cell
    const Eigen::AlignedBox2d to = photo_bounds(t, {cell.min() + inset, cell.max() - inset});
    return is_inside(k, to.min(), margin) && is_inside(k, to.max(), margin);
}

}  // namespace

LensTable lens_table(const Intrinsics& camera, const Lens& lens) {
    LensTable out{camera, std::min(lens_range(lens), 1e9), {}};
    constexpr int cells = LensTable::cells, side = LensTable::side, nodes = side + 2;
    std::vector<Vector2d> values;
    values.reserve(std::size_t(nodes) * nodes);
    for (int y = -2; y < nodes - 2; ++y)
        for (int x = -2; x < nodes - 2; ++x) values.push_back(displacement(camera, lens, out.range, x, y));
    const auto value = [&](int x, int y) -> const Vector2d& {
        return values[std::size_t(y + 2) * nodes + std::size_t(x + 2)];
    };
    out.displaced.reserve(std::size_t(side) * side);
    for (int y = -1; y <= cells + 1; ++y)
        for (int x = -1; x <= cells + 1; ++x)
            out.displaced.push_back(coefficient(y, [&](int j) {
                                        return coefficient(x, [&](int i) { return value(i, j); });
                                    }).cast<float>());
    return out;
}

std::optional<LensTable> lens_table(const PackageReader& package, const package::PhotoRecord& record,
                                    std::uint32_t photo) {
    const Lens lens = lens_of(package, photo);
    return lens.distorts() ? std::optional(lens_table(intrinsics(record), lens)) : std::nullopt;
}

SplinePlace spline_place(double share) {
    const double at = std::clamp(share, 0.0, 1.0) * LensTable::cells;
    const int first = std::min(int(at), LensTable::cells - 1);
    const double f = at - first, g = 1 - f;
    return {first,
            {float(g * g * g / 6), float((3 * f * f * f - 6 * f * f + 4) / 6),
             float((3 * g * g * g - 6 * g * g + 4) / 6), float(f * f * f / 6)}};
}

Vector2d photo_pixel(const LensTable& table, const Vector2d& pixel) {
    const Intrinsics& k = table.camera;
    const Vector2d ray((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy);
    if (!(ray.norm() <= table.range)) return Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    const SplinePlace x = spline_place(pixel.x() / k.width), y = spline_place(pixel.y() / k.height);
    Eigen::Vector2f sum = Eigen::Vector2f::Zero();
    for (int j = 0; j < 4; ++j) {
        const auto* row = &table.displaced[std::size_t(y.first + j) * LensTable::side + std::size_t(x.first)];
        for (int i = 0; i < 4; ++i) sum += y.weights[std::size_t(j)] * x.weights[std::size_t(i)] * row[i];
    }
    return pixel + sum.cast<double>();
}

double largest_displacement(const Camera& camera) {
    if (!camera.lens.distorts()) return 0;
    constexpr int n = 32;
    const Intrinsics& k = camera.intrinsics;
    const double range = lens_range(camera.lens);
    double largest = 0;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const Vector2d ray((double(i) * k.width / n - k.cx) / k.fx,
                               (double(j) * k.height / n - k.cy) / k.fy);
            if (!(ray.norm() <= range)) continue;
            const Vector2d d = distort(camera.lens, ray) - ray;
            const double px = std::hypot(k.fx * d.x(), k.fy * d.y());
            if (std::isfinite(px)) largest = std::max(largest, px);
        }
    return largest;
}

Eigen::AlignedBox2d photo_bounds(const LensTable& table, const Eigen::AlignedBox2d& pixels) {
    const Intrinsics& k = table.camera;
    const int left = spline_place(pixels.min().x() / k.width).first,
              right = spline_place(pixels.max().x() / k.width).first + 3,
              top = spline_place(pixels.min().y() / k.height).first,
              bottom = spline_place(pixels.max().y() / k.height).first + 3;
    // The values of a spline lie within the range of its coefficients.
    Eigen::AlignedBox2f moves;
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
            moves.extend(table.displaced[std::size_t(y) * LensTable::side + std::size_t(x)]);
    return {pixels.min() + moves.min().cast<double>(), pixels.max() + moves.max().cast<double>()};
}

std::vector<std::uint8_t> inside_photo(const LensTable& table, int level) {
    const Intrinsics& k = table.camera;
    const Level size = level_size(k.width, k.height, level);
    const double texel = 1 << level;
    std::vector<std::uint8_t> out;
    for (int row = 0; row < LensTable::cells; ++row)
        for (int column = 0; column < LensTable::cells; ++column) {
            if (is_inside(table, column, row, texel)) continue;
            out.resize(std::size_t(size.width) * std::size_t(size.height), 1);
            const auto first = [](int cell, int count) { return cell * count / LensTable::cells; };
            for (int y = first(row, size.height); y < std::min(first(row + 1, size.height) + 1, size.height);
                 ++y)
                for (int x = first(column, size.width);
                     x < std::min(first(column + 1, size.width) + 1, size.width); ++x) {
                    const Vector2d pixel = photo_pixel(table, {(x + 0.5) * texel, (y + 0.5) * texel});
                    out[std::size_t(y) * std::size_t(size.width) + std::size_t(x)] =
                        is_inside(k, pixel, texel);
                }
        }
    return out;
}

}  // namespace vantage

#include "scene/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vantage {
namespace {

Eigen::Vector2d opencv(const std::array<double, 8>& p, const Eigen::Vector2d& q) {
    const double x = q.x(), y = q.y(), r2 = x * x + y * y;
    const double radial =
        (1 + r2 * (p[0] + r2 * (p[1] + r2 * p[4]))) / (1 + r2 * (p[5] + r2 * (p[6] + r2 * p[7])));
    return {x * radial + 2 * p[2] * x * y + p[3] * (r2 + 2 * x * x),
            y * radial + p[2] * (r2 + 2 * y * y) + 2 * p[3] * x * y};
}

/// Maps radius tan(theta) to theta in the same direction; the ratio tends to 1 at the center.
Eigen::Vector2d equidistant(const Eigen::Vector2d& q) {
    const double r = q.norm();
    return r > 1e-9 ? Eigen::Vector2d(q * (std::atan(r) / r)) : q;
}

Eigen::Vector2d fisheye(const std::array<double, 8>& p, const Eigen::Vector2d& q) {
    const Eigen::Vector2d e = equidistant(q);
    const double t2 = e.squaredNorm();
    return e * (1 + t2 * (p[0] + t2 * (p[1] + t2 * (p[2] + t2 * p[3]))));
}

Eigen::Vector2d fov(double omega, const Eigen::Vector2d& q) {
    const double r = q.norm(), half = 2 * std::tan(omega / 2);
    if (std::abs(omega) < 1e-6) return q;
    const double factor = r > 1e-9 ? std::atan(r * half) / (r * omega) : half / omega;
    return q * factor;
}

Eigen::Vector2d thin_prism(const std::array<double, 8>& p, const Eigen::Vector2d& q) {
    const Eigen::Vector2d e = equidistant(q);
    const double x = e.x(), y = e.y(), r2 = e.squaredNorm();
    const double radial = 1 + r2 * (p[0] + r2 * (p[1] + r2 * (p[4] + r2 * p[5])));
    return {x * radial + 2 * p[2] * x * y + p[3] * (r2 + 2 * x * x) + p[6] * r2,
            y * radial + 2 * p[3] * x * y + p[2] * (r2 + 2 * y * y) + p[7] * r2};
}

/// Distorted radius of a ray at angle theta from the axis, tangential terms ignored.
double distorted_radius(const Lens& lens, double theta) {
    Lens radial = lens;
    if (lens.model == LensModel::opencv || lens.model == LensModel::thin_prism) radial.p[2] = radial.p[3] = 0;
    if (lens.model == LensModel::thin_prism) radial.p[6] = radial.p[7] = 0;
    return distort(radial, {std::tan(theta), 0}).x();
}

}  // namespace

double lens_range(const Lens& lens) {
    if (!lens.distorts()) return std::numeric_limits<double>::infinity();
    constexpr int steps = 4096;
    constexpr double last = std::numbers::pi / 2 * (1 - 1e-6);
    double before = 0;
    int i = 1;
    for (; i <= steps; ++i) {
        const double now = distorted_radius(lens, last * i / steps);
        if (!(now > before)) break;
        before = now;
    }
    if (i > steps) return std::numeric_limits<double>::infinity();
    // The maximum is in one of the last two steps: ternary search.
    double low = last * std::max(i - 2, 0) / steps, high = last * i / steps;
    while (high - low > 1e-9) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (distorted_radius(lens, a) < distorted_radius(lens, b))
            low = a;
        else
            high = b;
    }
    return std::tan(std::max(low - 1e-7, 0.0));
}

bool Lens::distorts() const {
    if (model == LensModel::none) return false;
    if (model != LensModel::opencv) return true;
    return std::any_of(p.begin(), p.end(), [](double v) { return v != 0; });
}

std::string_view name(LensModel model) {
    switch (model) {
        case LensModel::none:
            return "pinhole";
        case LensModel::opencv:
            return "radial and tangential";
        case LensModel::fisheye:
            return "fisheye";
        case LensModel::fov:
            return "field of view";
        case LensModel::thin_prism:
            return "thin prism";
    }
    return "unknown";
}

Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& xy) {
    switch (lens.model) {
        case LensModel::none:
            return xy;
        case LensModel::opencv:
            return opencv(lens.p, xy);
        case LensModel::fisheye:
            return fisheye(lens.p, xy);
        case LensModel::fov:
            return fov(lens.p[0], xy);
        case LensModel::thin_prism:
            return thin_prism(lens.p, xy);
    }
    return xy;
}

}  // namespace vantage

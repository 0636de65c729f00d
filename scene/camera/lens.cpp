#include "scene/camera/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vantage {
namespace {

using Coefficients = std::array<double, 12>;

Eigen::Vector2d opencv(const Coefficients& p, const Eigen::Vector2d& q) {
    const double x = q.x(), y = q.y(), r2 = x * x + y * y;
    const double radial =
        (1 + r2 * (p[0] + r2 * (p[1] + r2 * p[4]))) / (1 + r2 * (p[5] + r2 * (p[6] + r2 * p[7])));
    return {x * radial + 2 * p[2] * x * y + p[3] * (r2 + 2 * x * x),
            y * radial + p[2] * (r2 + 2 * y * y) + 2 * p[3] * x * y};
}

/// Maps a radius of tan(theta) to a radius of theta in the same direction; the ratio of the two tends to 1 at
/// the center.
Eigen::Vector2d equidistant(const Eigen::Vector2d& q) {
    const double r = q.norm();
    return r > 1e-9 ? Eigen::Vector2d(q * (std::atan(r) / r)) : q;
}

Eigen::Vector2d fisheye(const Coefficients& p, const Eigen::Vector2d& q) {
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

Eigen::Vector2d thin_prism(const Coefficients& p, const Eigen::Vector2d& q) {
    const Eigen::Vector2d e = equidistant(q);
    const double x = e.x(), y = e.y(), r2 = e.squaredNorm();
    const double radial = 1 + r2 * (p[0] + r2 * (p[1] + r2 * (p[4] + r2 * p[5])));
    return {x * radial + 2 * p[2] * x * y + p[3] * (r2 + 2 * x * x) + p[6] * r2,
            y * radial + 2 * p[3] * x * y + p[2] * (r2 + 2 * y * y) + p[7] * r2};
}

Eigen::Vector2d brown(const Coefficients& p, const Eigen::Vector2d& q) {
    const double x = q.x(), y = q.y(), r2 = q.squaredNorm();
    const double radial = 1 + r2 * (p[0] + r2 * (p[1] + r2 * (p[4] + r2 * p[5])));
    const Eigen::Vector2d d(x * radial + 2 * p[2] * x * y + p[3] * (r2 + 2 * x * x),
                            y * radial + p[2] * (r2 + 2 * y * y) + 2 * p[3] * x * y);
    return {d.x() + p[6] * d.y(), d.y()};
}

Eigen::Vector2d aria(const Coefficients& p, const Eigen::Vector2d& q) {
    const Eigen::Vector2d e = equidistant(q);
    const double t2 = e.squaredNorm();
    const Eigen::Vector2d d =
        e * (1 + t2 * (p[0] + t2 * (p[1] + t2 * (p[2] + t2 * (p[3] + t2 * (p[4] + t2 * p[5]))))));
    const double x = d.x(), y = d.y(), r2 = d.squaredNorm();
    return {x + 2 * p[7] * x * y + p[6] * (r2 + 2 * x * x) + r2 * (p[8] + r2 * p[9]),
            y + 2 * p[6] * x * y + p[7] * (r2 + 2 * y * y) + r2 * (p[10] + r2 * p[11])};
}

/// The root of k r x'^2 - x' + r = 0 that equals r for k = 0. NaN if there is no such root.
Eigen::Vector2d division(double k, const Eigen::Vector2d& q) {
    return q * (2 / (1 + std::sqrt(1 - 4 * k * q.squaredNorm())));
}

/// The root of x' + k x'^3 = r that equals r for k = 0, in closed form. NaN if there is no such root.
Eigen::Vector2d matchmover(double k, const Eigen::Vector2d& q) {
    const double r = q.norm(), root = std::sqrt(3 * std::abs(k)), x = 1.5 * r * root;
    if (!(x > 1e-8)) return q;
    const double third = k > 0 ? std::sinh(std::asinh(x) / 3) : std::sin(std::asin(x) / 3);
    return q * (2 / root * third / r);
}

Eigen::Vector2d unified(double alpha, double beta, const Eigen::Vector2d& q) {
    return q / (alpha * std::sqrt(beta * q.squaredNorm() + 1) + 1 - alpha);
}

/// The distorted radius of a ray at the angle theta from the axis, without tangential terms.
double distorted_radius(const Lens& lens, double theta) {
    Lens radial = lens;
    const auto leave_out = [&](std::size_t first, std::size_t last) {
        std::fill(radial.p.begin() + std::ptrdiff_t(first), radial.p.begin() + std::ptrdiff_t(last) + 1, 0.0);
    };
    if (lens.model == LensModel::opencv || lens.model == LensModel::brown ||
        lens.model == LensModel::thin_prism)
        leave_out(2, 3);
    if (lens.model == LensModel::brown || lens.model == LensModel::thin_prism) leave_out(6, 7);
    if (lens.model == LensModel::aria) leave_out(6, 11);
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
    // The maximum lies within the last two steps and is found by ternary search.
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
        case LensModel::brown:
            return "radial up to r^8, tangential and skew";
        case LensModel::aria:
            return "fisheye with thin prism";
        case LensModel::division:
            return "division";
        case LensModel::matchmover:
            return "radial, of the photo's point";
        case LensModel::unified:
            return "extended unified";
    }
    return "unknown";
}

std::span<const char* const> coefficient_names(LensModel model) {
    static constexpr const char* rational[] = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
    static constexpr const char* fisheye[] = {"k1", "k2", "k3", "k4"};
    static constexpr const char* fov[] = {"omega"};
    static constexpr const char* thin_prism[] = {"k1", "k2", "p1", "p2", "k3", "k4", "sx1", "sy1"};
    static constexpr const char* brown[] = {"k1", "k2", "p1", "p2", "k3", "k4", "skew"};
    static constexpr const char* aria[] = {"k1", "k2", "k3", "k4", "k5", "k6",
                                           "p1", "p2", "s1", "s2", "s3", "s4"};
    static constexpr const char* one[] = {"k"};
    static constexpr const char* unified[] = {"alpha", "beta"};
    switch (model) {
        case LensModel::none:
            return {};
        case LensModel::opencv:
            return rational;
        case LensModel::fisheye:
            return fisheye;
        case LensModel::fov:
            return fov;
        case LensModel::thin_prism:
            return thin_prism;
        case LensModel::brown:
            return brown;
        case LensModel::aria:
            return aria;
        case LensModel::division:
        case LensModel::matchmover:
            return one;
        case LensModel::unified:
            return unified;
    }
    return {};
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
        case LensModel::brown:
            return brown(lens.p, xy);
        case LensModel::aria:
            return aria(lens.p, xy);
        case LensModel::division:
            return division(lens.p[0], xy);
        case LensModel::matchmover:
            return matchmover(lens.p[0], xy);
        case LensModel::unified:
            return unified(lens.p[0], lens.p[1], xy);
    }
    return xy;
}

}  // namespace vantage

#include "pipeline/synth/urn.h"

#include <array>
#include <numbers>

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Radius and height, relative to the urn's height, at v from 0 to 1 along its outline, which is a
/// Catmull-Rom spline (1974).
Vector2d outline(double v) {
    static const std::array<Vector2d, 20> points{
        {{0.25, 0},    {0.25, 0.05}, {0.20, 0.07}, {0.12, 0.12},  {0.09, 0.2},  {0.13, 0.225}, {0.10, 0.25},
         {0.22, 0.29}, {0.35, 0.36}, {0.38, 0.43}, {0.345, 0.47}, {0.33, 0.55}, {0.325, 0.7},  {0.34, 0.8},
         {0.40, 0.89}, {0.46, 0.93}, {0.48, 0.97}, {0.45, 1.0},   {0.38, 0.94}, {0, 0.8}}};
    const double at = v * double(points.size() - 1);
    const auto i = std::min(std::size_t(at), points.size() - 2);
    const double t = at - double(i);
    const Vector2d &b = points[i], &c = points[i + 1], a = i > 0 ? points[i - 1] : b,
                   d = i + 2 < points.size() ? points[i + 2] : c;
    return 0.5 *
           (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - 3 * c + d - a));
}

/// Height of the carving's relief, relative to the urn's height.
double carving(double angle, double z) {
    const auto bell = [](double x) { return std::exp(-x * x); };
    const auto within = [](double x, double low, double high) {
        const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
        return std::sin(std::numbers::pi * s);
    };
    double out = 0.030 * within(z, 0.27, 0.45) * std::abs(std::sin(14 * angle));  // gadroons
    out += 0.012 * within(z, 0.9, 0.96) * std::abs(std::sin(24 * angle));         // eggs
    out += 0.008 * within(z, 0.05, 0.2) * std::abs(std::sin(10 * angle));         // flutes
    const double swag = 6 * angle / (2 * std::numbers::pi), t = swag - std::floor(swag);
    const double hang = 0.74 - 0.13 * std::sin(std::numbers::pi * t),
                 leaf = 0.75 + 0.25 * std::sin(34 * std::numbers::pi * t + 90 * (z - hang));
    out += 0.028 * bell((z - hang) / (0.018 + 0.016 * std::sin(std::numbers::pi * t))) * leaf;
    const double across = 0.33 * (t - std::round(t)) * 2 * std::numbers::pi / 6, up = z - 0.74,
                 r = std::hypot(across, up);
    const double petals = 1 + 0.3 * std::cos(8 * std::atan2(up, across));
    return out + 0.035 * bell(r / (0.035 * petals)) + 0.012 * bell((z - 0.83) / 0.008) +
           0.01 * bell((z - 0.5) / 0.006);
}

}  // namespace

void add_urn(ModelBuilder& b, const Vector3d& foot, double height, int triangles) {
    const int along = int(std::sqrt(triangles / 2.0 * 0.75)), around = triangles / 2 / along;
    b.surface(
        around, along,
        [&](double u, double v) {
            const double angle = 2 * std::numbers::pi * u;
            const Vector2d p = outline(v);
            const double r = p.x() + (v < 0.85 ? carving(angle, p.y()) : 0);
            return Vector3d(foot + height * Vector3d(r * std::cos(angle), r * std::sin(angle), p.y()));
        },
        Material::statuary);
    for (const double side : {-1.0, 1.0})
        b.surface(
            12, 40,
            [&](double u, double v) {
                const double bow = std::numbers::pi * (1.25 * v - 0.2), thick = 0.028 * (1.15 - 0.4 * v);
                const Vector2d middle(0.39 + 0.12 * std::sin(bow), 0.57 - 0.14 * std::cos(bow));
                const Vector2d out(std::sin(bow), -std::cos(bow));
                const Vector2d p = middle + thick * std::cos(2 * std::numbers::pi * u) * out;
                return Vector3d(foot + height * Vector3d(side * p.x(),
                                                         side * thick * std::sin(2 * std::numbers::pi * u),
                                                         p.y()));
            },
            Material::statuary);
}

}  // namespace vantage

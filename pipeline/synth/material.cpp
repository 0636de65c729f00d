#include "pipeline/synth/material.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "pipeline/synth/noise.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double level = 0.9;  ///< minimum |normal.z| of a floor

/// A point on masonry.
struct Course {
    double id;  ///< [0, 1), random per brick
    bool joint;
};

/// Masonry in running bond. Bricks are width x height in size, including joints of width `joint`, all in
/// meters.
Course course(const Vector2d& p, double width, double height, double joint) {
    const double row = std::floor(p.y() / height);
    const double x = p.x() / width + (std::int64_t(row) & 1 ? 0.5 : 0.0), column = std::floor(x);
    const double u = (x - column) * width, v = p.y() - row * height;
    return {hashed(std::int64_t(column), std::int64_t(row), 5), u < joint || v < joint};
}

Vector3f brick(const Vector3d& p, const Vector2d& uv) {
    const Course c = course(uv, 0.22, 0.075, 0.01);
    const double grain = turbulence(p, 40, 4);
    if (c.joint) return mix({0.42f, 0.40f, 0.36f}, {0.55f, 0.53f, 0.48f}, grain);
    return mix({0.30f, 0.09f, 0.06f}, {0.55f, 0.24f, 0.15f}, 0.6 * c.id + 0.4 * grain);
}

/// Vertical bars whose period falls from 20 cm to 4 mm within each meter, as a test of resolution.
Vector3f grating(const Vector2d& uv) {
    const double x = uv.x() - std::floor(uv.x());
    const double period = 0.2 * std::pow(0.02, x);
    const bool bar = std::fmod(x, period) < period / 2, row = std::fmod(std::abs(uv.y()), 0.5) < 0.02;
    return bar || row ? Vector3f(0.04f, 0.045f, 0.06f) : Vector3f(0.72f, 0.72f, 0.68f);
}

/// A page of text drawn in OpenCV's vector font.
const cv::Mat& page() {
    static const cv::Mat drawn = [] {
        cv::Mat m(1024, 1024, CV_8U, cv::Scalar(230));
        const char* const lines[] = {"VANTAGE",
                                     "every photo is",
                                     "a point of view",
                                     "0123456789",
                                     "the quick brown fox",
                                     "jumps over the lazy dog",
                                     "sharper than a texture",
                                     "1 2 4 8 16 32 64 128"};
        double y = 150, size = 5.2;
        for (const char* line : lines) {
            cv::putText(m, line, {40, int(y)}, cv::FONT_HERSHEY_DUPLEX, size, 25,
                        std::max(2, int(size * 2.2)), cv::LINE_AA);
            size = std::max(1.2, size * 0.62);
            y += 40 * size + 35;
        }
        return m;
    }();
    return drawn;
}

Vector3f text(const Vector2d& uv) {
    const cv::Mat& m = page();
    const double width = 1.2, left = 0.528;  // m; a page starts at the edge of the garden scene's panels
    const double across = (uv.x() - left) / width, up = uv.y() / width;
    const double u = across - std::floor(across), v = up - std::floor(up);
    const double x = u * (m.cols - 1), y = (1 - v) * (m.rows - 1);
    const int x0 = std::min(int(x), m.cols - 2), y0 = std::min(int(y), m.rows - 2);
    const auto at = [&](int i, int j) { return double(m.at<std::uint8_t>(y0 + j, x0 + i)); };
    const double a = x - x0, b = y - y0;
    const double ink =
        ((1 - a) * at(0, 0) + a * at(1, 0)) * (1 - b) + ((1 - a) * at(0, 1) + a * at(1, 1)) * b;
    return mix({0.05f, 0.04f, 0.08f}, {0.80f, 0.76f, 0.64f}, ink / 255);
}

/// Panes and glazing bars; a curtain is painted on the panes, so they neither reflect nor transmit.
Vector3f window(const Vector3d& p, const Vector2d& uv) {
    const double x = std::fmod(std::abs(uv.x()) + 0.17, 0.42), y = std::fmod(std::abs(uv.y()) + 0.1, 0.55);
    if (x < 0.045 || y < 0.045) return Vector3f(0.75f, 0.74f, 0.70f);
    const double fold = 0.5 + 0.5 * std::sin(uv.x() * 55 + 2.5 * noise(p * 3));
    return mix({0.05f, 0.08f, 0.13f}, {0.22f, 0.30f, 0.38f}, fold);
}

Vector3f roof(const Vector3d& p) {
    const Course c = course({p.x(), p.y()}, 0.28, 0.19, 0.015);
    if (c.joint) return {0.05f, 0.05f, 0.06f};
    return mix({0.13f, 0.15f, 0.18f}, {0.24f, 0.27f, 0.32f}, 0.5 * c.id + 0.5 * turbulence(p, 25, 4));
}

Vector3f paving(const Vector3d& p, const Vector2d& uv) {
    const Course c = course(uv, 0.8, 0.5, 0.012);
    if (c.joint) return {0.10f, 0.11f, 0.07f};
    return mix({0.25f, 0.23f, 0.20f}, {0.48f, 0.45f, 0.40f}, 0.4 * c.id + 0.6 * turbulence(p, 12, 6));
}

Vector3f marble(const Vector3d& p) {
    const double vein = std::abs(std::sin(9 * p.x() + 7 * p.z() + 9 * turbulence(p, 4, 6)));
    const double speck = noise(p * 130) > 0.86 ? 0.5 : 0.0;
    return mix({0.02f, 0.16f, 0.17f}, {0.42f, 0.72f, 0.66f},
               std::clamp(std::pow(vein, 0.6) - speck, 0.0, 1.0));
}

}  // namespace

Vector2d across_and_up(const Vector3d& p, const Vector3d& n, double level) {
    if (std::abs(n.z()) > level) return {p.x(), p.y()};
    return {std::abs(n.x()) > std::abs(n.y()) ? p.y() : p.x(), p.z()};
}

Vector3f albedo(Material material, const Vector3d& p, const Vector3d& n) {
    const Vector2d uv = across_and_up(p, n, level);
    switch (material) {
        case Material::brick:
            return brick(p, uv);
        case Material::window:
            return window(p, uv);
        case Material::grating:
            return grating(uv);
        case Material::text:
            return text(uv);
        case Material::roof:
            return roof(p);
        case Material::paving:
            return paving(p, uv);
        case Material::marble:
            return marble(p);
        case Material::grass:
            return mix({0.07f, 0.15f, 0.03f}, {0.25f, 0.36f, 0.10f},
                       0.6 * turbulence(p, 0.5, 3) + 0.4 * turbulence(p, 9, 4));
        case Material::trees:
            return mix({0.02f, 0.06f, 0.02f}, {0.16f, 0.24f, 0.07f}, std::pow(turbulence(p, 0.45, 5), 1.5));
        case Material::iron:
            return {0.03f, 0.03f, 0.035f};
        default:  // plaster
            break;
    }
    return mix({0.48f, 0.44f, 0.36f}, {0.78f, 0.74f, 0.64f}, turbulence(p, 10, 6));
}

namespace {

/// Strokes 4 cm wide that form a grid of 0.8 m squares, with an arch in every other square.
double charcoal(const Vector2d& uv) {
    constexpr double square = 0.8, half = 0.02;
    const double column = std::floor(uv.x() / square), row = std::floor(uv.y() / square);
    const double x = uv.x() - (column + 0.5) * square, y = uv.y() - (row + 0.5) * square;
    const double edge = square / 2 - std::max(std::abs(x), std::abs(y));
    const bool arched = std::int64_t(column + row) & 1;
    const double arch = arched ? std::abs(std::hypot(x, y + 0.2) - 0.35) : square;
    return std::min(edge, arch) < half ? 1.0 : 0.0;
}

}  // namespace

Vector3f infrared_albedo(Material material, const Vector3d& p, const Vector3d& n) {
    const Vector3f visible = albedo(material, p, n);
    const double mean = double(visible.sum()) / 3;
    const auto gray = [](double light) { return Vector3f::Constant(float(std::clamp(light, 0.0, 1.0))); };
    switch (material) {
        case Material::plaster:
        case Material::brick:
            return gray((0.55 + 0.3 * mean) * (1 - 0.8 * charcoal(across_and_up(p, n, level))));
        case Material::grass:
        case Material::trees:
            return gray(0.5 + mean);  // leaves are bright
        case Material::text:
            return gray(0.6 + 0.1 * mean);
        default:
            return gray(0.15 + 0.8 * double(visible.x()));
    }
}

Vector3f clouded(const Vector3f& sky, const Vector3d& d) {
    if (!(d.z() > 0)) return sky;
    const Vector3d above = d / (d.z() + 0.12);  // on a layer of clouds
    const double share = std::clamp(2.6 * turbulence(above, 1.1, 5) - 1.15, 0.0, 1.0);
    return mix(sky, {0.93f, 0.93f, 0.94f}, share * std::min(1.0, 6 * d.z()));
}

}  // namespace vantage

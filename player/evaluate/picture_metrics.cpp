#include "player/evaluate/picture_metrics.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

/// One value per pixel.
struct Plane {
    int width, height;
    std::vector<double> values;
    double& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    double at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

Plane plane(const Picture& p) { return {p.width, p.height, std::vector<double>(p.rgba.size() / 4, 0)}; }

/// BT.601 luminance after gains, rounded as in 8-bit pictures.
Plane luminance(const Picture& p, const std::array<double, 3>& gain = {1, 1, 1}) {
    Plane out = plane(p);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = std::round(0.299 * gain[0] * p.rgba[4 * i] + 0.587 * gain[1] * p.rgba[4 * i + 1] +
                                   0.114 * gain[2] * p.rgba[4 * i + 2]);
    return out;
}

constexpr int window = 5;  // pixels to each side
std::array<double, 2 * window + 1> gaussian() {
    std::array<double, 2 * window + 1> g{};
    double sum = 0;
    for (int i = -window; i <= window; ++i)
        sum += g[std::size_t(i + window)] = std::exp(-i * i / (2 * 1.5 * 1.5));
    for (double& v : g) v /= sum;
    return g;
}

/// Gaussian-weighted sums around every pixel; values outside the frame count as 0.
Plane blurred(const Plane& p) {
    static const auto g = gaussian();
    Plane rows{p.width, p.height, std::vector<double>(p.values.size(), 0)}, out = rows;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            for (int i = std::max(-window, -x); i <= std::min(window, p.width - 1 - x); ++i)
                rows.at(x, y) += g[std::size_t(i + window)] * p.at(x + i, y);
    for (int y = 0; y < p.height; ++y)
        for (int i = std::max(-window, -y); i <= std::min(window, p.height - 1 - y); ++i)
            for (int x = 0; x < p.width; ++x) out.at(x, y) += g[std::size_t(i + window)] * rows.at(x, y + i);
    return out;
}

double mean_ssim(const Picture& photo, const Picture& picture, const std::vector<bool>& scored,
                 std::size_t pixels) {
    const Plane a = luminance(photo), b = luminance(picture);
    const auto moment = [&](const auto& value) {
        Plane p = plane(photo);
        for (std::size_t i = 0; i < p.values.size(); ++i)
            if (scored[i]) p.values[i] = value(a.values[i], b.values[i]);
        return blurred(p);
    };
    const Plane n = moment([](double, double) { return 1; }), ma = moment([](double x, double) { return x; }),
                mb = moment([](double, double y) { return y; }),
                aa = moment([](double x, double) { return x * x; }),
                bb = moment([](double, double y) { return y * y; }),
                ab = moment([](double x, double y) { return x * y; });
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double sum = 0;
    for (std::size_t i = 0; i < n.values.size(); ++i) {
        if (!scored[i]) continue;
        const double w = std::max(n.values[i], 1e-9), x = ma.values[i] / w, y = mb.values[i] / w,
                     vx = std::max(aa.values[i] / w - x * x, 0.0),
                     vy = std::max(bb.values[i] / w - y * y, 0.0), vxy = ab.values[i] / w - x * y;
        sum += (2 * x * y + c1) * (2 * vxy + c2) / ((x * x + y * y + c1) * (vx + vy + c2));
    }
    return sum / double(pixels);
}

/// Energy above half the Nyquist frequency: what the half-band filter of Deslauriers and Dubuc (1989)
/// removes, along rows and columns.
double fine_energy(const Plane& p, const std::vector<bool>& scored) {
    constexpr std::array<double, 4> half{16 / 32.0, 9 / 32.0, 0, -1 / 32.0};
    constexpr int reach = int(half.size()) - 1;
    const auto row = [&](int y) { return std::size_t(y) * std::size_t(p.width); };
    double energy = 0;
    for (int y = reach; y < p.height - reach; ++y)
        for (int x = reach; x < p.width - reach; ++x) {
            bool all = true;
            double coarse_x = half[0] * p.at(x, y), coarse_y = coarse_x;
            for (int i = -reach; i <= reach; ++i)
                all = all && scored[row(y) + std::size_t(x + i)] && scored[row(y + i) + std::size_t(x)];
            if (!all) continue;
            for (int i = 1; i <= reach; ++i) {
                coarse_x += half[std::size_t(i)] * (p.at(x - i, y) + p.at(x + i, y));
                coarse_y += half[std::size_t(i)] * (p.at(x, y - i) + p.at(x, y + i));
            }
            energy += std::pow(p.at(x, y) - coarse_x, 2) + std::pow(p.at(x, y) - coarse_y, 2);
        }
    return energy;
}

/// The smallest difference among the worst 0.1 % of the pixels, each judged by its worst channel.
double worst_thousandth(const Picture& photo, const Picture& picture, const std::vector<bool>& scored,
                        const std::array<double, 3>& gain) {
    std::vector<float> off;
    for (std::size_t i = 0; i < scored.size(); ++i) {
        if (!scored[i]) continue;
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(photo.rgba[4 * i + c] - gain[c] * picture.rgba[4 * i + c]));
        off.push_back(float(most));
    }
    const auto at = off.end() - std::ptrdiff_t(1 + off.size() / 1000);
    std::nth_element(off.begin(), at, off.end());
    return double(*at);
}

double psnr(double squares, std::size_t pixels) {
    return 10 * std::log10(255 * 255 / std::max(squares / (3.0 * double(pixels)), 1e-12));
}

}  // namespace

std::vector<bool> scored_pixels(const Picture& p, int radius) {
    std::vector<bool> out(p.rgba.size() / 4, true);
    const auto row = [&](int y) { return std::size_t(y) * std::size_t(p.width); };
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            if (p.rgba[4 * (row(y) + std::size_t(x)) + 3] >= 128) continue;
            for (int j = std::max(-radius, -y); j <= std::min(radius, p.height - 1 - y); ++j) {
                // One row of the disc, its half-width rounded.
                const int reach = int(std::lround(std::sqrt(double(radius * radius - j * j))));
                for (int i = std::max(0, x - reach); i <= std::min(p.width - 1, x + reach); ++i)
                    out[row(y + j) + std::size_t(i)] = false;
            }
        }
    return out;
}

PictureScore score(const Picture& photo, const Picture& picture, const std::vector<bool>& scored) {
    PictureScore s;
    double both[3]{}, own[3]{}, squares = 0, gained = 0;
    const auto each = [&](const auto& visit) {
        for (std::size_t i = 0; i < scored.size(); ++i)
            for (std::size_t c = 0; scored[i] && c < 3; ++c)
                visit(c, double(photo.rgba[4 * i + c]), double(picture.rgba[4 * i + c]));
    };
    s.pixels = std::size_t(std::count(scored.begin(), scored.end(), true));
    if (s.pixels == 0) return s;
    each([&](std::size_t c, double a, double b) {
        both[c] += a * b;
        own[c] += b * b;
        squares += (a - b) * (a - b);
    });
    for (std::size_t c = 0; c < 3; ++c) s.gain[c] = both[c] / std::max(own[c], 1e-9);
    each([&](std::size_t c, double a, double b) { gained += (a - s.gain[c] * b) * (a - s.gain[c] * b); });
    s.psnr = psnr(squares, s.pixels);
    s.psnr_gain = psnr(gained, s.pixels);
    s.worst = worst_thousandth(photo, picture, scored, s.gain);
    s.ssim = mean_ssim(photo, picture, scored, s.pixels);
    const double detail = fine_energy(luminance(photo), scored);
    if (detail > 0) s.sharpness = fine_energy(luminance(picture, s.gain), scored) / detail;
    return s;
}

std::array<double, 2> shift_of(const Picture& photo, const Picture& picture,
                               const std::vector<bool>& scored) {
    const PictureScore s = score(photo, picture, scored);
    const Plane a = blurred(luminance(photo)), b = blurred(luminance(picture, s.gain));
    double squares = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (scored[i]) squares += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
    const double usual = std::max(1.0, squares / double(std::max<std::size_t>(1, s.pixels)));
    double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
    for (int y = 1; y + 1 < a.height; ++y)
        for (int x = 1; x + 1 < a.width; ++x) {
            if (!scored[std::size_t(y) * std::size_t(a.width) + std::size_t(x)]) continue;
            // Gradients of both, so that a shift is not underestimated if one is blurred.
            const double gx = (a.at(x + 1, y) - a.at(x - 1, y) + b.at(x + 1, y) - b.at(x - 1, y)) / 4,
                         gy = (a.at(x, y + 1) - a.at(x, y - 1) + b.at(x, y + 1) - b.at(x, y - 1)) / 4,
                         t = a.at(x, y) - b.at(x, y);
            // Outliers, such as passers-by and highlights, carry no information about the shift.
            const double w = 1 / (1 + t * t / (9 * usual));
            xx += w * gx * gx, xy += w * gx * gy, yy += w * gy * gy, xt += w * gx * t, yt += w * gy * t;
        }
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-6 * (xx + yy) * (xx + yy)) || !(det > 0)) return {0, 0};
    return {(yy * xt - xy * yt) / det, (xx * yt - xy * xt) / det};
}

Picture difference_picture(const Picture& photo, const Picture& picture, const PictureScore& s) {
    Picture out{photo.width, photo.height, std::vector<std::uint8_t>(photo.rgba.size(), 255), {}};
    for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
        double worst = 0;
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(photo.rgba[i + c] - s.gain[c] * picture.rgba[i + c]));
        const bool colored = picture.rgba[i + 3] >= 128;
        for (std::size_t c = 0; c < 3; ++c)  // red first, then green, then blue: black, red, yellow, white
            out.rgba[i + c] =
                colored ? std::uint8_t(std::clamp(12 * worst - 255.0 * double(c), 0.0, 255.0)) : 40;
    }
    return out;
}

}  // namespace vantage

#include "player/measure/evaluation/picture_metrics.h"

#include <algorithm>
#include <cmath>

#include "player/measure/evaluation/luminance.h"

namespace vantage {
namespace {

/// Energy above half the Nyquist frequency: the part removed by the half-band filter of Deslauriers and Dubuc
/// (1989), along rows and columns.
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

/// The smallest difference among the worst 0.1 % of the pixels, each represented by its worst channel.
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

}  // namespace

double psnr_of(double squares, std::size_t pixels) {
    return 10 * std::log10(255 * 255 / std::max(squares / (3.0 * double(pixels)), 1e-12));
}

std::vector<bool> scored_pixels(const Picture& p, int radius) {
    std::vector<bool> out(p.rgba.size() / 4, true);
    const auto row = [&](int y) { return std::size_t(y) * std::size_t(p.width); };
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            if (p.rgba[4 * (row(y) + std::size_t(x)) + 3] >= 128) continue;
            for (int j = std::max(-radius, -y); j <= std::min(radius, p.height - 1 - y); ++j) {
                // Half-width of a row of the disc.
                const int reach = int(std::lround(std::sqrt(double(radius * radius - j * j))));
                for (int i = std::max(0, x - reach); i <= std::min(p.width - 1, x + reach); ++i)
                    out[row(y + j) + std::size_t(i)] = false;
            }
        }
    return out;
}

std::array<double, 3> fitted_gain(const Picture& photo, const Picture& picture,
                                  const std::vector<bool>& scored) {
    if (std::ranges::count(scored, true) == 0) return {1, 1, 1};
    std::array<double, 3> both{}, own{}, gain{};
    for (std::size_t i = 0; i < scored.size(); ++i)
        for (std::size_t c = 0; scored[i] && c < 3; ++c) {
            both[c] += double(photo.rgba[4 * i + c]) * picture.rgba[4 * i + c];
            own[c] += double(picture.rgba[4 * i + c]) * picture.rgba[4 * i + c];
        }
    for (std::size_t c = 0; c < 3; ++c) gain[c] = both[c] / std::max(own[c], 1e-9);
    return gain;
}

double psnr_after(const std::array<double, 3>& gain, const Picture& photo, const Picture& picture,
                  const std::vector<bool>& scored) {
    double squares = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < scored.size(); ++i) {
        pixels += scored[i];
        for (std::size_t c = 0; scored[i] && c < 3; ++c)
            squares += std::pow(photo.rgba[4 * i + c] - gain[c] * picture.rgba[4 * i + c], 2);
    }
    return pixels ? psnr_of(squares, pixels) : 0;
}

Picture gained(Picture picture, const std::array<double, 3>& gain, const std::vector<bool>& where) {
    for (std::size_t i = 0; i < where.size(); ++i)
        for (std::size_t c = 0; where[i] && c < 3; ++c) {
            std::uint8_t& value = picture.rgba[4 * i + c];
            value = std::uint8_t(std::clamp(value * gain[c] + 0.5, 0.0, 255.0));
        }
    return picture;
}

double mean_ssim(const Picture& photo, const Picture& picture, const std::vector<bool>& scored) {
    const Plane a = luminance(photo), b = luminance(picture);
    const auto moment = [&](const auto& value) {
        Plane p(photo.width, photo.height);
        for (std::size_t i = 0; i < p.values.size(); ++i)
            if (scored[i]) p.values[i] = value(a.values[i], b.values[i]);
        return blurred(p);
    };
    const Plane n = moment([](float, float) { return 1.0f; }), ma = moment([](float x, float) { return x; }),
                mb = moment([](float, float y) { return y; }),
                aa = moment([](float x, float) { return x * x; }),
                bb = moment([](float, float y) { return y * y; }),
                ab = moment([](float x, float y) { return x * y; });
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double sum = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < n.values.size(); ++i) {
        if (!scored[i]) continue;
        ++pixels;
        const double w = 1 / std::max(double(n.values[i]), 1e-9), x = double(ma.values[i]) * w,
                     y = double(mb.values[i]) * w, vx = std::max(double(aa.values[i]) * w - x * x, 0.0),
                     vy = std::max(double(bb.values[i]) * w - y * y, 0.0),
                     vxy = double(ab.values[i]) * w - x * y;
        sum += (2 * x * y + c1) * (2 * vxy + c2) / ((x * x + y * y + c1) * (vx + vy + c2));
    }
    return pixels ? sum / double(pixels) : 0;
}

PictureScore score(const Picture& photo, const Picture& picture, const std::vector<bool>& scored) {
    PictureScore s;
    s.pixels = std::size_t(std::count(scored.begin(), scored.end(), true));
    if (s.pixels == 0) return s;
    s.gain = fitted_gain(photo, picture, scored);
    s.psnr = psnr_after({1, 1, 1}, photo, picture, scored);
    s.psnr_gain = psnr_after(s.gain, photo, picture, scored);
    s.worst = worst_thousandth(photo, picture, scored, s.gain);
    s.ssim = mean_ssim(photo, picture, scored);
    s.ssim_gain = mean_ssim(photo, gained(picture, s.gain, scored), scored);
    const double detail = fine_energy(luminance(photo), scored);
    if (detail > 0) s.sharpness = fine_energy(luminance(picture, s.gain), scored) / detail;
    return s;
}

std::array<double, 2> shift_of(const Picture& photo, const Picture& picture,
                               const std::vector<bool>& scored) {
    const Plane a = blurred(luminance(photo)),
                b = blurred(luminance(picture, fitted_gain(photo, picture, scored)));
    double squares = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (scored[i]) ++pixels, squares += std::pow(double(a.values[i]) - double(b.values[i]), 2);
    const double usual = std::max(1.0, squares / double(std::max<std::size_t>(1, pixels)));
    double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
    for (int y = 1; y + 1 < a.height; ++y)
        for (int x = 1; x + 1 < a.width; ++x) {
            if (!scored[std::size_t(y) * std::size_t(a.width) + std::size_t(x)]) continue;
            // Gradients of both pictures, so that a shift is not underestimated if one is blurred.
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

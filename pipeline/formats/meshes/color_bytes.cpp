#include "pipeline/formats/meshes/color_bytes.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double v : values)
        if (std::isfinite(v)) most = std::max(most, v);
    return most;
}

/// The factor that maps values up to `most` to 0..255. Fractions may slightly exceed 1, in bright highlights.
double factor(double most, bool is_real) {
    constexpr double brightest_fraction = 1.5;
    if (is_real && most <= brightest_fraction) return 255;
    return most <= 255 ? 1 : 255.0 / 65535.0;
}

}  // namespace

std::vector<std::array<std::uint8_t, 4>> color_bytes(const std::array<std::vector<double>, 4>& channels,
                                                     bool is_real, bool is_alpha_real) {
    const double most = std::max({largest(channels[0]), largest(channels[1]), largest(channels[2])});
    const double of_color = factor(most, is_real);
    const double of_alpha = factor(largest(channels[3]), is_alpha_real);
    std::vector<std::array<std::uint8_t, 4>> out(channels[0].size(), {255, 255, 255, 255});
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t v = 0; v < channels[c].size(); ++v) {
            const double x = channels[c][v] * (c < 3 ? of_color : of_alpha);
            out[v][c] = std::uint8_t(std::lround(std::clamp(std::isfinite(x) ? x : 0.0, 0.0, 255.0)));
        }
    return out;
}

}  // namespace vantage

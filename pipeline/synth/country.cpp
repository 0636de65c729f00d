#include "pipeline/synth/country.h"

#include <numbers>

#include "pipeline/synth/noise.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double whole_turn = 2 * std::numbers::pi;

double ground(const SynthSpec::Garden& g, double x, double y) {
    const double far = std::hypot(x, y),
                 out = std::clamp(std::log(far / g.radius) / std::log(4000 / g.radius), 0.0, 1.0);
    const double rolling = rough({x, y, 0}, 1600, 30, 0.5), near = rough({x, y, 5}, 120, 10, 0.5);
    return -0.03 + out * out * g.hill * (0.65 + 0.5 * rolling) + std::min(out * 4, 1.0) * near;
}

}  // namespace

void add_country(ModelBuilder& b, const SynthSpec::Garden& g) {
    b.surface(
        320, 110,
        [&](double u, double v) {
            const double r = v > 0 ? 8 * std::pow(6000.0 / 8, v) : 0, a = -whole_turn * u;
            const double x = r * std::cos(a), y = r * std::sin(a);
            return Vector3d(x, y, v > 0 ? ground(g, x, y) : -0.03);
        },
        Material::meadow);
}

}  // namespace vantage

#include "player/measure/evaluation/luminance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr int reach = 5;  // pixels to each side

std::array<float, 2 * reach + 1> gaussian() {
    std::array<double, 2 * reach + 1> g{};
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        sum += g[std::size_t(i + reach)] = std::exp(-i * i / (2 * 1.5 * 1.5));
    std::array<float, 2 * reach + 1> out{};
    for (std::size_t i = 0; i < g.size(); ++i) out[i] = float(g[i] / sum);
    return out;
}

}  // namespace

Plane luminance(const Picture& p, const std::array<double, 3>& gain) {
    Plane out(p.width, p.height);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] =
            float(std::floor(0.299 * gain[0] * p.rgba[4 * i] + 0.587 * gain[1] * p.rgba[4 * i + 1] +
                             0.114 * gain[2] * p.rgba[4 * i + 2] + 0.5));
    return out;
}

Plane blurred(const Plane& p) {
    static const auto g = gaussian();
    const auto line = [](auto* data, int n) { return Eigen::Map<const Eigen::ArrayXf>(data, n); };
    Plane rows(p.width, p.height), out = rows;
    for (int y = 0; y < p.height; ++y)
        for (int i = -reach; i <= reach; ++i) {
            const int x0 = std::max(0, -i), n = std::min(p.width, p.width - i) - x0;
            if (n > 0)
                Eigen::Map<Eigen::ArrayXf>(rows.row(y) + x0, n) +=
                    g[std::size_t(i + reach)] * line(p.row(y) + x0 + i, n);
        }
    for (int y = 0; y < p.height; ++y)
        for (int i = std::max(-reach, -y); i <= std::min(reach, p.height - 1 - y); ++i)
            Eigen::Map<Eigen::ArrayXf>(out.row(y), p.width) +=
                g[std::size_t(i + reach)] * line(rows.row(y + i), p.width);
    return out;
}

}  // namespace vantage

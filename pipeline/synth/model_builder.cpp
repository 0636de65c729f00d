#include "pipeline/synth/model_builder.h"

namespace vantage {

using Eigen::Vector2d;
using Eigen::Vector3d;

void ModelBuilder::surface(int nu, int nv, const std::function<Vector3d(double, double)>& f,
                           Material material) {
    const auto divided = [&](int pieces, double length) {
        return max_edge > 0 ? std::max(pieces, int(std::ceil(length / max_edge))) : pieces;
    };
    nu = divided(nu, std::max((f(0.5, 0) - f(0, 0)).norm() + (f(1, 0) - f(0.5, 0)).norm(),
                              (f(0.5, 1) - f(0, 1)).norm() + (f(1, 1) - f(0.5, 1)).norm()));
    nv = divided(nv, std::max((f(0, 1) - f(0, 0)).norm(), (f(0.5, 1) - f(0.5, 0)).norm()));
    const auto first = std::uint32_t(model.mesh.positions.size()), row = std::uint32_t(nu) + 1;
    for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i) {
            const double u = double(i) / nu, v = double(j) / nv, e = 1e-3;
            const double a = std::clamp(u, e, 1 - e), b = std::clamp(v, e, 1 - e);
            const Vector3d du = f(a + e, b) - f(a - e, b), dv = f(a, b + e) - f(a, b - e);
            vertex(f(u, v), du.cross(dv).normalized());
        }
    for (std::uint32_t j = 0; j < std::uint32_t(nv); ++j)
        for (std::uint32_t a = first + j * row; a < first + j * row + row - 1; ++a) {
            triangle(a, a + 1, a + row + 1, material);
            triangle(a, a + row + 1, a + row, material);
        }
}

void ModelBuilder::sweep(std::span<const Vector2d> profile, int steps,
                         const std::function<Vector3d(double, const Vector2d&)>& at, Material material) {
    const std::size_t pieces = profile.size() - 1;
    const auto f = [&](double t, double v) {
        const std::size_t i = std::min(std::size_t(v * double(pieces)), pieces - 1);
        return at(t, profile[i] + (profile[i + 1] - profile[i]) * (v * double(pieces) - double(i)));
    };
    surface(steps, int(pieces), f, material);
}

}  // namespace vantage

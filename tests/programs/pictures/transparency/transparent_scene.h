#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

/// Converts linear light to an sRGB value from 0 to 1.
inline double encoded(double l) {
    l = std::clamp(l, 0.0, 1.0);
    return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

/// The largest difference between the channels of two colors, in 8-bit values.
inline double codes_apart(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
    double most = 255 * std::abs(a[3] - b[3]);
    for (int c = 0; c < 3; ++c) most = std::max(most, 255 * std::abs(encoded(a[c]) - encoded(b[c])));
    return most;
}

/// Puts transparent triangles into a small synthetic scene.
class Transparent : public TemporaryFolder {
  protected:
    using Vector3d = Eigen::Vector3d;
    using Vector4d = Eigen::Vector4d;
    using Color = std::array<std::uint8_t, 4>;

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        copy_scene(spec, dir / "scene");
        input = read_scene(discover(dir / "scene"));
        settings.validate = false;
        settings.effects[Effect::background] = EffectChoice::off;
    }
    /// Adds a separate triangle with one normal.
    void add(const std::array<Vector3d, 3>& corners, const std::array<Color, 3>& colors) {
        Mesh& m = input.mesh;
        const Vector3d n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        m.colors.resize(m.positions.size(), {255, 255, 255, 255});
        const auto first = std::uint32_t(m.positions.size());
        for (std::size_t i = 0; i < 3; ++i) {
            m.positions.push_back(corners[i]);
            m.normals.push_back(n.cast<float>());
            m.colors.push_back(colors[i]);
        }
        m.triangles.push_back({first, first + 1, first + 2});
    }
    void add_quad(const Vector3d& corner, const Vector3d& u, const Vector3d& v, const Color& color) {
        add({corner, corner + u, corner + u + v}, {color, color, color});
        add({corner, corner + u + v, corner + v}, {color, color, color});
    }
    /// Adds ground that is so wide that no triangle on it is subdivided, and a wall on the ground.
    void ground() {
        input.mesh = {};
        for (int x = 0; x < 70; ++x)
            for (int y = 0; y < 70; ++y)
                add_quad({-250 + x * 500 / 70.0, -250 + y * 500 / 70.0, 0}, {500 / 70.0, 0, 0},
                         {0, 500 / 70.0, 0}, {255, 255, 255, 255});
        add_quad({-1.5, 0.5, 0}, {2.5, 0, 0}, {0, 0, 2.5}, {255, 255, 255, 255});
    }
    Color random_color() {
        std::uniform_int_distribution<int> code(0, 255);
        return {std::uint8_t(code(random)), std::uint8_t(code(random)), std::uint8_t(code(random)), 255};
    }
    /// Adds triangles that cross each other, with alpha from 0 to 1 inclusive. Every fifth triangle is
    /// coplanar with the one before it, either at the same position or at a different one. The planes of
    /// these pairs face the viewer unless they are `inclined`.
    void scatter(int count, int max_alpha, bool inclined) {
        std::uniform_real_distribution<double> across(-3, 3), up(0.2, 4.5), size(1, 4);
        std::uniform_int_distribution<int> alpha(0, max_alpha), kind(0, 9);
        std::array<Vector3d, 3> before;
        before.fill(Vector3d::Zero());
        for (int i = 0; i < count; ++i) {
            const Vector3d middle(across(random), across(random), up(random));
            std::array<Vector3d, 3> corners;
            for (Vector3d& c : corners)
                c = middle + size(random) * Vector3d(across(random), across(random), across(random)) / 3;
            if (i % 5 == 3 && !inclined)
                for (Vector3d& c : corners) c.y() = middle.y();
            if (i % 5 == 4)
                for (std::size_t j = 0; j < 3; ++j)
                    corners[j] = i % 10 == 4 ? before[j] : 0.7 * before[j] + 0.3 * before[(j + 1) % 3];
            before = corners;
            std::array<Color, 3> colors;
            for (Color& c : colors) {
                c = random_color();
                const int k = kind(random);
                c[3] = std::uint8_t(k == 0 ? 0 : k == 1 ? 255 : alpha(random));
            }
            if (colors[0][3] == 255 && colors[1][3] == 255) colors[0][3] = 100;
            add(corners, colors);
        }
    }
    PackageReader prepared(const std::string& name = "scene", const PrepareRun& run = {}) const {
        prepare(
            input, settings, dir / (name + ".vantage"), [](const Progress&) {}, run);
        return PackageReader(dir / (name + ".vantage"));
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    static RenderSettings shown_as(Transparency mode) {
        RenderSettings s;
        s.transparency = mode;
        return s;
    }
    static Picture taken(Renderer& renderer, const View& view, const RenderSettings& settings, int side = 1) {
        return take_picture(renderer, view, settings, all(renderer.package()), side);
    }
    /// The samples of a picture as linear light and coverage.
    static std::vector<Vector4d> light(Renderer& renderer, const View& view, const RenderSettings& settings) {
        taken(renderer, view, settings);
        std::vector<Eigen::Vector4f> out(std::size_t(view.intrinsics.width) *
                                         std::size_t(view.intrinsics.height));
        glGetTextureImage(renderer.resources().targets.samples.front().sum.id(), 0, GL_RGBA, GL_FLOAT,
                          GLsizei(out.size() * 16), out.data());
        std::vector<Vector4d> light;
        for (const Eigen::Vector4f& l : out) light.push_back(l.cast<double>());
        return light;
    }
    static View facing(const PackageReader& package, double fov = 30, int width = 160, int height = 120) {
        const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
        return view_towards(Vector3d(0, -14, 2.5) - origin, Vector3d(0, 0, 2.5) - origin, {0, 0, 1}, fov,
                            width, height);
    }
    /// The depth of the opaque surface at each pixel.
    std::vector<double> opaque_depth(const PackageReader& package, const View& view) const {
        Mesh opaque = input.mesh;
        std::erase_if(opaque.triangles, [&](const auto& t) {
            return opaque.colors[t[0]][3] < 255 || opaque.colors[t[1]][3] < 255 ||
                   opaque.colors[t[2]][3] < 255;
        });
        std::vector<double> out;
        const Intrinsics& k = view.intrinsics;
        if (opaque.triangles.empty()) return std::vector<double>(std::size_t(k.width * k.height), 1e300);
        const RayScene rays(opaque);
        const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
        const Eigen::Matrix3d turned = view.cam_from_origin.R.transpose();
        for (int y = 0; y < k.height; ++y)
            for (int x = 0; x < k.width; ++x) {
                const Vector3d ray((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
                const auto hit = rays.first_hit(view.cam_from_origin.center() + origin, turned * ray);
                out.push_back(hit ? hit->distance : 1e300);
            }
        return out;
    }
    SceneInput input;
    PrepareSettings settings;
    std::mt19937 random{7};
};

}  // namespace vantage

#include "pipeline/background/backdrop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <set>

#include "pipeline/background/calm_colors.h"
#include "pipeline/background/depth/walls_beyond.h"
#include "tests/pipeline/background/yard.h"

using namespace vantage;

namespace {

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values.at(std::size_t(share * double(values.size() - 1)));
}

/// Errors of the backdrop for each part of the yard, in directions that at least three photos show.
struct ByContent {
    std::vector<double> ground, hill;  ///< relative error of the distance
    std::vector<double> sky;           ///< distance
};

ByContent compare(const Backdrop& b, const std::vector<CoarseView>& views) {
    ByContent out;
    for (std::size_t i = 0; i < b.positions.size(); ++i) {
        const Eigen::Vector3d direction = b.sphere.directions[i].cast<double>();
        const double truth = yard::distance(b.center, direction), far = std::isfinite(truth) ? truth : 1e6;
        const Eigen::Vector3d point = b.center + far * direction;
        const auto shows = [&](const CoarseView& v) {
            const auto p = project(v.k, v.pose, point);
            if (!p || !in_frame(v.k, p->pixel)) return false;
            return v.is_open(std::size_t(p->pixel.y()) * std::size_t(v.k.width) + std::size_t(p->pixel.x()));
        };
        if (std::ranges::count_if(views, shows) < 3) continue;
        const double found = (b.positions[i].cast<double>() - b.center).norm();
        if (!std::isfinite(truth))
            out.sky.push_back(found);
        else
            (point.z() < 1e-6 ? out.ground : out.hill).push_back(std::abs(found - truth) / truth);
    }
    return out;
}

double degrees_from_down(const Eigen::Vector3d& direction) {
    return std::acos(std::clamp(-direction.z(), -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Discs on a wall through the origin, 4 by 4 units in size.
std::vector<SurfaceDisc> wall(const Eigen::Vector3f& normal, int count) {
    const Eigen::Vector3f across = normal.cross(Eigen::Vector3f::UnitZ());
    std::vector<SurfaceDisc> out;
    for (int i = 0; i < count; ++i)
        out.push_back({across * (float(i % 20) / 5 - 2) + Eigen::Vector3f(0, 0, float(i) / float(count) * 4),
                       normal, 0.1f});
    return out;
}

/// Two walls on a narrow floor. The floor has a twentieth of all discs, and all surfaces are rough.
std::vector<SurfaceDisc> house(double floor, double roughness) {
    std::vector<SurfaceDisc> out = wall(Eigen::Vector3f::UnitY(), 300);
    const std::vector<SurfaceDisc> other = wall(Eigen::Vector3f::UnitX(), 270);
    out.insert(out.end(), other.begin(), other.end());
    for (int i = 0; i < 30; ++i)
        out.push_back(
            {{float(i) / 7.5f - 2, -0.1f * float(i % 3), float(floor)}, Eigen::Vector3f::UnitZ(), 0.1f});
    std::mt19937 random(1);
    std::normal_distribution<float> rough(0, float(roughness));
    for (SurfaceDisc& d : out) {
        d.normal = (d.normal + Eigen::Vector3f(rough(random), rough(random), rough(random))).normalized();
        d.center += 0.3f * Eigen::Vector3f(rough(random), rough(random), rough(random));
    }
    return out;
}

struct Depths {
    DirectionSphere sphere = direction_sphere(5);
    SweptDepths swept;
    std::vector<float> inverse;
};

/// Directions within 45 degrees of the x axis, with inverse distances from `inverse` plus noise.
Depths depths_of(const Eigen::Vector3d& center,
                 const std::function<double(const Eigen::Vector3d& ray)>& inverse) {
    Depths out;
    out.swept.center = center;
    out.swept.step = 0.002f;
    std::mt19937 random(2);
    std::normal_distribution<float> noise(0, 0.0005f);
    for (std::uint32_t v = 0; v < out.sphere.directions.size(); ++v) {
        const Eigen::Vector3f& ray = out.sphere.directions[v];
        const bool shown = ray.x() > 0.7f;
        if (shown) out.swept.shown.push_back(v);
        out.swept.base.push_back(1e-4f);
        out.inverse.push_back(shown ? float(inverse(ray.cast<double>())) + noise(random) : 1e-4f);
    }
    return out;
}

}  // namespace

TEST(DirectionSphere, IsClosedAndRegular) {
    const DirectionSphere s = direction_sphere(3);
    EXPECT_EQ(s.triangles.size(), 20u * 64);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : s.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second)
                << "each edge is crossed once in each direction";
    for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a}));
    EXPECT_EQ(s.directions.size() + s.triangles.size(), edges.size() / 2 + 2) << "Euler's formula";
    for (std::uint32_t v = 0; v < s.directions.size(); ++v)
        for (const std::uint32_t u : s.neighbors[v])
            EXPECT_TRUE(u == DirectionSphere::none || edges.contains({v, u}));
}

TEST(GroundPlane, IsFoundFromWhatPhotosShowOfIt) {
    const std::vector<CoarseView> views = yard::photos();
    const auto ground = find_ground(views, {});
    ASSERT_TRUE(ground);
    EXPECT_LT(std::acos(std::clamp(-ground->normal.z(), -1.0, 1.0)), 1.0 * std::numbers::pi / 180);
    const double above = ground->height - ground->normal.dot(Eigen::Vector3d(0, -6, 1.6));
    EXPECT_NEAR(above, 1.6, 0.05);
}

TEST(GroundPlane, ContinuesTheFloorOfAMeshWithWalls) {
    const std::vector<CoarseView> views = yard::photos();
    const MeshPlanes mesh = mesh_planes(house(0.06, 0.01), views);
    const auto ground = find_ground(views, mesh);
    ASSERT_TRUE(ground);
    EXPECT_LT(degrees_from_down(ground->normal), 0.3);
    EXPECT_NEAR(ground->height, -0.06, 0.01) << "even though the photos agree best at 0";
}

TEST(GroundPlane, IsNotTheTableOnWhichTheMeshStands) {
    const std::vector<CoarseView> views = yard::photos();
    const MeshPlanes mesh = mesh_planes(house(0.8, 0.02), views);
    ASSERT_TRUE(mesh.floor);
    EXPECT_NEAR(mesh.floor->height, -0.8, 0.02);
    const auto ground = find_ground(views, mesh);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->height, 0, 0.05);
}

TEST(WallsBeyond, AreFoundInTheDepths) {
    const Eigen::Vector3d center(3, -2, 1), facade = Eigen::Vector3d(1, 0.2, 0).normalized();
    const double facade_away = 12, gable_away = 7;
    // A street corner, seen from the center with a little noise.
    const Depths d = depths_of(center, [&](const Eigen::Vector3d& ray) {
        return std::max(facade.dot(ray) / facade_away, ray.y() / gable_away);
    });
    const std::vector<Plane> walls = walls_beyond(d.swept, d.sphere, d.inverse, -Eigen::Vector3d::UnitZ());
    ASSERT_EQ(walls.size(), 2u);
    for (const Plane& w : walls) {
        const bool of_facade = w.normal.dot(facade) > 0.9;
        const Eigen::Vector3d truth = of_facade ? facade : Eigen::Vector3d(Eigen::Vector3d::UnitY());
        EXPECT_GT(w.normal.dot(truth), std::cos(1.0 * std::numbers::pi / 180));
        EXPECT_NEAR(w.height - w.normal.dot(center), of_facade ? facade_away : gable_away, 0.2);
    }
}

TEST(WallsBeyond, AreUpright) {
    const Depths slope = depths_of({0, 0, 0}, [](const Eigen::Vector3d& ray) {
        return ray.dot(Eigen::Vector3d(1, 0, 1).normalized()) / 12;
    });
    EXPECT_TRUE(walls_beyond(slope.swept, slope.sphere, slope.inverse, -Eigen::Vector3d::UnitZ()).empty());
}

TEST(Backdrop, DepthByDirectionIsThatOfTheYard) {
    const std::vector<CoarseView> views = yard::photos();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    const ByContent found = compare(b, views);
    ASSERT_GT(found.ground.size(), 300u);
    ASSERT_GT(found.hill.size(), 100u);
    ASSERT_GT(found.sky.size(), 300u);
    std::printf(
        "ground: %zu directions, median error %.3f, 90 %% below %.3f; hill: %zu, %.3f, %.3f; sky: %zu\n",
        found.ground.size(), quantile(found.ground, 0.5), quantile(found.ground, 0.9), found.hill.size(),
        quantile(found.hill, 0.5), quantile(found.hill, 0.9), found.sky.size());
    EXPECT_LT(quantile(found.ground, 0.5), 0.02);
    EXPECT_LT(quantile(found.ground, 0.9), 0.1);
    EXPECT_LT(quantile(found.hill, 0.5), 0.15);
    EXPECT_GT(quantile(found.sky, 0.3), 100) << "practically infinite for cameras at most 10 apart";
}

TEST(Backdrop, ContainsTheCamerasAndLeavesTheMeshInSight) {
    const std::vector<CoarseView> views = yard::photos();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    for (const CoarseView& v : views) {
        const Eigen::Vector3d eye = v.pose.center() - b.center;
        for (std::size_t i = 0; i < b.positions.size(); ++i) {
            const bool toward = b.sphere.directions[i].cast<double>().dot(eye.normalized()) > 0.99;
            EXPECT_TRUE(!toward || (b.positions[i].cast<double>() - b.center).norm() > eye.norm());
        }
    }
    for (const Eigen::Vector3f& p : b.positions) ASSERT_TRUE(p.allFinite());
    for (const auto& [i, j, k] : b.sphere.triangles) {
        const auto &u = b.sphere.directions[i], &v = b.sphere.directions[j], &w = b.sphere.directions[k];
        ASSERT_LT(u.dot(v.cross(w)), 0) << "the player draws only the inside";
    }
}

TEST(Backdrop, NeedsMoreThanOneViewpoint) {
    std::vector<CoarseView> views = yard::photos();
    EXPECT_TRUE(have_parallax(views));
    views.resize(1);
    EXPECT_FALSE(have_parallax(views));
}

TEST(CalmColors, AreWhatMostPhotosShow) {
    std::vector<CoarseView> views =
        yard::photos([](const auto&, const auto&, const auto&) { return Eigen::Array3f(0.2f, 0.4f, 0.6f); });
    for (std::size_t i = 0; i < views[4].ln.size(); ++i)  // leaves in front of one lens
        if (views[4].is_open(i)) views[4].ln[i] = Eigen::Array3f::Constant(std::log(0.02f));
    const Backdrop b = estimate_backdrop(views, {}, validated_detail, 0);
    const std::vector<Eigen::Array3f> colors = calm_colors(b, views, paint_backdrop(b, views, 0));
    std::size_t right = 0;
    for (const Eigen::Array3f& c : colors) {
        ASSERT_TRUE(c.isFinite().all());
        right += (c - Eigen::Array3f(0.2f, 0.4f, 0.6f)).abs().maxCoeff() < 0.1f;
    }
    EXPECT_GT(double(right), 0.9 * double(colors.size()))
        << "everything except the area that only the photo with leaves sees";
}

TEST(CalmColors, OfTheSkyHaveNothingOfTheHillBelow) {
    const std::vector<CoarseView> views = yard::photos();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    ASSERT_TRUE(b.sky.any());
    const std::vector<Eigen::Array3f> colors = calm_colors(b, views, paint_backdrop(b, views, 0));
    std::size_t sky = 0, blue = 0;
    for (std::size_t d = 0; d < colors.size(); ++d) {
        const Eigen::Vector3d direction = b.sphere.directions[d].cast<double>();
        if (!b.is_sky[d] || std::isfinite(yard::distance(b.center, direction))) continue;
        const auto inside = [&](const CoarseView& v) {
            return sample(v, v.pose.R.cast<float>() * b.sphere.directions[d], 1).kind == ViewSample::open;
        };
        if (std::ranges::count_if(views, inside) < 3) continue;
        ++sky, blue += colors[d].z() > colors[d].y() + 0.05f;  // by 0.1, where the green hill ends
    }
    EXPECT_GT(double(blue), 0.98 * double(sky)) << sky;
}

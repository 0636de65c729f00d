// Detection of a mesh's sky triangles. The ground truth is a ray-traced brick house with a window that
// mirrors the sky. A white tower stands beside the house, a pond lies in front of it, and above the roof is a
// membrane that exists only in the mesh.
#include "pipeline/background/sky_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace vantage;

namespace {

using SkyCode = std::function<float(double elevation, int channel)>;  // codes

/// An upright rectangle at depth y.
struct HousePart {
    double x0, x1, z0, z1, y;
    bool real;
    std::function<float(const Eigen::Vector3d& at, const Eigen::Vector3d& ray, int channel)> code;
};

struct House {
    SkyCode sky;
    std::vector<HousePart> parts;
    double pond_near = -9, pond_far = -4;

    explicit House(SkyCode s, float white) : sky(std::move(s)) {
        const auto brick = [](const Eigen::Vector3d& at, const Eigen::Vector3d&, int c) {
            return float(90 + 20 * std::sin(9 * at.x()) * std::sin(9 * at.z()) - 15 * c);
        };
        const auto mirror = [this](const Eigen::Vector3d&, const Eigen::Vector3d& ray, int c) {
            return sky(std::abs(ray.z()) + 0.2, c);
        };
        parts = {{-3, 3, 0, 3, 0, true, brick},
                 {-0.5, 0.5, 1.8, 2.6, -0.01, true, mirror},
                 {3.2, 5, 0, 5, 0, true, [white](const auto&, const auto&, int) { return white; }},
                 {-2, 2, 3, 4.6, 0.5, false, {}}};
    }
    /// The nearest intersection of a ray with the mesh or with the world: the distance, which is infinite for
    /// the sky, and the part.
    std::pair<double, const HousePart*> meets(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
                                              bool mesh) const {
        std::pair<double, const HousePart*> out{std::numeric_limits<double>::infinity(), nullptr};
        for (const HousePart& p : parts) {
            const double r = (p.y - eye.y()) / ray.y();
            const Eigen::Vector3d at = eye + r * ray;
            const bool hit = at.x() > p.x0 && at.x() < p.x1 && at.z() > p.z0 && at.z() < p.z1;
            if (hit && (p.real || mesh) && r < out.first) out = {r, &p};
        }
        return out;
    }
    float code(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray, int channel) const {
        const auto [r, part] = meets(eye, ray, false);
        const double ground = ray.z() < 0 ? -eye.z() / ray.z() : std::numeric_limits<double>::infinity();
        if (part && r < ground) return part->code(eye + r * ray, ray, channel);
        if (std::isinf(ground)) return sky(ray.z(), channel);
        const double y = (eye + ground * ray).y();
        return y > pond_near && y < pond_far ? sky(-ray.z(), channel) : 70.0f + 10.0f * float(channel);
    }

    std::vector<SkyPicture> pictures() const {
        std::vector<SkyPicture> out;
        for (int i = 0; i < 5; ++i) {
            SkyPicture p;
            p.k = {384, 288, 330, 330, 192, 200};
            p.pose.R << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // looks along y
            const Eigen::Vector3d eye(2.0 * (i - 2), -12, 1.6);
            p.pose.t = -p.pose.R * eye;
            p.codes.create(p.k.height, p.k.width);
            p.z.create(p.k.height, p.k.width);
            p.sky.create(p.k.height, p.k.width);
            for (int y = 0; y < p.k.height; ++y)
                for (int x = 0; x < p.k.width; ++x) {
                    const Eigen::Vector3d ray =
                        (p.pose.R.transpose() *
                         Eigen::Vector3d((x + 0.5 - p.k.cx) / p.k.fx, (y + 0.5 - p.k.cy) / p.k.fy, 1))
                            .normalized();
                    const double r = meets(eye, ray, true).first;
                    const bool pond = ray.z() < 0 && -eye.z() / ray.z() < r;
                    const double hit = pond ? -eye.z() / ray.z() : r;
                    p.z(y, x) = float(hit * ray.y());
                    for (int c = 0; c < 3; ++c) p.codes(y, x)[c] = code(eye, ray, c);
                    p.sky(y, x) = std::isinf(hit) && ray.z() > 0;
                }
            out.push_back(std::move(p));
        }
        return out;
    }
};

/// The parts divided into squares of 0.1 units, and the ground in front of the house.
struct HouseMesh {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<bool> membrane;  ///< per triangle

    void add(const std::array<Eigen::Vector3f, 4>& q, bool is_membrane) {
        const auto at = std::uint32_t(positions.size());
        positions.insert(positions.end(), q.begin(), q.end());
        triangles.push_back({at, at + 1, at + 2});
        triangles.push_back({at, at + 2, at + 3});
        membrane.insert(membrane.end(), 2, is_membrane);
    }
    explicit HouseMesh(const House& house) {
        constexpr float step = 0.1f;
        for (const HousePart& p : house.parts)
            for (float x = float(p.x0); x < float(p.x1) - step / 2; x += step)
                for (float z = float(p.z0); z < float(p.z1) - step / 2; z += step) {
                    const auto y = float(p.y);
                    add({Eigen::Vector3f(x, y, z),
                         {x + step, y, z},
                         {x + step, y, z + step},
                         {x, y, z + step}},
                        !p.real);
                }
        for (float x = -3; x < 3; x += 4 * step)
            for (float y = -9; y < -1; y += 4 * step)
                add({Eigen::Vector3f(x, y, 0),
                     {x + 4 * step, y, 0},
                     {x + 4 * step, y + 4 * step, 0},
                     {x, y + 4 * step, 0}},
                    false);
    }
};

struct Removed {
    double membrane = 0;   ///< fraction removed
    std::size_t real = 0;  ///< number of triangles removed
};
Removed removed_from(const House& house) {
    const HouseMesh mesh(house);
    const auto found =
        sky_triangles(mesh.positions, mesh.triangles, house.pictures(), -Eigen::Vector3f::UnitZ(), 0);
    Removed out;
    for (const std::uint32_t t : found) mesh.membrane[t] ? void(++out.membrane) : void(++out.real);
    out.membrane /= double(std::ranges::count(mesh.membrane, true));
    return out;
}

float blue_sky_code(double elevation, int c) {
    return float(215 - 30 * elevation - (c == 0 ? 40 : c == 1 ? 15 : 0));
}
float overcast_code(double elevation, int) { return float(212 - 25 * elevation); }
float overexposed_code(double, int) { return 255; }

}  // namespace

TEST(SkyTriangles, AreTheMembraneAndNothingElse) {
    const Removed blue_sky = removed_from(House(blue_sky_code, 240)),
                  gray = removed_from(House(overcast_code, 245));
    EXPECT_GT(blue_sky.membrane, 0.9);
    EXPECT_GT(gray.membrane, 0.9);
    EXPECT_EQ(blue_sky.real, 0u) << "of wall, window, tower and pond";
    EXPECT_EQ(gray.real, 0u) << "of wall, window, tower and pond";
}

TEST(SkyTriangles, AreNotToldFromAWhiteWallWhereTheSkyIsOverexposed) {
    EXPECT_EQ(removed_from(House(overexposed_code, 255)).real, 0u);
}

TEST(SkyTriangles, NeedMoreThanOnePhoto) {
    const House house(blue_sky_code, 240);
    const HouseMesh mesh(house);
    std::vector<SkyPicture> one = house.pictures();
    one.resize(1);
    EXPECT_TRUE(sky_triangles(mesh.positions, mesh.triangles, one, -Eigen::Vector3f::UnitZ(), 0).empty());
    EXPECT_TRUE(sky_triangles(mesh.positions, mesh.triangles, {}, -Eigen::Vector3f::UnitZ(), 0).empty());
}

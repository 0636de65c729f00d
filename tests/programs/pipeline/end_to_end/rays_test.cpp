// Compares pictures and visibility with Embree's ray casting and with the photos themselves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/photos/photos.h"
#include "pipeline/run/settings.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/programs/pipeline/end_to_end/prepared_scene.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// Whether a point is in front of the camera, inside the photo and, according to ray casting, not occluded.
bool sees(const RayScene& rays, const Camera& camera, const Eigen::Vector3d& point) {
    const auto p = project(camera.intrinsics, camera.cam_from_world, point);
    if (!p || p->pixel.x() < 0 || p->pixel.y() < 0 || p->pixel.x() >= camera.intrinsics.width ||
        p->pixel.y() >= camera.intrinsics.height)
        return false;
    const Eigen::Vector3d center = camera.cam_from_world.center();
    return !rays.occluded(center, point - center, 0, 1 - 1e-4);
}

Mesh about_origin(const Mesh& mesh, const Eigen::Vector3d& origin) {
    Mesh moved = mesh;
    for (Eigen::Vector3d& p : moved.positions) p -= origin;
    return moved;
}

std::vector<Camera> cameras_about(const SceneInput& scene, const Eigen::Vector3d& origin) {
    std::vector<Camera> cameras;
    for (const PhotoInput& photo : scene.photos) {
        cameras.push_back(photo.camera);
        cameras.back().cam_from_world = photo.camera.cam_from_world.relative_to(origin);
    }
    return cameras;
}

struct Colored {
    std::size_t seen = 0, colored = 0;
};

/// Checks every `step`-th pixel in both directions: counts the pixels whose surface at least one photo sees,
/// and how many of these are colored.
Colored count_colored(const Picture& picture, const Camera& from, const RayScene& rays,
                      const std::vector<Camera>& cameras, int step) {
    Colored count;
    const Intrinsics& k = from.intrinsics;
    const Eigen::Vector3d eye = from.cam_from_world.center();
    for (int y = 0; y < picture.height; y += step)
        for (int x = 0; x < picture.width; x += step) {
            const Eigen::Vector3d ray = from.cam_from_world.R.transpose() *
                                        Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            const auto hit = rays.first_hit(eye, ray);
            if (!hit) continue;
            const Eigen::Vector3d point = eye + hit->distance * ray;
            const auto sees_point = [&](const Camera& c) { return sees(rays, c, point); };
            if (std::none_of(cameras.begin(), cameras.end(), sees_point)) continue;
            ++count.seen;
            count.colored +=
                picture.rgba[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4 + 3] == 255;
        }
    return count;
}

/// Renders views from the camera of every `every`-th photo at full size, with the player's default settings.
/// Expects to see the photo itself with the default blend and with "best", blending all photos or only one.
/// Surfaces that at least one photo sees must be colored; every `step`-th pixel is tested.
void expect_own_views_are_the_photos(Prepared& p, int step, std::uint32_t every) {
    const Eigen::Map<const Eigen::Vector3d> origin(p.package->scene().origin);
    const RayScene rays(about_origin(p.scene.mesh, origin));
    const std::vector<Camera> cameras = cameras_about(p.scene, origin);
    double worst = 1e9, average = 0;
    Colored all;
    int views = 0;
    for (const std::uint32_t i : p.photos) {
        if (i % every != 0) continue;
        ++views;
        const Intrinsics& k = p.scene.photos[i].camera.intrinsics;
        const auto photo = read_photo(p.scene.photos[i].file, {k.width, k.height}).rgba;
        for (const Blend blend : {RenderSettings{}.blend, Blend::best})
            for (const int photos : {0, 1})
                worst = std::min(worst, psnr(p.own_view(i, blend, 4, photos), photo));
        const Picture blended = p.own_view(i, Blend::average);
        average += psnr(blended, photo);
        const Colored count = count_colored(blended, cameras[i], rays, cameras, step);
        all.seen += count.seen;
        all.colored += count.colored;
    }
    average /= views;
    std::printf(
        "own views: lowest PSNR %.1f dB with the default blend and the best photo, mean PSNR %.1f dB with "
        "the weighted average; %.3f %% of %zu pixels colored\n",
        worst, average, 100 * double(all.colored) / double(all.seen), all.seen);
    EXPECT_GE(worst, 50);
    EXPECT_GE(average, 20);
    EXPECT_GE(double(all.colored), 0.995 * double(all.seen));
}

/// The projections of silhouette and boundary edges, at which the depth is discontinuous.
class DepthBorders {
  public:
    DepthBorders(const Mesh& mesh, const Camera& camera) {
        const Eigen::Vector3d eye = camera.cam_from_world.center();
        std::map<std::array<std::uint32_t, 2>, std::array<int, 2>>
            edges;  // number of triangles facing away from and toward the camera
        for (const auto& t : mesh.triangles) {
            const Eigen::Vector3d a = mesh.positions[t[0]];
            const double away = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).dot(a - eye);
            for (std::size_t i = 0; i < 3; ++i)
                ++edges[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}][away < 0];
        }
        for (const auto& [edge, looks] : edges) {
            if (looks[0] + looks[1] == 2 && looks[0] != 1) continue;
            const auto a = project(camera.intrinsics, camera.cam_from_world, mesh.positions[edge[0]]);
            const auto b = project(camera.intrinsics, camera.cam_from_world, mesh.positions[edge[1]]);
            if (a && b) segments.push_back({a->pixel, b->pixel});
        }
    }
    bool within(double pixels, const Eigen::Vector2d& p) const {
        return std::any_of(segments.begin(), segments.end(), [&](const auto& s) {
            const Eigen::Vector2d along = s[1] - s[0];
            const double length2 = along.squaredNorm();
            const double share = length2 > 0 ? std::clamp((p - s[0]).dot(along) / length2, 0.0, 1.0) : 0;
            return (s[0] + share * along - p).norm() <= pixels;
        });
    }

  private:
    std::vector<std::array<Eigen::Vector2d, 2>> segments;
};

/// Whether the depth varies too abruptly within a few pixels for a smooth surface.
bool depth_jumps_around(const RayScene& rays, const Camera& camera, const Eigen::Vector2d& pixel) {
    constexpr int reach = 3;
    double inverse[2 * reach + 1][2 * reach + 1], largest = 0;
    const Intrinsics& k = camera.intrinsics;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const Eigen::Vector3d ray((pixel.x() + i - k.cx) / k.fx, (pixel.y() + j - k.cy) / k.fy, 1);
            const auto hit =
                rays.first_hit(camera.cam_from_world.center(), camera.cam_from_world.R.transpose() * ray);
            inverse[j + reach][i + reach] = hit ? 1 / hit->distance : 0;
            largest = std::max(largest, inverse[j + reach][i + reach]);
        }
    const auto bends = [&](double a, double b, double c) {
        return std::abs(a - 2 * b + c) > 0.002 * largest;
    };
    for (int j = 0; j <= 2 * reach; ++j)
        for (int i = 1; i < 2 * reach; ++i)
            if (bends(inverse[j][i - 1], inverse[j][i], inverse[j][i + 1]) ||
                bends(inverse[i - 1][j], inverse[i][j], inverse[i + 1][j]))
                return true;
    return false;
}

/// Compares the package's visibility per vertex with ray casting, for all vertices and every `every`-th
/// photo.
void expect_visibility_is_that_of_rays(Prepared& p, std::uint32_t every = 1) {
    const Eigen::Map<const Eigen::Vector3d> origin(p.package->scene().origin);
    const Mesh mesh = about_origin(p.scene.mesh, origin);
    const RayScene rays(mesh);
    const std::vector<Camera> cameras = cameras_about(p.scene, origin);
    const auto vertices = p.package->records<Eigen::Vector3f>(package::Type::positions);
    std::size_t pairs = 0, differ = 0, away_from_borders = 0;
    for (const std::uint32_t i : p.photos) {
        if (i % every != 0) continue;
        const auto uv = p.package->records<Eigen::Vector2f>(package::Type::coordinates, i);
        std::vector<Eigen::Vector3d> wrong;
        for (std::size_t v = 0; v < uv.size(); ++v, ++pairs)
            if (const Eigen::Vector3d at = vertices[v].cast<double>();
                (uv[v].x() >= 0) != sees(rays, cameras[i], at))
                wrong.push_back(at);
        if (wrong.empty()) continue;
        const DepthBorders borders(mesh, cameras[i]);
        differ += wrong.size();
        for (const Eigen::Vector3d& at : wrong) {
            const auto p = project(cameras[i].intrinsics, cameras[i].cam_from_world, at);
            away_from_borders +=
                !p || !(borders.within(2, p->pixel) || depth_jumps_around(rays, cameras[i], p->pixel));
        }
    }
    std::printf("visibility: %zu of %zu pairs differ (%.4f %% agree), %zu of them away from depth borders\n",
                differ, pairs, 100 * (1 - double(differ) / double(pairs)), away_from_borders);
    EXPECT_LE(double(differ), 0.001 * double(pairs));
    EXPECT_EQ(away_from_borders, 0u);
}

/// Compares VISB with the visible vertices in TEXC, and the rectangles of COVR with their pixels.
void expect_coverage_is_that_of_the_vertices(const PackageReader& package, std::uint32_t photo) {
    const auto uv = package.records<Eigen::Vector2f>(package::Type::coordinates, photo);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    const auto bits = package.records<std::uint64_t>(package::Type::visible, photo);
    const auto coverage = package.records<package::CoverageRecord>(package::Type::coverage, photo);
    const auto clusters = package.records<package::ClusterRecord>(package::Type::clusters);
    const std::size_t part = package::visible_words(indices.size() / 3);
    const auto bit = [&](std::size_t first, std::size_t t) { return bits[first + t / 64] >> (t % 64) & 1; };
    std::size_t more = 0;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        const package::CoverageRecord& r = coverage[c];
        for (std::size_t t = clusters[c].first_triangle;
             t < clusters[c].first_triangle + std::size_t(clusters[c].triangles); ++t) {
            int seen = 0;
            for (std::size_t v = 0; v < 3; ++v) {
                const Eigen::Vector2f at = uv[indices[3 * t + v]] * 65535;
                if (at.x() < 0) continue;
                ++seen;
                EXPECT_TRUE(at.x() >= r.u0 && at.x() <= r.u1 && at.y() >= r.v0 && at.y() <= r.v1);
            }
            EXPECT_EQ(bit(0, t), seen == 3) << t;
            EXPECT_TRUE(seen == 0 || bit(part, t)) << t;
            more += seen == 0 && bit(part, t);
        }
    }
    EXPECT_GT(more, 0u) << "some partly visible triangles should have only hidden corners";
}

}  // namespace

TEST_F(EndToEnd, OwnViewsMatchThePhotosOnASyntheticScene) {
    Prepared p = prepared(make(tiny()));
    expect_own_views_are_the_photos(p, 1, 1);
    expect_visibility_is_that_of_rays(p);
    for (const std::uint32_t i : p.photos) expect_coverage_is_that_of_the_vertices(*p.package, i);
}

TEST_F(EndToEndAtLength, VisibilityMatchesRayCastingOnTheGarden) {
    Prepared p = prepared(make(spec_named("garden")));
    expect_visibility_is_that_of_rays(p, 5);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosOnSceaux) {
    VANTAGE_DATASET(set, "sceaux");
    Prepared p = prepared(set);
    expect_own_views_are_the_photos(p, 6, 11);
    expect_visibility_is_that_of_rays(p, 4);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosDespiteTheTransientMask) {
    VANTAGE_DATASET(set, "sceaux-small");  // trees appear in some photos only
    PrepareSettings masked;
    masked.effects[Effect::transients] = EffectChoice::on;
    Prepared p(set, dir / "scene.vantage", masked);
    expect_own_views_are_the_photos(p, 6, 3);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosOnFountain) {
    VANTAGE_DATASET(set, "fountain-P11");
    Prepared p = prepared(set);
    expect_own_views_are_the_photos(p, 6, 11);
    expect_visibility_is_that_of_rays(p, 4);
}

// From photos to pictures, compared with ray casting by Embree and with the photos themselves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "player/view/shots.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// A scene, its package and its renderer.
struct Prepared {
    SceneInput scene;
    fs::path file;
    std::unique_ptr<PackageReader> package;
    std::unique_ptr<gl::HeadlessContext> context;
    std::unique_ptr<Renderer> renderer;
    std::vector<std::uint32_t> photos;

    Prepared(const fs::path& folder, const fs::path& to, const PrepareSettings& settings = {})
        : scene(read_scene(discover(folder))), file(to) {
        copy_package(folder, settings, file);
        open();
    }
    Prepared(SceneInput input, const fs::path& to, const PrepareSettings& settings = {})
        : scene(std::move(input)), file(to) {
        prepare(scene, settings, file, [](const Progress&) {});
        open();
    }
    void open() {
        package = std::make_unique<PackageReader>(file);
        context = std::make_unique<gl::HeadlessContext>(gl::Debug::on);
        renderer = std::make_unique<Renderer>(*package, MemoryBudget{});
        photos.resize(package->photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
    }
    Picture picture(const View& view, const RenderSettings& settings) {
        return take_picture(*renderer, view, settings, photos, 1);
    }
    Picture own_view(std::uint32_t photo, Blend blend, int per_pass = 4) {
        RenderSettings s;
        s.blend = blend;
        s.photos_per_pass = per_pass;
        return picture(view_of_photo(package->photos()[photo], 1), s);
    }
};

class EndToEnd : public TemporaryFolder {
  protected:
    static SynthSpec tiny() { return spec_named("tiny"); }
    fs::path make(const SynthSpec& spec) {
        copy_scene(spec, dir / "scene");
        return dir / "scene";
    }
    Prepared prepared(const fs::path& folder) {
        PrepareSettings settings;
        settings.vertex_coordinates = true;
        return Prepared(folder, dir / "scene.vantage", settings);
    }
};

class EndToEndAtLength : public EndToEnd {};

/// PSNR over the colored pixels in 8-bit sRGB; 200 if identical.
double psnr(const Picture& picture, const std::vector<std::uint8_t>& rgba) {
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        if (picture.rgba[i + 3] < 128) continue;
        for (std::size_t c = 0; c < 3; ++c, ++n) {
            const double d = double(picture.rgba[i + c]) - double(rgba[i + c]);
            sum += d * d;
        }
    }
    if (n == 0) return 0;
    return sum > 0 ? 10 * std::log10(255.0 * 255.0 * double(n) / sum) : 200;
}

/// Unoccluded, in front of the camera and inside the photo, by ray casting.
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

/// Among every `step`-th pixel along each side, counts those whose surface some photo sees, and how many of
/// these are colored.
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

/// Renders from the camera of every `every`-th photo at full size, with the player's default settings.
/// Expects the photo itself, by the default blend and by "best", and surfaces that some photo sees to be
/// colored, as sampled at every `step`-th pixel.
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
            worst = std::min(worst, psnr(p.own_view(i, blend), photo));
        const Picture blended = p.own_view(i, Blend::average);
        average += psnr(blended, photo);
        const Colored count = count_colored(blended, cameras[i], rays, cameras, step);
        all.seen += count.seen;
        all.colored += count.colored;
    }
    average /= views;
    std::printf(
        "own views: default and best photo at worst %.1f dB, weighted average %.1f dB, colored %.3f %% of "
        "%zu\n",
        worst, average, 100 * double(all.colored) / double(all.seen), all.seen);
    EXPECT_GE(worst, 50);
    EXPECT_GE(average, 20);
    EXPECT_GE(double(all.colored), 0.995 * double(all.seen));
}

/// Projections of silhouette and boundary edges, where depth jumps.
class DepthBorders {
  public:
    DepthBorders(const Mesh& mesh, const Camera& camera) {
        const Eigen::Vector3d eye = camera.cam_from_world.center();
        std::map<std::array<std::uint32_t, 2>, std::array<int, 2>>
            edges;  // numbers of triangles facing away from and toward the camera
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

/// Whether the depth within a few pixels is too curved for a smooth surface.
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

/// Compares the package's per-vertex visibility with ray casting, for every vertex in each photo, or in one
/// of so many.
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
    std::printf("visibility: %zu of %zu pairs differ (%.4f %% agree), %zu away from depth borders\n", differ,
                pairs, 100 * (1 - double(differ) / double(pairs)), away_from_borders);
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
    EXPECT_GT(more, 0u) << "no partly visible triangle has all corners hidden";
}

}  // namespace

TEST_F(EndToEnd, OwnViewsMatchThePhotosOnASyntheticScene) {
    Prepared p = prepared(make(tiny()));
    expect_own_views_are_the_photos(p, 1, 1);
    expect_visibility_is_that_of_rays(p);
    for (const std::uint32_t i : p.photos) expect_coverage_is_that_of_the_vertices(*p.package, i);
}

TEST_F(EndToEnd, BlendDoesNotDependOnPhotosPerPass) {
    Prepared p = prepared(make(tiny()));
    for (const Blend blend : {Blend::average, Blend::lumigraph, Blend::best}) {
        const Picture one = p.own_view(2, blend, 1);
        for (const int per_pass : {3, 16}) {
            const Picture many = p.own_view(2, blend, per_pass);
            const int rounding = blend == Blend::best ? 0 : 1;
            for (std::size_t i = 0; i < one.rgba.size(); ++i)
                ASSERT_NEAR(int(one.rgba[i]), int(many.rgba[i]), rounding) << int(blend) << " " << per_pass;
        }
    }
}

TEST_F(EndToEnd, BlackPixelsAreOpaque) {
    const fs::path scene = make(tiny());
    const Picture before = prepared(scene).own_view(2, Blend::average);
    for (const auto& photo : fs::directory_iterator(scene / "images"))
        image_files().write(photo.path(), 331, 250, 3, Sample::u8, std::vector<std::byte>(331 * 250 * 3));
    const Picture black = prepared(scene).own_view(2, Blend::average);
    for (std::size_t i = 0; i < black.rgba.size(); i += 4) {
        ASSERT_EQ(int(black.rgba[i]), 0);
        ASSERT_EQ(int(black.rgba[i + 3]), int(before.rgba[i + 3]));
    }
}

TEST_F(EndToEnd, ExcludedPhotoDoesNotContribute) {
    const fs::path scene = make(tiny());
    PrepareSettings settings;
    settings.effects[Effect::background] = EffectChoice::off;  // their shape depends on all photos
    PrepareSettings without = settings;
    without.hold_out = {"0002"};
    const Picture held = Prepared(scene, dir / "held.vantage", without).own_view(2, Blend::average);
    Prepared all(scene, dir / "scene.vantage", settings);
    std::erase(all.photos, 2u);
    const Picture excluded = all.own_view(2, Blend::average);
    EXPECT_EQ(excluded.rgba, held.rgba);
    const auto photo = read_photo(all.scene.photos[2].file, {331, 250}).rgba;
    for (const Picture& picture : {excluded, all.own_view(2, Blend::lumigraph)}) {
        EXPECT_GE(psnr(picture, photo), 22);
        EXPECT_LE(psnr(picture, photo), 40);
    }
}

TEST_F(EndToEnd, PhotosCoarserThanThePictureCountLess) {
    SynthSpec spec = tiny();
    spec.photos.width = 662, spec.photos.height = 500;
    spec.photos.arc = 40;
    SceneInput input = read_scene(discover(make(spec)));
    // One of the neighbors of photo 2, at a quarter of its size.
    PhotoInput& coarse = input.photos[1];
    RgbaImage image = read_photo(coarse.file, {662, 500});
    image = reduced(image, {166, 125});
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 < 3) rgb.push_back(image.rgba[i]);
    image_files().write(coarse.file, 166, 125, 3, Sample::u8, std::as_bytes(std::span(rgb)));
    coarse.camera.intrinsics = coarse.camera.intrinsics.scaled(166, 125);
    coarse.read.clear();  // changed on purpose
    Prepared p(std::move(input), dir / "scene.vantage");
    const auto photo = read_photo(p.scene.photos[2].file, {662, 500}).rgba;
    std::erase(p.photos, 2u);
    const auto gain_of_mask = [&](double scale, const std::vector<std::uint8_t>& truth) {
        RenderSettings settings;
        const View view = view_of_photo(p.package->photos()[2], scale);
        const double with = psnr(p.picture(view, settings), truth);
        settings.weights.depth_mask = false;
        return with - psnr(p.picture(view, settings), truth);
    };
    EXPECT_GT(gain_of_mask(1, photo), 0.05);
    const RgbaImage whole{662, 500, photo}, small = reduced(whole, {82, 62});
    EXPECT_NEAR(gain_of_mask(0.124, small.rgba), 0, 0.02) << "where every photo shows enough";
}

TEST_F(EndToEnd, PhotosAreReducedToTheRequestedSize) {
    const fs::path scene = make(tiny());
    PrepareSettings settings;
    settings.photo_size = 166;
    Prepared p(scene, dir / "small.vantage", settings);
    const Picture small = p.own_view(1, Blend::best);
    ASSERT_EQ(small.width, 166);
    const RgbaImage photo = read_photo(p.scene.photos[1].file, {331, 250});
    EXPECT_GE(psnr(small, reduced(photo, thumbnail_size(photo.width, photo.height, 166)).rgba), 40);
}

TEST_F(EndToEnd, DifferentExposuresAreReconciled) {
    SynthSpec spec = tiny();
    spec.photos.width = 662, spec.photos.height = 500;
    spec.photos.arc = 50;
    spec.exposure = {0.7, 0.2, 0.3};
    Prepared p = prepared(make(spec));
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::exposure));
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::vignetting));
    for (const std::uint32_t i : {1u, 2u, 3u}) {
        const auto photo = read_photo(p.scene.photos[i].file, {662, 500}).rgba;
        EXPECT_GE(psnr(p.own_view(i, Blend::best), photo), 40) << "with its own vignetting and exposure";
        std::vector<std::uint32_t> others = p.photos;
        std::erase(others, i);
        const View view = view_of_photo(p.package->photos()[i], 1);
        RenderSettings settings;
        const double agreeing = psnr(take_picture(*p.renderer, view, settings, others, 1), photo);
        settings.refined_colors = false;
        const double original = psnr(take_picture(*p.renderer, view, settings, others, 1), photo);
        std::printf("photo %u from the others: %.1f dB, as they were exposed %.1f dB\n", i, agreeing,
                    original);
        EXPECT_GT(agreeing, original + 5);
    }
    // With the exposure of the mean photo and of another one.
    RenderSettings settings;
    View view = view_of_photo(p.package->photos()[1], 1);
    view.exposure = {};
    const Picture mean = p.picture(view, settings);
    settings.exposure = 2;
    const Picture as_second = p.picture(view, settings);
    const std::size_t middle = 4 * (std::size_t(250) * 662 + 331);
    const auto& linear = linear_of_srgb_byte();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(linear[mean.rgba[middle + c]] / linear[as_second.rgba[middle + c]],
                    p.package->photos()[2].gain[c], 0.03);
}

/// Paints a photo's file in `color` wherever `inside` is true.
template <class Inside>
void paint(const PhotoInput& photo, const std::array<std::uint8_t, 3>& color, const Inside& inside) {
    const Intrinsics& k = photo.camera.intrinsics;
    const auto rgba = read_photo(photo.file, {k.width, k.height}).rgba;
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                rgb.push_back(inside(x, y)
                                  ? color[c]
                                  : rgba[4 * (std::size_t(y) * std::size_t(k.width) + std::size_t(x)) + c]);
    image_files().write(photo.file, k.width, k.height, 3, Sample::u8, std::as_bytes(std::span(rgb)));
}

TEST_F(EndToEnd, PassersByAndHighlightsInSinglePhotosVanish) {
    SynthSpec spec = spec_named("small");
    spec.photos.count = 7;
    spec.photos.arc = 60;
    const fs::path folder = make(spec);
    const SceneInput scene = read_scene(discover(folder));
    const auto untouched = read_photo(scene.photos[3].file, {1000, 750}).rgba;
    {
        PrepareSettings never;
        never.effects[Effect::transients] = EffectChoice::off;
        Prepared clean(folder, dir / "clean.vantage"), off(folder, dir / "off.vantage", never);
        EXPECT_FALSE(effect_on(clean.package->scene(), Effect::transients));
        for (std::uint32_t i = 0; i < clean.photos.size(); ++i)
            EXPECT_EQ(clean.package->find(package::Type::masks, i, mask_level)->checksum,
                      off.package->find(package::Type::masks, i, mask_level)->checksum)
                << "a consistent scene is not changed";
    }
    // A person in front of the wall, and the reflection of a flash.
    const auto passer_by = [](int x, int y) { return std::hypot((x - 420) / 45.0, (y - 380) / 110.0) < 1; };
    const auto flash = [](int x, int y) { return std::hypot(x - 640, y - 300) < 40; };
    paint(scene.photos[2], {190, 30, 25}, passer_by);
    paint(scene.photos[4], {255, 255, 255}, flash);
    Prepared p = prepared(folder);
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::transients));
    // The photo between them, rendered from the others.
    std::vector<std::uint32_t> others = p.photos;
    std::erase(others, 3u);
    const View view = view_of_photo(p.package->photos()[3], 1);
    RenderSettings model_only;
    model_only.background = ShowBackground::off;
    const double without = psnr(take_picture(*p.renderer, view, model_only, others, 1), untouched);
    RenderSettings all = model_only;
    all.weights.transient_mask = false;
    const double with = psnr(take_picture(*p.renderer, view, all, others, 1), untouched);
    // The same photos, unpainted.
    fs::remove_all(folder);
    Prepared clean = Prepared(make(spec), dir / "again.vantage");
    const double best = psnr(take_picture(*clean.renderer, view, model_only, others, 1), untouched);
    std::printf("with passers-by %.1f dB, without them %.1f dB, never painted %.1f dB\n", with, without,
                best);
    EXPECT_GT(without, with + 1);
    EXPECT_GT(without, best - 0.1);
    // The person vanishes from the photo's own view, too.
    const Picture own = p.own_view(2, Blend::average);
    const std::size_t middle = 4 * (std::size_t(380) * 1000 + 420);
    EXPECT_LT(int(own.rgba[middle]) - int(own.rgba[middle + 1]), 100);
}

TEST_F(EndToEnd, StencilExcludesCoveredPixels) {
    SynthSpec spec = tiny();
    const fs::path folder = make(spec);
    const PhotoInput photo = read_scene(discover(folder)).photos[2];
    std::vector<std::uint8_t> stencil(331 * 250, 255);
    for (std::size_t y = 100; y < 150; ++y)
        for (std::size_t x = 120; x < 200; ++x) stencil[y * 331 + x] = 0;
    const fs::path file = folder / "images" / "0002.mask.png";
    image_files().write(file, 331, 250, 1, Sample::u8, std::as_bytes(std::span(stencil)));
    Prepared p = prepared(folder);
    EXPECT_EQ(p.photos.size(), 5u) << "the stencil is not listed as a photo";
    EXPECT_TRUE(p.package->photos()[2].flags & package::photo_has_alpha);
    const View view = view_of_photo(p.package->photos()[2], 1);
    const Picture alone = take_picture(*p.renderer, view, {}, std::array{2u}, 1);
    const auto colored = [&](std::size_t x, std::size_t y) {
        return alone.rgba[4 * (y * 331 + x) + 3] == 255;
    };
    EXPECT_FALSE(colored(160, 125));
    EXPECT_TRUE(colored(160, 90));
    // A changed stencil is a changed input; a stencil of the wrong size is rejected.
    stencil.assign(stencil.size(), 255);
    image_files().write(file, 331, 250, 1, Sample::u8, std::as_bytes(std::span(stencil)));
    PrepareSettings settings;
    settings.vertex_coordinates = true;
    const PrepareResult again =
        prepare(read_scene(discover(folder)), settings, p.file, [](const Progress&) {});
    EXPECT_EQ(again.stages[std::size_t(package::Stage::tiles)].made, 1u);
    image_files().write(file, 33, 25, 1, Sample::u8, std::as_bytes(std::span(stencil).first(33 * 25)));
    const PrepareResult small =
        prepare(read_scene(discover(folder)), settings, p.file, [](const Progress&) {});
    ASSERT_EQ(small.left_out.size(), 1u);
    EXPECT_NE(small.left_out[0].why.find("its stencil 0002.mask.png"), std::string::npos)
        << small.left_out[0].why;
}

TEST_F(EndToEnd, LensDistortionIsRemoved) {
    // The reference is the same scene photographed without distortion.
    SynthSpec spec = spec_named("hard");
    spec.photos.count = 3;
    Prepared p = prepared(make(spec));
    spec.lens = {};
    copy_scene(spec, dir / "straight");
    EXPECT_TRUE(lens_of(*p.package, 0).distorts());
    EXPECT_EQ(p.package->find(package::Type::tiles, 0)->form, package::Form::cells) << "the photo as taken";
    for (const std::uint32_t i : p.photos) {
        const PhotoInput& photo = p.scene.photos[i];
        const Picture best = p.own_view(i, Blend::best);
        const double straight =
            psnr(best, read_photo(dir / "straight" / "images" / photo.name, photo.decoded).rgba);
        std::printf("lens taken out: %.1f dB against the photo without one\n", straight);
        EXPECT_GE(straight, 28.5);  // an offset of half a pixel would give 26
        EXPECT_LT(psnr(best, read_photo(photo.file, photo.decoded).rgba), 25);
    }
}

TEST_F(EndToEndAtLength, VisibilityMatchesRayCastingOnTheDemoScene) {
    Prepared p = prepared(make(spec_named("demo")));
    expect_visibility_is_that_of_rays(p, 5);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosOnSceaux) {
    VANTAGE_DATASET(set, "sceaux");
    Prepared p = prepared(set);
    expect_own_views_are_the_photos(p, 6, 11);
    expect_visibility_is_that_of_rays(p, 4);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosDespiteTheTransientMask) {
    VANTAGE_DATASET(set, "sceaux-small");  // trees appear in single photos
    PrepareSettings masked;
    masked.effects[Effect::transients] = EffectChoice::on;
    Prepared p(set, dir / "scene.vantage", masked);
    expect_own_views_are_the_photos(p, 6, 3);
}

TEST_F(EndToEnd, BackgroundFillTheFrameAndLeaveTheMeshAlone) {
    VANTAGE_DATASET(set, "sceaux-small");
    const auto picture = [](Prepared& of, ShowBackground shown) {
        RenderSettings settings;
        settings.background = shown;
        std::vector<std::uint32_t> others = of.photos;
        std::erase(others, 4u);
        return take_picture(*of.renderer, view_of_photo(of.package->photos()[4], 1), settings, others, 1)
            .rgba;
    };
    std::vector<package::DirectoryEntry> chunks;
    std::vector<std::uint8_t> before;
    {
        PrepareSettings without;
        without.effects[Effect::background] = EffectChoice::off;
        without.vertex_coordinates = true;  // as prepared() does
        Prepared none(set, dir / "none.vantage", without);
        const auto directory = none.package->directory();
        chunks.assign(directory.begin(), directory.end());
        before = picture(none, ShowBackground::on);
    }
    Prepared p = prepared(set);
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::background)) << "trees, lawn and sky";
    EXPECT_EQ(p.package->directory().size(), chunks.size() + 1);
    for (const package::DirectoryEntry& e : chunks) {
        const auto* same = p.package->find(package::Type(e.type), e.photo, e.level);
        const bool lists_effects =
            e.type == std::uint32_t(package::Type::meta) || e.type == std::uint32_t(package::Type::scene);
        ASSERT_TRUE(same);
        EXPECT_TRUE(lists_effects || same->checksum == e.checksum) << describe(*same, *p.package);
    }
    const auto off = picture(p, ShowBackground::off), on = picture(p, ShowBackground::on),
               dimmed = picture(p, ShowBackground::dimmed);
    EXPECT_TRUE(off == before) << "the same frame as without the effect";
    std::size_t filled = 0, beside = 0, changed = 0, darker = 0;
    for (std::size_t i = 0; i < on.size(); i += 4) {
        filled += on[i + 3] == 255;
        if (off[i + 3] == 255) {
            changed +=
                !std::equal(&on[i], &on[i] + 3, &off[i]) || !std::equal(&on[i], &on[i] + 3, &dimmed[i]);
        } else {
            ++beside;
            darker += dimmed[i] + dimmed[i + 1] + dimmed[i + 2] <= on[i] + on[i + 1] + on[i + 2];
        }
    }
    EXPECT_GE(double(filled), 0.99 * double(on.size() / 4));
    EXPECT_GT(double(beside), 0.2 * double(on.size() / 4));
    // The clip planes differ, and with them which of two triangles at the same depth is drawn.
    EXPECT_LE(double(changed), 1e-4 * double(on.size() / 4 - beside)) << "pixels of the mesh";
    EXPECT_EQ(darker, beside);
}

TEST_F(EndToEndAtLength, OwnViewsMatchThePhotosOnFountain) {
    VANTAGE_DATASET(set, "fountain-P11");
    Prepared p = prepared(set);
    expect_own_views_are_the_photos(p, 6, 11);
    expect_visibility_is_that_of_rays(p, 4);
}

// Compares tile sizes: small tiles contain fewer unused texels, but large tiles need fewer requests.
#include <Eigen/Geometry>
#include <array>
#include <unordered_set>

#include "base/gl/context.h"
#include "base/gl/object.h"
#include "base/values/tiling.h"
#include "pipeline/mesh/ray_scene.h"
#include "player/measure/evaluation/photo_pixels.h"
#include "player/plan/selection/sampling.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/crop.h"
#include "tests/bench/scenes/surface_points.h"
#include "tests/bench/sweeps/sweep.h"
#include "tests/bench/sweeps/tiles/tile_layers.h"
#include "tests/bench/sweeps/tiles/tile_pixels.h"

namespace vantage::bench {
namespace {

/// A square of 8x8 texels in a level of a photo. At every tile size, a tile's content consists of whole
/// squares.
constexpr int block_size = 8;
struct Block {
    std::uint32_t photo, level, x, y;
    std::uint64_t key() const {
        return std::uint64_t(photo) << 40 | std::uint64_t(level) << 34 | std::uint64_t(x) << 17 | y;
    }
};
using Blocks = std::unordered_set<std::uint64_t>;

/// A photo that a view may show.
struct Source {
    std::uint32_t photo;
    int levels;
    Intrinsics k;
    Pose pose;
    Eigen::Vector3d center;
};

/// The package's model, ready for ray casting.
struct Surface {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    RayScene rays;
};

Surface surface(const PackageReader& package) {
    std::vector<Eigen::Vector3f> positions;
    for (const auto& p : package.records<std::array<float, 3>>(package::Type::positions))
        positions.emplace_back(p[0], p[1], p[2]);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    RayScene rays(positions, indices);
    return {std::move(positions), {indices.begin(), indices.end()}, std::move(rays)};
}

/// Marks the blocks that a trilinear sample of the photo reads.
void mark(const Source& source, const SurfaceSample& sample, const Eigen::Vector2d& pixel, Blocks& out) {
    // Computes the level in the same way as footprint_of() and color_at() in the shaders.
    const double lod =
        std::clamp(level_of_detail(sample, source.k, source.pose) - 0.02, 0.0, double(source.levels - 1));
    for (int l = int(lod); l <= int(std::ceil(lod)); ++l) {
        const double scale = 1.0 / (block_size << l);
        out.insert(Block{source.photo, std::uint32_t(l), std::uint32_t(pixel.x() * scale),
                         std::uint32_t(pixel.y() * scale)}
                       .key());
    }
}

/// Marks the blocks that a point needs, from at most four photos: those nearest in angle that see it.
void mark_point(const Surface& surface, const std::vector<Source>& sources, const View& view,
                const Eigen::Vector3d& p, const Eigen::Vector3d& normal, Blocks& out) {
    const auto sample = surface_sample(view, p, normal, 1);
    if (!sample) return;
    const Eigen::Vector3d to_eye = (view.cam_from_origin.center() - p).normalized();
    std::vector<std::pair<double, const Source*>> by_angle;
    for (const Source& s : sources) {
        const Eigen::Vector3d to_photo = s.center - p;
        // Photos taken from behind show the other side of the surface.
        if (normal.dot(to_photo) * normal.dot(to_eye) > 0)
            by_angle.emplace_back(-to_photo.normalized().dot(to_eye), &s);
    }
    std::sort(by_angle.begin(), by_angle.end());
    int photos = 0;
    for (const auto& [angle, s] : by_angle) {
        const auto seen = project(s->k, s->pose, p);
        const double almost_there = 1 - 0.3 / std::max(s->k.fx, s->k.fy);
        if (!seen || !in_frame(s->k, seen->pixel) ||
            surface.rays.occluded(s->center, p - s->center, 0, almost_there))
            continue;
        mark(*s, *sample, seen->pixel, out);
        if (++photos == 4) return;
    }
}

/// The blocks that a view shows, found with one ray every `step` pixels.
Blocks shown_blocks(const PackageReader& package, const Surface& surface, const TrueView& view, int step) {
    std::vector<Source> sources;
    for (const std::uint32_t i : view.photos) {
        const package::PhotoRecord& p = package.photos()[i];
        const Pose pose = cam_from_origin(p);
        if (p.levels > 0) sources.push_back({i, int(p.levels), intrinsics(p), pose, pose.center()});
    }
    const Intrinsics& k = view.view.intrinsics;
    const Pose& pose = view.view.cam_from_origin;
    const Eigen::Vector3d eye = pose.center();
    Blocks out;
    for (int y = step / 2; y < k.height; y += step)
        for (int x = step / 2; x < k.width; x += step) {
            const Eigen::Vector3d ray =
                pose.R.transpose() * Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            const auto hit = surface.rays.first_hit(eye, ray);
            if (!hit) continue;
            const Eigen::Vector3d normal =
                area_vector(corners(surface.positions, surface.indices, hit->triangle)).normalized();
            mark_point(surface, sources, view.view, eye + hit->distance * ray, normal, out);
        }
    return out;
}

/// The bytes of the tiles that contain these blocks, including borders.
double tile_bytes_of(const Blocks& blocks, int size) {
    if (size == block_size) return double(blocks.size()) * size * size * 4;
    constexpr std::uint64_t mask = (1u << 17) - 1;
    const std::uint64_t content = std::uint64_t((size - 2 * tile_border) / block_size);
    Blocks tiles;
    for (const std::uint64_t b : blocks)
        tiles.insert((b & ~(mask << 17 | mask)) | (b >> 17 & mask) / content << 17 | (b & mask) / content);
    return double(tiles.size()) * size * size * 4;
}

/// About 16 MB of tiles of one size, cut from an image. Together, they do not fit in the processor's caches.
std::vector<Bytes> cut_some(const Picture& image, int size) {
    const int count = std::clamp((1 << 22) / (size * size), 4, 256);
    std::vector<Bytes> out;
    for (int i = 0; i < count; ++i)
        out.push_back(crop(image, i * size % image.width, i * size / image.width * size, size, size).rgba);
    return out;
}

// The first size has no border: it stands for the visible blocks, as if they could be read individually.
constexpr int tile_sizes[] = {block_size, 64, 128, 256, 512, 1024};

/// The time in milliseconds to upload a tile of each size.
std::vector<double> upload_ms(const Picture& image, int repeats) {
    std::vector<std::vector<Bytes>> tiles;
    std::vector<Layers> layers;
    for (const int size : tile_sizes) {
        tiles.push_back(cut_some(image, size));
        layers.emplace_back(GL_SRGB8_ALPHA8, size, 4);
        for (int i = 0; i < 4; ++i) layers.back().put_rgba(tiles.back()[0].data());  // allocates the memory
    }
    std::vector<double> ms = medians_in_turn(std::size(tile_sizes), repeats, [&](std::size_t s) {
        return milliseconds([&] {
            for (const Bytes& t : tiles[s]) layers[s].put_rgba(t.data());
        });
    });
    for (std::size_t s = 0; s < ms.size(); ++s) ms[s] /= double(tiles[s].size());
    return ms;
}

std::vector<Measurement> measure_sizes(const BenchScene& scene, const Effort& effort) {
    const gl::HeadlessContext context;
    const PackageReader package(scene.package);
    const std::vector<std::uint32_t> photos = some_photos(package, 1);
    const auto triangles = package.records<std::uint32_t>(package::Type::indices, package::scene_wide, false);
    if (photos.empty() || triangles.empty() || scene.views.empty()) return {};
    const Surface model = surface(package);
    std::vector<Blocks> shown;
    for (const TrueView& v : scene.views)
        shown.push_back(shown_blocks(package, model, v, effort.points < 20000 ? 4 : 2));
    const std::vector<double> ms = upload_ms(photo_at_level(package, photos[0], 0), effort.repeats);
    gl::check("uploading tiles");
    std::vector<Measurement> out;
    for (std::size_t s = 0; s < std::size(tile_sizes); ++s) {
        const int size = tile_sizes[s];
        std::vector<double> read;
        for (const Blocks& b : shown) read.push_back(tile_bytes_of(b, size));
        Measurement m;
        m.curve = "tile size";
        m.exact = size == block_size;
        m.chosen = size == tile_size;
        m.setting = m.exact ? "8x8, what is shown" : std::to_string(size);
        m.values = {{"read_bytes", mean(read)}, {"tile_ms", ms[s]}};
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    return {{"all", [=, &scene] { return measure_sizes(scene, effort); }}};
}

}  // namespace

extern const Sweep tile_size_sweep;
const Sweep tile_size_sweep{
    "tile-size",
    "Tile size",
    "Tiles are 256 texels wide. How much must be read for a view if tiles are larger or smaller?",
    "the blocks of 8x8 texels that the view shows, found by ray casting",
    "exact by definition, because it reads only those blocks",
    {{"tile_ms", "read_bytes", true, true}},
    jobs};

}  // namespace vantage::bench

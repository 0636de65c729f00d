#include "tests/bench/scenes/scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <numeric>

#include "base/files/make_folder.h"
#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/file_identity.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/garden.h"
#include "pipeline/synth/synthesize.h"
#include "player/measure/evaluation/photo_pixels.h"
#include "tests/bench/scenes/crop.h"
#include "tests/bench/scenes/surface_points.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

/// Whether a product exists and was made from sources with this stamp; the stamp is stored next to the
/// product.
bool made_from(const fs::path& product, const std::string& stamp) {
    std::ifstream in(product.string() + ".from");
    return fs::exists(product) && std::string(std::istreambuf_iterator<char>(in), {}) == stamp;
}
void mark_made_from(const fs::path& product, const std::string& stamp) {
    std::ofstream(product.string() + ".from") << stamp;
}

/// Identifies this program by its bytes, and all files under `input` by size and timestamp.
std::string stamp_of(const fs::path& input) {
    std::vector<std::string> lines;
    const auto add = [&](const fs::path& file) {
        lines.push_back(fmt::format("{} {} {}\n", file.string(), fs::file_size(file),
                                    fs::last_write_time(file).time_since_epoch().count()));
    };
    if (fs::is_regular_file(input)) {
        add(input);
    } else {
        for (const fs::directory_entry& e : fs::recursive_directory_iterator(input))
            if (e.is_regular_file()) add(e.path());
    }
    std::ranges::sort(lines);
    std::string out = fmt::format("{}\n", identify(fs::read_symlink("/proc/self/exe")).checksum);
    for (const std::string& l : lines) out += l;
    return out;
}

void synthesize_once(const SynthSpec& spec, const fs::path& input, const fs::path& folder) {
    const std::string stamp = stamp_of(input);
    if (made_from(folder, stamp)) return;
    fs::remove_all(folder);
    synthesize(spec, folder, {});
    mark_made_from(folder, stamp);
}

void prepare_once(const fs::path& folder, const fs::path& package) {
    const std::string stamp = stamp_of(folder);
    if (made_from(package, stamp)) return;
    // Raw tiles are exact, so the measurements use them.
    PrepareSettings settings;
    settings.effects[Effect::compact] = EffectChoice::off;
    prepare(read_scene(discover(folder)), settings, package, [](const Progress&) {});
    mark_made_from(package, stamp);
}

struct PhotoCamera {
    Intrinsics k;
    Pose pose;
    Eigen::Vector3d eye;
};

/// The pixels whose surface faces at least one photo and is visible in it.
std::vector<bool> seeable_pixels(const PackageReader& package, const RayScene& rays, const View& view,
                                 const std::vector<std::uint32_t>& photos) {
    const auto positions = package.records<Eigen::Vector3f>(package::Type::positions);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    std::vector<PhotoCamera> cameras;
    for (const std::uint32_t p : photos) {
        const package::PhotoRecord& r = package.photos()[p];
        cameras.push_back({intrinsics(r), cam_from_origin(r), cam_from_origin(r).center()});
    }
    const Intrinsics& k = view.intrinsics;
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::vector<std::uint8_t> seeable(std::size_t(k.width) * std::size_t(k.height), 0);
    for_each_photo(std::size_t(k.height), 0, [&](std::size_t y) {
        for (int x = 0; x < k.width; ++x) {
            const Eigen::Vector3d ray =
                view.cam_from_origin.R.transpose() *
                Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (double(y) + 0.5 - k.cy) / k.fy, 1);
            const auto hit = rays.first_hit(eye, ray);
            if (!hit) continue;
            const Eigen::Vector3d point = eye + hit->distance * ray;
            Eigen::Vector3d normal = area_vector(corners(positions, indices, hit->triangle));
            if (normal.dot(eye - point) < 0) normal = -normal;
            const auto sees = [&](const PhotoCamera& c) {
                const auto p = project(c.k, c.pose, point);
                return p && in_frame(c.k, p->pixel) && normal.dot(c.eye - point) > 0 &&
                       !rays.occluded(c.eye, point - c.eye, 0, 1 - 1e-4);
            };
            seeable[y * std::size_t(k.width) + std::size_t(x)] = std::ranges::any_of(cameras, sees);
        }
    });
    return {seeable.begin(), seeable.end()};
}

/// The finest pyramid level that is within the effort's size limit.
int level_for(const Effort& effort, int width, int height) {
    int level = 0;
    while (std::max(width, height) >> level > effort.longest) ++level;
    return level;
}

/// A window at the center of a frame, within the effort's size limit, as in a close-up view.
Intrinsics middle_of(const Intrinsics& k, const Effort& effort) {
    const int w = std::min(k.width, effort.longest), h = std::min(k.height, effort.longest * 2 / 3);
    return {w, h, k.fx, k.fy, k.cx - (k.width - w) / 2, k.cy - (k.height - h) / 2};
}

/// Every other view is a close-up: the center of a frame at full resolution.
bool close_up(std::size_t view) { return view % 2 == 1; }

/// The views of held-out photos, which are evenly spread.
std::vector<TrueView> held_out_views(const PackageReader& package, const Effort& effort) {
    std::vector<TrueView> views;
    const std::size_t photos = package.photos().size(), count = std::min(effort.views, photos);
    for (std::size_t v = 0; v < count; ++v) {
        const auto held_out = std::uint32_t((v + 1) * photos / (count + 1));
        const package::PhotoRecord& record = package.photos()[held_out];
        const int wanted = close_up(v) ? 0 : level_for(effort, int(record.width), int(record.height));
        const int level = std::min(wanted, int(record.levels) - 1);
        TrueView view{
            record.name, view_of_level(record, level), photo_at_level(package, held_out, level), {}, {}, {}};
        if (close_up(v)) {
            const Intrinsics whole = view.view.intrinsics, k = middle_of(whole, effort);
            view.view.intrinsics = k;
            view.truth = crop(view.truth, (whole.width - k.width) / 2, (whole.height - k.height) / 2, k.width,
                              k.height);
            view.name += ", close";
        }
        view.photos.resize(photos);
        std::iota(view.photos.begin(), view.photos.end(), 0u);
        std::erase(view.photos, held_out);
        view.held_out = record.name;
        views.push_back(std::move(view));
    }
    return views;
}

/// Views between the photos' cameras and slightly closer; the truth is ray-cast with 16 rays per pixel.
std::vector<TrueView> cast_views(const PackageReader& package, const SynthSpec& spec, const Effort& effort) {
    SynthSpec between = spec;
    between.photos.count = 2 * spec.photos.count - 1;
    between.photos.radius *= 0.85;
    between.seed += 17;
    const std::vector<NamedCamera> cameras = place_cameras(between);
    const SynthModel model = build_world(spec);
    const RayScene rays(model.mesh);
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    std::vector<TrueView> views;
    for (std::size_t v = 0; v < effort.views; ++v) {
        const std::size_t gaps = cameras.size() / 2, gap = (2 * v + 1) * gaps / (2 * effort.views);
        Camera camera = cameras[std::min(2 * gap + 1, cameras.size() - 1)].camera;
        camera.lens = {};
        const Intrinsics& k = camera.intrinsics;
        const Level size = level_size(k.width, k.height, level_for(effort, k.width, k.height));
        camera.intrinsics = close_up(v) ? middle_of(k, effort) : k.scaled(size.width, size.height);
        TrueView view{fmt::format("between {} and {}", gap, gap + 1),
                      {camera.intrinsics, camera.cam_from_world.relative_to(origin)},
                      {camera.intrinsics.width, camera.intrinsics.height, {}, {}},
                      {},
                      {},
                      {}};
        const auto rgb = cast_photo(model, rays, camera, 4);
        for (std::size_t i = 0; i < rgb.size(); i += 3)
            view.truth.rgba.insert(view.truth.rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
        view.photos.resize(package.photos().size());
        std::iota(view.photos.begin(), view.photos.end(), 0u);
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace

BenchScene open_scene(const fs::path& input, const fs::path& work, const Effort& effort) {
    if (!fs::is_directory(input) && !(fs::is_regular_file(input) && input.extension() == ".toml"))
        throw Error(Exit::input,
                    input.string() + ": expected the folder of a scan, or a specification (.toml)");
    make_folder(work);
    BenchScene scene;
    if (input.extension() == ".toml") {
        scene.name = input.stem();
        scene.spec = read_spec(input);
        scene.folder = work / scene.name;
        synthesize_once(*scene.spec, input, scene.folder);
    } else {
        scene.folder = fs::weakly_canonical(input);
        scene.name = scene.folder.filename();
    }
    scene.package = work / (scene.name + ".vantage");
    prepare_once(scene.folder, scene.package);
    const PackageReader package(scene.package);
    if (package.photos().size() < 2)
        throw Error(Exit::input, input.string() + ": at least two photos are needed for a comparison");
    scene.views = scene.spec ? cast_views(package, *scene.spec, effort) : held_out_views(package, effort);
    const RayScene rays(package.records<Eigen::Vector3f>(package::Type::positions),
                        package.records<std::uint32_t>(package::Type::indices));
    for (TrueView& v : scene.views) v.seeable = seeable_pixels(package, rays, v.view, v.photos);
    return scene;
}

}  // namespace vantage::bench

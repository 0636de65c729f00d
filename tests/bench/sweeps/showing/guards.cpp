// Measures the cost of checking files, lenses and pictures.
#include <cstring>

#include "base/gl/context.h"
#include "base/values/tiling.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "player/measure/bench/finite_targets.h"
#include "player/render/renderer.h"
#include "scene/camera/lens.h"
#include "scene/package/package_shape.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

using package::Type;

/// Compares the times with and without a guard; `time(guarded)` returns milliseconds.
template <class Time>
std::vector<Measurement> compare(const char* curve, const char* metric, int repeats, const Time& time) {
    const std::vector<double> ms =
        medians_in_turn(2, repeats, [&](std::size_t guarded) { return time(guarded == 1); });
    std::vector<Measurement> out;
    for (const bool guarded : {false, true}) {
        out.push_back({"", "", curve, guarded ? "with" : "without", guarded, guarded, {}, {}});
        out.back().values[metric] = ms[guarded];
    }
    return out;
}

/// Measures the cost of copying tiles from the page cache into memory, as in streaming, with and without
/// checksums.
std::vector<Measurement> tiles(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    const package::DirectoryEntry* chunk = package.find(Type::tiles, 0, 0);
    const std::size_t count = package.blocks(*chunk);
    std::vector<std::byte> to(tile_bytes);
    return compare("checksum of a tile", "fetch_ms", effort.repeats, [&](bool guarded) {
        bool valid = true;
        const double ms = milliseconds([&] {
            for (std::size_t i = 0; i < count; ++i) {
                if (guarded) valid &= package.block_valid(*chunk, i);
                std::memcpy(to.data(), package.block(*chunk, i).data(), to.size());
            }
        });
        return valid ? ms / double(count) : 0;
    });
}

std::vector<Measurement> opening(const BenchScene& scene, const Effort& effort) {
    return compare("consistency of the records", "open_ms", effort.repeats, [&](bool guarded) {
        return milliseconds([&] {
            const PackageReader package(scene.package);
            package.photos();
            if (guarded) expect_shape(package);
        });
    });
}

std::vector<Measurement> lenses(const BenchScene& scene, const Effort& effort) {
    const SceneInput input = read_scene(discover(scene.folder));
    return compare("valid range of the lenses", "photo_ms", effort.repeats, [&](bool guarded) {
        return milliseconds([&] {
                   for (const PhotoInput& photo : input.photos)
                       if (guarded) lens_range(photo.camera.lens);
               }) /
               double(input.photos.size());
    });
}

std::vector<Measurement> targets(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    const gl::HeadlessContext context;
    Renderer renderer(package, ample_memory());
    const TrueView& view = scene.views.front();
    const PictureSetting setting{"", "", false, false, {}};
    settle(renderer, view, setting);
    return compare("counting non-finite pixels (verify)", "frame_ms", effort.repeats, [&](bool guarded) {
        return milliseconds([&] {
            renderer.draw(view.view, setting.settings, view.photos, {}, 0);
            if (guarded) count_non_finite(renderer.resources().targets);
            glFinish();
        });
    });
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    return {{"tiles", [=, &scene] { return tiles(scene, effort); }},
            {"opening", [=, &scene] { return opening(scene, effort); }},
            {"lenses", [=, &scene] { return lenses(scene, effort); }},
            {"targets", [=, &scene] { return targets(scene, effort); }}};
}

}  // namespace

extern const Sweep guards_sweep;
const Sweep guards_sweep{"guards",
                         "Validation",
                         "What do the checks of files, lenses and pictures cost?",
                         "the same work without the check",
                         "not applicable: the output is the same",
                         {},
                         jobs,
                         true};

}  // namespace vantage::bench

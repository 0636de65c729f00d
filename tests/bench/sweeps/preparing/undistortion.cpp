// Undistortion: the error of resampling a photo to a pinhole camera, measured against a photo cast without a
// lens.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/pixels/undistort.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/settings/settings.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/synthesize.h"
#include "player/evaluate/picture_metrics.h"
#include "scene/halve.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/evenly_spread.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

constexpr Resampling resamplings[] = {Resampling::nearest, Resampling::linear, Resampling::cubic,
                                      Resampling::lanczos};
constexpr std::size_t settings =
    std::size(resamplings) + 1;  // the last starts from a photo of twice the size
constexpr const char* twice = "lanczos, photo of twice the size";

/// At most `count` of the specified cameras, evenly spread, at most `width` pixels wide, all with a lens.
std::vector<Camera> cameras(const SynthSpec& spec, std::size_t count, int width) {
    std::vector<Camera> out;
    for (const NamedCamera& named : evenly_spread(place_cameras(spec), count)) {
        Camera c = named.camera;
        if (!c.lens.distorts()) c.lens = {LensModel::opencv, {-0.12, 0.03}};
        const Intrinsics& k = c.intrinsics;
        const int w = std::min(width, k.width);
        c.intrinsics = k.scaled(w, std::max(1, int(std::lround(double(w) * k.height / k.width))));
        out.push_back(c);
    }
    return out;
}

RgbaImage cast(const SynthModel& model, const RayScene& rays, const Camera& camera, int samples) {
    const std::vector<std::uint8_t> rgb = cast_photo(model, rays, camera, samples);
    RgbaImage out{camera.intrinsics.width, camera.intrinsics.height, {}};
    out.rgba.reserve(rgb.size() / 3 * 4);
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
        out.rgba.insert(out.rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
    return out;
}

Camera doubled(Camera camera) {
    const Intrinsics& k = camera.intrinsics;
    camera.intrinsics = k.scaled(2 * k.width, 2 * k.height);
    return camera;
}

/// Photos cast through the lens, through the lens at twice the size, and through a pinhole.
struct Cast {
    Camera camera;
    RgbaImage lens, lens_doubled, pinhole;
};

/// Casts all photos; `samples` along the side of a pixel must be even.
std::vector<Cast> cast_all(const SynthSpec& spec, const std::vector<Camera>& cameras, int samples) {
    const SynthModel model = build_model(spec);
    const RayScene rays(model.mesh);
    std::vector<Cast> out(cameras.size());
    for_each_photo(3 * cameras.size(), 0, [&](std::size_t i) {
        Cast& c = out[i / 3];
        const Camera& camera = cameras[i / 3];
        if (i % 3 == 0)
            c.camera = camera, c.lens = cast(model, rays, camera, samples);
        else if (i % 3 == 1)  // the same number of samples in total
            c.lens_doubled = cast(model, rays, doubled(camera), samples / 2);
        else
            c.pinhole = cast(model, rays, {camera.intrinsics, {}, camera.cam_from_world}, samples);
    });
    return out;
}

RgbaImage undistorted(const Cast& c, std::size_t setting) {
    if (setting < std::size(resamplings)) return undistort(c.lens, c.camera, resamplings[setting]);
    return halve(undistort(c.lens_doubled, doubled(c.camera), Resampling::lanczos));
}

Picture picture(const RgbaImage& image) { return {image.width, image.height, image.rgba, {}}; }

struct Result {
    std::vector<double> psnr, ssim, worst, ms;
};

void add(const RgbaImage& truth, const RgbaImage& image, double ms, Result& result) {
    const Picture shown = picture(image);
    const PictureScore s = score(picture(truth), shown, scored_pixels(shown));
    if (s.pixels == 0) return;  // no ray of the pinhole is in the lens's view
    result.psnr.push_back(std::min(s.psnr, psnr_cap));
    result.ssim.push_back(s.ssim);
    result.worst.push_back(s.worst);
    result.ms.push_back(ms);
}

struct Results {
    std::array<Result, settings> full, halved;
};

/// Adds the results of all settings on one photo, and of the next coarser level of each.
void add(const Cast& c, int repeats, Results& results) {
    std::array<RgbaImage, settings> images, halves;
    const auto ms = medians_in_turn(settings, repeats, [&](std::size_t s) {
        return milliseconds([&] { images[s] = undistorted(c, s); });
    });
    const auto half_ms = medians_in_turn(settings, repeats, [&](std::size_t s) {
        return milliseconds([&] { halves[s] = halve(images[s]); });
    });
    const RgbaImage half_truth = halve(c.pinhole);
    for (std::size_t s = 0; s < settings; ++s) {
        add(c.pinhole, images[s], ms[s], results.full[s]);
        add(half_truth, halves[s], ms[s] + half_ms[s], results.halved[s]);
    }
}

Measurement measured(const char* curve, std::size_t setting, const Result& r) {
    Measurement m;
    m.curve = curve;
    m.exact = setting == std::size(resamplings);
    m.setting = m.exact ? twice : name(resamplings[setting]);
    m.chosen = !m.exact && resamplings[setting] == PrepareSettings{}.resampling;
    m.values = {
        {"psnr", mean(r.psnr)}, {"ssim", mean(r.ssim)}, {"worst", mean(r.worst)}, {"photo_ms", mean(r.ms)}};
    return m;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort,
                                 const std::filesystem::path& folder) {
    // Casting takes most of the time, but with fewer samples the truth is noisier than some measured errors.
    const bool smoke = effort.name == "smoke";
    const int width = smoke ? 160 : (effort.name == "full" ? 640 : 400);
    const std::vector<Cast> photos =
        cast_all(*scene.spec, cameras(*scene.spec, effort.photos, width), smoke ? 4 : 6);
    Results results;
    for (const Cast& c : photos) add(c, effort.repeats, results);
    std::vector<Measurement> out;
    if (results.full[0].psnr.empty() || results.halved[0].psnr.empty()) return out;
    for (std::size_t s = 0; s < settings; ++s) out.push_back(measured("as undistorted", s, results.full[s]));
    for (std::size_t s = 0; s < settings; ++s)
        out.push_back(measured("one level coarser", s, results.halved[s]));
    const Picture truth = picture(photos.front().pinhole);
    const Window window = worst_window(truth, picture(undistorted(photos.front(), 0)));
    for (const std::size_t s : {std::size_t(0), settings - 2, settings - 1})
        out[s].exhibits.push_back(keep_exhibit(folder, scene.name + "-undistortion-" + std::to_string(s),
                                               out[s].setting, picture(undistorted(photos.front(), s)),
                                               window));
    out[settings - 1].exhibits.push_back(
        keep_exhibit(folder, scene.name + "-undistortion-truth", "cast without a lens", truth, window));
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    if (!scene.spec) return {};
    return {{"all", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep undistortion_sweep;
const Sweep undistortion_sweep{
    "undistortion",
    "Undistorting photos",
    "Photos taken through a lens are resampled to a pinhole camera. How much quality does that lose, and how "
    "much of the loss remains where the player shows a coarser level?",
    "the ray-cast photo of the same camera without a lens",
    "37 dB as undistorted, 42 dB one level coarser (data/tiny.toml); the rest is "
    "aliasing at 36 samples per pixel",
    {{"photo_ms", "psnr", true, false}, {"photo_ms", "worst", true, false}},
    jobs,
    true};

}  // namespace vantage::bench

#include "pipeline/prepare/resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "pipeline/background/find_background.h"
#include "pipeline/input/identity_cache.h"
#include "pipeline/output/disk_space.h"
#include "pipeline/refine/folds.h"
#include "pipeline/refine/transient.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// A field of /proc/self/status, in bytes.
std::uint64_t status_bytes(const char* key) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key))
            return std::strtoull(line.c_str() + std::string(key).size(), nullptr, 10) * 1024;
    return 0;
}

/// Resident heap memory that is free and will be reused.
std::uint64_t freed_in_heap() {
#ifdef __GLIBC__
    std::ifstream in("/proc/self/smaps");
    std::uint64_t heap = 0;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (const std::size_t colon = line.find(':'); line.find('-') < colon)
            inside = line.ends_with("[heap]");
        if (inside && line.starts_with("Rss:")) heap += std::strtoull(line.c_str() + 4, nullptr, 10) * 1024;
    }
    const std::uint64_t used = ::mallinfo2().uordblks;
    return heap > used ? heap - used : 0;
#else
    return 0;
#endif
}

double pixels(const PhotoInput& photo) { return double(photo.decoded.width) * photo.decoded.height; }

/// These times are for one thread of a 2023 server; machine_speed() scales them. They were measured as
/// described in docs/measurements.md, "Cost by number of triangles".
constexpr double seconds_per_pixel = 17e-9, seconds_per_lens_pixel = 2e-9, seconds_per_triangle = 0.16e-6;
/// Seconds for decoding.
constexpr double seconds_per_jpeg_pixel = 5e-9, seconds_per_other_pixel = 35e-9;
/// Seconds per byte for writing a package to a disk, including the final flush.
constexpr double seconds_per_written_byte = 2e-9;
/// Seconds per photo for comparing photos, and for validation. Validation takes time for at most
/// `max_validated` photos, because few photos are held out.
constexpr double seconds_per_photo = 0.02, seconds_per_validated = 0.02;
constexpr std::size_t max_validated = 12;
/// Seconds per photo for computing the background.
constexpr double seconds_per_swept = 0.03;
/// Maximum memory for the background, in bytes: views, depths by direction, the costs of depths, and
/// messages.
constexpr std::uint64_t background_memory = 50'000'000;
/// Runs shorter than this, in seconds, are too short to measure the speed.
constexpr double shortest_run = 0.5;

/// Seconds that one thread needs for a photo.
double photo_seconds(const PhotoInput& photo, const package::SceneRecord& model) {
    const double kept = double(photo.camera.intrinsics.width) * photo.camera.intrinsics.height;
    const std::string extension = lower_extension(photo.file);
    const bool jpeg = extension == ".jpg" || extension == ".jpeg";
    const bool lens = photo.camera.lens.distorts() && effect_on(model, Effect::undistortion);
    return pixels(photo) * (jpeg ? seconds_per_jpeg_pixel : seconds_per_other_pixel) +
           kept * (seconds_per_pixel + (lens ? seconds_per_lens_pixel : 0)) +
           double(model.triangles) * seconds_per_triangle;
}

/// Bytes of a photo's file per pixel, counted twice, because decoding a large file that is not a JPEG needs
/// the same amount again.
double file_bytes(const PhotoInput& photo) {
    std::error_code error;
    const auto bytes = fs::file_size(photo.file, error);
    return error ? 1 : std::max(1.0, 2 * double(bytes) / std::max(1.0, pixels(photo)));
}

fs::path speed_file() {
    const fs::path cache = default_identity_cache();
    return cache.empty() ? fs::path() : cache.parent_path() / "machine-speed";
}

double machine_speed() {
    std::ifstream in(speed_file());
    double factor = 1;
    return in >> factor && factor > 0.01 && factor < 100 ? factor : 1;
}

}  // namespace

std::string in_words(const ResourceEstimate& n) {
    return fmt::format(
        "about {:.0f} s, at most {:.0f} MB of memory ({} photos at a time), {:.0f} MB of disk{}",
        std::ceil(n.seconds), double(n.memory) / 1e6, n.in_flight, double(n.disk) / 1e6,
        n.disk_free == unknown_space ? "" : fmt::format(" ({:.0f} MB free)", double(n.disk_free) / 1e6));
}

ResourceEstimate estimate_resources(const SceneInput& scene, const PrepareSettings& settings,
                                    const package::SceneRecord& model, const PackageLayout& layout,
                                    const RunConditions& run) {
    const auto photo = [&](unsigned in_flight) {
        return photo_memory(scene, model, uses_spare_cores(settings, in_flight));
    };
    const std::uint64_t base = memory_now() + scene_memory(model, run.opengl);
    const bool shared = run.shares > 0;
    // The memory of the photos has been freed by the time their results are compared.
    const auto needed = [&](unsigned in_flight) {
        return base +
               std::max(in_flight * photo(in_flight), shared ? 0 : agree_memory(scene, settings, in_flight));
    };
    const unsigned in_flight = photos_in_flight(settings, needed);
    const ExpectedSeconds expected = expected_seconds(scene, settings, model, in_flight,
                                                      is_in_memory(run.out) ? 0 : disk_space_needed(layout));
    const double photos = expected.photos / (shared ? run.shares : 1);
    return {.disk = disk_space_needed(layout),
            .disk_free = disk_space_for(run.out),
            .memory = needed(in_flight),
            .in_flight = in_flight,
            .seconds = run.seconds_before + photos + (shared ? 0 : expected.finish),
            .photo_seconds = photos};
}

std::uint64_t photo_memory(const SceneInput& scene, const package::SceneRecord& model, bool spare_cores) {
    double most = 0;
    for (const PhotoInput& photo : scene.photos) {
        // Bytes per pixel: 6 for RGBA and its pyramid, plus the file; 12 for a copy and the source position
        // of each pixel; 4 for a mask. Maps, distances and weight maps take 28 bytes for each of a quarter of
        // the pixels.
        const double texels =
            6 + file_bytes(photo) + (photo.camera.lens.distorts() ? 12 : 0) + (photo.mask.empty() ? 0 : 4);
        constexpr double maps = 7;
        most = std::max(most, pixels(photo) * (spare_cores ? texels + maps : std::max(texels, maps)));
    }
    return std::uint64_t(most + 44.0 * double(model.vertices) + 28.0 * double(model.triangles));
}

bool uses_spare_cores(const PrepareSettings& settings, unsigned in_flight) {
    return threads_of(settings) > 1 && !(settings.memory > 0 && in_flight == 1);
}

std::uint64_t agree_memory(const SceneInput& scene, const PrepareSettings& settings, unsigned threads) {
    const auto off = [&](Effect e) { return choice_of(settings.effects, e) == EffectChoice::off; };
    const std::uint64_t beside = off(Effect::background) ? 0 : background_memory;
    if (off(Effect::exposure) && off(Effect::transients)) return beside;
    const auto at_most = [&](std::size_t n) { return double(std::min(scene.photos.size(), n)); };
    double texels = 0;  // at the level of Folds, at most 256 on the longer side
    for (const PhotoInput& photo : scene.photos)
        texels = std::max(texels, std::min(pixels(photo) / 4, 256.0 * 256.0 * 3 / 4));
    // Bytes per texel: 100 for the photos of Folds, 80 for transient views, 52 for sightings at a quarter of
    // the texels, and for each thread 100 for the blended colors of three predictions.
    return beside + std::uint64_t(texels * (100 * at_most(cached_photos) + 80 * at_most(cached_views) +
                                            13 * at_most(kept_sightings) * at_most(max_others) +
                                            100 * at_most(threads)));
}

std::uint64_t scene_memory(const package::SceneRecord& model, bool opengl) {
    // Memory for the report's views, and with OpenGL also for the shaders, buffers and triangle bins of a
    // software renderer.
    return std::uint64_t(18e6 + (opengl ? 160e6 + 150.0 * double(model.triangles) : 0));
}

std::uint64_t memory_now() {
    const std::uint64_t resident = status_bytes("VmRSS:");
    return resident - std::min(resident, freed_in_heap());
}
std::uint64_t memory_peak() { return status_bytes("VmHWM:"); }

unsigned threads_of(const PrepareSettings& settings) {
    return settings.threads ? settings.threads : std::max(1u, std::thread::hardware_concurrency());
}

unsigned photos_in_flight(const PrepareSettings& settings,
                          const std::function<std::uint64_t(unsigned in_flight)>& needed) {
    unsigned in_flight = threads_of(settings);
    if (settings.memory == 0) return in_flight;
    while (in_flight > 1 && needed(in_flight) > settings.memory) --in_flight;
    if (needed(in_flight) > settings.memory)
        throw Error(Exit::usage,
                    fmt::format("--memory {}: one photo at a time and this model may need up to {}M",
                                settings.memory >> 20 ? fmt::format("{}M", settings.memory >> 20)
                                                      : fmt::format("{}", settings.memory),
                                (needed(in_flight) >> 20) + 1));
    return in_flight;
}

ExpectedSeconds expected_seconds(const SceneInput& scene, const PrepareSettings& settings,
                                 const package::SceneRecord& model, unsigned in_flight,
                                 std::uint64_t to_disk) {
    double work = 0;
    for (const PhotoInput& photo : scene.photos) work += photo_seconds(photo, model);
    const auto at_once = double(std::min({in_flight, std::max(1u, std::thread::hardware_concurrency()),
                                          unsigned(std::max<std::size_t>(1, scene.photos.size()))}));
    const std::size_t photos = scene.photos.size();
    const bool background = choice_of(settings.effects, Effect::background) != EffectChoice::off;
    const double finish =
        double(photos) * seconds_per_photo + double(std::min(photos, max_validated)) * seconds_per_validated +
        (background ? double(std::min(photos, max_surrounding_views)) * seconds_per_swept : 0);
    const double writing = double(to_disk) * seconds_per_written_byte;
    return {std::max(work / at_once, writing) * machine_speed(), finish * machine_speed()};
}

void remember_speed(double expected, double took) {
    const fs::path file = speed_file();
    if (file.empty() || !(std::max(expected, took) > shortest_run) || !(expected > 0) || !(took > 0)) return;
    const double speed = machine_speed() * std::sqrt(took / expected);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    try {
        replace_file(file, fmt::format("{:g}\n", speed));
    } catch (const Error&) {
        // Ignored, because the speed only improves estimates.
    }
}

}  // namespace vantage

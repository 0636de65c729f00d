#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/input/scene_input.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_layout.h"

namespace vantage {

/// The resources that a preparation needs, estimated before the first photo is started.
struct ResourceEstimate {
    std::uint64_t disk, disk_free;  ///< bytes
    std::uint64_t memory;           ///< bytes, peak
    unsigned in_flight;             ///< photos processed concurrently
    double seconds;                 ///< time for the whole run, including the elapsed time, without reuse
    double photo_seconds;           ///< part of this time for the photos
};

/// "about 4 s, at most 319 MB of memory (2 photos at a time), 161 MB of disk (25186 MB free)"
std::string in_words(const ResourceEstimate& estimate);

/// The conditions of a run that determine its resources.
struct RunConditions {
    std::filesystem::path out;  ///< the package; need not exist
    bool opengl;                ///< the model is rendered by OpenGL, not on the CPU
    unsigned shares;            ///< number of shards; 0: the run processes all photos
    double seconds_before;      ///< elapsed before the estimate
};
/// Estimates the resources that a run still needs. Throws Error(usage) if the memory limit in the settings is
/// too small.
ResourceEstimate estimate_resources(const SceneInput& scene, const PrepareSettings& settings,
                                    const package::SceneRecord& model, const PackageLayout& layout,
                                    const RunConditions& run);

/// Memory per photo in flight, in bytes: its pixels, and the rendered maps of the model with weight maps;
/// both at once if it may use a spare core.
std::uint64_t photo_memory(const SceneInput& scene, const package::SceneRecord& model, bool spare_cores);

/// Whether a photo may use two cores while others are idle: not if memory is limited to one photo.
bool uses_spare_cores(const PrepareSettings& settings, unsigned in_flight);

/// Memory in bytes for the results of all photos, after the photos are done: the coarse photos cached for
/// validation, on up to `threads` threads; 0 without validation.
std::uint64_t agree_memory(const SceneInput& scene, const PrepareSettings& settings, unsigned threads);

/// Memory in bytes still to be allocated for the scene, independent of the number of photos in flight.
std::uint64_t scene_memory(const package::SceneRecord& model, bool opengl);

/// Resident memory of this process in bytes, at present (without free heap memory) and at its peak; 0 if
/// unknown.
std::uint64_t memory_now();
std::uint64_t memory_peak();

/// The number of threads in the settings, or one per core.
unsigned threads_of(const PrepareSettings& settings);

/// Number of photos in flight that the settings' threads and memory allow; n photos need needed(n) bytes.
/// Throws Error(usage) if the memory is too small for one.
unsigned photos_in_flight(const PrepareSettings& settings,
                          const std::function<std::uint64_t(unsigned in_flight)>& needed);

/// Expected seconds, scaled by this machine's speed in earlier runs. Linear in photos * (triangles + pixels),
/// or in the bytes written to a disk if these take longer.
struct ExpectedSeconds {
    double photos;
    double finish;  ///< results of all photos, including the background unless it is off; longer if the
                    ///< photos require pose refinement
};
ExpectedSeconds expected_seconds(const SceneInput& scene, const PrepareSettings& settings,
                                 const package::SceneRecord& model, unsigned in_flight,
                                 std::uint64_t to_disk);
/// Corrects the speed by the ratio of actual to expected time, for the next estimate. Ignores errors, and
/// runs that are too short. A single run changes the speed by the square root of its ratio, because the
/// machine may have been busy.
void remember_speed(double expected, double took);

}  // namespace vantage

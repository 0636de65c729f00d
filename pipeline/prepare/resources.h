#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/input/scene_input.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_layout.h"

namespace vantage {

/// The resources that `prepare` needs, estimated before the first photo is started.
struct ResourceEstimate {
    std::uint64_t disk, disk_free;  ///< bytes
    std::uint64_t memory;           ///< bytes, peak
    unsigned in_flight;             ///< photos processed concurrently
    double seconds;        ///< time for the whole run, including the elapsed time, if nothing is reused
    double photo_seconds;  ///< the part of `seconds` that is spent on the photos
};

/// "about 4 s, at most 319 MB of memory (2 photos at a time), 161 MB of disk (25186 MB free)"
std::string in_words(const ResourceEstimate& estimate);

/// The conditions of a run that determine its resources.
struct RunConditions {
    std::filesystem::path out;  ///< the package, which need not exist yet
    bool opengl;                ///< the model is rendered by OpenGL, not on the CPU
    unsigned shares;            ///< number of shards; 0: the run processes all photos
    double seconds_before;      ///< time elapsed before the estimate
};
/// Estimates the resources that a run still needs. Throws Error(usage) if the memory limit in the settings is
/// too small.
ResourceEstimate estimate_resources(const SceneInput& scene, const PrepareSettings& settings,
                                    const package::SceneRecord& model, const PackageLayout& layout,
                                    const RunConditions& run);

/// Memory per photo in flight, in bytes: either its pixels, or the rendered maps of the model and the weight
/// maps. If the photo may use a spare core, both are in memory at once.
std::uint64_t photo_memory(const SceneInput& scene, const package::SceneRecord& model, bool spare_cores);

/// Whether a photo may use a second core that is idle. False if memory is limited to one photo.
bool uses_spare_cores(const PrepareSettings& settings, unsigned in_flight);

/// Memory in bytes for the results that depend on all photos, computed after the photos are done: the
/// background and the coarse photos cached for validation, on up to `threads` threads. 0 if there is neither.
std::uint64_t agree_memory(const SceneInput& scene, const PrepareSettings& settings, unsigned threads);

/// Memory in bytes still to be allocated for the scene, independent of the number of photos in flight.
std::uint64_t scene_memory(const package::SceneRecord& model, bool opengl);

/// Resident memory of this process in bytes: the current value (without free heap memory) and the peak; 0 if
/// unknown.
std::uint64_t memory_now();
std::uint64_t memory_peak();

/// The number of threads in the settings, or of cores if the settings give none.
unsigned threads_of(const PrepareSettings& settings);

/// Number of photos in flight that the threads and memory in the settings allow; n photos need needed(n)
/// bytes. Throws Error(usage) if the memory is too small for one photo.
unsigned photos_in_flight(const PrepareSettings& settings,
                          const std::function<std::uint64_t(unsigned in_flight)>& needed);

/// Expected time in seconds, scaled by this machine's speed in earlier runs. It is linear in photos *
/// (triangles + pixels), or in the bytes written to a disk if writing takes longer.
struct ExpectedSeconds {
    double photos;
    double finish;  ///< for results that depend on all photos, including the background unless it is off, but
                    ///< not pose refinement
};
ExpectedSeconds expected_seconds(const SceneInput& scene, const PrepareSettings& settings,
                                 const package::SceneRecord& model, unsigned in_flight,
                                 std::uint64_t to_disk);
/// Corrects the speed by the ratio of actual to expected time, for the next estimate. Errors and runs that
/// are too short are ignored. A single run changes the speed by the square root of the ratio, because the
/// machine may have been busy.
void remember_speed(double expected, double took);

}  // namespace vantage

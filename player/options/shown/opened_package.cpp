#include "player/options/shown/opened_package.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "scene/remote/remote_package.h"

namespace vantage {
namespace {

/// Shows the amount of data fetched, four times per second.
void show_progress(const PackageReader& package, std::stop_token stop) {
    ProgressLine line(ProgressStyle::bar);
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    while (!stopped.wait_for(lock, stop, std::chrono::milliseconds(250),
                             [&] { return stop.stop_requested(); })) {
        const SourceTraffic t = *package.traffic();
        line.show({"fetching", "kB of " + package.path().filename().string(),
                   std::size_t(t.bytes_received + t.bytes_from_cache) / 1000,
                   std::size_t(package.scene_bytes()) / 1000});
    }
}

}  // namespace

PackageReader opened_package(const std::filesystem::path& package, const MemoryOptions& options) {
    const bool quiet = output_form() == OutputForm::none;
    PackageReader out = open_package(package, {.cache_bytes = memory_budget(options).cache});
    if (!out.remote()) return out;
    const auto start = std::chrono::steady_clock::now();
    {
        std::jthread progress;
        if (!quiet && ::isatty(STDERR_FILENO))
            progress = std::jthread([&](std::stop_token stop) { show_progress(out, stop); });
        out.fetch_scene();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const SourceTraffic t = *out.traffic();
    if (!quiet)
        std::fprintf(stderr, "%s  %.1f MB fetched in %.1f s, %.1f MB from the cache%s\n", out.path().c_str(),
                     double(t.bytes_received) / 1e6, seconds.count(), double(t.bytes_from_cache) / 1e6,
                     t.offline ? "; the server cannot be reached" : "");
    return out;
}

}  // namespace vantage

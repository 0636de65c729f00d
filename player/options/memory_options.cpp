#include "player/options/memory_options.h"

namespace vantage {

void add_memory_options(CLI::App& app, MemoryOptions& o) {
    app.add_option("--graphics-memory", o.graphics_mib,
                   "limit of graphics memory in MiB (default by the size of the frame); exceeded if a "
                   "frame needs more")
        ->check(CLI::Range(16u, 1u << 20));
    app.add_option("--memory", o.ring_mib, "MiB of main memory for tiles in flight")
        ->check(CLI::Range(1u, 4096u))
        ->capture_default_str();
    app.add_option("--upload", o.upload_kib,
                   "KiB uploaded per frame, at most (window and bench); at rest in a window, per thirtieth "
                   "of a second")
        ->check(CLI::Range(256u, 1u << 22))
        ->capture_default_str();
    app.add_option("--cache-size", o.cache_mib, "MiB on the disk for packages from servers, at most")
        ->check(CLI::Range(16u, 1u << 24))
        ->capture_default_str();
}

MemoryBudget memory_budget(const MemoryOptions& o) {
    return {.graphics = std::uint64_t(o.graphics_mib) << 20,
            .ring = std::uint64_t(o.ring_mib) << 20,
            .cache = std::uint64_t(o.cache_mib) << 20};
}

}  // namespace vantage

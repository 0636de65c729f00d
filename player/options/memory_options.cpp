#include "player/options/memory_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_memory_options(const Command& c, MemoryOptions& o) {
    c.integer("--graphics-memory", o.graphics_mib, 16, 1 << 20,
              "limit on graphics memory in MiB (default: depends on the frame size); exceeded if a frame "
              "needs more");
    c.integer("--cache-size", o.cache_mib, 16, 1 << 24,
              "maximum size of the disk cache for remote packages, in MiB");
}

void add_upload_option(const Command& c, MemoryOptions& o) {
    c.integer(
        "--upload-budget", o.upload_kib, 256, 1 << 22,
        "limit on uploads per frame, in KiB; at rest in a window, it applies per thirtieth of a second");
}

MemoryBudget memory_budget(const MemoryOptions& o) {
    return {.graphics = std::uint64_t(o.graphics_mib) << 20, .cache = std::uint64_t(o.cache_mib) << 20};
}

}  // namespace vantage

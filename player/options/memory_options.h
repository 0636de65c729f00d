#pragma once
#include <CLI/CLI.hpp>

#include "player/render/render_settings.h"

namespace vantage {

struct MemoryOptions {
    unsigned graphics_mib = 0;  ///< 0: by the size of the frame
    unsigned ring_mib = 32, upload_kib = 8192;
    unsigned cache_mib = 4096;

    std::size_t upload_bytes() const { return std::size_t(upload_kib) << 10; }  ///< per frame
};
void add_memory_options(CLI::App& app, MemoryOptions& options);

MemoryBudget memory_budget(const MemoryOptions& options);

}  // namespace vantage

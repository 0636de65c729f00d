#pragma once

#include "player/render/render_settings.h"

namespace vantage {

class Command;

struct MemoryOptions {
    unsigned graphics_mib = 0;  ///< 0: depends on the frame size
    unsigned cache_mib = 4096;
    unsigned upload_kib = 8192;

    std::size_t upload_bytes() const { return std::size_t(upload_kib) << 10; }  ///< per frame
};
void add_memory_options(const Command& command, MemoryOptions& options);
/// Adds --upload-budget, for commands that upload within a budget.
void add_upload_option(const Command& command, MemoryOptions& options);

MemoryBudget memory_budget(const MemoryOptions& options);

}  // namespace vantage

#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>

#include "scene/remote/cache/blocks.h"

namespace vantage {

/// Blocks that must not be freed because they are being fetched or read. To hold a block, a process takes a
/// shared lock on the byte of the table whose offset is the block's number. Other processes respect this
/// lock, and it ends with the process. Thread-safe.
class BlockHolds {
  public:
    /// `fd`: the table's descriptor, which is not owned.
    explicit BlockHolds(int fd) : fd_(fd) {}

    /// Holds blocks. A block may be held more than once at the same time. Waits while another process is
    /// freeing one of them. Throws Error(storage) if the file system does not support locks.
    void hold(std::span<const BlockRun> runs);
    void release(std::span<const BlockRun> runs);
    /// If no process holds the block, calls `free`, which must not throw, and returns its result; the block
    /// cannot be held in the meantime. Otherwise returns false.
    bool if_unheld(std::uint64_t block, const std::function<bool()>& free);

  private:
    bool lock(short type, BlockRun run, bool wait) const;

    const int fd_;
    std::mutex mutex_;
    std::map<std::uint64_t, std::uint32_t> held_;  ///< number of holds of each block
};

}  // namespace vantage

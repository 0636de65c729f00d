#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>

#include "scene/remote/cache/blocks.h"

namespace vantage {

/// Blocks that must not be freed because they are being fetched or read. A hold is a shared lock on the byte
/// of the table whose offset is the block's number, so that other processes respect it and it ends with the
/// process. Thread-safe.
class BlockHolds {
  public:
    /// `fd`: the table's descriptor, not owned.
    explicit BlockHolds(int fd) : fd_(fd) {}

    /// Blocks may be held several times. Waits while another process is freeing one of them. Throws
    /// Error(storage) if the file system has no locks.
    void hold(std::span<const BlockRun> runs);
    void release(std::span<const BlockRun> runs);
    /// Calls `free`, which must not throw, if no process holds the block, and prevents new holds meanwhile.
    /// Returns the result of `free`, or false.
    bool if_unheld(std::uint64_t block, const std::function<bool()>& free);

  private:
    bool lock(short type, BlockRun run, bool wait) const;

    const int fd_;
    std::mutex mutex_;
    std::map<std::uint64_t, std::uint32_t> held_;  ///< number of holds, by block
};

}  // namespace vantage

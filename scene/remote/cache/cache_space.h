#pragma once
#include <cstdint>
#include <mutex>

#include "scene/remote/cache/cache_folder.h"
#include "scene/remote/cache/cached_file.h"

namespace vantage {

/// Keeps the cache within its limit, by deleting files that are not open, and then by freeing blocks of the
/// open one. Thread-safe.
class CacheSpace {
  public:
    /// `limit`: bytes on the disk. Both objects must outlive this one.
    CacheSpace(const CacheFolder& folder, CachedFile& file, std::uint64_t limit);

    /// Makes room for so many bytes, which are then to be written. Throws Error(storage).
    void reserve(std::uint64_t bytes);
    /// Reserved bytes were written, or will not be.
    void settle(std::uint64_t bytes);

  private:
    const CacheFolder& folder_;
    CachedFile& file_;
    const std::uint64_t limit_;
    std::mutex mutex_;
    std::uint64_t on_disk_ = 0;   ///< bytes, as counted last, and those settled since
    std::uint64_t reserved_ = 0;  ///< bytes
    std::uint64_t until_count_ =
        0;  ///< bytes to settle until all is counted again: other processes write too
};

}  // namespace vantage

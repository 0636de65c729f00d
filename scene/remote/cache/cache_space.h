#pragma once
#include <cstdint>
#include <mutex>

#include "scene/remote/cache/cache_folder.h"
#include "scene/remote/cache/cached_file.h"

namespace vantage {

/// Keeps the cache within its limit, first by deleting files that are not open, then by freeing blocks of the
/// open file. Thread-safe.
class CacheSpace {
  public:
    /// `limit`: bytes on the disk. `folder` and `file` must outlive this object.
    CacheSpace(const CacheFolder& folder, CachedFile& file, std::uint64_t limit);

    /// Makes room for bytes that are about to be written. Throws Error(storage).
    void reserve(std::uint64_t bytes);
    /// Releases a reservation when the bytes have been written, or if they will not be written.
    void settle(std::uint64_t bytes);

  private:
    const CacheFolder& folder_;
    CachedFile& file_;
    const std::uint64_t limit_;
    std::mutex mutex_;
    std::uint64_t on_disk_ = 0;   ///< bytes found at the last count, plus those settled since
    std::uint64_t reserved_ = 0;  ///< bytes
    std::uint64_t until_count_ =
        0;  ///< bytes to settle before the next count, since other processes also write
};

}  // namespace vantage
